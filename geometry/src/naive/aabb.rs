use crate::{Aabb, Interval, Ray};

/// The slab test without a thought for zeros or rounding.
///
/// For each axis the two `t` at which the ray crosses the box's planes are put in order by a comparison, and the intervals are cut
/// with one another. (Kay, Kajiya: Ray Tracing Complex Scenes, SIGGRAPH 1986, as usually written down.)
///
/// A ray in the plane of a face, with a direction of 0 along that axis, gives `0 * infinity`, a NaN: it fails the comparison, so that
/// it ends up in `near` or `far` and wins or loses by chance. And nothing makes up for the rounding of the two `t`: a flat box is lost
/// where its two `t` are one number, and one met in a corner where they are rounded past each other.
pub fn slab_test(bounds: &Aabb, ray: &Ray, within: Interval) -> Option<Interval> {
    let (mut min, mut max) = (within.min, within.max);
    for axis in 0..3 {
        let inverse = 1.0 / ray.direction[axis];
        let mut near = (bounds.min[axis] - ray.origin[axis]) * inverse;
        let mut far = (bounds.max[axis] - ray.origin[axis]) * inverse;
        if near > far {
            std::mem::swap(&mut near, &mut far);
        }
        min = if near > min { near } else { min };
        max = if far < max { far } else { max };
        if max <= min {
            return None;
        }
    }
    Some(Interval { min, max })
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::Vec3;

    #[test]
    fn an_easy_box_is_met_and_a_flat_one_lost() {
        let cube = Aabb { min: Vec3::ZERO, max: Vec3::ONE };
        let ray = Ray::new(Vec3::new(0.5, 0.25, -2.0), Vec3::Z);
        assert_eq!(slab_test(&cube, &ray, Interval::FORWARD), Some(Interval { min: 2.0, max: 3.0 }));
        let flat = Aabb { min: Vec3::ZERO, max: Vec3::new(1.0, 1.0, 0.0) };
        assert_eq!(slab_test(&flat, &ray, Interval::FORWARD), None);
    }
}
