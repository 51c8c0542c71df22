//! The fields of Sunflow's types that girasol reads but does not render, as tables.
//!
//! What is rendered has types of its own in `scene_file`; for the rest one form is enough, and these tables say what is of
//! which kind.

/// What a value must be.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Form {
    /// A number.
    Number,
    /// A whole number.
    Integer,
    /// `true` or `false`.
    Flag,
    /// Any word.
    Word,
    /// A colour in whatever space.
    Color,
    /// A point or a vector.
    Triple,
    /// A count, and so many numbers.
    List,
    /// Four numbers of a quaternion, one by one.
    Quadruple,
    /// A number that may be left out.
    MaybeNumber,
    /// A whole number that may be left out; the next value is none.
    MaybeInteger,
    /// Lines up to `</code>`.
    Code,
}

use Form::{Code, Color, Flag, Integer, List, MaybeInteger, MaybeNumber, Number, Quadruple, Triple, Word};

/// A field's first word, and what stands after it.
pub(crate) type FieldForm = (&'static str, &'static [Form]);

/// A type's name, and its fields.
pub(crate) type TypeForm = (&'static str, &'static [FieldForm]);

pub(crate) const GI: &[TypeForm] = &[
    (
        "irr-cache",
        &[
            ("samples", &[Integer]),
            ("tolerance", &[Number]),
            ("spacing", &[Number, Number]),
            ("global", &[Integer, Word, Integer, Number]),
        ],
    ),
    ("path", &[("samples", &[Integer]), ("bounces", &[Integer])]),
    ("fake", &[("up", &[Triple]), ("sky", &[Color]), ("ground", &[Color])]),
    (
        "igi",
        &[
            ("samples", &[Integer]),
            ("sets", &[Integer]),
            ("b", &[Number]),
            ("c", &[Number]),
            ("bias-samples", &[Integer]),
        ],
    ),
    ("ambocc", &[("bright", &[Color]), ("dark", &[Color]), ("samples", &[Integer]), ("maxdist", &[Number])]),
    ("none", &[]),
    ("null", &[]),
];

pub(crate) const PHOTONS: TypeForm = (
    "photons",
    &[
        ("emit", &[Integer]),
        ("global", &[MaybeInteger, Word, Integer, Number]),
        ("caustics", &[MaybeInteger, Word, Integer, Number]),
    ],
);

pub(crate) const LIGHT_SERVER: TypeForm = (
    "lightserver",
    &[
        ("shadows", &[Flag]),
        ("direct-samples", &[Integer]),
        ("glossy-samples", &[Integer]),
        ("max-depth", &[Integer]),
        ("global", &[Flag, Integer, Integer, Integer, Number]),
        ("caustics", &[Flag, Integer, Number, Integer, Number]),
        ("irr-cache", &[Integer, Number, Number, Number]),
    ],
);

pub(crate) const MODIFIERS: &[TypeForm] = &[
    ("bump", &[("texture", &[Word]), ("scale", &[Number])]),
    ("normalmap", &[("texture", &[Word])]),
    ("perlin", &[("function", &[Integer]), ("size", &[Number]), ("scale", &[Number])]),
];

const AMBIENT_OCCLUSION: &[FieldForm] = &[
    ("diff", &[Color]),
    ("bright", &[Color]),
    ("texture", &[Word]),
    ("dark", &[Color]),
    ("samples", &[Integer]),
    ("dist", &[Number]),
];

pub(crate) const SHADERS: &[TypeForm] = &[
    ("amb-occ", AMBIENT_OCCLUSION),
    ("amb-occ2", AMBIENT_OCCLUSION),
    (
        "ward",
        &[
            ("diff", &[Color]),
            ("texture", &[Word]),
            ("spec", &[Color]),
            ("rough", &[Number, Number]),
            ("samples", &[Integer]),
        ],
    ),
    (
        "uber",
        &[
            ("diff", &[Color]),
            ("diff.texture", &[Word]),
            ("diff.blend", &[Number]),
            ("refl", &[Color]),
            ("spec", &[Color]),
            ("texture", &[Word, MaybeNumber]),
            ("spec.texture", &[Word]),
            ("spec.blend", &[Number]),
            ("glossy", &[Number]),
            ("samples", &[Integer]),
        ],
    ),
    ("id", &[]),
    ("view-caustics", &[]),
    ("view-global", &[]),
    ("view-irradiance", &[]),
    ("janino", &[("typename", &[Word]), ("<code>", &[Code])]),
];

pub(crate) const OBJECTS: &[TypeForm] = &[
    ("banchoff", &[]),
    ("julia", &[("q", &[Quadruple]), ("iterations", &[Integer]), ("epsilon", &[Number])]),
    ("hair", &[("segments", &[Integer]), ("width", &[Number]), ("points", &[List])]),
    ("janino-tesselatable", &[("typename", &[Word]), ("<code>", &[Code])]),
];

pub(crate) const LIGHTS: &[TypeForm] = &[
    (
        "spherical",
        &[
            ("color", &[Color]),
            ("radiance", &[Number]),
            ("center", &[Triple]),
            ("radius", &[Number]),
            ("samples", &[Integer]),
        ],
    ),
    (
        "directional",
        &[
            ("source", &[Triple]),
            ("target", &[Triple]),
            ("radius", &[Number]),
            ("emit", &[Color]),
            ("intensity", &[Number]),
        ],
    ),
    (
        "ibl",
        &[
            ("image", &[Word]),
            ("center", &[Triple]),
            ("up", &[Triple]),
            ("lock", &[Flag]),
            ("samples", &[Integer]),
            ("lowsamples", &[Integer]),
        ],
    ),
    (
        "sunsky",
        &[
            ("up", &[Triple]),
            ("east", &[Triple]),
            ("sundir", &[Triple]),
            ("turbidity", &[Number]),
            ("samples", &[Integer]),
            ("ground.extendsky", &[Flag]),
            ("ground.color", &[Color]),
        ],
    ),
    (
        "cornellbox",
        &[
            ("corner0", &[Triple]),
            ("corner1", &[Triple]),
            ("left", &[Color]),
            ("right", &[Color]),
            ("top", &[Color]),
            ("bottom", &[Color]),
            ("back", &[Color]),
            ("emit", &[Color]),
            ("samples", &[Integer]),
        ],
    ),
];

/// The form of a type.
pub(crate) fn form_of(kind: &str, types: &[TypeForm]) -> Option<TypeForm> {
    types.iter().copied().find(|(name, _)| *name == kind)
}
