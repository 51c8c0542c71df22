//! The image is a function of the scene and the settings alone.

use std::num::NonZeroUsize;

use accel::Accelerator;
use cli::scenes::{self, EmbeddedFiles};
use geometry::{Hit, Interval, Primitives, Ray, Surface};
use glam::{DVec2, Vec3};
use render::{
    Allotment, Assembled, Buckets, Camera, Crop, Film, Lighting, Modules, Settings, Shaders, View, camera, render,
};
use scene_format::scene_file::BucketOrder;
use shading::{Bounces, Color, LazySurface, LightFormula, Shader, ShadingPoint, SoftShadows};
use tests::Rendering;

/// A textured one with meshes, one of glass and mirrors, one with depth of field, one with soft shadows.
const SCENES: [&str; 4] = ["textures", "glass-mirror", "depth-of-field", "shadows-soft"];

fn assembled(name: &str, modules: Modules) -> Assembled {
    let scene = scenes::find(name).expect("the scene is embedded");
    let soft_shadows = scene.soft_shadows.then(SoftShadows::default);
    let lighting = Lighting { soft_shadows, ..Lighting::default() };
    Rendering { text: scene.source().into_owned(), files: EmbeddedFiles, modules, lighting }.assemble()
}

/// A small picture with two rays in each of 2 x 2 zones.
fn small(settings: &Settings) -> Settings {
    Settings { size: [40, 30], aa: 1, samples: 2, ..settings.clone() }
}

/// The same; one with two to sixteen rays a pixel; and one whose edges cut squares of pixels, with three rays each.
fn all(settings: &Settings) -> [Settings; 3] {
    [
        small(settings),
        Settings { allotment: Allotment::Adaptive, least_aa: 0, samples: 1, aa: 2, ..small(settings) },
        Settings { size: [37, 29], aa: 0, samples: 3, ..small(settings) },
    ]
}

fn film(assembled: &Assembled, settings: &Settings) -> Film {
    render(&assembled.scene, settings, &|_| std::ops::ControlFlow::Continue(())).expect("nothing breaks it off")
}

/// The first pixel that differs in any bit, for the message.
fn difference(one: &Film, other: &Film) -> Option<String> {
    let bits =
        |film: &Film| -> Vec<[u32; 3]> { film.pixels.iter().map(|pixel| pixel.to_array().map(f32::to_bits)).collect() };
    let (one_bits, other_bits) = (bits(one), bits(other));
    assert_eq!((one.width, one.height), (other.width, other.height));
    let at = one_bits.iter().zip(&other_bits).position(|(one, other)| one != other)?;
    let (x, y) = (at as u32 % one.width, at as u32 / one.width);
    Some(format!("pixel ({x}, {y}): {:?} and {:?}", one.pixels[at], other.pixels[at]))
}

#[track_caller]
fn assert_same(name: &str, what: &str, one: &Film, other: &Film) {
    assert_eq!(difference(one, other), None, "{name}, {what}");
    assert_eq!(one.rays, other.rays, "{name}, {what}");
}

#[test]
fn any_number_of_threads_gives_the_same_bits() {
    for name in SCENES {
        let assembled = assembled(name, Modules::default());
        for settings in all(&assembled.settings) {
            let with = |threads| Settings { threads: NonZeroUsize::new(threads), ..settings.clone() };
            let one = film(&assembled, &with(1));
            for threads in [2, 5] {
                assert_same(name, &format!("{threads} threads"), &one, &film(&assembled, &with(threads)));
            }
        }
    }
}

/// A camera that makes a ray too many of each lot.
struct OneMore(Box<dyn Camera>);

impl Camera for OneMore {
    fn ray(&self, film: DVec2, lens: &dyn Fn() -> DVec2) -> Ray {
        self.0.ray(film, lens)
    }

    fn rays(&self, films: &[DVec2], lens: &dyn Fn(usize) -> DVec2, rays: &mut Vec<Ray>) {
        self.0.rays(films, lens, rays);
        rays.push(Ray::new(Vec3::ZERO, Vec3::X));
    }

    fn has_lens(&self) -> bool {
        self.0.has_lens()
    }
}

