//! Random shapes with rays aimed at them, from everyday to hard.

use geometry::{Aabb, Ellipsoid, Plane, Ray, Sphere, Transform, Triangle};
use glam::{DMat3, DVec3, Vec3};

use super::random::Random;

/// A shape, and a ray that meets it or narrowly does not.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Aimed<Shape> {
    pub(crate) shape: Shape,
    pub(crate) ray: Ray,
}

/// From one number to another.
pub(crate) type Range = [f64; 2];

/// How spheres and ellipsoids are aimed at. Lengths in radii.
#[derive(Clone, Copy, Debug)]
pub(crate) struct AtSphere {
    pub(crate) radius: Range,
    /// From the ray's origin to the centre.
    pub(crate) distance: Range,
    /// From the line to the centre.
    pub(crate) passing: Range,
    /// From the scene's origin to the centre.
    pub(crate) offset: Range,
    /// The longest axis over the shortest; of ellipsoids alone.
    pub(crate) stretch: Range,
    /// The length of the direction.
    pub(crate) length: Range,
}

impl Default for AtSphere {
    fn default() -> Self {
        let one = [1.0, 1.0];
        Self { radius: one, distance: [1.5, 10.0], passing: [0.0, 1.5], offset: [1.0, 3.0], stretch: one, length: one }
    }
}

impl AtSphere {
    /// The line as a unit sphere at 0 sees it.
    fn line(&self, random: &mut Random) -> (DVec3, DVec3) {
        let distance = random.magnitude(self.distance[0], self.distance[1]);
        let passing = random.between(self.passing[0], self.passing[1]).min(distance);
        let frame = random.frame();
        let along = (distance * distance - passing * passing).sqrt();
        // One in four looks away.
        let sign = random.one_of(&[1.0, 1.0, 1.0, -1.0]);
        (frame.x_axis * passing - frame.z_axis * (sign * along), frame.z_axis)
    }

    pub(crate) fn sphere(&self, random: &mut Random) -> Aimed<Sphere> {
        let radius = random.magnitude(self.radius[0], self.radius[1]);
        let offset = random.magnitude(self.offset[0], self.offset[1]);
        let center = (random.direction() * offset * radius).as_vec3();
        let (origin, direction) = self.line(random);
        let length = random.magnitude(self.length[0], self.length[1]);
        let origin = (center.as_dvec3() + origin * radius).as_vec3();
        Aimed { shape: Sphere { center, radius: radius as f32 }, ray: Ray::new(origin, (direction * length).as_vec3()) }
    }

    pub(crate) fn ellipsoid(&self, random: &mut Random) -> Aimed<Ellipsoid> {
        loop {
            let radius = random.magnitude(self.radius[0], self.radius[1]);
            let stretch = random.magnitude(self.stretch[0], self.stretch[1]);
            let axes = DVec3::new(1.0, random.magnitude(1.0, stretch) / stretch, 1.0 / stretch) * radius;
            let linear = random.frame() * DMat3::from_diagonal(axes) * random.frame();
            let offset = random.magnitude(self.offset[0], self.offset[1]);
            let translation = random.direction() * offset * radius;
            let (origin, direction) = self.line(random);
            let length = random.magnitude(self.length[0], self.length[1]);
            let origin = (linear * origin + translation).as_vec3();
            let direction = ((linear * direction).normalize() * length).as_vec3();
            if let Some(shape) = Ellipsoid::new(Transform { linear, translation }) {
                return Aimed { shape, ray: Ray::new(origin, direction) };
            }
        }
    }
}

/// How triangles are aimed at. Lengths in sizes.
#[derive(Clone, Copy, Debug)]
pub(crate) struct AtTriangle {
    /// The longest edge.
    pub(crate) size: Range,
    /// The longest edge over the height on it.
    pub(crate) aspect: Range,
    /// From the ray's origin to the target.
    pub(crate) distance: Range,
    /// The tangent of the angle between ray and plane.
    pub(crate) slope: Range,
    /// From the scene's origin to the first corner.
    pub(crate) offset: Range,
    /// The length of the direction.
    pub(crate) length: Range,
}

impl Default for AtTriangle {
    fn default() -> Self {
        let one = [1.0, 1.0];
        Self {
            size: one,
            aspect: [1.0, 3.0],
            distance: [1.0, 10.0],
            slope: [0.2, 5.0],
            offset: [0.3, 3.0],
            length: one,
        }
    }
}

impl AtTriangle {
    pub(crate) fn triangle(&self, random: &mut Random) -> Aimed<Triangle> {
        let frame = random.frame();
        let size = random.magnitude(self.size[0], self.size[1]);
        let a = random.direction() * random.magnitude(self.offset[0], self.offset[1]) * size;
        let lean = random.between(0.0, 1.0) * size;
        let height = size / random.magnitude(self.aspect[0], self.aspect[1]);
        let b = a + frame.x_axis * size;
        let c = a + frame.x_axis * lean + frame.y_axis * height;
        let corners = [a.as_vec3(), b.as_vec3(), c.as_vec3()];
        let [a, b, c] = corners.map(|corner| corner.as_dvec3());
        // Three in four inside, the others around.
        let (v, w) = (random.unit(), random.unit());
        let [v, w] = if random.one_of(&[true, true, true, false]) {
            if v + w > 1.0 { [1.0 - v, 1.0 - w] } else { [v, w] }
        } else {
            [3.0 * v - 1.0, 3.0 * w - 1.0]
        };
        let target = a + (b - a) * v + (c - a) * w;
        let slope = random.magnitude(self.slope[0], self.slope[1]) * random.sign();
        let (sin, cos) = libm::sincos(random.between(0.0, std::f64::consts::TAU));
        let direction = (frame.x_axis * cos + frame.y_axis * sin + frame.z_axis * slope).normalize();
        let distance = random.magnitude(self.distance[0], self.distance[1]) * size;
        let length = random.magnitude(self.length[0], self.length[1]);
        Aimed {
            shape: Triangle { corners },
            ray: Ray::new((target - direction * distance).as_vec3(), (direction * length).as_vec3()),
        }
    }
}

