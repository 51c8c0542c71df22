//! Tables in plain text that are Markdown, too.

use std::fmt::Write;

/// How a column's cells stand.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Align {
    Left,
    Right,
}

/// Headings and rows as a Markdown table with its columns in line. Each row has as many cells as there are headings.
pub(crate) fn markdown(headings: &[(&str, Align)], rows: &[Vec<String>]) -> String {
    let width = |column: usize| {
        let cells = rows.iter().map(|row| row[column].chars().count());
        cells.chain([headings[column].0.chars().count()]).max().unwrap_or(0)
    };
    let widths: Vec<usize> = (0..headings.len()).map(width).collect();
    let mut text = String::new();
    let mut add_row = |cell: &dyn Fn(usize) -> String| {
        let cells: Vec<String> = (0..headings.len()).map(cell).collect();
        let _ = writeln!(text, "| {} |", cells.join(" | "));
    };
    let padded = |cell: &str, column: usize| match headings[column].1 {
        Align::Left => format!("{cell:<width$}", width = widths[column]),
        Align::Right => format!("{cell:>width$}", width = widths[column]),
    };
    add_row(&|column| padded(headings[column].0, column));
    add_row(&|column| match headings[column].1 {
        Align::Left => "-".repeat(widths[column].max(3)),
        Align::Right => format!("{}:", "-".repeat(widths[column].max(3) - 1)),
    });
    for row in rows {
        add_row(&|column| padded(&row[column], column));
    }
    text
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn columns_stand_in_line() {
        let rows = [vec!["a".to_owned(), "1".to_owned()], vec!["long".to_owned(), "12345".to_owned()]];
        let expected = "\
| name | time |
| ---- | ---: |
| a    |    1 |
";
        assert_eq!(markdown(&[("name", Align::Left), ("time", Align::Right)], &rows[..1]), expected);
        let both = markdown(&[("name", Align::Left), ("time", Align::Right)], &rows);
        assert!(both.lines().all(|line| line.chars().count() == both.lines().next().unwrap_or("").chars().count()));
    }
}
