/// How much a scene may ask for. Over a limit stands an error that names it, never a crash; before a limit is checked nothing of
/// that size is allocated.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Limits {
    /// How deep files may include files.
    pub include_depth: usize,
    /// How many files may take part in a scene: a few that include each other twice would otherwise grow without end.
    pub files: usize,
    /// How many bytes all includes together may have; and any one file of a mesh or texture.
    pub bytes: usize,
    /// How many elements (points, triangles, spheres) a single object may have, whether written, read from a file or made.
    pub elements: usize,
    /// The longest edge of the picture in pixels.
    pub picture_edge: u32,
    /// The longest edge of a texture in pixels.
    pub texture_edge: u32,
    /// The memory that decoding a texture may take, in bytes.
    pub texture_bytes: u64,
    /// How many messages are kept: nobody reads more, and a hostile file must not fill the memory.
    pub messages: usize,
}

impl Default for Limits {
    /// What a machine with a few GiB of memory can hold. The longest edge of a picture is Sunflow's.
    fn default() -> Self {
        Self {
            include_depth: 32,
            files: 4096,
            bytes: 1 << 30,
            elements: 1 << 27,
            picture_edge: 16_384,
            texture_edge: 16_384,
            texture_bytes: 1 << 30,
            messages: 1000,
        }
    }
}
