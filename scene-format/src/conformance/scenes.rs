//! Scenes of every form that the format has.

use proptest::collection::vec;
use proptest::option;
use proptest::prelude::*;

use crate::scene_file::*;
use crate::{SceneFile, Spanned};

/// Every finite float: the ordinary and the tiny, huge and negative zero.
pub fn float() -> impl Strategy<Value = f32> {
    use proptest::num::f32::{NEGATIVE, NORMAL, POSITIVE, SUBNORMAL, ZERO};
    prop_oneof![-100.0..100.0f32, (-50i8..50).prop_map(f32::from), POSITIVE | NEGATIVE | NORMAL | SUBNORMAL | ZERO]
}

fn number() -> impl Strategy<Value = Spanned<f32>> {
    float().prop_map(Spanned::from)
}

fn positive() -> impl Strategy<Value = Spanned<f32>> {
    float().prop_map(f32::abs).prop_filter("greater than 0", |number| *number > 0.0).prop_map(Spanned::from)
}

fn row<const N: usize>() -> impl Strategy<Value = [f32; N]> {
    vec(float(), N).prop_map(|numbers| std::array::from_fn(|index| numbers[index]))
}

fn floats<const N: usize>() -> impl Strategy<Value = Spanned<[f32; N]>> {
    row().prop_map(Spanned::from)
}

/// Words that the format can say: without `"` and line ends, and no braces.
fn word() -> impl Strategy<Value = String> {
    prop_oneof!["[a-z]{1,6}", "[ -!#-z|~äß\u{3000}]{0,8}", Just("/*".to_owned()), Just("%".to_owned())]
}

fn name() -> impl Strategy<Value = Spanned<String>> {
    word().prop_map(Spanned::from)
}

/// Scenes of one to seven statements.
pub fn scene() -> impl Strategy<Value = SceneFile> {
    vec(statement().prop_map(Spanned::from), 1..8).prop_map(|statements| SceneFile { statements })
}

/// Statements of every form, whether rendered or not.
pub fn statement() -> impl Strategy<Value = Statement> {
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
        light().prop_map(Statement::Light),
        name().prop_map(Statement::TexturePath),
        name().prop_map(Statement::IncludePath),
        name().prop_map(|path| Statement::Include { path, file: None }),
        (name(), kind(MODIFIERS, "wobble")).prop_map(|(name, kind)| Statement::Modifier { name, kind }),
        kind(GI, "radiosity").prop_map(Statement::Gi),
        typed(&[("photons", PHOTONS)]).prop_map(Statement::Photons),
        typed(&[("lightserver", LIGHT_SERVER)]).prop_map(Statement::LightServer),
        (name(), spanned(any::<bool>())).prop_map(|(shader, photons)| Statement::Override { shader, photons }),
        name().prop_map(Statement::Accelerator),
        (name(), option::of(floats())).prop_map(|(name, size)| Statement::Filter { name, size }),
        unknown_statement().prop_map(Statement::Unknown),
    ]
}

fn spanned<T: std::fmt::Debug>(strategy: impl Strategy<Value = T>) -> impl Strategy<Value = Spanned<T>> {
    strategy.prop_map(Spanned::from)
}

fn option_triple() -> impl Strategy<Value = [Option<Spanned<u32>>; 3]> {
    prop::array::uniform3(option::of(count()))
}

fn count() -> impl Strategy<Value = Spanned<u32>> + Clone {
    (0..=i32::MAX as u32).prop_map(Spanned::from)
}

fn flag() -> impl Strategy<Value = Option<Spanned<bool>>> {
    option::of(spanned(any::<bool>()))
}

fn image() -> impl Strategy<Value = Image> {
    let size = (
        option::of(spanned(prop::array::uniform2(1..=16384u32))),
        option::of(name()),
        option::of(spanned(any::<[i32; 2]>())),
        option::of(count()),
    );
    let quality = (option::of(number()), option::of(name()), flag());
    let old = (flag(), flag(), option::of(name()));
    (size, quality, old).prop_map(
        |((resolution, sampler, aa, samples), (contrast, filter, jitter), (show_aa, cache, output))| Image {
            resolution,
            sampler,
            aa,
            samples,
            contrast,
            filter,
            jitter,
            show_aa,
            cache,
            output,
        },
    )
}

