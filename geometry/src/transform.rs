use glam::{DMat3, DVec3, Vec3};

/// An affine map: `linear * p + translation`, in `f64`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Transform {
    /// Turns, scales, shears.
    pub linear: DMat3,
    /// Moves, after the linear part.
    pub translation: DVec3,
}

impl Transform {
    /// Leaves everything where it is.
    pub const IDENTITY: Self = Self { linear: DMat3::IDENTITY, translation: DVec3::ZERO };

    /// Moves by a vector.
    pub fn translation(by: DVec3) -> Self {
        Self { translation: by, ..Self::IDENTITY }
    }

    /// Scales along the axes.
    pub fn scale(by: DVec3) -> Self {
        Self { linear: DMat3::from_diagonal(by), ..Self::IDENTITY }
    }

    /// Turns about an axis through the origin, counter-clockwise seen from the axis' tip; the axis need not be a unit vector,
    /// and a zero axis turns nothing.
    ///
    /// Whole quarter turns are exact. (Rodrigues 1840: `R = cos I + sin [a]x + (1 - cos) a a^T`.)
    pub fn rotation(axis: DVec3, degrees: f64) -> Self {
        let Some(axis) = axis.try_normalize() else { return Self::IDENTITY };
        let (sin, cos) = sin_cos_degrees(degrees);
        let cross = DMat3::from_cols(
            DVec3::new(0.0, axis.z, -axis.y),
            DVec3::new(-axis.z, 0.0, axis.x),
            DVec3::new(axis.y, -axis.x, 0.0),
        );
        let along = DMat3::from_cols(axis * axis.x, axis * axis.y, axis * axis.z);
        Self { linear: DMat3::IDENTITY * cos + cross * sin + along * (1.0 - cos), ..Self::IDENTITY }
    }

    /// First this one, then `next`.
    #[must_use]
    pub fn then(&self, next: &Self) -> Self {
        Self { linear: next.linear * self.linear, translation: next.linear * self.translation + next.translation }
    }

    /// The way back, if there is one. Far from the origin apply its linear part to a difference, as [`crate::Ellipsoid`] does: the
    /// translation that it holds cancels against a point's.
    ///
    /// There is none: `None` when the map flattens space or holds a NaN or an infinity.
    pub fn inverse(&self) -> Option<Self> {
        let determinant = self.linear.determinant();
        let inverse = self.linear.inverse();
        if determinant == 0.0 || !inverse.is_finite() || !self.translation.is_finite() {
            return None;
        }
        Some(Self { linear: inverse, translation: -(inverse * self.translation) })
    }

    /// Moves a point.
    pub fn point(&self, point: DVec3) -> DVec3 {
        self.linear * point + self.translation
    }

    /// Moves a direction: without the translation.
    pub fn direction(&self, direction: DVec3) -> DVec3 {
        self.linear * direction
    }

    /// The matrix that moves normals: the inverse transpose of the linear part, up to a positive factor.
    ///
    /// Taken from the cofactors, so that it exists for flattening maps too; the sign of the determinant keeps outward normals
    /// outward under a mirror.
    pub fn normals(&self) -> DMat3 {
        let [x, y, z] = [self.linear.x_axis, self.linear.y_axis, self.linear.z_axis];
        let cofactors = DMat3::from_cols(y.cross(z), z.cross(x), x.cross(y));
        if self.mirrors() { cofactors * -1.0 } else { cofactors }
    }

    /// Whether it turns left hands into right ones: counter-clockwise corners come out clockwise.
    pub fn mirrors(&self) -> bool {
        self.linear.determinant() < 0.0
    }

    /// The same factor along all axes and no turn? Then that factor, if positive.
    pub fn uniform_scale(&self) -> Option<f64> {
        let scale = self.linear.x_axis.x;
        (scale > 0.0 && self.linear == DMat3::from_diagonal(DVec3::splat(scale))).then_some(scale)
    }

    /// Moves an `f32` point, rounding once.
    pub fn point_f32(&self, point: Vec3) -> Vec3 {
        self.point(point.as_dvec3()).as_vec3()
    }
}

