use crate::report::Failure;

/// What Cargo, Rust or this program calls something else.
const TAKEN: [&str; 15] = [
    "accel",
    "cli",
    "geometry",
    "glam",
    "render",
    "scene-format",
    "shading",
    "core",
    "std",
    "alloc",
    "test",
    "self",
    "crate",
    "super",
    "girasol",
];

/// Words of Rust that a crate cannot be called.
const KEYWORDS: [&str; 36] = [
    "as", "async", "await", "break", "const", "continue", "dyn", "else", "enum", "extern", "false", "fn", "for", "if",
    "impl", "in", "let", "loop", "match", "mod", "move", "mut", "pub", "ref", "return", "static", "struct", "trait",
    "true", "type", "unsafe", "use", "where", "while", "box", "try",
];

/// Whether a crate can be called so: lower-case letters, digits, `-` and `_`, a letter first, and not what something else is called.
pub(crate) fn check_name(name: &str) -> Result<(), Failure> {
    let letters = name.starts_with(|letter: char| letter.is_ascii_lowercase())
        && name.chars().all(|letter| letter.is_ascii_lowercase() || letter.is_ascii_digit() || "-_".contains(letter));
    if !letters {
        Err(Failure::new(format!("a crate cannot be called `{name}`"))
            .help("lower-case letters, digits, `-` and `_`, with a letter first, as in my-octree"))
    } else if KEYWORDS.contains(&name) || TAKEN.contains(&name.replace('_', "-").as_str()) {
        Err(Failure::new(format!("`{name}` is something else already")).help(format!("as in my-{name}")))
    } else {
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_that_cargo_would_turn_down_are_turned_down() {
        for name in ["my-octree", "o", "sphere_2"] {
            assert!(check_name(name).is_ok(), "{name}");
        }
        for name in ["", "2nd", "My-octree", "my octree", "../x", "fn", "std", "scene_format", "ö"] {
            assert!(check_name(name).is_err(), "{name}");
        }
    }
}
