//! The colour of a picture at a place.

use std::sync::Arc;

use glam::Vec2;
use shading::{Color, ImageTexture, Texture};

/// Makes a texture of a picture's texels.
pub fn texture(picture: ImageTexture) -> Arc<dyn Texture> {
    Arc::new(Picture { picture })
}

/// A stub: black, whatever the picture shows.
struct Picture {
    picture: ImageTexture,
}

impl Texture for Picture {
    /// The colour at texture coordinates, which are computed only if they are asked for.
    fn color(&self, _uv: &dyn Fn() -> Vec2) -> Color {
        let _ = &self.picture;
        Color::BLACK
    }
}
