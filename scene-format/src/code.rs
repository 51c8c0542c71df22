use std::fmt;

/// What kind of problem a message is about: stable from version to version, so that tools can rely on it.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[non_exhaustive]
pub enum Code {
    /// A statement that nobody knows.
    UnknownStatement,
    /// A brace between statements.
    StrayBrace,
    /// A statement without the block that it needs.
    MissingBlock,
    /// A block that is not closed.
    UnclosedBlock,
    /// A colour or transform that is not closed.
    UnclosedGroup,
    /// A comment that is not closed.
    UnclosedComment,
    /// A word in a block that begins no field.
    UnknownWord,
    /// A field that a block of this type does not have.
    MeaninglessField,
    /// A number that belongs to no field.
    StrayNumber,
    /// A field given twice.
    RepeatedField,
    /// A field that the block cannot do without.
    MissingField,
    /// A block without its type.
    MissingType,
    /// A type that nobody knows.
    UnknownType,
    /// Another word than the one that must stand there.
    Expected,
    /// The same thing said in two ways.
    Contradiction,
    /// A file without a statement.
    EmptyFile,
    /// A quote that is not closed in its line.
    UnclosedQuote,
    /// A word where a number is due.
    NotANumber,
    /// A number that is not finite.
    NotFinite,
    /// A number that is impossible here.
    OutOfRange,
    /// Neither `true` nor `false`.
    NotAFlag,
    /// A colour space that nobody knows.
    UnknownColorSpace,
    /// A step of a transform that nobody knows.
    UnknownStep,
    /// A matrix whose last row is not 0 0 0 1.
    NotAffine,
    /// An order of buckets that nobody knows.
    UnknownOrder,
    /// A view that no plane can show: 180 degrees or more, or an aspect below 0.
    ImpossibleView,
    /// A list that ends before its count.
    ListTooShort,
    /// A list that goes on after its count.
    ListTooLong,
    /// Values that stand before what they belong to.
    TooEarly,
    /// A corner that is no point of the mesh.
    NoSuchPoint,
    /// A plane that its fields do not determine.
    UndeterminedPlane,
    /// A face shader that is not in the object's list.
    NoSuchFaceShader,
    /// Triangles without area.
    FlatTriangles,
    /// A transform without inverse.
    NoInverse,
    /// An object that reaches too far out.
    TooFar,
    /// A camera without direction.
    NoView,
    /// A sphere without place.
    NoPlace,
    /// An object in which there is nothing.
    EmptyMesh,
    /// A name given twice.
    RepeatedName,
    /// An object without shader.
    NoShader,
    /// A shader that is used before it is declared.
    UndeclaredShader,
    /// An instance of something that is not there.
    UndeclaredGeometry,
    /// A scene without camera.
    NoCamera,
    /// A file that is not there.
    FileNotFound,
    /// A file that cannot be used.
    UnusableFile,
    /// A file that includes itself.
    IncludeCycle,
    /// A statement or field that is read and does nothing.
    Ignored,
    /// A type that is read and not rendered.
    TypeNotRendered,
    /// Movement.
    MovementNotRendered,
    /// Glossy reflections.
    GlossNotRendered,
    /// More bounces of a ray than are followed.
    TooManyBounces,
    /// More than a limit allows.
    OverLimit,
}

/// The explanations of all codes, each under a heading of its own.
const EXPLANATIONS: &str = include_str!("../DIAGNOSTICS.md");

impl Code {
    /// All codes, in order.
    pub const ALL: [Self; 52] = [
        Self::UnknownStatement,
        Self::StrayBrace,
        Self::MissingBlock,
        Self::UnclosedBlock,
        Self::UnclosedGroup,
        Self::UnclosedComment,
        Self::UnknownWord,
        Self::MeaninglessField,
        Self::StrayNumber,
        Self::RepeatedField,
        Self::MissingField,
        Self::MissingType,
        Self::UnknownType,
        Self::Expected,
        Self::Contradiction,
        Self::EmptyFile,
        Self::UnclosedQuote,
        Self::NotANumber,
        Self::NotFinite,
        Self::OutOfRange,
        Self::NotAFlag,
        Self::UnknownColorSpace,
        Self::UnknownStep,
        Self::NotAffine,
        Self::UnknownOrder,
        Self::ImpossibleView,
        Self::ListTooShort,
        Self::ListTooLong,
        Self::TooEarly,
        Self::NoSuchPoint,
        Self::UndeterminedPlane,
        Self::NoSuchFaceShader,
        Self::FlatTriangles,
        Self::NoInverse,
        Self::TooFar,
        Self::NoView,
        Self::NoPlace,
        Self::EmptyMesh,
        Self::RepeatedName,
        Self::NoShader,
        Self::UndeclaredShader,
        Self::UndeclaredGeometry,
        Self::NoCamera,
        Self::FileNotFound,
        Self::UnusableFile,
        Self::IncludeCycle,
        Self::Ignored,
        Self::TypeNotRendered,
        Self::MovementNotRendered,
        Self::GlossNotRendered,
        Self::TooManyBounces,
        Self::OverLimit,
    ];

