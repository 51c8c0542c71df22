use std::fmt::Display;

use toml::Spanned;
use toml::de::{DeTable, DeValue};

use super::{Speed, exams};
use crate::parts::Part;
use crate::report::Failure;

/// How many points each law has, and speed.
///
/// ```toml
/// default = 1                 # a law that is not named
///
/// [accelerator]
/// every_primitive_is_found = 5
///
/// [speed]
/// points = 3                  # 0 unless given
/// full = 1.5                  # all of them up to so many times the reference's time
/// none = 10                   # none of them from so many on
/// ```
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Points {
    default: f64,
    laws: Vec<(Part, &'static str, f64)>,
    pub(crate) speed: SpeedPoints,
}

/// What speed is worth: all up to one ratio of times, none from another one on, and between them by the ratio's logarithm.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct SpeedPoints {
    pub(crate) points: f64,
    full: f64,
    none: f64,
}

impl Default for Points {
    /// A point for each law, and none for speed.
    fn default() -> Self {
        Self { default: 1.0, laws: Vec::new(), speed: SpeedPoints { points: 0.0, full: 1.0, none: 10.0 } }
    }
}

impl Points {
    /// Those of a law.
    pub(crate) fn of(&self, part: Part, law: &str) -> f64 {
        let named = self.laws.iter().find(|(of, name, _)| (*of, *name) == (part, law));
        named.map_or(self.default, |(.., points)| *points)
    }

    /// Reads a TOML file's text; `name` is what messages call it.
    pub(crate) fn read(name: &str, text: &str) -> Result<Self, Failure> {
        let table = DeTable::parse(text).map_err(|error| Failure::of(format!("`{name}` is no TOML"), error))?;
        let reader = Reader { name, text };
        let mut points = Self::default();
        for (key, value) in table.get_ref() {
            match &**key.get_ref() {
                "default" => points.default = reader.number(key, value)?,
                "speed" => points.speed = reader.speed(key, value)?,
                part => {
                    let known: Vec<String> = Part::all().iter().map(|part| part.name()).collect();
                    let others = ["default".to_owned(), "speed".to_owned()];
                    let found = known.iter().position(|name| name == part);
                    let number = found.ok_or_else(|| reader.unknown(key, "a part", &[&known[..], &others].concat()))?;
                    reader.laws(Part::all()[number], key, value, &mut points.laws)?;
                }
            }
        }
        Ok(points)
    }
}

impl SpeedPoints {
    /// What a time is worth.
    pub(crate) fn of(&self, speed: &Speed) -> f64 {
        let ratio = speed.ratio();
        if ratio <= self.full {
            self.points
        } else if ratio >= self.none {
            0.0
        } else {
            self.points * libm::log(self.none / ratio) / libm::log(self.none / self.full)
        }
    }
}

type Key<'t> = Spanned<std::borrow::Cow<'t, str>>;

/// Reads values, and says where one is wrong.
struct Reader<'t> {
    name: &'t str,
    text: &'t str,
}

impl<'t> Reader<'t> {
    fn laws(
        &self,
        part: Part,
        key: &Key<'t>,
        value: &Spanned<DeValue<'t>>,
        laws: &mut Vec<(Part, &'static str, f64)>,
    ) -> Result<(), Failure> {
        let known: Vec<&'static str> = exams(part).iter().map(|exam| exam.law).collect();
        for (law, value) in self.table(key, value)? {
            let found = known.iter().find(|known| law.get_ref() == **known);
            let name = *found.ok_or_else(|| self.unknown(law, &format!("a law of `{part}`"), &known))?;
            laws.push((part, name, self.number(law, value)?));
        }
        Ok(())
    }

    fn speed(&self, key: &Key<'t>, value: &Spanned<DeValue<'t>>) -> Result<SpeedPoints, Failure> {
        let mut speed = Points::default().speed;
        for (key, value) in self.table(key, value)? {
            match &**key.get_ref() {
                "points" => speed.points = self.number(key, value)?,
                "full" => speed.full = self.number(key, value)?,
                "none" => speed.none = self.number(key, value)?,
                _ => return Err(self.unknown(key, "said of speed", &["points", "full", "none"])),
            }
        }
        if speed.full > 0.0 && speed.full < speed.none {
            return Ok(speed);
        }
        Err(self
            .wrong(
                key,
                format!(
                    "speed has all points up to {} times the reference's time and none from {} on",
                    speed.full, speed.none
                ),
            )
            .help("`full` must be greater than 0, and less than `none`"))
    }

    fn table<'v>(&self, key: &Key<'t>, value: &'v Spanned<DeValue<'t>>) -> Result<&'v DeTable<'t>, Failure> {
        let table = value.get_ref().as_table();
        table.ok_or_else(|| {
            self.wrong(key, format!("`{}` is {}, not a table", key.get_ref(), &self.text[value.span()]))
                .help(format!("write [{}], and below it lines of the form name = points", key.get_ref()))
        })
    }

