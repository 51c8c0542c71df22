//! How far two pictures are apart: as light, and as an eye sees it.
//!
//! | measure | what it says | of |
//! |---|---|---|
//! | [`rmse`] | the root of the mean square difference | linear channels, not clamped |
//! | [`flip`] | how much of a difference one sees on flipping between the pictures, 0 to 1, for each pixel | what a screen shows |
//!
//! The first has a theory: the error of a mean of n independent rays falls with the root of n, so that it is a straight line on log-log
//! axes. The second knows that noise in fine grains is seen less than in coarse ones, and that edges are what eyes look at.

mod flip;
mod heat;
mod rmse;

pub use flip::{ErrorMap, PIXELS_PER_DEGREE, flip};
pub use heat::heat;
pub use rmse::rmse;

use render::Film;
use thiserror::Error;

/// Why two pictures were not compared.
#[derive(Clone, Copy, Debug, PartialEq, Error)]
pub enum MetricError {
    /// Their pixels cannot be paired.
    #[error("pictures of {} x {} and {} x {} pixels cannot be compared: render both with the same size", .one[0], .one[1], .other[0], .other[1])]
    DifferentSizes {
        /// Width and height of one.
        one: [u32; 2],
        /// Width and height of the other.
        other: [u32; 2],
    },
    /// No eye or screen is like this.
    #[error("{0} pixels for each degree of sight: expected 1 to 1000, as 67 for a usual screen")]
    PixelsPerDegree(f64),
}

fn check_sizes(one: &Film, other: &Film) -> Result<(), MetricError> {
    let sizes = [one, other].map(|film| [film.width, film.height]);
    match sizes {
        [one, other] if one != other => Err(MetricError::DifferentSizes { one, other }),
        _ => Ok(()),
    }
}