fn bucket() -> impl Strategy<Value = Bucket> {
    let order = prop::sample::select(BucketOrder::ALL.to_vec());
    (1..=i32::MAX as u32, order, any::<bool>()).prop_map(|(size, order, reversed)| Bucket {
        size: size.into(),
        order: order.into(),
        reversed,
    })
}

fn color() -> impl Strategy<Value = Spanned<Color>> {
    spanned(prop_oneof![
        row().prop_map(Color::Bare),
        row().prop_map(Color::SrgbNonlinear),
        row().prop_map(Color::SrgbLinear),
        row().prop_map(Color::Xyz),
        positive().prop_map(|kelvin| Color::Blackbody(kelvin.value)),
        (row(), vec(float(), 1..5)).prop_map(|(range, values)| Color::Spectrum { range, values }),
    ])
}

fn paint() -> impl Strategy<Value = Paint> {
    prop_oneof![color().prop_map(Paint::Color), name().prop_map(Paint::Texture)]
}

fn camera() -> impl Strategy<Value = Camera> {
    let lens = prop_oneof![
        view().prop_map(Lens::Pinhole),
        (view(), positive(), number(), option::of(count()), option::of(number())).prop_map(
            |(view, focus_distance, radius, sides, rotation)| Lens::Thin {
                view,
                focus_distance,
                radius: radius.value.abs().into(),
                sides,
                rotation,
            }
        ),
        Just(Lens::Spherical),
        Just(Lens::Fisheye),
    ];
    let placement = prop_oneof![
        4 => still_place(),
        1 => (floats(), vec(still_place(), 1..4)).prop_map(|(times, steps)| CameraPlacement::Moving { times, steps }),
        1 => transform().prop_map(|transform| CameraPlacement::Transform(transform.into())),
    ];
    (spanned(lens), placement, option::of(floats())).prop_map(|(lens, placement, shutter)| Camera {
        lens,
        placement,
        shutter,
    })
}

fn view() -> impl Strategy<Value = View> {
    let aspect = number().prop_filter("not 0", |aspect| aspect.value != 0.0);
    (number(), aspect, option::of(floats())).prop_map(|(fov, aspect, shift)| View { fov, aspect, shift })
}

fn still_place() -> impl Strategy<Value = CameraPlacement> {
    prop_oneof![
        (floats(), floats(), floats()).prop_map(|(eye, target, up)| CameraPlacement::LookAt { eye, target, up }),
        still_transform().prop_map(|transform| CameraPlacement::Transform(transform.into())),
    ]
}

fn transform() -> impl Strategy<Value = Transform> {
    prop_oneof![
        4 => still_transform(),
        1 => (floats(), vec(still_transform().prop_map(Spanned::from), 1..4))
            .prop_map(|(times, steps)| Transform::Moving { times, steps }),
    ]
}

fn still_transform() -> impl Strategy<Value = Transform> {
    prop_oneof![
        row::<12>().prop_map(|m| {
            let [a, b, c, d, e, f, g, h, i, j, k, l] = m;
            Transform::Row([a, b, c, d, e, f, g, h, i, j, k, l, 0.0, 0.0, 0.0, 1.0])
        }),
        row::<12>().prop_map(|m| {
            let [a, b, c, d, e, f, g, h, i, j, k, l] = m;
            Transform::Col([a, b, c, 0.0, d, e, f, 0.0, g, h, i, 0.0, j, k, l, 1.0])
        }),
        vec(spanned(transform_step()), 0..4).prop_map(Transform::Steps),
    ]
}

