//! Our own parts keep the laws of their kits.

use geometry::{BoxProbe, Ellipsoid, Kernels, Plane, Primitive, Sphere, Surface, Transform, Triangle};

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

mod sphere_uv {
    use super::*;

    geometry::sphere_uv_conformance!(|outward| Kernels::default().uv_of_sphere(outward));
}

mod plane_uv {
    use super::*;

    geometry::plane_uv_conformance!(Plane::uv_at);
}

mod triangle_uv {
    use super::*;

    geometry::triangle_uv_conformance!(|corners, u, v| Kernels::default().uv_of_triangle(corners, u, v));
}

mod smooth_normal {
    use super::*;

    geometry::smooth_normal_conformance!(|corners, u, v| Kernels::default().normal_between(corners, u, v));
}

mod normal_matrix {
    use super::*;

    geometry::normal_matrix_conformance!(Transform::normals);
}

mod ray_origin {
    use super::*;

    geometry::ray_origin_conformance!(Surface::origin_towards);
}
