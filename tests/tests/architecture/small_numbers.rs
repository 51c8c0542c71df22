//! No epsilon is scattered in the code. Every small number in it is named here, with the reason why it is not one: an error bound that
//! is derived beside it, or a number that has nothing to do with rounding.

use crate::sources::{code_only, numbers, without_tests};
use crate::{crates, root};

/// Numbers from here on to 1 are too coarse to stand for rounding.
const SMALL: f64 = 1e-2;

/// File, number as it is written, and why it stands there.
const EXCEPTIONS: &[(&str, &str, &str)] = &[
    ("geometry/src/rounding.rs", "EPSILON", "the unit roundoff itself, in which the bounds are counted"),
    ("geometry/src/surface.rs", "1.0 / (1 << 48)", "the f64 steps behind a hit point, in its error bound"),
    (
        "geometry/src/surface.rs",
        "MIN_POSITIVE",
        "a point at the origin of space has no error, and is left all the same",
    ),
    (
        "geometry/src/sphere.rs",
        "1.0 / (1 << 50)",
        "more than what f64 rounds off of a power: above it, its sign is certain",
    ),
    ("geometry/src/ellipsoid.rs", "EPSILON", "f64's own rounding of the lengths that make the box"),
    (
        "geometry/src/aabb.rs",
        "MIN_POSITIVE",
        "what underflows in a box test, and the least component that has a reciprocal",
    ),
    (
        "geometry/src/aabb.rs",
        "1.0 / (1 << 100)",
        "the share of a direction that stands for 0: its turn is less than the slack",
    ),
    ("geometry/src/aabb.rs", "1.0 / (1 << 64)", "directions so short that no smaller share of them has a reciprocal"),
    (
        "geometry/src/triangle_probe.rs",
        "1.0 / (1 << 20)",
        "from which angle on a triangle is taken for edge-on, and asked the exact way",
    ),
    (
        "geometry/src/triangle_probe.rs",
        "1.0 / (1 << 44)",
        "the slack of a box in f64, more than its rounding and less than f32's",
    ),
    ("accel/src/octree/build.rs", "EPSILON", "how near to a cell counts as in it: its rounding, and more"),
    ("accel/src/wide/boxes.rs", "EPSILON", "the slack of a box test"),
    ("accel/src/wide/boxes.rs", "1.0 / (1 << 48)", "the share of a direction that stands for 0"),
    ("accel/src/wide/triangles.rs", "EPSILON", "the unit roundoff, in the bound of a filter: the exact test follows"),
    ("accel/src/wide/triangles.rs", "1.0 / (1 << 120)", "what underflows in that filter"),
    ("accel/src/wide/morton.rs", "MIN_POSITIVE", "a scene without extent, which is not to be divided by"),
    ("shading/src/sunflow/ray_origin.rs", "0.001", "Sunflow's own epsilon, to be compared with its pictures"),
    (
        "cli/src/commands/parity.rs",
        "0.005",
        "the distance of rays beside a pixel's own, in pixels: how near an edge must pass",
    ),
    ("scene-format/src/print/words.rs", "1e-5", "from where on a number is printed with an exponent"),
    (
        "scene-format/src/number.rs",
        "MIN_POSITIVE",
        "below it `f32` rounds otherwise, and a number is read the exact way",
    ),
    ("cli/src/commands/parity.rs", "0.005", "how far apart rays beside a pixel's own run, in pixels"),
    ("render/src/sampler/sobol.rs", "1.0 / 4_294_967_296.0", "32 bits as a fraction"),
    ("render/src/sampler/random.rs", "1.0 / (1 << 24)", "24 bits as a fraction"),
];

/// Folders and files whose numbers are their own business, and why.
const FOLDERS: &[(&str, &str)] = &[
    ("geometry/src/naive", "kernels with the usual epsilons, to be compared with ours"),
    ("conformance", "inputs for tests: how near a ray passes an edge is what they are about"),
    ("render/src/assemble/spectrum", "units of physics and the CIE's tables"),
    ("cli/src/accuracy", "what is varied and how it is printed, in the figures of error"),
    ("cli/src/scenes", "shapes and colours of the built-in scenes"),
    ("cli/src/accuracy", "how hard cases are, and the ends of diagrams' axes: nothing there is rendered with"),
    ("cli/src/metrics", "constants of published formulas for the differences of pictures"),
];