#[test]
fn a_camera_that_makes_more_rays_than_asked_for_gives_the_same_bits() {
    let one_more = |view: &View| Some(Box::new(OneMore(camera(view)?)) as Box<dyn Camera>);
    for name in ["textures", "depth-of-field"] {
        let right = assembled(name, Modules::default());
        let more = assembled(name, Modules { camera: one_more, ..Modules::default() });
        let settings = small(&right.settings);
        assert_same(name, "a ray too many", &film(&right, &settings), &film(&more, &settings));
    }
}

#[test]
fn any_bucket_size_gives_the_same_bits() {
    for name in SCENES {
        let assembled = assembled(name, Modules::default());
        for settings in all(&assembled.settings) {
            let usual = film(&assembled, &settings);
            for size in [1, 7, 16, 64, 1000] {
                let buckets = Buckets { size, ..settings.buckets };
                let other = film(&assembled, &Settings { buckets, ..settings.clone() });
                assert_same(name, &format!("buckets of {size}"), &usual, &other);
            }
        }
    }
}

/// An accelerator as a student writes it first: of many rays at once it knows nothing.
struct OneByOne(Box<dyn Accelerator>);

impl Accelerator for OneByOne {
    fn closest(&self, ray: &Ray, within: Interval) -> Option<Hit> {
        self.0.closest(ray, within)
    }

    fn any(&self, ray: &Ray, within: Interval) -> bool {
        self.0.any(ray, within)
    }
}

/// As [`Modules::accelerator`].
type Build = fn(Primitives) -> Box<dyn Accelerator>;

#[test]
fn every_accelerator_gives_the_same_bits() {
    let others: [(&str, Build); 3] = [
        ("none", accel::none),
        ("octree", accel::octree),
        ("one ray at a time", |primitives| Box::new(OneByOne(accel::wide(primitives)))),
    ];
    for name in SCENES {
        let usual = assembled(name, Modules::default());
        for settings in all(&usual.settings) {
            let expected = film(&usual, &settings);
            for (accelerator, build) in others {
                let other = assembled(name, Modules { accelerator: build, ..Modules::default() });
                assert_same(name, accelerator, &expected, &film(&other, &settings));
            }
        }
    }
}