/// Sine and cosine of an angle in degrees, exact at whole quarter turns.
fn sin_cos_degrees(degrees: f64) -> (f64, f64) {
    let quarters = libm::rint(degrees / 90.0);
    let (sin, cos) = libm::sincos((degrees - 90.0 * quarters).to_radians());
    match libm::fmod(quarters, 4.0) as i32 {
        1 | -3 => (cos, -sin),
        2 | -2 => (-sin, -cos),
        3 | -1 => (-cos, sin),
        _ => (sin, cos),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_quarter_turn_about_z_takes_x_to_y_exactly() {
        for (degrees, expected) in
            [(90.0, DVec3::Y), (180.0, -DVec3::X), (270.0, -DVec3::Y), (-90.0, -DVec3::Y), (450.0, DVec3::Y)]
        {
            assert_eq!(Transform::rotation(DVec3::Z, degrees).direction(DVec3::X), expected, "{degrees} degrees");
        }
    }

    #[test]
    fn sines_and_cosines_are_right_in_every_quarter() {
        for degrees in (-900..=900).map(|tenth| f64::from(tenth) * 0.9) {
            let (sin, cos) = sin_cos_degrees(degrees);
            let (true_sin, true_cos) = libm::sincos(degrees.to_radians());
            assert!((sin - true_sin).abs() < 1e-14 && (cos - true_cos).abs() < 1e-14, "{degrees} degrees");
        }
    }

    #[test]
    fn a_third_of_a_turn_about_the_diagonal_takes_each_axis_to_the_next() {
        let turn = Transform::rotation(DVec3::splat(5.0), 120.0);
        for (from, to) in [(DVec3::X, DVec3::Y), (DVec3::Y, DVec3::Z), (DVec3::Z, DVec3::X)] {
            assert!(turn.direction(from).distance(to) < 1e-15, "{from} to {}", turn.direction(from));
        }
        // Half a turn about an axis that is no diagonal: what is along it stays.
        let axis = DVec3::new(1.0, -2.0, 3.0);
        let half = Transform::rotation(axis, 180.0);
        assert!(half.direction(axis).distance(axis) < 8e-15);
        assert!(half.direction(DVec3::new(2.0, 1.0, 0.0)).distance(DVec3::new(-2.0, -1.0, 0.0)) < 8e-15);
    }

    #[test]
    fn only_the_same_factor_along_all_axes_is_a_uniform_scale() {
        assert_eq!(Transform::scale(DVec3::splat(2.5)).uniform_scale(), Some(2.5));
        for other in [DVec3::splat(-1.0), DVec3::ZERO, DVec3::new(1.0, 1.0, 2.0)] {
            assert_eq!(Transform::scale(other).uniform_scale(), None, "{other}");
        }
        assert_eq!(Transform::rotation(DVec3::Z, 30.0).uniform_scale(), None);
    }

    #[test]
    fn steps_apply_in_the_order_written() {
        let moved_then_scaled = Transform::translation(DVec3::X).then(&Transform::scale(DVec3::splat(2.0)));
        assert_eq!(moved_then_scaled.point(DVec3::ZERO), DVec3::new(2.0, 0.0, 0.0));
    }

    #[test]
    fn normals_stay_perpendicular_under_a_shear_and_outward_under_a_mirror() {
        // The plane x + y = 0 holds the direction (1, -1, 0).
        let stretch = Transform::scale(DVec3::new(2.0, 1.0, 1.0));
        let normal = stretch.normals() * DVec3::new(1.0, 1.0, 0.0);
        assert_eq!(normal.dot(stretch.direction(DVec3::new(1.0, -1.0, 0.0))), 0.0);
        let mirror = Transform::scale(DVec3::new(-1.0, 1.0, 1.0));
        assert_eq!(mirror.normals() * DVec3::X, -DVec3::X);
    }

    #[test]
    fn a_flattening_map_has_no_inverse() {
        assert_eq!(Transform::scale(DVec3::new(1.0, 1.0, 0.0)).inverse(), None);
        assert_eq!(Transform::scale(DVec3::splat(f64::NAN)).inverse(), None);
    }
}
