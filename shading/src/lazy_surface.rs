use std::cell::OnceCell;
use std::ops::Deref;

use geometry::Surface;

/// A surface that is computed when it is first looked at: a shader that shows the same colour everywhere need not know where it is.
///
/// ```
/// # use std::cell::OnceCell;
/// # use geometry::Surface;
/// # use glam::Vec3;
/// # use shading::LazySurface;
/// let (known, compute) = (OnceCell::new(), || Surface::rounded(Vec3::ONE, 1.0, Vec3::Z));
/// let surface = LazySurface::new(&known, &compute);
/// assert_eq!(known.get(), None);
/// assert_eq!(surface.position, Vec3::ONE);
/// assert_eq!(known.get(), Some(&compute()));
/// ```
#[derive(Clone, Copy)]
pub struct LazySurface<'a> {
    known: &'a OnceCell<Surface>,
    compute: &'a dyn Fn() -> Surface,
}

impl<'a> LazySurface<'a> {
    /// What is kept in `known`, or else computed, and then kept there.
    pub fn new(known: &'a OnceCell<Surface>, compute: &'a dyn Fn() -> Surface) -> Self {
        Self { known, compute }
    }

    /// Whether it is kept in this place: not another surface, be it equal.
    pub fn is_kept_in(&self, place: &OnceCell<Surface>) -> bool {
        std::ptr::eq(self.known, place)
    }
}

impl Deref for LazySurface<'_> {
    type Target = Surface;

    #[inline]
    fn deref(&self) -> &Surface {
        self.known.get_or_init(self.compute)
    }
}
