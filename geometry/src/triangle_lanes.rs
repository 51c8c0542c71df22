use glam::{DVec3, Vec3};

use crate::triangle_probe::{edge_functions, have_one_sign, plane_of};

/// As many rays as lanes, each against its own triangle: see [`intersect_lanes`]. Axes turned as a [`crate::TriangleProbe`]'s.
#[derive(Clone, Debug)]
pub struct TriangleLanes<const N: usize> {
    /// For x, y, z: each ray's.
    pub origin: [[f32; N]; 3],
    /// As `origin`.
    pub direction: [[f32; N]; 3],
    /// For each corner: x, y, z.
    pub corners: [[[f32; N]; 3]; 3],
}

/// Where each lane's ray meets its triangle, as [`crate::TriangleProbe::intersect`] has it in each bit, but in no interval.
#[derive(Clone, Debug)]
pub struct LanesMet<const N: usize> {
    /// As in [`crate::Intersection`].
    pub t: [f32; N],
    /// As in [`crate::Intersection`].
    pub u: [f32; N],
    /// As in [`crate::Intersection`].
    pub v: [f32; N],
    /// Not 0 where the probe has to be asked, because the triangle is missed, or seen edge-on, or met at its very edge.
    pub is_in_doubt: [u32; N],
}

#[inline(always)]
fn at<const N: usize>(rows: &[[f32; N]; 3], lane: usize) -> DVec3 {
    Vec3::new(rows[0][lane], rows[1][lane], rows[2][lane]).as_dvec3()
}

/// Intersects many rays with a triangle each, all in the same steps: a loop that the compiler makes vectors of. For who knows already that
/// nearly all of them meet.
#[inline(always)]
pub fn intersect_lanes<const N: usize>(lanes: &TriangleLanes<N>) -> LanesMet<N> {
    let mut met = LanesMet { t: [0.0; N], u: [0.0; N], v: [0.0; N], is_in_doubt: [0; N] };
    for lane in 0..N {
        let (origin, direction) = (at(&lanes.origin, lane), at(&lanes.direction, lane));
        let corners = [at(&lanes.corners[0], lane), at(&lanes.corners[1], lane), at(&lanes.corners[2], lane)];
        let seen = [corners[0] - origin, corners[1] - origin, corners[2] - origin];
        let weights = edge_functions(seen, direction);
        let plane = plane_of(corners, seen, weights, direction);
        let inverse = 1.0 / (weights[0] + weights[1] + weights[2]);
        let (u, v) = (weights[1] * inverse, weights[2] * inverse);
        // Comparisons that a NaN fails. The last one: no cut to the triangle would change them.
        let is_certain = have_one_sign(weights) & !plane.is_in_doubt & (v <= 1.0 - u);
        met.t[lane] = plane.t as f32;
        met.u[lane] = u as f32;
        met.v[lane] = v as f32;
        met.is_in_doubt[lane] = u32::from(!is_certain);
    }
    met
}
