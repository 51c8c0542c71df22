//! The statements that every scene of the course has.

use proptest::collection::vec;
use proptest::prelude::*;

use crate::scene_file::*;
use crate::{SceneFile, Spanned};

/// Numbers with few digits, which every way of reading gets right.
fn number() -> impl Strategy<Value = f32> {
    prop_oneof![(-99..100_i8).prop_map(f32::from), (-99..100_i8).prop_map(|halves| f32::from(halves) / 2.0)]
}

fn positive() -> impl Strategy<Value = Spanned<f32>> {
    (1..100_u8).prop_map(|quarters| Spanned::from(f32::from(quarters) / 4.0))
}

fn triple() -> impl Strategy<Value = Spanned<Triple>> {
    [number(), number(), number()].prop_map(Spanned::from)
}

fn color() -> impl Strategy<Value = Spanned<Color>> {
    [number(), number(), number()].prop_map(|channels| Spanned::from(Color::SrgbNonlinear(channels)))
}

fn count() -> impl Strategy<Value = Spanned<u32>> {
    (1..100_u32).prop_map(Spanned::from)
}

fn name() -> impl Strategy<Value = Spanned<String>> {
    "x[a-z]{1,6}".prop_map(Spanned::from)
}

fn image() -> impl Strategy<Value = Image> {
    ([1..2000_u32, 1..2000_u32], [0..4_i32, 0..4_i32], count()).prop_map(|(resolution, aa, samples)| Image {
        resolution: Some(resolution.into()),
        aa: Some(aa.into()),
        samples: Some(samples),
        ..Image::default()
    })
}

fn camera() -> impl Strategy<Value = Camera> {
    let view = (positive(), positive(), [number(), number()]).prop_map(|(fov, aspect, shift)| View {
        fov,
        aspect,
        shift: Some(shift.into()),
    });
    let lens = (view, positive(), positive(), count(), number(), any::<bool>()).prop_map(
        |(view, focus_distance, radius, sides, rotation, pinhole)| match pinhole {
            true => Lens::Pinhole(view),
            false => Lens::Thin { view, focus_distance, radius, sides: Some(sides), rotation: Some(rotation.into()) },
        },
    );
    (lens, triple(), triple(), triple()).prop_map(|(lens, eye, target, up)| Camera {
        lens: lens.into(),
        placement: CameraPlacement::LookAt { eye, target, up },
        shutter: None,
    })
}

fn shader() -> impl Strategy<Value = Shader> {
    let paint = || prop_oneof![color().prop_map(Paint::Color), name().prop_map(Paint::Texture)];
    let absorption =
        (positive(), color()).prop_map(|(distance, color)| Absorption { distance: Some(distance), color: Some(color) });
    let kind = prop_oneof![
        color().prop_map(ShaderKind::Constant),
        paint().prop_map(ShaderKind::Diffuse),
        (paint(), color(), positive(), count()).prop_map(|(diffuse, specular, exponent, samples)| {
            ShaderKind::Phong { diffuse, specular, exponent, samples: Some(samples) }
        }),
        color().prop_map(ShaderKind::Mirror),
        (positive(), color(), absorption).prop_map(|(eta, color, absorption)| ShaderKind::Glass {
            eta,
            color,
            absorption
        }),
    ];
    (name(), kind).prop_map(|(name, kind)| Shader { name, kind })
}

fn object() -> impl Strategy<Value = Object> {
    let steps = vec(
        prop_oneof![
            [number(), number(), number()].prop_map(TransformStep::Translate),
            positive().prop_map(|by| TransformStep::ScaleUniform(by.value)),
            number().prop_map(TransformStep::RotateX),
            number().prop_map(TransformStep::RotateY),
            number().prop_map(TransformStep::RotateZ),
        ]
        .prop_map(Spanned::from),
        1..4,
    );
    let triangle =
        ([triple(), triple(), triple()], Just(vec![[0, 1, 2], [2, 1, 0]])).prop_map(|(points, triangles)| {
            let points = points.map(|point| point.value).to_vec();
            Shape::Mesh(Mesh { points: points.into(), triangles: triangles.into(), ..Mesh::default() })
        });
    let placed = steps.prop_map(|steps| Some(Spanned::from(Transform::Steps(steps))));
    let shape = prop_oneof![
        (triple(), positive())
            .prop_map(|(center, radius)| { (None, Shape::Sphere(SphereForm::CenterRadius { center, radius })) }),
        triple().prop_map(|point| {
            let normal = Spanned::from([0.0, 0.0, 1.0]);
            (None, Shape::Plane { point, orientation: PlaneOrientation::Normal(normal) })
        }),
        (placed, prop_oneof![Just(Shape::Box), triangle]),
    ];
    (name(), name(), shape).prop_map(|(shader, name, (transform, shape))| Object {
        shaders: vec![shader],
        modifiers: Vec::new(),
        transform,
        noinstance: None,
        accelerator: None,
        name: Some(name),
        shape: shape.into(),
    })
}

/// A statement of the kinds that the course's scenes have, and with all that it may say.
pub fn common_statement() -> impl Strategy<Value = Statement> {
    let order = prop::sample::select(BucketOrder::ALL.to_vec());
    let light = (color(), positive(), triple()).prop_map(|(color, power, position)| Light::Point {
        color,
        power: Some(power),
        position,
    });
    prop_oneof![
        image().prop_map(Statement::Image),
        (count(), order)
            .prop_map(|(size, order)| { Statement::Bucket(Bucket { size, order: order.into(), reversed: false }) }),
        [count(), count(), count()].prop_map(|[diffuse, reflection, refraction]| {
            let [diffuse, reflection, refraction] = [diffuse, reflection, refraction].map(Some);
            Statement::TraceDepths(TraceDepths { diffuse, reflection, refraction })
        }),
        color().prop_map(Statement::Background),
        camera().prop_map(Statement::Camera),
        shader().prop_map(Statement::Shader),
        object().prop_map(Statement::Object),
        light.prop_map(Statement::Light),
    ]
}

/// One to seven of these.
pub fn common_scene() -> impl Strategy<Value = SceneFile> {
    vec(common_statement().prop_map(Spanned::from), 1..8).prop_map(|statements| SceneFile { statements })
}
