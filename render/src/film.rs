use std::ops::AddAssign;

use shading::{Color, srgb};

use crate::LostRays;

/// A finished picture.
#[derive(Clone, Debug, PartialEq)]
pub struct Film {
    /// Columns.
    pub width: u32,
    /// Rows.
    pub height: u32,
    /// Linear colours, row by row from the top.
    pub pixels: Vec<Color>,
    /// What it took.
    pub rays: RayCounts,
    /// Where it is not what the scene asks for.
    pub lost: LostRays,
}

/// How many rays were traced.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct RayCounts {
    /// From the camera.
    pub camera: u64,
    /// Reflected and refracted.
    pub secondary: u64,
    /// To lights.
    pub shadow: u64,
}

impl RayCounts {
    /// All of them.
    pub fn total(self) -> u64 {
        self.camera + self.secondary + self.shadow
    }
}

impl AddAssign for RayCounts {
    fn add_assign(&mut self, other: Self) {
        self.camera += other.camera;
        self.secondary += other.secondary;
        self.shadow += other.shadow;
    }
}

impl Film {
    /// 8-bit sRGB: three bytes a pixel, row by row from the top; each the nearest to the linear value, clamped.
    pub fn to_srgb_bytes(&self) -> Vec<u8> {
        self.pixels.iter().flat_map(|pixel| pixel.to_array().map(srgb::encode_byte)).collect()
    }
}
