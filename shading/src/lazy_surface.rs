use std::cell::OnceCell;
use std::ops::Deref;

use geometry::Surface;

/// A surface that may be computed only when it is first looked at: a shader that shows the same colour everywhere need not know where it is.
///
/// ```
/// # use std::cell::OnceCell;
/// # use geometry::Surface;
/// # use glam::Vec3;
/// # use shading::LazySurface;
/// let (known, compute) = (OnceCell::new(), || Surface::rounded(Vec3::ONE, 1.0, Vec3::Z));
/// let surface = LazySurface::Asked { known: &known, compute: &compute };
/// assert_eq!(known.get(), None);
/// assert_eq!(surface.position, Vec3::ONE);
/// assert_eq!(known.get(), Some(&compute()));
/// ```
#[derive(Clone, Copy)]
pub enum LazySurface<'a> {
    /// It is there.
    Known(&'a Surface),
    /// It is computed, once.
    Asked {
        /// Where it is kept then.
        known: &'a OnceCell<Surface>,
        /// What computes it.
        compute: &'a dyn Fn() -> Surface,
    },
}

impl LazySurface<'_> {
    /// Whether it is this very one: not another, be it equal.
    #[inline]
    pub fn is(&self, surface: &Surface) -> bool {
        let own = match self {
            Self::Known(known) => Some(*known),
            Self::Asked { known, .. } => known.get(),
        };
        own.is_some_and(|own| std::ptr::eq(own, surface))
    }
}

impl Deref for LazySurface<'_> {
    type Target = Surface;

    #[inline]
    fn deref(&self) -> &Surface {
        match self {
            Self::Known(surface) => surface,
            Self::Asked { known, compute } => known.get_or_init(compute),
        }
    }
}
