//! Scenes of every form that the format has.

use proptest::collection::vec;
use proptest::option;
use proptest::prelude::*;
use scene_format::scene_file::*;
use scene_format::{SceneFile, Span, Spanned};

/// Every finite float: the ordinary and the tiny, huge and negative zero.
pub(crate) fn float() -> impl Strategy<Value = f32> {
    use proptest::num::f32::{NEGATIVE, NORMAL, POSITIVE, SUBNORMAL, ZERO};
    prop_oneof![-100.0..100.0f32, (-50i8..50).prop_map(f32::from), POSITIVE | NEGATIVE | NORMAL | SUBNORMAL | ZERO]
}

fn positive() -> impl Strategy<Value = f32> {
    float().prop_map(f32::abs).prop_filter("greater than 0", |number| *number > 0.0)
}

fn floats<const N: usize>() -> impl Strategy<Value = [f32; N]> {
    vec(float(), N).prop_map(|numbers| numbers.try_into().unwrap())
}

/// Words that the format can say: without `"` and line ends, and no braces.
fn word() -> impl Strategy<Value = String> {
    prop_oneof!["[a-z]{1,6}", "[ -!#-z|~äß\u{3000}]{0,8}", Just("/*".to_owned()), Just("%".to_owned())]
}

fn name() -> impl Strategy<Value = Spanned<String>> {
    word().prop_map(Spanned::from)
}

pub(crate) fn scene() -> impl Strategy<Value = SceneFile> {
    vec(statement().prop_map(Spanned::from), 1..8).prop_map(|statements| SceneFile { statements })
}

pub(crate) fn statement() -> impl Strategy<Value = Statement> {
    prop_oneof![
        image().prop_map(Statement::Image),
        bucket().prop_map(Statement::Bucket),
        option_triple().prop_map(|[diffuse, reflection, refraction]| {
            Statement::TraceDepths(TraceDepths { diffuse, reflection, refraction })
        }),
        color().prop_map(Statement::Background),
        camera().prop_map(Statement::Camera),
        (name(), shader_kind()).prop_map(|(name, kind)| Statement::Shader(Shader { name, kind })),
        object().prop_map(Statement::Object),
        instance().prop_map(Statement::Instance),
        light().prop_map(|kind| Statement::Light(Light { kind })),
        name().prop_map(Statement::TexturePath),
        name().prop_map(Statement::IncludePath),
        name().prop_map(|path| Statement::Include { path, file: None }),
        other_statement().prop_map(Statement::Other),
    ]
}

fn option_triple() -> impl Strategy<Value = [Option<u32>; 3]> {
    prop::array::uniform3(option::of(0..=i32::MAX as u32))
}

fn image() -> impl Strategy<Value = Image> {
    (
        option::of(prop::array::uniform2(1..=16384u32)),
        option::of(word()),
        option::of(any::<[i32; 2]>()),
        option::of(0..=i32::MAX as u32),
        option::of(float()),
        option::of(word()),
        option::of(any::<bool>()),
    )
        .prop_map(|(resolution, sampler, aa, samples, contrast, filter, jitter)| Image {
            resolution,
            sampler,
            aa,
            samples,
            contrast,
            filter,
            jitter,
        })
}

fn bucket() -> impl Strategy<Value = Bucket> {
    let order = prop::sample::select(BucketOrder::ALL.to_vec());
    (1..=16384u32, order, any::<bool>()).prop_map(|(size, order, reversed)| Bucket { size, order, reversed })
}

fn color() -> impl Strategy<Value = Color> {
    prop_oneof![
        floats().prop_map(Color::Bare),
        floats().prop_map(Color::SrgbNonlinear),
        floats().prop_map(Color::SrgbLinear),
        floats().prop_map(Color::Xyz),
    ]
}

fn paint() -> impl Strategy<Value = Paint> {
    prop_oneof![color().prop_map(Paint::Color), name().prop_map(Paint::Texture)]
}

