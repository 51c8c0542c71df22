//! Sixteen rays against one sphere: in `f64`, by the steps of `geometry`'s own kernel, for there is no cheaper way to be as certain.

use geometry::{Primitives, meet_sphere_lanes};

use super::{Packet, RAYS};
use crate::wide::simd::Isa;

/// So many rays are worth all lanes; fewer are asked for one by one.
const FEWEST: u32 = 3;

/// What the rays of a packet find of a sphere: a bit for each.
pub(super) struct SphereBits {
    /// Those that meet it, and where.
    pub(super) met: u32,
    pub(super) t: [f32; RAYS],
    /// Those that have to be asked for one by one.
    pub(super) unknown: u32,
}

impl<I: Isa> Packet<I> {
    /// Where the active rays meet a primitive, if it is a sphere; other shapes leave all of them unknown, and so do spheres that few rays ask.
    #[inline(always)]
    pub(super) fn meet_sphere(&self, primitives: &Primitives, number: u32, active: u32) -> SphereBits {
        let sphere = primitives.sphere(number).filter(|_| active.count_ones() >= FEWEST);
        let Some(sphere) = sphere else { return SphereBits { met: 0, t: [f32::NAN; RAYS], unknown: active } };
        // With their axes back in place.
        let (mut origins, mut directions) = ([&[0.0; RAYS]; 3], [&[0.0; RAYS]; 3]);
        for (turned, &axis) in self.axes.iter().enumerate() {
            (origins[axis], directions[axis]) = (&self.triangles.origin[turned].0, &self.directions[turned].0);
        }
        let found = meet_sphere_lanes(sphere, origins, directions, self.within);
        let (mut met, mut unknown) = (0, 0);
        for ray in 0..RAYS {
            met |= u32::from(!found.t[ray].is_nan()) << ray;
            unknown |= u32::from(found.is_in_doubt[ray] != 0) << ray;
        }
        SphereBits { met: met & active & !unknown, t: found.t, unknown: unknown & active }
    }
}