fn transform_step() -> impl Strategy<Value = TransformStep> {
    prop_oneof![
        row().prop_map(TransformStep::Translate),
        float().prop_map(TransformStep::ScaleUniform),
        row().prop_map(TransformStep::Scale),
        float().prop_map(TransformStep::ScaleX),
        float().prop_map(TransformStep::ScaleY),
        float().prop_map(TransformStep::ScaleZ),
        float().prop_map(TransformStep::RotateX),
        float().prop_map(TransformStep::RotateY),
        float().prop_map(TransformStep::RotateZ),
        (row(), float()).prop_map(|(axis, degrees)| TransformStep::Rotate { axis, degrees }),
    ]
}

fn shader_kind() -> impl Strategy<Value = ShaderKind> {
    let absorption =
        (option::of(number()), option::of(color())).prop_map(|(distance, color)| Absorption { distance, color });
    prop_oneof![
        color().prop_map(ShaderKind::Constant),
        paint().prop_map(ShaderKind::Diffuse),
        (paint(), color(), number(), option::of(count())).prop_map(|(diffuse, specular, exponent, samples)| {
            ShaderKind::Phong { diffuse, specular, exponent, samples }
        }),
        color().prop_map(ShaderKind::Mirror),
        (positive(), color(), absorption).prop_map(|(eta, color, absorption)| ShaderKind::Glass {
            eta,
            color,
            absorption
        }),
        (paint(), number()).prop_map(|(diffuse, reflection)| ShaderKind::Shiny { diffuse, reflection }),
        typed(SHADERS).prop_map(ShaderKind::Unrendered),
        (unknown("marble"), option::of(row())).prop_map(|(mut block, diffuse)| {
            // The paint is what the words say it is.
            if let Some(diffuse) = diffuse {
                block.words.push("diff".to_owned().into());
                block.words.extend(diffuse.iter().map(|channel| Spanned::from(channel.to_string())));
            }
            let paint = diffuse.map(|diffuse| Paint::Color(Color::Bare(diffuse).into()));
            ShaderKind::Unknown { block, paint }
        }),
    ]
}

fn object() -> impl Strategy<Value = Object> {
    let shape = prop_oneof![
        Just(Shape::Sphere(SphereForm::Unit)),
        (floats(), number()).prop_map(|(center, radius)| Shape::Sphere(SphereForm::CenterRadius { center, radius })),
        (floats(), plane_orientation()).prop_map(|(point, orientation)| Shape::Plane { point, orientation }),
        Just(Shape::Box),
        mesh().prop_map(Shape::Mesh),
        (name(), flag()).prop_map(|(file, smooth)| Shape::FileMesh { file, smooth }),
        bezier().prop_map(Shape::Bezier),
        Just(Shape::Cylinder),
        [positive(), positive()].prop_map(|radii| Shape::Torus { radii: radii.map(|radius| radius.value).into() }),
        (option::of(count()), option::of(nonzero()), option::of(number()))
            .prop_map(|(level, axis, radius)| Shape::Sphereflake { level, axis, radius }),
        subdivision().prop_map(Shape::Teapot),
        subdivision().prop_map(Shape::Gumbo),
        particles(),
        typed(OBJECTS).prop_map(Shape::Unrendered),
        unknown("terrain").prop_map(Shape::Unknown),
    ];
    let names = || vec(name(), 0..3);
    let noinstance = option::of(Just(Spanned::from(())));
    let common = (names(), names(), option::of(spanned(transform())));
    (common, noinstance, option::of(name()), option::of(name()), spanned(shape)).prop_map(
        |((shaders, modifiers, transform), noinstance, accelerator, name, shape)| Object {
            shaders,
            modifiers,
            transform,
            noinstance,
            accelerator,
            name,
            shape,
        },
    )
}

fn subdivision() -> impl Strategy<Value = Subdivision> {
    let count = option::of((1..=i32::MAX as u32).prop_map(Spanned::from));
    (count, flag()).prop_map(|(count, smooth)| Subdivision { count, smooth })
}

