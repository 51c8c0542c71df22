//! One HTML file with both pictures, their difference and a slider: nothing is loaded.

use base64::{Engine, engine::general_purpose::STANDARD};
use render::Film;

use super::{Contest, slider::slider, summary};
use crate::accuracy::{machine, page::escaped, png};
use crate::metrics::heat;
use crate::parts::listed;
use crate::report::Failure;

/// A picture as it stands in the page, and what it shows.
pub(super) struct Picture {
    pub(super) source: String,
    pub(super) width: u32,
    pub(super) height: u32,
    pub(super) alt: String,
}

/// The page of a contest.
pub(crate) fn page(contest: &Contest) -> Result<String, Failure> {
    let Film { width, height, .. } = contest.own.film;
    let picture = |bytes: &[u8], alt: String| -> Result<Picture, Failure> {
        let source = format!("data:image/png;base64,{}", STANDARD.encode(png(bytes, width, height)?));
        Ok(Picture { source, width, height, alt })
    };
    let parts = listed(&contest.parts).replace('`', "");
    let own = picture(&contest.own.film.to_srgb_bytes(), format!("With this program's own {parts}"))?;
    let reference = picture(&contest.reference.film.to_srgb_bytes(), format!("With the reference's {parts}"))?;
    let seen = "What an eye sees of the difference on flipping between the two (FLIP): from black, nothing, to white";
    let seen = picture(&contest.flip.to_srgb_bytes(), seen.to_owned())?;
    let bits = picture(&any_difference(contest), "White: pixels that have not the same bits".to_owned())?;
    let title = format!("{}: {parts}", contest.scene);
    let facts: String = machine()
        .iter()
        .map(|(name, fact)| format!("<dt>{}</dt><dd>{}</dd>\n", escaped(name), escaped(fact)))
        .collect();
    Ok(format!(
        "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n\
         <meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n\
         <meta name=\"color-scheme\" content=\"light dark\">\n<title>{title}</title>\n\
         <style>\n{}{}</style>\n</head>\n<body>\n<header>\n<h1>{title}</h1>\n<p class=\"verdict\">{}</p>\n</header>\n<main>\n{}\
         <div class=\"row\">\n{}{}{}{}</div>\n{}</main>\n<footer>\n<h2>Where it was rendered</h2>\n<dl>\n{facts}</dl>\n</footer>\n\
         <script>\n{}</script>\n</body>\n</html>\n",
        include_str!("../accuracy/page.css"),
        include_str!("slider.css"),
        escaped(&summary::verdict(contest)).replace('\n', "<br>"),
        slider(&own, &reference),
        figure(&own),
        figure(&reference),
        figure(&seen),
        figure(&bits),
        times(contest),
        include_str!("slider.js"),
        title = escaped(&title),
    ))
}

/// White where the bits differ, black elsewhere: what no measure rounds away.
fn any_difference(contest: &Contest) -> Vec<u8> {
    let Film { width, height, .. } = contest.own.film;
    let mut bytes = vec![heat(0.0); width as usize * height as usize];
    for [x, y] in contest.different() {
        bytes[(y * width + x) as usize] = heat(1.0);
    }
    bytes.into_flattened()
}

fn figure(picture: &Picture) -> String {
    let Picture { source, width, height, alt } = picture;
    let alt = escaped(alt);
    format!(
        "<figure class=\"picture\"><img width=\"{width}\" height=\"{height}\" alt=\"{alt}\" src=\"{source}\">\
         <figcaption>{alt}</figcaption></figure>\n"
    )
}

fn times(contest: &Contest) -> String {
    let cell = |cell: &String| format!("<td class=\"number\">{}</td>", escaped(cell));
    let row = |row: &Vec<String>| {
        let (name, cells) = row.split_first().map_or((String::new(), &row[..]), |(name, rest)| (escaped(name), rest));
        format!("<tr><th scope=\"row\">{name}</th>{}</tr>\n", cells.iter().map(cell).collect::<String>())
    };
    let rows: String = summary::rows(contest).iter().map(row).collect();
    format!(
        "<h2>What each took</h2>\n<div class=\"table\"><table>\n<thead><tr><td></td><th class=\"number\">own</th>\
         <th class=\"number\">reference</th><th class=\"number\">ratio</th></tr></thead>\n<tbody>\n{rows}</tbody>\n</table></div>\n"
    )
}
