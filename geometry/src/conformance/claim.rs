use super::{Counterexample, Figure, Ink, Verdict};
use crate::{Intersection, Interval, Ray};

/// Where a ray meets a shape, as the exact numbers say.
#[derive(Clone, Copy, Debug)]
pub(super) struct Truth {
    /// `None` if nowhere.
    pub(super) t: Option<f64>,
    /// How far the part may be off, as a share of `t`.
    pub(super) tolerance: f64,
}

impl Truth {
    /// Whether a part's answer is it.
    pub(super) fn judge(self, ray: &Ray, found: Option<Intersection>, scene: impl FnOnce() -> Figure) -> Verdict {
        let is_right = match (self.t, found) {
            (None, None) => true,
            (Some(t), Some(met)) => (f64::from(met.t) - t).abs() <= self.tolerance * t.abs(),
            _ => false,
        };
        if is_right {
            return Ok(());
        }
        let expected = self.t.map_or("None".to_owned(), |t| match self.tolerance {
            0.0 => format!("t = {t}"),
            tolerance => format!("t = {t}, to {tolerance:e} of it"),
        });
        Err(broken(ray, (&expected, self.t), found, scene()))
    }
}

/// An answer that is not what a law asks for, drawn into the scene.
pub(super) fn broken(
    ray: &Ray,
    (expected, t): (&str, Option<f64>),
    found: Option<Intersection>,
    scene: Figure,
) -> Box<Counterexample> {
    let figure = scene.hit(ray, t.map(|t| t as f32), Ink::Expected).hit(ray, found.map(|met| met.t), Ink::Found);
    Counterexample::new(expected, format!("{found:?}")).drawn(figure)
}

/// An answer to numbers of any kind: none if one is NaN, else none outside the interval.
pub(super) fn wild_claim(found: Option<Intersection>, shape_has_nan: bool, ray: &Ray, within: Interval) -> Verdict {
    let has_nan = ray.origin.is_nan() || ray.direction.is_nan() || within.min.is_nan() || within.max.is_nan();
    match found {
        Some(_) if shape_has_nan || has_nan => Err(Counterexample::new("None", format!("{found:?}"))),
        Some(met) if !within.contains(met.t) => {
            Err(Counterexample::new("a t strictly inside the interval, or None", format!("{found:?}")))
        }
        _ => Ok(()),
    }
}