fn bezier() -> impl Strategy<Value = BezierMesh> {
    let size = [4..8u32, 4..8u32].prop_map(|[along_u, along_v]| (along_u, along_v));
    size.prop_flat_map(|(along_u, along_v)| {
        let points = spanned(vec(row(), (along_u * along_v) as usize));
        (option::of(spanned(any::<[bool; 2]>())), points, subdivision()).prop_map(move |(wrap, points, subdivision)| {
            BezierMesh { size: [along_u, along_v].into(), wrap, points, subdivision }
        })
    })
}

fn particles() -> impl Strategy<Value = Shape> {
    let little_endian = option::of(Just(Spanned::from(())));
    let centers = prop_oneof![
        spanned(vec(row(), 0..5)).prop_map(ParticleSource::Points),
        (name(), little_endian).prop_map(|(name, little_endian)| ParticleSource::File { name, little_endian }),
    ];
    (centers, option::of(count()), positive()).prop_map(|(centers, count, radius)| Shape::Particles {
        centers,
        count,
        radius,
    })
}

fn nonzero() -> impl Strategy<Value = Spanned<Triple>> {
    floats().prop_filter("not 0", |vector| vector.value != [0.0; 3])
}

fn plane_orientation() -> impl Strategy<Value = PlaneOrientation> {
    prop_oneof![nonzero().prop_map(PlaneOrientation::Normal), [floats(), floats()].prop_map(PlaneOrientation::Points),]
}

fn instance() -> impl Strategy<Value = Instance> {
    let names = || vec(name(), 0..3);
    (option::of(name()), name(), option::of(spanned(transform())), names(), names()).prop_map(
        |(name, geometry, transform, shaders, modifiers)| Instance { name, geometry, transform, shaders, modifiers },
    )
}

fn mesh() -> impl Strategy<Value = Mesh> {
    (1..6usize, 0..5usize).prop_flat_map(|(points, triangles)| {
        let generic = (per_vertex(points, triangles), per_vertex(points, triangles));
        let generic = (generic, option::of(spanned(vec(0..4u32, triangles))))
            .prop_map(|((normals, uvs), face_shaders)| (MeshForm::Generic, normals, uvs, face_shaders));
        let form = prop_oneof![Just(MeshForm::Lines), Just(MeshForm::FlatLines)];
        let lines = (form, vec(row(), points), vec(row(), points))
            .prop_map(|(form, normals, uvs)| (form, PerVertex::Vertex(normals), PerVertex::Vertex(uvs), None));
        (triangles_of(points, triangles), prop_oneof![generic, lines]).prop_map(
            |((points, triangles), (form, normals, uvs, face_shaders))| Mesh {
                form,
                points,
                triangles,
                normals: normals.into(),
                uvs: uvs.into(),
                face_shaders,
            },
        )
    })
}

type Triangles = (Spanned<Vec<Triple>>, Spanned<Vec<[u32; 3]>>);

fn triangles_of(points: usize, triangles: usize) -> impl Strategy<Value = Triangles> {
    let corner = 0..points as u32;
    (spanned(vec(row(), points)), spanned(vec(prop::array::uniform3(corner), triangles)))
}

fn per_vertex<const N: usize>(points: usize, triangles: usize) -> impl Strategy<Value = PerVertex<N>> {
    prop_oneof![
        Just(PerVertex::None),
        vec(row(), points).prop_map(PerVertex::Vertex),
        vec([row(), row(), row()], triangles).prop_map(PerVertex::FaceVarying),
    ]
}

fn light() -> impl Strategy<Value = Light> {
    prop_oneof![
        (color(), option::of(number()), floats()).prop_map(|(color, power, position)| Light::Point {
            color,
            power,
            position
        }),
        mesh_light(),
        typed(LIGHTS).prop_map(Light::Unrendered),
        unknown("ibl2").prop_map(Light::Unknown),
    ]
}

