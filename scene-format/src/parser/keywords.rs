//! The words that begin a statement, and the search for the one that was meant.

/// Statements that are a keyword and a block in braces.
pub(super) const BLOCKS: &[&str] = &[
    "image",
    "trace-depths",
    "background",
    "camera",
    "shader",
    "object",
    "instance",
    "light",
    "modifier",
    "gi",
    "photons",
    "lightserver",
];

/// Statements that are a keyword and a few words, where no block has a field of that name.
pub(super) const LINES: &[&str] = &["bucket", "texturepath", "includepath", "include", "override"];

/// All statements.
pub(super) fn statements() -> Vec<&'static str> {
    [BLOCKS, LINES, &["accel", "filter"]].concat()
}

/// The known word that `word` is a slip of the finger away from: one wrong, missing, surplus or swapped letter for every
/// three of the shorter word.
pub(super) fn nearest<'k>(word: &str, known: &[&'k str]) -> Option<&'k str> {
    // Nobody means `fov` by a thousand letters, and the distance takes time by the square.
    const LONGEST: usize = 32;
    if word.len() > LONGEST {
        return None;
    }
    let word = word.to_lowercase();
    let distance = |known: &&&str| strsim::osa_distance(&word, &known.to_lowercase());
    let nearest = known.iter().min_by_key(distance)?;
    (distance(&nearest) * 3 <= word.len().min(nearest.len())).then_some(*nearest)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_slip_of_the_finger_is_forgiven() {
        let known = statements();
        for (word, meant) in
            [("shadr", "shader"), ("Camera", "camera"), ("imgae", "image"), ("trace-depth", "trace-depths")]
        {
            assert_eq!(nearest(word, &known), Some(meant), "{word}");
        }
    }

    #[test]
    fn another_word_is_not_taken_for_a_slip() {
        // `shape` is two letters from `shader`.
        for word in ["shape", "scene", "x", "", &"shader".repeat(1000)] {
            assert_eq!(nearest(word, &statements()), None, "{word}");
        }
    }
}