fn is_in_folder(file: &str) -> bool {
    FOLDERS.iter().any(|(folder, _)| file.contains(&format!("{folder}/")) || file.contains(&format!("{folder}.rs")))
}

#[test]
fn every_small_number_in_the_code_has_its_reason() {
    let mut found = Vec::new();
    for package in crates().iter().filter(|package| package.name != "tests") {
        let sources = package.sources();
        let tests: Vec<_> = sources.iter().flat_map(|(path, text)| without_tests(path, &code_only(text)).1).collect();
        for (path, text) in sources.iter().filter(|(path, _)| !tests.contains(path)) {
            let file = path.strip_prefix(root()).expect("in the workspace").display().to_string();
            let (code, _) = without_tests(path, &code_only(text));
            if !is_in_folder(&file) {
                found.extend(small_numbers(&code).into_iter().map(|number| (file.clone(), number)));
            }
        }
    }
    let is_excepted = |(file, number): &&(String, String)| {
        EXCEPTIONS.iter().any(|(in_file, excepted, _)| file == in_file && number == excepted)
    };
    let unexplained: Vec<_> = found.iter().filter(|found| !is_excepted(found)).collect();
    assert!(unexplained.is_empty(), "an epsilon? If not, name it in EXCEPTIONS: {unexplained:#?}");
    for (file, number, _) in EXCEPTIONS {
        let still_there = found.iter().any(|(in_file, found)| in_file == file && found == number);
        assert!(still_there, "{file} has no {number} any more");
    }
}

/// Numbers below [`SMALL`], the reciprocals of such large ones, powers of two and ten with a minus, and what calls itself an epsilon.
fn small_numbers(code: &str) -> Vec<String> {
    let mut found = Vec::new();
    for (number, written, before) in numbers(code) {
        if 0.0 < number && number < SMALL {
            found.push(written);
        } else if number > 1.0 / SMALL && before.ends_with("1.0/") {
            found.push(format!("1.0 / {written}"));
        }
    }
    let tight: String = code.split_whitespace().collect();
    for name in ["EPSILON", "MIN_POSITIVE", "exp2(-", "powi(-", "powf(-", "from_bits(0"] {
        found.extend(tight.matches(name).map(str::to_owned));
    }
    // 1.0 / (1_u64 << 48) as f32, 1.0 / f64::from(1 << 24)
    for (at, _) in tight.match_indices("1.0/") {
        let divisor = tight[at + 4..].split([';', ',', '}', '*']).next().unwrap_or_default();
        if let Some((_, by)) = divisor.split_once("<<") {
            let by: String = by.chars().take_while(char::is_ascii_digit).collect();
            found.push(format!("1.0 / (1 << {by})"));
        }
    }
    found
}

#[test]
fn the_search_finds_every_way_to_write_a_small_number() {
    for (code, written) in [
        ("t > 1e-4", "1e-4"),
        ("let x = 0.000_1_f32;", "0.000_1_f32"),
        ("const A: f32 = 5.0E-3f32;", "5.0E-3f32"),
        ("x < 9.99e-3", "9.99e-3"),
        ("a * f32::EPSILON", "EPSILON"),
        ("a < MY_EPSILON", "EPSILON"),
        ("f64::MIN_POSITIVE", "MIN_POSITIVE"),
        ("f32::exp2(-20.0)", "exp2(-"),
        ("10_f32.powi( -5)", "powi(-"),
        ("f32::from_bits(0x3456)", "from_bits(0"),
        ("1.0 / 4_096.0", "1.0 / 4_096.0"),
        ("1.0 / (1_u64 << 48) as f32", "1.0 / (1 << 48)"),
        ("x * (1.0 / f64::from(1 << 24))", "1.0 / (1 << 24)"),
    ] {
        assert_eq!(small_numbers(code), [written], "{code}");
    }
}

#[test]
fn the_search_lets_pass_what_is_not_small() {
    for code in [
        "0.0",
        "0..5",
        "0.01",
        "a.0.1",
        "x1e-4",
        "1..=3",
        "tuple.0 / 255.0",
        "0x1e",
        "1e4",
        "v[0].abs()",
        "1_u64 << 48",
    ] {
        assert_eq!(small_numbers(code), Vec::<String>::new(), "{code}");
    }
}
