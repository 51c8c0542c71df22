use crate::span::Spanned;

/// `image { ... }`: the size of the picture and how it is sampled. What the file leaves out is `None`.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Image {
    /// `resolution W H` in pixels; 640 x 480 unless given.
    pub resolution: Option<Spanned<[u32; 2]>>,
    /// `sampler NAME`: not heeded.
    pub sampler: Option<Spanned<String>>,
    /// `aa MIN MAX`: the larger number is the binary logarithm of the zones along a pixel's edge; 0 0 unless given.
    pub aa: Option<Spanned<[i32; 2]>>,
    /// `samples N`: rays in each zone; 1 unless given.
    pub samples: Option<Spanned<u32>>,
    /// `contrast C`: not heeded.
    pub contrast: Option<Spanned<f32>>,
    /// `filter NAME`: not heeded.
    pub filter: Option<Spanned<String>>,
    /// `jitter BOOL`: not heeded.
    pub jitter: Option<Spanned<bool>>,
    /// `show-aa BOOL`: an old word without effect.
    pub show_aa: Option<Spanned<bool>>,
    /// `cache BOOL`: not heeded.
    pub cache: Option<Spanned<bool>>,
    /// `output NAME`: an old word without effect.
    pub output: Option<Spanned<String>>,
}

/// `bucket SIZE ORDER`: the tiles that the picture is rendered in.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Bucket {
    /// The edge of a tile in pixels.
    pub size: Spanned<u32>,
    /// The order in which the tiles are taken.
    pub order: Spanned<BucketOrder>,
    /// `"reverse ORDER"`: the same order, backwards.
    pub reversed: bool,
}

/// An order of tiles.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum BucketOrder {
    /// Along Hilbert's curve: neighbours in time are neighbours in the picture.
    #[default]
    Hilbert,
    /// From the middle outwards.
    Spiral,
    /// Column by column, every second one upwards.
    Column,
    /// Row by row, every second one from right to left.
    Row,
    /// Along the diagonals.
    Diagonal,
    /// In a fixed shuffled order.
    Random,
}

impl BucketOrder {
    /// All orders.
    pub const ALL: [Self; 6] = [Self::Hilbert, Self::Spiral, Self::Column, Self::Row, Self::Diagonal, Self::Random];

    /// What a scene file calls it.
    pub fn name(self) -> &'static str {
        match self {
            Self::Hilbert => "hilbert",
            Self::Spiral => "spiral",
            Self::Column => "column",
            Self::Row => "row",
            Self::Diagonal => "diagonal",
            Self::Random => "random",
        }
    }

    /// The order of that name.
    pub fn from_name(name: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|order| order.name() == name)
    }
}

/// `trace-depths { ... }`: how often a ray may bounce. What the file leaves out is `None`.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct TraceDepths {
    /// `diff N`: diffuse bounces; 1 unless given.
    pub diffuse: Option<Spanned<u32>>,
    /// `refl N`: reflections; 4 unless given.
    pub reflection: Option<Spanned<u32>>,
    /// `refr N`: refractions; 4 unless given.
    pub refraction: Option<Spanned<u32>>,
}
