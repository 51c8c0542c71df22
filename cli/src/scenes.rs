//! The scenes that the program carries with it: the assignment's, and one for each picture of the report.
//!
//! Small ones are `.sc` files in the folder `scenes`; what has thousands of triangles is computed, and so are the textures.
//! A scene is the same text on every machine. In all of them lengths are free units and angles degrees; +Z is up, but for the
//! two views of figures 1 and 2, whose cameras the report names, with +Y up.

mod chain_link;
mod grid;
mod implicit;
mod mesh;
mod noise;
mod rabbit;
mod scales;
mod textures;
mod water_tower;

use scene_format::{FileError, Files};
use std::borrow::Cow;

/// A scene that needs no file.
pub struct EmbeddedScene {
    /// What it is called on the command line: lower case, words joined by `-`.
    pub name: &'static str,
    /// What it shows, and which part of the report it illustrates; a line without a final stop.
    pub summary: &'static str,
    /// Whether it is meant to be rendered with soft shadows, which a `.sc` file cannot say.
    pub soft_shadows: bool,
    source: Source,
}

enum Source {
    /// One after another; scenes that differ in a block only share the rest.
    Texts(&'static [&'static str]),
    Computed(fn() -> String),
}

impl EmbeddedScene {
    /// The scene's `.sc` text. It includes no other file; its textures are [`EmbeddedFiles`].
    pub fn source(&self) -> Cow<'static, str> {
        match self.source {
            Source::Texts([text]) => Cow::Borrowed(text),
            Source::Texts(texts) => Cow::Owned(texts.concat()),
            Source::Computed(compute) => Cow::Owned(compute()),
        }
    }
}

/// All of them, from the first assignment to the whole renderer.
pub fn all() -> &'static [EmbeddedScene] {
    SCENES
}

/// The scene of that name.
pub fn find(name: &str) -> Option<&'static EmbeddedScene> {
    SCENES.iter().find(|scene| scene.name == name)
}

/// The textures of the embedded scenes, as PNG files that are computed when they are read.
#[derive(Clone, Copy, Debug, Default)]
pub struct EmbeddedFiles;

impl Files for EmbeddedFiles {
    fn read(&self, path: &str) -> Result<Vec<u8>, FileError> {
        let texture = textures::TEXTURES.iter().find(|texture| texture.name == path);
        texture.map(textures::Texture::png).ok_or(FileError::NotFound)
    }
}

/// The names that [`EmbeddedFiles`] has a file for.
pub fn texture_names() -> &'static [&'static str] {
    const { &names() }
}

const fn names() -> [&'static str; textures::TEXTURES.len()] {
    let mut names = [""; textures::TEXTURES.len()];
    let mut i = 0;
    while i < names.len() {
        names[i] = textures::TEXTURES[i].name;
        i += 1;
    }
    names
}

const fn scene(name: &'static str, summary: &'static str, source: Source) -> EmbeddedScene {
    EmbeddedScene { name, summary, soft_shadows: false, source }
}

/// The texts of files in the folder `scenes`, in their order.
macro_rules! texts {
    ($($file:literal),+) => { Source::Texts(&[$(include_str!(concat!("../scenes/", $file))),+]) };
}