fn mesh_light() -> impl Strategy<Value = Light> {
    let generic = triangles_of(3, 2).prop_map(|(points, triangles)| Mesh { points, triangles, ..Mesh::default() });
    let lines = mesh().prop_filter("in the old form", |mesh| mesh.form == MeshForm::Lines);
    (option::of(name()), color(), option::of(number()), option::of(count()), spanned(prop_oneof![generic, lines]))
        .prop_map(|(name, emission, radiance, samples, mesh)| Light::Mesh {
            name,
            emission,
            radiance,
            samples,
            mesh: Box::new(mesh),
        })
}

/// What a field of a type that is not rendered has after its name, each letter a value: `n`umber, `i`nteger, `b`ool, `w`ord,
/// `c`olor, `3` or `4` numbers, `l`ist, `<` code.
type Fields = &'static [(&'static str, &'static str)];
type Types = &'static [(&'static str, Fields)];

const GI: Types = &[
    ("irr-cache", &[("samples", "i"), ("tolerance", "n"), ("spacing", "nn"), ("global", "iwin")]),
    ("path", &[("samples", "i"), ("bounces", "i")]),
    ("fake", &[("up", "3"), ("sky", "c"), ("ground", "c")]),
    ("igi", &[("samples", "i"), ("sets", "i"), ("b", "n"), ("c", "n"), ("bias-samples", "i")]),
    ("ambocc", &[("bright", "c"), ("dark", "c"), ("samples", "i"), ("maxdist", "n")]),
    ("none", &[]),
    ("null", &[]),
];
const PHOTONS: Fields = &[("emit", "i"), ("global", "iwin"), ("caustics", "win")];
const LIGHT_SERVER: Fields = &[
    ("shadows", "b"),
    ("direct-samples", "i"),
    ("glossy-samples", "i"),
    ("max-depth", "i"),
    ("global", "biiin"),
    ("caustics", "binin"),
    ("irr-cache", "innn"),
];
const MODIFIERS: Types = &[
    ("bump", &[("texture", "w"), ("scale", "n")]),
    ("normalmap", &[("texture", "w")]),
    ("perlin", &[("function", "i"), ("size", "n"), ("scale", "n")]),
];
const OCCLUSION: Fields = &[("bright", "c"), ("texture", "w"), ("dark", "c"), ("samples", "i"), ("dist", "n")];
const SHADERS: Types = &[
    ("amb-occ", OCCLUSION),
    ("amb-occ2", OCCLUSION),
    ("ward", &[("diff", "c"), ("spec", "c"), ("rough", "nn"), ("samples", "i")]),
    (
        "uber",
        &[
            ("diff", "c"),
            ("diff.texture", "w"),
            ("diff.blend", "n"),
            ("refl", "c"),
            ("texture", "wn"),
            ("spec.texture", "w"),
            ("spec.blend", "n"),
            ("glossy", "n"),
            ("samples", "i"),
        ],
    ),
    ("id", &[]),
    ("view-caustics", &[]),
    ("view-global", &[]),
    ("view-irradiance", &[]),
    ("janino", &[("typename", "w"), ("<code>", "<")]),
];
const OBJECTS: Types = &[
    ("banchoff", &[]),
    ("julia", &[("q", "4"), ("iterations", "i"), ("epsilon", "n")]),
    ("hair", &[("segments", "i"), ("width", "n"), ("points", "l")]),
    ("janino-tesselatable", &[("typename", "w"), ("<code>", "<")]),
];
const LIGHTS: Types = &[
    ("spherical", &[("color", "c"), ("radiance", "n"), ("center", "3"), ("radius", "n"), ("samples", "i")]),
    ("directional", &[("source", "3"), ("target", "3"), ("radius", "n"), ("emit", "c"), ("intensity", "n")]),
    ("ibl", &[("image", "w"), ("center", "3"), ("up", "3"), ("lock", "b"), ("samples", "i"), ("lowsamples", "i")]),
    (
        "sunsky",
        &[
            ("up", "3"),
            ("east", "3"),
            ("sundir", "3"),
            ("turbidity", "n"),
            ("ground.extendsky", "b"),
            ("ground.color", "c"),
        ],
    ),
    (
        "cornellbox",
        &[
            ("corner0", "3"),
            ("corner1", "3"),
            ("left", "c"),
            ("right", "c"),
            ("back", "c"),
            ("emit", "c"),
            ("samples", "i"),
        ],
    ),
];

