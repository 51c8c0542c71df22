/// How far the wide octree is built: each step has those before it in it. For comparison; [`wide`](fn@crate::wide) takes the last.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Step {
    /// Each node is one cell of the octree, and half of its slots are the cell's eighths.
    OneLevel,
    /// Nodes are the cheapest cuts through several levels.
    CheapestCuts,
    /// Long thin triangles stand in pieces, where that costs less.
    ThinInPieces,
}

impl Step {
    /// From the first to the last.
    pub const ALL: [Self; 3] = [Self::OneLevel, Self::CheapestCuts, Self::ThinInPieces];
}
