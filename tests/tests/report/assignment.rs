//! The course's assignment: its first three scenes, and blocks that are not supported.

use cli::scenes::EmbeddedFiles;
use geometry::{Interval, Ray};
use glam::Vec3;
use render::{Lighting, Modules, Scene};
use scene_format::{
    NoFiles, SceneFile, Severity,
    scene_file::{Shape, SphereForm, Statement},
};

use super::{WHITE, look};

fn embedded(name: &str) -> SceneFile {
    let scene = cli::scenes::find(name).expect("the scene is embedded");
    scene_format::parse(name, &scene.source(), &NoFiles).scene
}

/// The centres of a scene's spheres of a radius.
fn spheres(scene: &SceneFile, wanted: f32) -> Vec<Vec3> {
    let shapes = scene.statements.iter().filter_map(|statement| match &statement.value {
        Statement::Object(object) => Some(&object.shape.value),
        _ => None,
    });
    shapes
        .filter_map(|shape| match *shape {
            Shape::Sphere(SphereForm::CenterRadius { center, radius }) if radius.value == wanted => {
                Some(center.value.into())
            }
            _ => None,
        })
        .collect()
}

/// Every x at which a line along the x axis meets something.
fn met_along_x(scene: &Scene, y: f32, z: f32) -> Vec<f32> {
    let mut met = Vec::new();
    let mut x = -100.0_f32;
    while let Some(hit) = scene.closest(&Ray::new(Vec3::new(x, y, z), Vec3::X)) {
        assert!(Interval::FORWARD.contains(hit.t));
        x = (x + hit.t).next_up() + 1e-4;
        met.push(x - 1e-4);
    }
    met
}

#[test]
fn a_pyramid_of_base_and_height_5_carries_a_sphere_and_stands_among_four() {
    let scene = embedded("pyramid");
    let mesh = scene.statements.iter().find_map(|statement| match &statement.value {
        Statement::Object(object) => match &object.shape.value {
            Shape::Mesh(mesh) => Some(mesh),
            _ => None,
        },
        _ => None,
    });
    let points: Vec<Vec3> = mesh.expect("there is a mesh").points.iter().copied().map(Vec3::from).collect();
    let size = points.iter().copied().reduce(Vec3::max).unwrap() - points.iter().copied().reduce(Vec3::min).unwrap();
    assert_eq!(size, Vec3::splat(5.0));
    let tip = points.iter().copied().max_by(|a, b| a.z.total_cmp(&b.z)).unwrap();
    assert_eq!(spheres(&scene, 1.0), [tip + Vec3::Z]);
    // One for each corner of the base, three units from it.
    let small = spheres(&scene, 0.5);
    assert_eq!(small.len(), 4);
    for corner in points.iter().filter(|point| point.z < tip.z) {
        let near = small.iter().filter(|center| (center.distance(*corner) - 3.0).abs() < 1e-3).count();
        assert_eq!(near, 1, "{corner}");
    }
}

#[test]
fn sixty_four_spheres_stand_in_a_grid_spaced_1_5() {
    let centers = spheres(&embedded("spheres64"), 0.5);
    let first = centers.iter().copied().reduce(Vec3::min).unwrap();
    let mut places: Vec<_> =
        centers.iter().map(|&center| ((center - first) / 1.5).to_array().map(|s| s as u32)).collect();
    assert!(centers.iter().all(|&center| ((center - first) / 1.5).fract() == Vec3::ZERO));
    places.sort_unstable();
    let expected: Vec<_> = (0..64).map(|i| [i / 16, i / 4 % 4, i % 4]).collect();
    assert_eq!(places, expected);
}

#[test]
fn three_cubes_and_two_spheres_alternate_along_x() {
    let source = cli::scenes::find("cubes").expect("the scene is embedded").source();
    let parsed = scene_format::parse("cubes.sc", &source, &EmbeddedFiles);
    let assembled = render::assemble(&parsed.scene, &Modules::default(), &Lighting::default(), &EmbeddedFiles);
    let scene = assembled.map(|assembled| assembled.scene).unwrap_or_else(|said| panic!("{said:#?}"));
    // Sides and diameters of 2, gaps of 0.5: from -6 to 6.
    let expected = [-6.0, -4.0, -3.5, -1.5, -1.0, 1.0, 1.5, 3.5, 4.0, 6.0];
    // A little beside the axis, since the axis lies in an edge between two triangles. The spheres are 1e-4 narrower there.
    let met = met_along_x(&scene, 0.01, 0.005);
    assert_eq!(met.len(), expected.len(), "{met:?}");
    for (met, expected) in met.iter().zip(expected) {
        assert!((met - expected).abs() < 1e-3, "{met} is not {expected}");
    }
}

#[test]
fn what_is_not_supported_is_skipped_with_a_warning_and_the_rest_is_rendered() {
    let text = look([0.0, -5.0, 0.0], [0.0; 3])
        + "gi { type ambocc bright 1 1 1 dark 0 0 0 samples 4 maxdist 1 }
           photons { caustics 1000 kd 10 0.5 }
           modifier { name bumps type bump texture a.png scale 1 }
           light { type ibl2 image a.hdr { nested } }
           object { shader white type klein-bottle twist 3 }
           shader { name fur type fur length 4 }
           wormhole { throat 2 }"
        + WHITE
        + "object { shader white type sphere c 0 0 0 r 1 }";
    let parsed = scene_format::parse("test.sc", &text, &NoFiles);
    assert!(parsed.diagnostics.len() >= 6, "{:#?}", parsed.diagnostics);
    assert!(parsed.diagnostics.iter().all(|diagnostic| diagnostic.severity == Severity::Warning));
    let lighting = Lighting { ambient: 1.0, ..Lighting::default() };
    let assembled = render::assemble(&parsed.scene, &Modules::default(), &lighting, &NoFiles).ok().unwrap();
    let film = render::render(&assembled.scene, &assembled.settings, &|_| std::ops::ControlFlow::Continue(()));
    assert_eq!(film.unwrap().pixels[0], shading::Color::WHITE);
}