const SCENES: &[EmbeddedScene] = &[
    scene("pyramid", "a pyramid with a sphere on its tip: the assignment's first scene", texts!["pyramid.sc"]),
    scene(
        "spheres64",
        "64 spheres in a 4 x 4 x 4 grid: the assignment's second scene",
        Source::Computed(grid::spheres),
    ),
    scene("cubes", "three cubes and two spheres in a row: the assignment's third scene", texts!["cubes.sc"]),
    scene(
        "camera-front",
        "three axes of spheres from (0, 0, 20): figure 1",
        texts!["camera-front.sc", "camera-common.sc"],
    ),
    scene("camera-side", "the same scene from (10, 10, 20): figure 2", texts!["camera-side.sc", "camera-common.sc"]),
    scene("worlds-dark", "64 globes without a light, only ambient: figure 3", Source::Computed(grid::worlds_dark)),
    scene("worlds", "the same globes under three lights: figure 4", Source::Computed(grid::worlds_lit)),
    scene(
        "ellipsoids",
        "spheres scaled unevenly, turned and sheared: transforms, section 2.3",
        texts!["ellipsoids.sc"],
    ),
    scene("textures", "cubes, planes and meshes with textures: sections 2.3.2 to 2.3.5", texts!["textures.sc"]),
    scene("watertower", "a water tower of 13,000 triangles: meshes, figure 5", Source::Computed(water_tower::scene)),
    scene("chainlink", "a fence woven of 80,000 triangles: meshes, figure 6", Source::Computed(chain_link::scene)),
    scene("organic", "a rabbit of 70,000 triangles: the octree, sections 4.1 and 5", Source::Computed(rabbit::scene)),
    scene("aliasing-off", "one ray a pixel: figure 7, jagged", texts!["aliasing-off.sc", "aliasing-common.sc"]),
    scene(
        "aliasing-on",
        "4 x 4 zones a pixel, 4 rays each: figure 7, smooth",
        texts!["aliasing-on.sc", "aliasing-common.sc"],
    ),
    EmbeddedScene {
        soft_shadows: true,
        ..scene(
            "shadows-soft",
            "a lamp's light as a cluster of lights: figure 9",
            texts!["shadows-soft.sc", "shadows-common.sc"],
        )
    },
    scene("shadows-hard", "the same lamp as a single point: figure 10", texts!["shadows-hard.sc", "shadows-common.sc"]),
    scene("globe", "a planet on a slanted axis, with a highlight: phong, figure 11", texts!["globe.sc"]),
    scene("glass-mirror", "glass and mirror spheres in a corner of three planes: figure 12", texts!["glass-mirror.sc"]),
    scene("depth-of-field", "a thin lens with six sides: cameras, section 2.1", texts!["depth-of-field.sc"]),
    scene(
        "scales",
        "a still life at four sizes, 1 to a billion: hard for naive kernels",
        Source::Computed(scales::scene),
    ),
    scene("marbles", "marbles of glass, metal and paint on a wooden tray: all at once", texts!["marbles.sc"]),
];

#[cfg(test)]
mod tests {
    use super::*;
    use std::collections::{BTreeSet, HashMap};

    /// The words of a scene's text, without its comments.
    fn words(source: &str) -> impl Iterator<Item = &str> {
        source.lines().flat_map(|line| line.split_whitespace().take_while(|word| !word.starts_with('%')))
    }

    /// The `count * width` numbers behind the word `heading`, in rows of `width`.
    fn rows<T: std::str::FromStr>(source: &str, heading: &str, width: usize) -> Vec<Vec<T>> {
        let mut words = words(source).skip_while(|word| *word != heading).skip(1);
        let count: usize = words.next().unwrap().parse().unwrap();
        let numbers: Vec<&str> = words.take(count * width).collect();
        numbers.chunks(width).map(|row| row.iter().map(|number| number.parse().ok().unwrap()).collect()).collect()
    }

    #[test]
    fn every_name_is_unique_and_found() {
        let names: BTreeSet<_> = all().iter().map(|scene| scene.name).collect();
        assert_eq!(names.len(), all().len());
        assert!(names.iter().all(|name| find(name).is_some_and(|scene| scene.name == *name)));
        assert!(find("no-such-scene").is_none());
    }

    #[test]
    fn every_summary_is_one_short_line() {
        for scene in all() {
            assert!(scene.summary.len() < 90 && !scene.summary.contains('\n'), "{}", scene.name);
        }
    }

    #[test]
    fn every_scene_begins_with_a_comment_on_what_it_shows() {
        for scene in all() {
            assert!(scene.source().starts_with("% "), "{}", scene.name);
        }
    }

    #[test]
    fn every_texture_that_a_scene_names_is_a_picture() {
        for scene in all() {
            let source = scene.source();
            for name in words(&source).map(|word| word.trim_matches('"')).filter(|word| word.ends_with(".png")) {
                assert!(texture_names().contains(&name), "{}: {name}", scene.name);
            }
        }
        for name in texture_names() {
            let bytes = EmbeddedFiles.read(name).unwrap();
            assert!(image::load_from_memory(&bytes).unwrap().width() >= 512, "{name}");
        }
        assert_eq!(EmbeddedFiles.read("absent.png"), Err(FileError::NotFound));
    }