/// A plane as a scene gives it.
#[derive(Clone, Copy, Debug)]
pub(crate) struct GivenPlane {
    pub(crate) point: Vec3,
    pub(crate) normal: Vec3,
    /// As girasol stores it.
    pub(crate) plane: Plane,
}

/// How planes are aimed at.
#[derive(Clone, Copy, Debug)]
pub(crate) struct AtPlane {
    /// From the ray's origin to the plane, along the ray.
    pub(crate) distance: Range,
    /// The tangent of the angle between ray and plane.
    pub(crate) slope: Range,
    /// From the scene's origin to the plane's point.
    pub(crate) offset: Range,
    /// From the plane's point to where the ray meets it.
    pub(crate) away: Range,
    /// The length of the direction.
    pub(crate) length: Range,
}

impl Default for AtPlane {
    fn default() -> Self {
        let one = [1.0, 1.0];
        Self { distance: [1.0, 10.0], slope: [0.2, 5.0], offset: [0.3, 3.0], away: [0.1, 10.0], length: one }
    }
}

impl AtPlane {
    pub(crate) fn plane(&self, random: &mut Random) -> Aimed<GivenPlane> {
        loop {
            let frame = random.frame();
            let normal = frame.z_axis.as_vec3();
            let point = (random.direction() * random.magnitude(self.offset[0], self.offset[1])).as_vec3();
            let in_plane = |angle: f64| frame.x_axis * libm::cos(angle) + frame.y_axis * libm::sin(angle);
            let away = random.magnitude(self.away[0], self.away[1]);
            let met = point.as_dvec3() + in_plane(random.between(0.0, std::f64::consts::TAU)) * away;
            let slope = random.magnitude(self.slope[0], self.slope[1]) * random.sign();
            let direction = in_plane(random.between(0.0, std::f64::consts::TAU)) + frame.z_axis * slope;
            let direction = direction.normalize();
            // One in eight looks away.
            let sign = random.one_of(&[1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, -1.0]);
            let distance = random.magnitude(self.distance[0], self.distance[1]) * sign;
            let length = random.magnitude(self.length[0], self.length[1]);
            let ray = Ray::new((met - direction * distance).as_vec3(), (direction * length).as_vec3());
            if let Some(plane) = Plane::from_normal(point, normal) {
                return Aimed { shape: GivenPlane { point, normal, plane }, ray };
            }
        }
    }
}

/// How boxes are aimed at.
#[derive(Clone, Copy, Debug)]
pub(crate) struct AtBox {
    /// From the ray's origin to the box, in sizes.
    pub(crate) distance: Range,
    /// How often, of eight, an edge has length 0.
    pub(crate) flat: u32,
    /// What components of the direction are set to, one or two of them; empty for none.
    pub(crate) set: &'static [f32],
    /// Whether rays start in a face's plane where a component is set, and run along an edge where two are.
    pub(crate) on_face: OnFace,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum OnFace {
    Never,
    WhereSet,
}

impl Default for AtBox {
    fn default() -> Self {
        Self { distance: [0.5, 10.0], flat: 0, set: &[], on_face: OnFace::Never }
    }
}

impl AtBox {
    pub(crate) fn aabb(&self, random: &mut Random) -> Aimed<Aabb> {
        let min = (random.direction() * random.between(0.0, 3.0)).as_vec3();
        let mut extent = || if random.unit() * 8.0 < f64::from(self.flat) { 0.0 } else { random.between(0.1, 1.0) };
        let extent = DVec3::new(extent(), extent(), extent());
        let max = (min.as_dvec3() + extent).as_vec3();
        let shape = Aabb { min, max };
        // Three in four at the inside or a face, the others around.
        let reach = random.one_of(&[[0.0, 1.0], [0.0, 1.0], [0.0, 1.0], [-0.5, 1.5]]);
        let mut target = Vec3::ZERO;
        for axis in 0..3 {
            let inside = random.between(reach[0], reach[1]);
            let place = random.one_of(&[0.0, 1.0, inside, inside]);
            target[axis] = match place {
                0.0 => min[axis],
                1.0 => max[axis],
                place => (f64::from(min[axis]) + place * extent[axis]) as f32,
            };
        }
        let direction = random.direction();
        let distance = random.magnitude(self.distance[0], self.distance[1]);
        let mut origin = (target.as_dvec3() - direction * distance).as_vec3();
        let mut direction = direction.as_vec3();
        if !self.set.is_empty() {
            let kept = random.one_of(&[0, 1, 2]);
            let first = (kept + 1) % 3;
            let second = random.one_of(&[first, (kept + 2) % 3]);
            for axis in [first, second] {
                direction[axis] = random.one_of(self.set);
                origin[axis] = match self.on_face {
                    OnFace::Never => target[axis],
                    OnFace::WhereSet => random.one_of(&[min[axis], max[axis]]),
                };
            }
        }
        Aimed { shape, ray: Ray::new(origin, direction) }
    }
}
