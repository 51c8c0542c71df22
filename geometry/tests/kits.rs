//! Our own parts keep the laws of their kits.

use geometry::{BoxProbe, Ellipsoid, Plane, Primitive, Sphere, Triangle};

mod sphere {
    use super::*;

    geometry::sphere_conformance!(Sphere::intersect);
}

mod ellipsoid {
    use super::*;

    geometry::ellipsoid_conformance!(Ellipsoid::intersect);
}

mod triangle {
    use super::*;

    geometry::triangle_conformance!(Triangle::intersect);
}

mod plane {
    use super::*;

    geometry::plane_conformance!(Plane::intersect);
}

mod aabb {
    use super::*;

    geometry::aabb_conformance!(|bounds, ray, within| { BoxProbe::new(ray, bounds.magnitude()).clip(*bounds, within) });
}