fn camera() -> impl Strategy<Value = Camera> {
    let lens = prop_oneof![
        Just(Lens::Pinhole),
        (positive(), float(), option::of(0..9u32), option::of(float())).prop_map(
            |(focus_distance, radius, sides, rotation)| Lens::Thin {
                focus_distance,
                radius: radius.abs(),
                sides,
                rotation
            }
        )
    ];
    let placement = prop_oneof![
        (floats(), floats(), floats())
            .prop_map(|(eye, target, up)| { CameraPlacement::LookAt { eye, target, up, span: Span::default() } }),
        transform().prop_map(|transform| CameraPlacement::Transform(transform.into())),
    ];
    let fov = positive().prop_filter("less than 180", |fov| *fov < 180.0);
    (lens, placement, fov, positive(), option::of(floats())).prop_map(|(lens, placement, fov, aspect, shift)| Camera {
        lens,
        placement,
        fov: fov.into(),
        aspect: aspect.into(),
        shift,
    })
}

fn transform() -> impl Strategy<Value = Transform> {
    prop_oneof![
        floats::<12>().prop_map(|m| {
            let [a, b, c, d, e, f, g, h, i, j, k, l] = m;
            Transform::Row([a, b, c, d, e, f, g, h, i, j, k, l, 0.0, 0.0, 0.0, 1.0])
        }),
        floats::<12>().prop_map(|m| {
            let [a, b, c, d, e, f, g, h, i, j, k, l] = m;
            Transform::Col([a, b, c, 0.0, d, e, f, 0.0, g, h, i, 0.0, j, k, l, 1.0])
        }),
        vec(transform_step(), 0..4).prop_map(Transform::Steps),
    ]
}

fn transform_step() -> impl Strategy<Value = TransformStep> {
    prop_oneof![
        floats().prop_map(TransformStep::Translate),
        float().prop_map(TransformStep::ScaleUniform),
        floats().prop_map(TransformStep::Scale),
        float().prop_map(TransformStep::ScaleX),
        float().prop_map(TransformStep::ScaleY),
        float().prop_map(TransformStep::ScaleZ),
        float().prop_map(TransformStep::RotateX),
        float().prop_map(TransformStep::RotateY),
        float().prop_map(TransformStep::RotateZ),
        (floats(), float()).prop_map(|(axis, degrees)| TransformStep::Rotate { axis, degrees }),
    ]
}

fn shader_kind() -> impl Strategy<Value = ShaderKind> {
    let absorption =
        (option::of(float()), option::of(color())).prop_map(|(distance, color)| Absorption { distance, color });
    prop_oneof![
        color().prop_map(ShaderKind::Constant),
        paint().prop_map(ShaderKind::Diffuse),
        (paint(), color(), float(), option::of(0..99u32)).prop_map(|(diffuse, specular, exponent, samples)| {
            ShaderKind::Phong { diffuse, specular, exponent, samples }
        }),
        color().prop_map(ShaderKind::Mirror),
        (positive(), color(), absorption).prop_map(|(eta, color, absorption)| ShaderKind::Glass {
            eta,
            color,
            absorption
        }),
        (paint(), float()).prop_map(|(diffuse, reflection)| ShaderKind::Shiny { diffuse, reflection }),
        (other("ward"), option::of(floats())).prop_map(|(mut block, diffuse)| {
            // The paint is what the words say it is.
            if let Some(diffuse) = diffuse {
                block.words.push("diff".to_owned());
                block.words.extend(diffuse.iter().map(f32::to_string));
            }
            ShaderKind::Other { block, diffuse: diffuse.map(|diffuse| Paint::Color(Color::Bare(diffuse))) }
        }),
    ]
}

fn object() -> impl Strategy<Value = Object> {
    let shape = prop_oneof![
        Just(Shape::Sphere(SphereForm::Unit)),
        (floats(), positive()).prop_map(|(center, radius)| Shape::Sphere(SphereForm::CenterRadius { center, radius })),
        (floats(), plane_orientation()).prop_map(|(point, orientation)| Shape::Plane { point, orientation }),
        Just(Shape::Box),
        mesh().prop_map(Shape::Mesh),
        other("teapot").prop_map(Shape::Other),
    ];
    let names = || vec(name(), 0..3);
    (names(), names(), option::of(transform()), any::<bool>(), option::of(name()), shape).prop_map(
        |(shaders, modifiers, transform, noinstance, name, shape)| Object {
            shaders,
            modifiers,
            transform: transform.map(Spanned::from),
            noinstance,
            name,
            shape: shape.into(),
        },
    )
}

