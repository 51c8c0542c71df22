//! One HTML file with everything in it: nothing is loaded, no script is needed.

use base64::{Engine, engine::general_purpose::STANDARD};

use super::figure::{Figure, Key, Mark, Part};
use crate::table::Align;

/// The page of some figures. `about` are the facts below the title, each a name and what it is.
pub(crate) fn page(about: &[(String, String)], figures: &[Figure]) -> String {
    let facts: String =
        about.iter().map(|(name, fact)| format!("<dt>{}</dt><dd>{}</dd>\n", escaped(name), escaped(fact))).collect();
    let contents: String = figures
        .iter()
        .map(|figure| format!("<li><a href=\"#{}\">{}</a></li>\n", figure.id, escaped(figure.title)))
        .collect();
    let sections: String = figures.iter().map(section).collect();
    format!(
        "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n\
         <meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n\
         <meta name=\"color-scheme\" content=\"light dark\">\n<title>girasol: speed against error</title>\n\
         <style>\n{}</style>\n</head>\n<body>\n<header>\n<h1>Speed against error</h1>\n{}</header>\n\
         <nav aria-label=\"Contents\">\n<ol>\n{contents}</ol>\n</nav>\n<main>\n{sections}</main>\n\
         <footer>\n<h2>What was measured, and where</h2>\n<dl>\n{facts}</dl>\n</footer>\n</body>\n</html>\n",
        include_str!("page.css"),
        include_str!("introduction.html"),
    )
}

fn section(figure: &Figure) -> String {
    let parts: String = figure.parts.iter().map(part).collect();
    format!(
        "<section id=\"{}\">\n<h2>{}</h2>\n<p>{}</p>\n{parts}</section>\n",
        figure.id,
        escaped(figure.title),
        prose(&figure.caption)
    )
}

fn part(part: &Part) -> String {
    match part {
        Part::Svg { svg, alt } => {
            format!("<figure class=\"chart\" role=\"img\" aria-label=\"{}\">\n{svg}\n</figure>\n", escaped(alt))
        }
        Part::Png { bytes, alt } => format!(
            "<figure class=\"picture\"><img alt=\"{0}\" src=\"data:image/png;base64,{1}\"><figcaption>{0}</figcaption></figure>\n",
            escaped(alt),
            STANDARD.encode(bytes)
        ),
        Part::Table { headings, rows } => table(headings, rows),
        Part::Legend(keys) => format!("<p class=\"legend\">{}</p>\n", keys.iter().map(key).collect::<String>()),
        Part::Heading(heading) => format!("<h3>{}</h3>\n", escaped(heading)),
        Part::Text(text) => format!("<p>{}</p>\n", prose(text)),
        Part::Row(parts) => {
            format!("<div class=\"row\">\n{}</div>\n", parts.iter().map(self::part).collect::<String>())
        }
        Part::Grid(parts) => {
            format!("<div class=\"grid\">\n{}</div>\n", parts.iter().map(self::part).collect::<String>())
        }
        Part::Folded { title, parts } => format!(
            "<details>\n<summary>{}</summary>\n{}</details>\n",
            escaped(title),
            parts.iter().map(self::part).collect::<String>()
        ),
    }
}

fn table(headings: &[(String, Align)], rows: &[Vec<String>]) -> String {
    let class = |column: usize| match headings.get(column) {
        Some((_, Align::Right)) => " class=\"number\"",
        _ => "",
    };
    let heads: String =
        (0..).zip(headings).map(|(i, (text, _))| format!("<th{}>{}</th>", class(i), escaped(text))).collect();
    let body: String = rows
        .iter()
        .map(|row| {
            let cells: String =
                (0..).zip(row).map(|(i, cell)| format!("<td{}>{}</td>", class(i), escaped(cell))).collect();
            format!("<tr>{cells}</tr>\n")
        })
        .collect();
    format!("<div class=\"table\"><table>\n<thead><tr>{heads}</tr></thead>\n<tbody>\n{body}</tbody>\n</table></div>\n")
}

fn key(key: &Key) -> String {
    let [red, green, blue] = key.color;
    let class = match key.mark {
        Mark::Disc => "disc",
        Mark::Ring => "ring",
        Mark::Square => "square",
    };
    format!(
        "<span><i class=\"{class}\" style=\"border-color:rgb({red},{green},{blue});color:rgb({red},{green},{blue})\"></i>{}</span>",
        escaped(&key.name)
    )
}

/// A paragraph's text, in which `backticks` stand around code.
fn prose(text: &str) -> String {
    let pieces = escaped(text);
    let pieces = pieces.split('`').enumerate();
    pieces.map(|(i, piece)| if i % 2 == 1 { format!("<code>{piece}</code>") } else { piece.to_owned() }).collect()
}

/// Text as HTML shows it.
pub(crate) fn escaped(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;").replace('"', "&quot;")
}

#[cfg(test)]
mod tests {
    use super::*;
    use serde_json::Value;

    #[test]
    fn what_is_shown_is_text_and_never_a_tag() {
        let figure = Figure {
            id: "one",
            title: "<script>",
            caption: "a < b & `c`".to_owned(),
            parts: vec![Part::Text("<img src=x>".to_owned())],
            data: Value::Null,
        };
        let page = page(&[("<b>".to_owned(), "\"".to_owned())], &[figure]);
        assert!(!page.contains("<script") && !page.contains("<img") && !page.contains("<b>"));
        assert!(page.contains("a &lt; b &amp; <code>c</code>"));
    }
}
