//! Where in a pixel, on a lens and among lights do samples fall?

use glam::DVec2;
use render::Sample;

/// Fills in points of the unit square: the one wanted and those with the next indices, each a function of which it is.
///
/// A stub: it fills in nothing.
pub fn sampler(_sample: Sample, _points: &mut [DVec2]) {}
