use super::Color;
use crate::span::Spanned;

/// A block of a type that Sunflow has and girasol does not render: read all the same, and kept.
#[derive(Clone, Debug, PartialEq)]
pub struct Unrendered {
    /// Its type: `ward`, `sunsky`, `hair` ...; of a statement without types its keyword: `photons`.
    pub kind: Spanned<String>,
    /// Its fields, in the order of the file. Which fields a type has, and of what values each is made, the reader sees to.
    pub fields: Vec<Field>,
}

/// One field of a block.
#[derive(Clone, Debug, PartialEq)]
pub struct Field {
    /// The word that begins it.
    pub name: Spanned<String>,
    /// What stands after it.
    pub values: Vec<Spanned<Value>>,
}

/// A value of a field.
#[derive(Clone, Debug, PartialEq)]
pub enum Value {
    /// A number.
    Number(f32),
    /// A whole number.
    Integer(i32),
    /// `true` or `false`.
    Flag(bool),
    /// A name or a file.
    Word(String),
    /// A colour.
    Color(Color),
    /// Two or three numbers that belong together.
    Numbers(Vec<f32>),
    /// A list whose length stands before it.
    List(Vec<f32>),
    /// Program text between `<code>` and `</code>`, line by line.
    Code(Vec<String>),
}

/// A statement or block that nobody knows: kept word for word.
#[derive(Clone, Debug, PartialEq)]
pub struct Unknown {
    /// The first word: the statement's keyword, or the block's type.
    pub keyword: Spanned<String>,
    /// All further words, braces included, as the reader cuts them (quotes removed). Program text is one word, from
    /// `<code>` to the line that begins with `</code>`, with its line breaks.
    pub words: Vec<Spanned<String>>,
}