    /// How messages and people write it: `SC101`.
    pub fn as_str(self) -> &'static str {
        match self {
            Self::UnknownStatement => "SC101",
            Self::StrayBrace => "SC102",
            Self::MissingBlock => "SC103",
            Self::UnclosedBlock => "SC104",
            Self::UnclosedGroup => "SC105",
            Self::UnclosedComment => "SC106",
            Self::UnknownWord => "SC107",
            Self::MeaninglessField => "SC108",
            Self::StrayNumber => "SC109",
            Self::RepeatedField => "SC110",
            Self::MissingField => "SC111",
            Self::MissingType => "SC112",
            Self::UnknownType => "SC113",
            Self::Expected => "SC114",
            Self::Contradiction => "SC115",
            Self::EmptyFile => "SC116",
            Self::UnclosedQuote => "SC117",
            Self::NotANumber => "SC201",
            Self::NotFinite => "SC202",
            Self::OutOfRange => "SC203",
            Self::NotAFlag => "SC204",
            Self::UnknownColorSpace => "SC205",
            Self::UnknownStep => "SC206",
            Self::NotAffine => "SC207",
            Self::UnknownOrder => "SC208",
            Self::ImpossibleView => "SC209",
            Self::ListTooShort => "SC301",
            Self::ListTooLong => "SC302",
            Self::TooEarly => "SC303",
            Self::NoSuchPoint => "SC304",
            Self::UndeterminedPlane => "SC305",
            Self::NoSuchFaceShader => "SC306",
            Self::FlatTriangles => "SC307",
            Self::NoInverse => "SC308",
            Self::TooFar => "SC309",
            Self::NoView => "SC310",
            Self::NoPlace => "SC311",
            Self::EmptyMesh => "SC312",
            Self::RepeatedName => "SC401",
            Self::NoShader => "SC402",
            Self::UndeclaredShader => "SC403",
            Self::UndeclaredGeometry => "SC404",
            Self::NoCamera => "SC405",
            Self::FileNotFound => "SC501",
            Self::UnusableFile => "SC502",
            Self::IncludeCycle => "SC503",
            Self::Ignored => "SC601",
            Self::TypeNotRendered => "SC602",
            Self::MovementNotRendered => "SC603",
            Self::GlossNotRendered => "SC604",
            Self::TooManyBounces => "SC605",
            Self::OverLimit => "SC701",
        }
    }

    /// The code that is written so, in whatever case.
    pub fn from_name(name: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|code| code.as_str().eq_ignore_ascii_case(name))
    }

    /// What it means, as Markdown: a heading, a few sentences, and a scene that is wrong and one that is right, each in a block
    /// of code that is called so.
    pub fn explanation(self) -> &'static str {
        let sections = EXPLANATIONS.match_indices("\n## ").map(|(at, _)| at + 1);
        let mut ends = sections.clone().skip(1).chain([EXPLANATIONS.len()]);
        sections
            .filter_map(|start| EXPLANATIONS.get(start..ends.next()?))
            .find(|section| section.strip_prefix("## ").is_some_and(|rest| rest.starts_with(self.as_str())))
            .unwrap_or_default()
            .trim_end()
    }

    /// The scene in [`Self::explanation`] that is called `which`: `wrong` or `right`.
    pub fn example(self, which: &str) -> Option<&'static str> {
        let (_, from) = self.explanation().split_once(&format!("```{which}\n"))?;
        Some(from.split_once("```")?.0)
    }
}

impl fmt::Display for Code {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.as_str())
    }
}
