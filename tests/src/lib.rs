//! What the tests of the whole share; they themselves stand in `tests/`.

mod memory;
mod program;
mod rendering;
mod shared;

pub use memory::MemoryFiles;
pub use program::{Ended, Folder};
pub use rendering::Rendering;
pub use shared::{Beside, scenes_of, shared_folder};
