use geometry::Transform;
use glam::{DMat3, DVec3};
use scene_format::{
    Code, Diagnostic, Spanned,
    scene_file::{self, TransformStep, Triple},
};

/// A point or vector of a scene file.
pub(super) fn dvec3(triple: Triple) -> DVec3 {
    DVec3::from(triple.map(f64::from))
}

/// A transform of a scene file; without one, nothing moves.
/// What moves stands where its first step puts it.
pub(super) fn transform(written: Option<&Spanned<scene_file::Transform>>) -> Transform {
    written.map_or(Transform::IDENTITY, |written| match &written.value {
        scene_file::Transform::Row(rows) => from_columns(rows, [0, 1, 2, 3], 4),
        scene_file::Transform::Col(columns) => from_columns(columns, [0, 4, 8, 12], 1),
        scene_file::Transform::Steps(steps) => {
            steps.iter().fold(Transform::IDENTITY, |so_far, next| so_far.then(&step(next)))
        }
        scene_file::Transform::Moving { steps, .. } => transform(steps.first()),
    })
}

/// A transform that must have an inverse, since what it places is to be hit.
pub(super) fn invertible(written: Option<&Spanned<scene_file::Transform>>) -> Result<Transform, Diagnostic> {
    let found = transform(written);
    match written {
        Some(written) if found.inverse().is_none() => Err(Diagnostic::error(
            Code::NoInverse,
            written.span,
            "this transform squeezes its object flat or makes it infinite",
        )
        .label("it has no inverse")
        .help("look for a scale by 0, or for numbers that overflow")),
        _ => Ok(found),
    }
}

/// From 16 numbers, where each column begins, and how far its elements are apart.
fn from_columns(numbers: &[f32; 16], starts: [usize; 4], stride: usize) -> Transform {
    let [x, y, z, translation] =
        starts.map(|start| dvec3([numbers[start], numbers[start + stride], numbers[start + 2 * stride]]));
    Transform { linear: DMat3::from_cols(x, y, z), translation }
}

fn step(step: &TransformStep) -> Transform {
    let scale = |x: f32, y: f32, z: f32| Transform::scale(dvec3([x, y, z]));
    match *step {
        TransformStep::Translate(by) => Transform::translation(dvec3(by)),
        TransformStep::ScaleUniform(by) => scale(by, by, by),
        TransformStep::Scale([x, y, z]) => scale(x, y, z),
        TransformStep::ScaleX(by) => scale(by, 1.0, 1.0),
        TransformStep::ScaleY(by) => scale(1.0, by, 1.0),
        TransformStep::ScaleZ(by) => scale(1.0, 1.0, by),
        TransformStep::RotateX(degrees) => Transform::rotation(DVec3::X, degrees.into()),
        TransformStep::RotateY(degrees) => Transform::rotation(DVec3::Y, degrees.into()),
        TransformStep::RotateZ(degrees) => Transform::rotation(DVec3::Z, degrees.into()),
        TransformStep::Rotate { axis, degrees } => Transform::rotation(dvec3(axis), degrees.into()),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use scene_format::scene_file::Transform as Written;

    fn moved(written: Written, point: [f64; 3]) -> DVec3 {
        transform(Some(&Spanned::from(written))).point(point.into())
    }

    #[test]
    fn rows_and_columns_hold_the_same_matrix_transposed() {
        let rows = [1., 2., 3., 10., 4., 5., 6., 20., 7., 8., 9., 30., 0., 0., 0., 1.];
        let columns = [1., 4., 7., 0., 2., 5., 8., 0., 3., 6., 9., 0., 10., 20., 30., 1.];
        for point in [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]] {
            assert_eq!(moved(Written::Row(rows), point), moved(Written::Col(columns), point));
        }
        assert_eq!(moved(Written::Row(rows), [1.0, 0.0, 0.0]), DVec3::new(11.0, 24.0, 37.0));
    }

    #[test]
    fn steps_apply_in_the_order_written() {
        let steps = [
            TransformStep::RotateZ(90.0),
            TransformStep::Translate([1.0, 0.0, 0.0]),
            TransformStep::ScaleY(3.0),
            TransformStep::ScaleUniform(2.0),
        ];
        let steps = steps.map(Spanned::from).to_vec();
        // x -> y -> (1, 1, 0) -> (1, 3, 0) -> (2, 6, 0)
        assert_eq!(moved(Written::Steps(steps), [1.0, 0.0, 0.0]), DVec3::new(2.0, 6.0, 0.0));
    }
}
