//! What the page is made of.

use serde_json::Value;

use crate::table::Align;

/// A section of the page.
pub(crate) struct Figure {
    /// Its name in links and in the JSON: lower case, words joined by `-`.
    pub(crate) id: &'static str,
    /// A line without a final stop.
    pub(crate) title: &'static str,
    /// What one sees, in whole sentences.
    pub(crate) caption: String,
    /// From top to bottom.
    pub(crate) parts: Vec<Part>,
    /// The same numbers, for programs.
    pub(crate) data: Value,
}

/// A piece of a figure. Texts are plain: the page escapes them.
pub(crate) enum Part {
    /// A diagram (see [`super::chart`]), with what it shows for those who cannot see it.
    Svg { svg: String, alt: String },
    /// A picture, with a line below it.
    Png { bytes: Vec<u8>, alt: String },
    /// Rows of cells, as many as there are headings.
    Table { headings: Vec<(String, Align)>, rows: Vec<Vec<String>> },
    /// What colours and marks mean.
    Legend(Vec<Key>),
    /// A heading within the figure.
    Heading(String),
    /// A paragraph.
    Text(String),
    /// Parts side by side, as far as the page is wide enough.
    Row(Vec<Part>),
    /// Small parts side by side.
    Grid(Vec<Part>),
    /// A part that is shown when its title is clicked.
    Folded { title: String, parts: Vec<Part> },
}

/// An entry of a legend.
pub(crate) struct Key {
    /// The colour: red, green, blue.
    pub(crate) color: [u8; 3],
    /// How its points are drawn.
    pub(crate) mark: Mark,
    /// What it stands for.
    pub(crate) name: String,
}

/// How a point is drawn.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Mark {
    /// A filled circle: what girasol uses.
    Disc,
    /// An empty circle: what it is compared with.
    Ring,
    /// A filled square: somebody's own.
    Square,
}

/// Colours that can be told apart on light and dark pages, by the colour-blind too. (Okabe, Ito: Color Universal Design, 2008.)
pub(crate) const BLUE: [u8; 3] = [0x1b, 0x83, 0xc4];
pub(crate) const ORANGE: [u8; 3] = [0xe0, 0x7b, 0x00];
pub(crate) const GREEN: [u8; 3] = [0x00, 0x9e, 0x73];
pub(crate) const PINK: [u8; 3] = [0xcc, 0x5f, 0x9b];
pub(crate) const GREY: [u8; 3] = [0x8a, 0x8a, 0x8a];
