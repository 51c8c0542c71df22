//! The picture has the same bits on every machine: it is made of operations whose bits are fixed.

use crate::crates;
use crate::sources::code_only;

/// Functions of numbers whose bits std leaves to the machine or its C library, as methods and by path. Those of the crate `libm` have the
/// same bits everywhere. (`sqrt`, `rem_euclid`, `to_radians` are exact or one rounding; `min` and `max` may give either sign of zero, which
/// nothing here makes a difference of.)
const MACHINE_S_FUNCTIONS: [&str; 26] = [
    "sin", "cos", "tan", "sin_cos", "asin", "acos", "atan", "atan2", "sinh", "cosh", "tanh", "asinh", "acosh", "atanh",
    "exp", "exp2", "exp_m1", "ln", "ln_1p", "log", "log2", "log10", "powf", "powi", "hypot", "cbrt",
];

/// glam's types with SIMD inside, and their products: another instruction set, other bits. And std's fused multiply-add, which rounds
/// once where the formula rounds twice.
const MACHINE_S_TYPES: [&str; 12] = [
    "Vec3A", "Vec4", "Quat", "DQuat", "Mat2", "Mat3A", "Mat4", "Affine2", "Affine3A", "DAffine2", "DAffine3", "mul_add",
];

#[test]
fn pictures_are_made_of_operations_whose_bits_do_not_depend_on_the_machine() {
    let mut found = Vec::new();
    for package in crates().iter().filter(|package| package.name != "tests") {
        for (path, text) in package.sources() {
            // Of cli only the scenes have a part in pictures; what the laws of the conformance kits compute has none.
            let names = path.to_string_lossy().replace('\\', "/");
            let is_scene = names.contains("/src/scenes");
            if (package.name == "cli" && !is_scene) || names.contains("conformance") || names.ends_with("/laws.rs") {
                continue;
            }
            found.extend(machine_s_operations(&text).into_iter().map(|name| format!("{}: {name}", path.display())));
        }
    }
    assert!(found.is_empty(), "{found:#?}");
}

/// The names of such operations in a source text, its tests left out: these stand last in a file.
fn machine_s_operations(text: &str) -> Vec<&'static str> {
    let code = code_only(text);
    let code = code.split("#[cfg(test)]").next().unwrap_or_default();
    // A space may stand wherever the formatter breaks a line.
    let code: String = code.split_whitespace().collect::<Vec<_>>().join(" ").replace(" .", ".").replace(" (", "(");
    let is_called = |name: &&&str| {
        ["f32::", "f64::", "."].iter().any(|before| {
            let call = format!("{before}{name}");
            code.match_indices(&call).any(|(at, _)| {
                let after = &code[at + call.len()..];
                // `f64::sin` may also be named without a call.
                after.starts_with('(') || (*before != "." && !after.starts_with(is_part_of_a_name))
            })
        })
    };
    let is_named = |name: &&&str| code.split(|letter| !is_part_of_a_name(letter)).any(|word| word == **name);
    let functions = MACHINE_S_FUNCTIONS.iter().filter(is_called);
    functions.chain(MACHINE_S_TYPES.iter().filter(is_named)).copied().collect()
}

fn is_part_of_a_name(letter: char) -> bool {
    letter.is_alphanumeric() || letter == '_'
}

#[test]
fn the_search_for_machine_s_operations_finds_each_and_nothing_else() {
    let found = |text: &str| machine_s_operations(text);
    assert_eq!(found("fn f(x: f64) -> f64 { x.sin() + x.powi(2) }"), ["sin", "powi"]);
    assert_eq!(found("fn f() { map(f32::exp); f64::ln(2.0); }"), ["exp", "ln"]);
    assert_eq!(found("fn f() { x\n    .atan2\n    (y) }"), ["atan2"]);
    assert_eq!(found("use glam::{Quat, Vec3}; fn f() { a.mul_add(b, c) }"), ["Quat", "mul_add"]);
    assert_eq!(
        found(
            "// x.sin()\nfn f() { libm::sin(x); x.sqrt(); x.exponent(); s.log; Vec3::X; } #[cfg(test)] mod tests { x.sin() }"
        ),
        Vec::<&str>::new()
    );
}
