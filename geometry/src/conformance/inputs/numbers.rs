use glam::{DMat3, DVec3};
use proptest::prelude::*;

/// Unit vectors: everywhere, and along the axes.
pub fn unit_vector() -> impl Strategy<Value = DVec3> {
    frame().prop_map(|frame| frame.z_axis)
}

/// Numbers whose logarithm is spread evenly.
pub fn magnitude(from: f64, to: f64) -> impl Strategy<Value = f64> + Clone {
    (libm::log(from)..libm::log(to)).prop_map(libm::exp)
}

/// How far a direction rises from a plane: often little.
pub(crate) fn slope() -> impl Strategy<Value = f64> {
    let rise = || prop_oneof![magnitude(1e-6, 1.0), magnitude(1.0, 1e6)];
    prop_oneof![rise(), rise().prop_map(|slope| -slope)]
}

/// Three perpendicular unit vectors, right-handed; often the axes.
pub(crate) fn frame() -> impl Strategy<Value = DMat3> {
    let turned = (-1.0..1.0, -3.2..3.2, -3.2..3.2).prop_map(|(height, longitude, turn)| {
        let (sin, cos) = libm::sincos(longitude);
        let width = f64::sqrt(1.0 - height * height);
        let z = DVec3::new(cos * width, sin * width, height);
        let (x, y) = z.any_orthonormal_pair();
        let (sin, cos) = libm::sincos(turn);
        let x = x * cos + y * sin;
        DMat3::from_cols(x, z.cross(x), z)
    });
    let axes = (0..3_usize, any::<bool>()).prop_map(|(first, back)| {
        let sign = if back { -1.0 } else { 1.0 };
        let axes = [DVec3::X * sign, DVec3::Y * sign, DVec3::Z];
        DMat3::from_cols(axes[first], axes[(first + 1) % 3], axes[(first + 2) % 3])
    });
    prop_oneof![3 => turned, 1 => axes]
}

/// A direction in the first two vectors' plane.
pub(crate) fn in_plane(frame: DMat3, angle: f64) -> DVec3 {
    let (sin, cos) = libm::sincos(angle);
    frame.x_axis * cos + frame.y_axis * sin
}
