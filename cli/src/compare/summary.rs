use std::fmt::Write;
use std::time::Duration;

use render::Film;

use super::{Contest, Side};
use crate::parts::listed;
use crate::report::Failure;
use crate::table::{Align, markdown};

/// What is told of a contest in words: which parts, whether the pictures are equal, what each took.
pub(crate) fn summary(contest: &Contest) -> Result<String, Failure> {
    let Film { width, height, .. } = contest.own.film;
    let mut text = format!(
        "{} of this program against the reference's: {}, {width} x {height} pixels\n\n",
        listed(&contest.parts),
        contest.scene
    );
    let headings = [("", Align::Left), ("own", Align::Right), ("reference", Align::Right), ("ratio", Align::Right)];
    text.push_str(&markdown(&headings, &rows(contest)));
    writeln!(text, "\n{}", verdict(contest)).map_err(|error| Failure::of("the comparison", error))?;
    Ok(text)
}

/// Times, rays and their ratios: own to reference.
pub(super) fn rows(contest: &Contest) -> Vec<Vec<String>> {
    let [own, reference] = [&contest.own, &contest.reference];
    let row = |name: &str, value: &dyn Fn(&Side) -> f64, shown: &dyn Fn(f64) -> String| {
        let [own, reference] = [value(own), value(reference)];
        let ratio = if reference > 0.0 { format!("{:.2}", own / reference) } else { "-".to_owned() };
        vec![name.to_owned(), shown(own), shown(reference), ratio]
    };
    let seconds = |time: f64| format!("{time:.3} s");
    let of = |time: Duration| time.as_secs_f64();
    vec![
        row("assembling", &|side| of(side.assembling), &seconds),
        row("rendering", &|side| of(side.rendering), &seconds),
        row("rays", &|side| side.film.rays.total() as f64, &|rays| format!("{rays}")),
        row("Mrays/s", &|side| side.rays_per_second() / 1e6, &|rays| format!("{rays:.2}")),
    ]
}

/// Equal, or where not, and by how much.
pub(super) fn verdict(contest: &Contest) -> String {
    let mut different = contest.different();
    let Some([x, y]) = different.next() else {
        return "equal: every pixel has the same bits".to_owned();
    };
    let color = |film: &Film| {
        let [red, green, blue] = film.pixels[(y * film.width + x) as usize].to_array();
        format!("({red}, {green}, {blue})")
    };
    let (count, all) = (1 + different.count(), contest.own.film.pixels.len());
    format!(
        "different: {count} of {all} pixels; the first is column {x}, row {y}: {} instead of {}\n\
         RMSE {:.6} in linear light; FLIP {:.4}, from 0 (nothing is seen) to 1",
        color(&contest.own.film),
        color(&contest.reference.film),
        contest.rmse,
        contest.flip.mean()
    )
}
