/// How often a ray may still bounce, and how it has bounced. Reflections and refractions are counted apart, so a path may hold all of both.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Bounces {
    /// Reflections left.
    pub reflections: u32,
    /// Refractions left.
    pub refractions: u32,
    /// Which way the ray came from the camera: a 1, then for each bounce a binary digit, 0 for a reflection, 1 for a refraction.
    /// Of the longest paths only the last 32 digits.
    pub path: u32,
}

impl Bounces {
    /// Those of a ray from the camera.
    pub fn of_camera_ray(reflections: u32, refractions: u32) -> Self {
        Self { reflections, refractions, path: 1 }
    }

    /// What is left after a reflection; `None` if there was none left.
    pub fn reflected(self) -> Option<Self> {
        Some(Self { reflections: self.reflections.checked_sub(1)?, path: self.path << 1, ..self })
    }

    /// What is left after a refraction; `None` if there was none left.
    pub fn refracted(self) -> Option<Self> {
        Some(Self { refractions: self.refractions.checked_sub(1)?, path: (self.path << 1) | 1, ..self })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_way_of_bouncing_has_its_own_number() {
        let mut rays = vec![Bounces::of_camera_ray(9, 9)];
        let mut next = 0;
        // A camera ray and five bounces: 1 + 2 + 4 + 8 + 16 + 32 rays.
        while rays.len() < 63 {
            let ray = rays[next];
            rays.extend([ray.reflected(), ray.refracted()].into_iter().flatten());
            next += 1;
        }
        let numbers: std::collections::BTreeSet<u32> = rays.iter().map(|ray| ray.path).collect();
        assert_eq!((rays.len(), numbers.len()), (63, 63));
    }
}