/// A block of one of some types, with some of its fields.
fn typed(types: Types) -> impl Strategy<Value = Unrendered> {
    prop::sample::select(types).prop_flat_map(|(kind, fields)| {
        prop::sample::subsequence(fields, 0..=fields.len())
            .prop_flat_map(|fields| fields.into_iter().map(field).collect::<Vec<_>>())
            .prop_map(move |fields| Unrendered { kind: kind.to_owned().into(), fields })
    })
}

fn kind(types: Types, unknown_kind: &'static str) -> impl Strategy<Value = Kind> {
    prop_oneof![4 => typed(types).prop_map(Kind::Unrendered), 1 => unknown(unknown_kind).prop_map(Kind::Unknown)]
}

fn field((name, values): (&'static str, &'static str)) -> BoxedStrategy<Field> {
    let values: Vec<_> = values.chars().map(value).collect();
    values.prop_map(move |values| Field { name: name.to_owned().into(), values }).boxed()
}

fn value(kind: char) -> BoxedStrategy<Spanned<Value>> {
    let value = match kind {
        'n' => float().prop_map(Value::Number).boxed(),
        'i' => any::<i32>().prop_map(Value::Integer).boxed(),
        'b' => any::<bool>().prop_map(Value::Flag).boxed(),
        // No number: one that may be left out would be taken for it.
        'w' => word().prop_filter("no number", |word| word.parse::<f32>().is_err()).prop_map(Value::Word).boxed(),
        'c' => color().prop_map(|color| Value::Color(color.value)).boxed(),
        '3' => vec(float(), 3).prop_map(Value::Numbers).boxed(),
        '4' => vec(float(), 4).prop_map(Value::Numbers).boxed(),
        'l' => vec(float(), 0..5).prop_map(Value::List).boxed(),
        _ => code().prop_map(Value::Code).boxed(),
    };
    value.prop_map(Spanned::from).boxed()
}

fn code() -> impl Strategy<Value = Vec<String>> {
    vec("[ -~]{0,9}", 0..3)
        .prop_map(|lines| lines.into_iter().filter(|line| !line.trim_start().starts_with("</code>")).collect())
}

/// A block of a type that nobody knows. No word in it is a field that its kind of block is asked for.
fn unknown(kind: &'static str) -> impl Strategy<Value = Unknown> {
    let word = || prop_oneof!["x[a-z]{0,4}", "[0-9]{1,3}", "x [%#\" ]y".prop_map(|word| word.replace('"', "'"))];
    let code = code().prop_map(|lines| {
        let lines = ["<code>".to_owned()].into_iter().chain(lines).chain(["</code>".to_owned()]);
        vec![lines.collect::<Vec<_>>().join("\n")]
    });
    let group = vec(word(), 0..3)
        .prop_map(|words| ["{".to_owned()].into_iter().chain(words).chain(["}".to_owned()]).collect::<Vec<_>>());
    vec(prop_oneof![3 => vec(word(), 1), 1 => group, 1 => code], 0..4).prop_map(move |words| Unknown {
        keyword: kind.to_owned().into(),
        words: words.concat().into_iter().map(Spanned::from).collect(),
    })
}

fn unknown_statement() -> impl Strategy<Value = Unknown> {
    let braced = |keyword: &str, words: Vec<Spanned<String>>| {
        let brace = |text: &str| Spanned::from(text.to_owned());
        let words = [brace("{")].into_iter().chain(words).chain([brace("}")]).collect();
        Unknown { keyword: keyword.to_owned().into(), words }
    };
    let words = |text: &str| text.split(' ').map(|word| Spanned::from(word.to_owned())).collect();
    prop_oneof![
        unknown("").prop_map(move |inside| braced("xyzzy", inside.words)),
        Just(braced("camera", words("type flength eye 1"))),
    ]
}
