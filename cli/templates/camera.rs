//! From a place in the picture to a ray.

use geometry::Ray;
use glam::{DVec2, Vec3};
use render::{Camera, View};

/// The camera of what a scene says of it; `None` where that defines no view.
pub fn camera(view: &View) -> Option<Box<dyn Camera>> {
    Some(Box::new(Pinhole { view: *view }))
}

/// A stub: it stands at the origin and sees a single point.
struct Pinhole {
    view: View,
}

impl Camera for Pinhole {
    /// The ray through a place of the picture: x from 0 at the left edge to 1 at the right, y from 0 at the bottom to 1 at the top.
    fn ray(&self, _film: DVec2, _lens: &dyn Fn() -> DVec2) -> Ray {
        let _ = self.view;
        Ray::new(Vec3::ZERO, Vec3::NEG_Z)
    }
}
