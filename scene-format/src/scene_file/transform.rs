use crate::span::Spanned;

/// Places an object in the world (or a camera, from its own space into the world's).
#[derive(Clone, Debug, PartialEq)]
pub enum Transform {
    /// `row` and 16 numbers, row by row; vectors are columns, so the translation is in numbers 4, 8 and 12.
    Row([f32; 16]),
    /// `col` and 16 numbers, column by column.
    Col([f32; 16]),
    /// `{ step step ... }`: applied to the object in the order written, the first step first.
    Steps(Vec<Spanned<TransformStep>>),
    /// `steps N times T0 T1` and N transforms, none of them moving: an object that moves. The first is rendered.
    Moving {
        /// When it stands at the first and at the last.
        times: Spanned<[f32; 2]>,
        /// At least one.
        steps: Vec<Spanned<Transform>>,
    },
}

/// One step of a transform. Angles are in degrees, counter-clockwise seen from the tip of the axis.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum TransformStep {
    /// `translate x y z`
    Translate([f32; 3]),
    /// `scaleu s`
    ScaleUniform(f32),
    /// `scale x y z`
    Scale([f32; 3]),
    /// `scalex s`
    ScaleX(f32),
    /// `scaley s`
    ScaleY(f32),
    /// `scalez s`
    ScaleZ(f32),
    /// `rotatex degrees`
    RotateX(f32),
    /// `rotatey degrees`
    RotateY(f32),
    /// `rotatez degrees`
    RotateZ(f32),
    /// `rotate x y z degrees`; the axis need not be a unit vector.
    Rotate {
        /// The axis.
        axis: [f32; 3],
        /// The angle.
        degrees: f32,
    },
}
