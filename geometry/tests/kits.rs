//! Our own parts keep the laws of their kits.

use geometry::{Primitive, Sphere};

mod sphere {
    use super::*;

    geometry::sphere_conformance!(Sphere::intersect);
}