    /// Points, or a ratio: 0 or more.
    fn number(&self, key: &Key<'t>, value: &Spanned<DeValue<'t>>) -> Result<f64, Failure> {
        let number: Option<f64> = match value.get_ref() {
            DeValue::Integer(integer) => {
                integer.as_str().replace('_', "").parse().ok().filter(|_| integer.radix() == 10)
            }
            DeValue::Float(float) => float.as_str().replace('_', "").parse().ok(),
            _ => None,
        };
        number.filter(|number| (0.0..=1e6).contains(number)).ok_or_else(|| {
            let found = &self.text[value.span()];
            self.wrong(key, format!("`{}` is {found}", key.get_ref())).help("expected a number from 0 to 1000000")
        })
    }

    fn unknown(&self, key: &Key<'t>, what: &str, known: &[impl AsRef<str>]) -> Failure {
        let name = &**key.get_ref();
        let near = known.iter().map(|known| (strsim::damerau_levenshtein(known.as_ref(), name), known.as_ref())).min();
        let failure = self.wrong(key, format!("`{name}` is not {what}"));
        match near {
            Some((distance, known)) if distance <= 1 + name.len() / 4 => {
                failure.help(format!("did you mean `{known}`?"))
            }
            _ => {
                let all: Vec<&str> = known.iter().map(AsRef::as_ref).collect();
                failure.help(format!("there are {}", all.join(", ")))
            }
        }
    }

    fn wrong(&self, key: &Key<'t>, message: impl Display) -> Failure {
        let line = 1 + self.text[..key.span().start].matches('\n').count();
        Failure::new(format!("{}:{line}: {message}", self.name))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn laws_that_are_named_have_their_points_and_others_the_default() {
        let text = "default = 2\n[mirror]\na_mirror_casts_a_shadow = 0.5\n[speed]\npoints = 1_0\n";
        let points = Points::read("w.toml", text).unwrap();
        assert_eq!(points.of(Part::Mirror, "a_mirror_casts_a_shadow"), 0.5);
        assert_eq!(points.of(Part::Mirror, "a_mirror_filters_each_channel"), 2.0);
        // A law of another part with the same name is another law.
        assert_eq!(points.of(Part::Glass, "a_mirror_casts_a_shadow"), 2.0);
        assert_eq!((points.speed.points, points.speed.full, points.speed.none), (10.0, 1.0, 10.0));
    }

    #[test]
    fn speed_has_all_points_up_to_one_ratio_none_from_another_and_half_at_their_geometric_mean() {
        let points = SpeedPoints { points: 8.0, full: 2.0, none: 32.0 };
        let at = |own: f64| points.of(&Speed { own, reference: 0.5, rays: 1.0 });
        assert_eq!([at(0.25), at(1.0), at(16.0), at(100.0)], [8.0, 8.0, 0.0, 0.0]);
        // 8 is the root of 2 x 32.
        assert!((at(4.0) - 4.0).abs() < 1e-12, "{}", at(4.0));
    }

    #[test]
    fn the_example_for_teachers_is_one() {
        let page = include_str!("../../../TEACHING.md");
        let (_, after) = page.split_once("```toml\n").unwrap();
        let points = Points::read("TEACHING.md", after.split("```").next().unwrap()).unwrap();
        assert_eq!(points.of(Part::Accelerator, "one_primitive_is_found"), 3.0);
        assert_eq!((points.speed.points, points.speed.full, points.speed.none), (5.0, 2.0, 20.0));
    }
}
