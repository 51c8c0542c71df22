/// How often a ray may still bounce. Reflections and refractions are counted apart, so a path may hold all of both.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Bounces {
    /// Reflections left.
    pub reflections: u32,
    /// Refractions left.
    pub refractions: u32,
}

impl Bounces {
    /// What is left after a reflection; `None` if there was none left.
    pub fn reflected(self) -> Option<Self> {
        Some(Self { reflections: self.reflections.checked_sub(1)?, ..self })
    }

    /// What is left after a refraction; `None` if there was none left.
    pub fn refracted(self) -> Option<Self> {
        Some(Self { refractions: self.refractions.checked_sub(1)?, ..self })
    }
}
