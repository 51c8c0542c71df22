//! Section 4.1: what the octree holds.

use render::{Modules, Settings};
use tests::Rendering;

use super::WHITE;

/// A 4 x 4 x 4 grid of spheres over a floor.
fn grid() -> Rendering {
    let spheres: String = (0..64)
        .map(|i| format!("object {{ shader white type sphere c {} {} {} r 0.4 }}\n", i % 4, i / 4 % 4, i / 16))
        .collect();
    Rendering::of(format!(
        "{WHITE} {spheres} object {{ shader white type plane p 0 0 -1 n 0 0 1 }}
         image {{ resolution 24 16 }} camera {{ type pinhole eye 9 -9 7 target 1.5 1.5 1 up 0 0 1 fov 40 aspect 1.5 }}
         light {{ type point color 1 1 1 power 40 p 5 -9 12 }}"
    ))
}

#[test]
fn planes_stand_outside() {
    let assembled = grid().assemble();
    let inventory = assembled.scene.inventory(&Settings::default());
    assert_eq!((inventory.bounded.total(), inventory.planes), (64, 1));
}

#[test]
fn its_cells_hold_all_bounded_primitives() {
    let tree = grid().assemble().scene.inventory(&Settings::default()).accelerator;
    assert!(tree.branches > 0 && tree.references >= 64, "{tree:?}");
}

#[test]
fn the_picture_is_the_same_without_it() {
    let without = Rendering { modules: Modules { accelerator: accel::none, ..Modules::default() }, ..grid() };
    assert_eq!(without.film(), grid().film());
}

#[test]
fn a_scene_of_planes_alone_needs_none() {
    let text = format!(
        "{WHITE} object {{ shader white type plane p 0 0 -1 n 0 0 1 }}
         camera {{ type pinhole eye 0 0 5 target 0 1 0 up 0 0 1 fov 40 aspect 1 }}"
    );
    assert_eq!(Rendering::of(text).assemble().scene.inventory(&Settings::default()).accelerator.references, 0);
}