/// What a shader does with the point that it is given, before it asks for light.
type Change = for<'a> fn(&ShadingPoint<'a>, &dyn Fn(&ShadingPoint<'_>) -> Color) -> Color;

/// A matt surface that says, or does not say, that it asks for light.
struct Asking {
    matt: shading::Constant,
    change: Change,
    says_so: bool,
}

impl Shader for Asking {
    fn radiance(&self, at: &ShadingPoint<'_>) -> Color {
        (self.change)(at, &|at| self.matt.radiance(at))
    }

    fn asks_lights(&self) -> Option<LightFormula> {
        self.says_so.then_some(LightFormula::Report)
    }
}

fn saying_so<const INDEX: usize>(color: Color) -> Box<dyn Shader> {
    Box::new(Asking { matt: shading::Constant { color }, change: CHANGES[INDEX].1, says_so: true })
}

fn saying_nothing<const INDEX: usize>(color: Color) -> Box<dyn Shader> {
    Box::new(Asking { matt: shading::Constant { color }, change: CHANGES[INDEX].1, says_so: false })
}

const CHANGES: [(&str, Change); 8] = [
    ("nothing", |at, light| light(at)),
    ("asks twice", |at, light| light(at) + light(at)),
    ("asks never", |at, _| Color::grey(at.distance)),
    ("another surface", |at, light| {
        let surface =
            Surface { shading_normal: (at.surface.shading_normal + 0.3 * Vec3::X).normalize(), ..*at.surface };
        light(&ShadingPoint { surface: LazySurface::Known(&surface), ..*at })
    }),
    ("the other side", |at, light| light(&ShadingPoint { direction: -at.direction, ..*at })),
    ("another path", |at, light| light(&ShadingPoint { bounces: Bounces { path: 9, ..at.bounces }, ..*at })),
    ("another origin", |at, light| light(&ShadingPoint { ray_origin: |surface, _| surface.position, ..*at })),
    ("another formula", |at, _| at.lit_by(LightFormula::Sunflow).map(|light| light.color).sum()),
];

/// The same picture, and as many rays counted, whether the shader says so or not.
fn hinted<const INDEX: usize>() {
    let named = |constant| Modules { shaders: Shaders { constant, ..Shaders::default() }, ..Modules::default() };
    let [with, without] =
        [saying_so::<INDEX>, saying_nothing::<INDEX>].map(|shader| assembled("shadows-soft", named(shader)));
    for settings in all(&with.settings) {
        assert_same("shadows-soft", CHANGES[INDEX].0, &film(&without, &settings), &film(&with, &settings));
    }
}

#[test]
fn a_shader_that_says_what_it_asks_gives_the_same_bits_whatever_it_asks() {
    hinted::<0>();
    hinted::<1>();
    hinted::<2>();
    hinted::<3>();
    hinted::<4>();
    hinted::<5>();
    hinted::<6>();
    hinted::<7>();
}

/// A shader of Sunflow's that does not say how it asks for lights.
struct Silent(Box<dyn Shader>);

impl Shader for Silent {
    fn radiance(&self, at: &ShadingPoint<'_>) -> Color {
        self.0.radiance(at)
    }
}

#[test]
fn lighting_by_sunflow_has_the_same_bits_whether_its_shaders_say_what_they_ask() {
    let with = Modules::default().lit_as_by_sunflow();
    let phong: fn(_, _, _) -> Box<dyn Shader> =
        |diffuse, specular, exponent| Box::new(Silent((Shaders::sunflow().phong)(diffuse, specular, exponent)));
    let without = Modules { shaders: Shaders { phong, ..with.shaders }, ..with };
    let [with, without] = [with, without].map(|modules| assembled("spheres64", modules));
    for settings in all(&with.settings) {
        assert_same("spheres64", "lit by Sunflow", &film(&without, &settings), &film(&with, &settings));
    }
}

#[test]
fn any_bucket_order_gives_the_same_bits() {
    for name in SCENES {
        let assembled = assembled(name, Modules::default());
        let usual = film(&assembled, &small(&assembled.settings));
        for (order, reversed) in BucketOrder::ALL.into_iter().flat_map(|order| [(order, false), (order, true)]) {
            let buckets = Buckets { size: 8, order, reversed };
            let other = film(&assembled, &Settings { buckets, ..small(&assembled.settings) });
            assert_same(name, &format!("{order:?}, reversed: {reversed}"), &usual, &other);
        }
    }
}

#[test]
fn every_embedded_scene_has_the_same_bits_without_the_octree() {
    for scene in scenes::all() {
        let with = assembled(scene.name, Modules::default());
        let without = assembled(scene.name, Modules { accelerator: accel::none, ..Modules::default() });
        // Some 10^8 tests of a ray and a primitive, at most.
        let primitives = with.scene.inventory(&with.settings).bounded.total();
        let size = match primitives {
            0..1_000 => [48, 36],
            1_000..20_000 => [20, 15],
            _ => [12, 9],
        };
        let settings = Settings { size, aa: 0, samples: 1, ..with.settings.clone() };
        assert_same(scene.name, "without the octree", &film(&with, &settings), &film(&without, &settings));
    }
}

#[test]
fn a_crop_has_the_bits_of_the_same_part_of_the_whole() {
    for name in SCENES {
        let assembled = assembled(name, Modules::default());
        for settings in all(&assembled.settings) {
            let whole = film(&assembled, &settings);
            for crop in [Crop { x: 0, y: 0, width: 1, height: 1 }, Crop { x: 11, y: 7, width: 17, height: 13 }] {
                let part = film(&assembled, &Settings { crop: Some(crop), ..settings.clone() });
                let rows = whole.pixels.chunks(whole.width as usize).skip(crop.y as usize).take(crop.height as usize);
                let columns = crop.x as usize..(crop.x + crop.width) as usize;
                let pixels = rows.flat_map(|row| &row[columns.clone()]).copied().collect();
                let expected =
                    Film { width: crop.width, height: crop.height, pixels, rays: part.rays, lost: part.lost.clone() };
                assert_same(name, &format!("{crop:?}"), &part, &expected);
            }
        }
    }
}

#[test]
fn the_same_rendering_twice_gives_the_same_bits() {
    for name in SCENES {
        let once = assembled(name, Modules::default());
        let again = assembled(name, Modules::default());
        assert_same(name, "again", &film(&once, &small(&once.settings)), &film(&again, &small(&again.settings)));
    }
}

#[test]
fn another_seed_gives_another_image() {
    for name in SCENES {
        let assembled = assembled(name, Modules::default());
        let with = |seed| film(&assembled, &Settings { seed, ..small(&assembled.settings) });
        assert!(difference(&with(0), &with(1)).is_some(), "{name}");
    }
}
