use geometry::{Ellipsoid, Ray};

use super::{Truth, half_ulps, sphere::roots};
use crate::accuracy::exact::{Exact, ExactVector};

/// A ray against an ellipsoid, whose map counts as exact.
pub(crate) fn ellipsoid(shape: &Ellipsoid, ray: &Ray) -> Truth {
    let map = shape.to_world();
    let columns = [map.linear.x_axis, map.linear.y_axis, map.linear.z_axis].map(ExactVector::from);
    // Cramer's rule: the rows of the inverse are the columns' cross products over the determinant.
    let [x, y, z] = columns;
    let rows = [y.cross(z), z.cross(x), x.cross(y)];
    let over_determinant = Exact::from(1.0) / x.dot(rows[0]);
    let to_unit = |v: ExactVector| ExactVector(rows.map(|row| row.dot(v) * over_determinant));
    let from_center = ExactVector::from(ray.origin).minus(map.translation.into());
    let rows = rows.map(|row| row.times(over_determinant).approximate());
    roots(to_unit(from_center), to_unit(ray.direction.into()), 1.0, |away, along| {
        // A step in the world moves the point of the unit sphere by the inverse's columns.
        let per_step = rows[0] * away.x + rows[1] * away.y + rows[2] * away.z;
        per_step.abs().dot(half_ulps(ray.origin) + half_ulps(ray.direction) * along.abs())
    })
}
