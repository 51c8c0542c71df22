//! Where a ray really meets a shape.
//!
//! A hit or miss is *unclear* if moving each coordinate of the input by half an ulp could make the other of it: no kernel can
//! be blamed for it, since the input itself was rounded. Whether it could is judged to first order, by the sum of the absolute
//! partial derivatives times half an ulp of each coordinate.

mod aabb;
mod ellipsoid;
mod plane;
mod sphere;
mod triangle;

pub(crate) use aabb::aabb;
pub(crate) use ellipsoid::ellipsoid;
pub(crate) use plane::plane;
pub(crate) use sphere::sphere;
pub(crate) use triangle::triangle;

use glam::{DVec3, Vec3};

use super::exact::Exact;

/// What a kernel should answer for rays from their origin on.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Truth {
    /// Half an ulp decides.
    Unclear,
    /// No hit.
    Miss,
    /// A hit at this `t`.
    Hit(Exact),
}

/// Half the distance to the next greater magnitude: how far the number that was meant may be from the one that was stored.
fn half_ulp(number: f32) -> f64 {
    0.5 * (f64::from(number.abs().next_up()) - f64::from(number.abs()))
}

/// Half an ulp of each coordinate.
fn half_ulps(v: Vec3) -> DVec3 {
    DVec3::new(half_ulp(v.x), half_ulp(v.y), half_ulp(v.z))
}