fn plane_orientation() -> impl Strategy<Value = PlaneOrientation> {
    prop_oneof![
        floats().prop_filter("not 0", |normal| *normal != [0.0; 3]).prop_map(PlaneOrientation::Normal),
        [floats(), floats()].prop_map(PlaneOrientation::Points),
    ]
}

fn instance() -> impl Strategy<Value = Instance> {
    let names = || vec(name(), 0..3);
    (option::of(name()), name(), option::of(transform()), names(), names()).prop_map(
        |(name, geometry, transform, shaders, modifiers)| Instance {
            name,
            geometry,
            transform: transform.map(Spanned::from),
            shaders,
            modifiers,
        },
    )
}

fn mesh() -> impl Strategy<Value = Mesh> {
    (1..6usize, 0..5usize).prop_flat_map(|(points, triangles)| {
        let corner = 0..points as u32;
        let shape = (vec(floats(), points), vec(prop::array::uniform3(corner), triangles));
        let generic = (per_vertex(points, triangles), per_vertex(points, triangles));
        let generic = (generic, option::of(vec(0..4u32, triangles)))
            .prop_map(|((normals, uvs), face_shaders)| (MeshForm::Generic, normals, uvs, face_shaders));
        let form = prop_oneof![Just(MeshForm::Lines), Just(MeshForm::FlatLines)];
        let lines = (form, vec(floats(), points), vec(floats(), points))
            .prop_map(|(form, normals, uvs)| (form, PerVertex::Vertex(normals), PerVertex::Vertex(uvs), None));
        (shape, prop_oneof![generic, lines]).prop_map(|((points, triangles), (form, normals, uvs, face_shaders))| {
            Mesh { form, points, triangles, normals, uvs, face_shaders }
        })
    })
}

fn per_vertex<const N: usize>(points: usize, triangles: usize) -> impl Strategy<Value = PerVertex<N>> {
    prop_oneof![
        Just(PerVertex::None),
        vec(floats(), points).prop_map(PerVertex::Vertex),
        vec([floats(), floats(), floats()], triangles).prop_map(PerVertex::FaceVarying),
    ]
}

fn light() -> impl Strategy<Value = LightKind> {
    prop_oneof![
        (color(), option::of(float()), floats()).prop_map(|(color, power, position)| LightKind::Point {
            color,
            power,
            position
        }),
        other("sunsky").prop_map(LightKind::Other),
    ]
}

/// A block of a type that is not rendered. No word in it is a field that its kind of block is asked for.
fn other(kind: &'static str) -> impl Strategy<Value = Other> {
    let word = || prop_oneof!["x[a-z]{0,4}", "[0-9]{1,3}", "x [%#\" ]y".prop_map(|word| word.replace('"', "'"))];
    let code = vec("[ -~]{0,9}", 0..3).prop_map(|lines| {
        let lines = lines.into_iter().filter(|line| line.trim() != "</code>");
        ["<code>".to_owned()].into_iter().chain(lines).chain(["</code>".to_owned()]).collect()
    });
    let group = vec(word(), 0..3)
        .prop_map(|words| ["{".to_owned()].into_iter().chain(words).chain(["}".to_owned()]).collect::<Vec<_>>());
    vec(prop_oneof![3 => vec(word(), 1), 1 => group, 1 => code], 0..4)
        .prop_map(move |words| Other { keyword: kind.to_owned().into(), words: words.concat() })
}

fn other_statement() -> impl Strategy<Value = Other> {
    let block = prop::sample::select(&["gi", "photons", "lightserver", "modifier", "xyzzy"][..]);
    prop_oneof![
        (block, other("")).prop_map(|(keyword, inside)| {
            let words = ["{".to_owned()].into_iter().chain(inside.words).chain(["}".to_owned()]).collect();
            Other { keyword: keyword.to_owned().into(), words }
        }),
        word().prop_map(|word| Other { keyword: "accel".to_owned().into(), words: vec![word] }),
        Just(Other {
            keyword: "filter".to_owned().into(),
            words: vec!["box".to_owned(), "1".to_owned(), "2".to_owned()]
        }),
        Just(Other {
            keyword: "camera".to_owned().into(),
            words: ["{", "type", "fisheye", "eye", "1", "}"].map(str::to_owned).to_vec(),
        }),
    ]
}
