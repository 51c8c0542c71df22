//! The kernels of many textbooks and tutorials, kept to be compared with: **not** what girasol renders with.
//!
//! Each is the well-known formula written down in `f32`, right on easy cases and wrong on hard ones; its documentation says
//! where it goes wrong and how far (`girasol accuracy` measures it). Every epsilon of this crate is here, and none elsewhere.
//! They fit [`Kernels`] and [`crate::RayOrigin`], one at a time or all together.

mod aabb;
mod ellipsoid;
mod plane;
mod ray_origin;
mod sphere;
mod triangle;

pub use aabb::slab_test;
pub use ellipsoid::single_precision_inverse;
pub use plane::rejecting_near_parallel;
pub use ray_origin::{OFFSET, hit_point, offset_along_normal, offset_along_ray};
pub use sphere::quadratic_formula;
pub use triangle::moeller_trumbore;

use crate::Kernels;

/// All naive kernels together.
pub fn kernels() -> Kernels {
    Kernels {
        sphere: Some(quadratic_formula),
        ellipsoid: Some(single_precision_inverse),
        triangle: Some(moeller_trumbore),
        plane: Some(rejecting_near_parallel),
        aabb: Some(slab_test),
        ..Kernels::default()
    }
}