    #[test]
    fn every_shader_that_an_object_names_was_declared_before_it() {
        for scene in all() {
            let source = scene.source();
            let mut declared = BTreeSet::new();
            let mut before = ["", "", ""];
            for word in words(&source) {
                match before {
                    ["shader", "{", "name"] => drop(declared.insert(word.to_owned())),
                    [_, _, "shader"] if word != "{" => assert!(declared.contains(word), "{}: {word}", scene.name),
                    _ => {}
                }
                before = [before[1], before[2], word];
            }
        }
    }

    #[test]
    fn no_two_things_in_a_scene_share_a_name() {
        for scene in all() {
            let source = scene.source();
            let mut names = BTreeSet::new();
            let mut all = words(&source);
            while let Some(word) = all.next() {
                if word == "name" {
                    let name = all.next().unwrap();
                    assert!(names.insert(name.to_owned()), "{}: {name}", scene.name);
                }
            }
        }
    }

    #[test]
    fn every_triangle_of_a_mesh_names_points_that_exist() {
        for scene in [water_tower::scene(), chain_link::scene()] {
            for object in scene.split("object {").filter(|object| words(object).any(|word| word == "generic-mesh")) {
                let points: Vec<Vec<f32>> = rows(object, "points", 3);
                let triangles: Vec<Vec<usize>> = rows(object, "triangles", 3);
                assert!(triangles.iter().flatten().all(|&i| i < points.len()));
            }
        }
    }

    #[test]
    fn the_fence_has_about_as_many_triangles_as_the_course_s_own() {
        let wires: Vec<Vec<u32>> = rows(&chain_link::scene(), "triangles", 3);
        assert!((70_000..90_000).contains(&wires.len()), "{}", wires.len());
    }

    #[test]
    fn the_rabbit_is_closed() {
        let triangles: Vec<Vec<u32>> = rows(&rabbit::scene(), "triangles", 3);
        assert!((60_000..80_000).contains(&triangles.len()), "{}", triangles.len());
        let mut edges = HashMap::new();
        for t in &triangles {
            for edge in [(t[0], t[1]), (t[1], t[2]), (t[2], t[0])] {
                *edges.entry(edge).or_insert(0) += 1;
            }
        }
        // Each edge is used once in each direction, so that two triangles meet there and look to the same side.
        assert!(edges.iter().all(|(&(a, b), &uses)| uses == 1 && edges.get(&(b, a)) == Some(&1)));
    }

    #[test]
    fn the_rabbit_has_no_degenerate_triangle() {
        let source = rabbit::scene();
        let points: Vec<Vec<f32>> = rows(&source, "points", 3);
        let points: Vec<_> = points.iter().map(|p| glam::DVec3::new(p[0].into(), p[1].into(), p[2].into())).collect();
        for t in rows::<usize>(&source, "triangles", 3) {
            let [a, b, c] = [points[t[0]], points[t[1]], points[t[2]]];
            // The shortest edges are some 0.03 x 0.06 long, far more than the last decimal that is written.
            assert!((b - a).cross(c - a).length() > 1e-7, "{a} {b} {c}");
        }
    }

    #[test]
    fn the_rabbit_s_normals_look_outward() {
        let source = rabbit::scene();
        let points: Vec<Vec<f64>> = rows(&source, "points", 3);
        let normals: Vec<f64> =
            words(&source).skip_while(|word| *word != "normals").skip(2).map_while(|word| word.parse().ok()).collect();
        assert_eq!(normals.len(), 3 * points.len());
        let point = |i: usize| glam::DVec3::from_slice(&points[i]);
        // The mean of the triangles around a point, by area: in a sharp fold a single one may look another way.
        let mut facing = vec![glam::DVec3::ZERO; points.len()];
        for t in rows::<usize>(&source, "triangles", 3) {
            let around = (point(t[1]) - point(t[0])).cross(point(t[2]) - point(t[0]));
            t.iter().for_each(|&i| facing[i] += around);
        }
        for (i, facing) in facing.iter().enumerate() {
            assert!(glam::DVec3::from_slice(&normals[3 * i..]).dot(*facing) > 0.0, "point {i}: {}", point(i));
        }
    }
}
