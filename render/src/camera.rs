use geometry::Ray;
use glam::{DVec2, DVec3, Vec3};

/// Turns a place in the picture into a ray.
pub trait Camera: Send + Sync {
    /// The ray through a place of the picture: x from 0 at the left edge to 1 at the right, y from 0 at the bottom to 1 at the
    /// top. `lens` gives a random point of the unit square, for cameras that ask.
    fn ray(&self, film: DVec2, lens: &dyn Fn() -> DVec2) -> Ray;

    /// The rays through some places, each as [`Self::ray`] has it, bit for bit; `lens` is asked with a ray's number. Ray by ray, unless a camera
    /// knows a faster way.
    fn rays(&self, films: &[DVec2], lens: &dyn Fn(usize) -> DVec2, rays: &mut Vec<Ray>) {
        rays.extend(films.iter().enumerate().map(|(number, &film)| self.ray(film, &|| lens(number))));
    }

    /// Whether rays start at different places of a lens.
    fn has_lens(&self) -> bool {
        false
    }
}

/// Where a camera stands and what it sees: its eye and its axes in the world.
///
/// ```text
///          up |   / -forward
///             |  /                 the image plane lies at distance 1 along forward, and reaches
///         eye o------ right        from -half to +half, moved by shift
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Frame {
    /// Where it stands.
    pub eye: DVec3,
    /// Right in the picture.
    pub right: DVec3,
    /// Up in the picture.
    pub up: DVec3,
    /// Into the picture.
    pub forward: DVec3,
    /// Half the width and height of the image plane.
    pub half: DVec2,
    /// Moves the image plane.
    pub shift: DVec2,
}

impl Frame {
    /// The axes of a camera at `eye` that looks at `target`; `None` if these do not define a view.
    pub fn look_at(eye: DVec3, target: DVec3, up: DVec3) -> Option<Self> {
        let forward = (target - eye).try_normalize()?;
        let right = forward.cross(up.try_normalize()?).try_normalize()?;
        Some(Self { eye, right, up: right.cross(forward), forward, half: DVec2::ONE, shift: DVec2::ZERO })
    }

    /// With a full horizontal angle of view in degrees, and the image plane's width over its height.
    #[must_use]
    pub fn seeing(self, fov_degrees: f64, aspect: f64) -> Self {
        let half_width = libm::tan(0.5 * fov_degrees.to_radians());
        Self { half: DVec2::new(half_width, half_width / aspect), ..self }
    }

    /// From the eye to the point of the image plane behind a place of the picture. Of directions alone: the point itself, taken
    /// far from the origin, would round the picture away.
    #[inline(always)]
    fn towards(&self, film: DVec2) -> DVec3 {
        let place = self.shift + self.half * (2.0 * film - DVec2::ONE);
        self.right * place.x + self.up * place.y + self.forward
    }
}

/// Everything is sharp.
///
/// A direction is right to its rounding to `f32`: an angle of 0.87 u (u = 2^-24, half an ulp in each coordinate), wherever the
/// eye stands. That is 9e-5 of a pixel where a thousand of them see 40 to 90 degrees, and grows as the angle of view shrinks: at
/// 0.01 degrees to a third of a pixel. (`conformance::camera`)
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pinhole {
    /// Where it stands and what it sees.
    pub frame: Frame,
}

impl Camera for Pinhole {
    fn ray(&self, film: DVec2, _lens: &dyn Fn() -> DVec2) -> Ray {
        Ray::new(self.frame.eye.as_vec3(), self.direction(film))
    }

    fn rays(&self, films: &[DVec2], _lens: &dyn Fn(usize) -> DVec2, rays: &mut Vec<Ray>) {
        accel::vectorize(
            #[inline(always)]
            || self.add_rays(films, rays),
        );
    }
}

impl Pinhole {
    #[inline(always)]
    fn add_rays(&self, films: &[DVec2], rays: &mut Vec<Ray>) {
        const LANES: usize = 8;
        let eye = self.frame.eye.as_vec3();
        for films in films.chunks(LANES) {
            let mut directions = [[0.0; LANES]; 3];
            // A loop that the compiler makes vectors of.
            for lane in 0..LANES {
                let direction = self.direction(films[lane.min(films.len() - 1)]);
                [directions[0][lane], directions[1][lane], directions[2][lane]] = direction.to_array();
            }
            let [x, y, z] = directions;
            rays.extend((0..films.len()).map(|lane| Ray::new(eye, Vec3::new(x[lane], y[lane], z[lane]))));
        }
    }

    #[inline(always)]
    fn direction(&self, film: DVec2) -> Vec3 {
        self.frame.towards(film).normalize().as_vec3()
    }
}

/// Sharp at one distance: depth of field. (Cook, Porter, Carpenter: Distributed Ray Tracing, SIGGRAPH 1984.)
///
/// A ray passes the point in focus as closely as a [`Pinhole`]'s would: within an angle of 0.87 u, seen from where it starts. That
/// is on the lens to a rounding of the eye's coordinates.
///
/// ```text
///    lens        focus     every ray through a place of the picture meets the same point in the plane of focus,
///     |\__         |       whichever point of the lens it comes from
///     |   \___     |
///     |_______\____*
///     |   ___ /    |
///     |__/         |
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ThinLens {
    /// Where it stands and what it sees.
    pub frame: Frame,
    /// The distance of the plane in focus, along the view axis.
    pub focus_distance: f64,
    /// The lens' radius.
    pub radius: f64,
    /// A regular polygon of that many sides, its corners at the radius; a disc below 3.
    pub sides: u32,
    /// The direction of the polygon's first corner, in degrees from right.
    pub rotation_degrees: f64,
}

impl Camera for ThinLens {
    fn ray(&self, film: DVec2, lens: &dyn Fn() -> DVec2) -> Ray {
        let on_lens = self.radius * self.place_on_lens(lens());
        let origin = (self.frame.eye + self.frame.right * on_lens.x + self.frame.up * on_lens.y).as_vec3();
        // The place where the ray does start: far from the origin of space, rounding moves it by more than the lens is wide.
        let offset = origin.as_dvec3() - self.frame.eye;
        let direction = self.frame.towards(film) - offset / self.focus_distance;
        Ray::new(origin, direction.normalize().as_vec3())
    }

    fn has_lens(&self) -> bool {
        true
    }
}

impl ThinLens {
    /// A point of the lens of radius 1, evenly spread, from two numbers in 0..1.
    fn place_on_lens(&self, random: DVec2) -> DVec2 {
        let (radius, angle) = concentric_disc(random);
        if self.sides < 3 {
            let (sin, cos) = libm::sincos(angle);
            radius * DVec2::new(cos, sin)
        } else {
            self.polygon(radius, angle)
        }
    }

    /// Moves a point of the disc, by its radius and angle, to the polygon: rings become smaller polygons, and each side has as much of the
    /// angle as any other. What is close together stays so.
    fn polygon(&self, radius: f64, angle: f64) -> DVec2 {
        // A negative radius points the other way.
        let turn = angle / std::f64::consts::TAU + if radius < 0.0 { 0.5 } else { 0.0 };
        let sides = f64::from(self.sides);
        let place = turn.rem_euclid(1.0) * sides;
        let side = place.floor();
        let along = place - side;
        let corner = |index: f64| {
            let (sin, cos) = libm::sincos(self.rotation_degrees.to_radians() + std::f64::consts::TAU * index / sides);
            DVec2::new(cos, sin)
        };
        radius.abs() * (corner(side) * (1.0 - along) + corner(side + 1.0) * along)
    }
}

/// The square onto the disc, ring by ring: radius and angle. (Shirley and Chiu: A Low Distortion Map Between Disk and Square, 1997.)
fn concentric_disc(random: DVec2) -> (f64, f64) {
    use std::f64::consts::FRAC_PI_4;
    let place = 2.0 * random - DVec2::ONE;
    if place == DVec2::ZERO {
        return (0.0, 0.0);
    }
    if place.x.abs() > place.y.abs() {
        (place.x, FRAC_PI_4 * place.y / place.x)
    } else {
        (place.y, 2.0 * FRAC_PI_4 - FRAC_PI_4 * place.x / place.y)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn frame() -> Frame {
        Frame::look_at(DVec3::new(0.0, 0.0, 5.0), DVec3::ZERO, DVec3::Y).unwrap().seeing(90.0, 2.0)
    }

    fn direction(camera: &dyn Camera, x: f64, y: f64, lens: DVec2) -> (Vec3, Vec3) {
        let ray = camera.ray(DVec2::new(x, y), &|| lens);
        (ray.origin, ray.direction)
    }

    #[test]
    fn the_picture_spans_the_angle_of_view_with_x_to_the_right_and_y_upwards() {
        let camera = Pinhole { frame: frame() };
        assert_eq!(direction(&camera, 0.5, 0.5, DVec2::ZERO), (Vec3::new(0.0, 0.0, 5.0), Vec3::NEG_Z));
        // 90 degrees across: 45 to each side. Aspect 2: half as much upwards, tan = 0.5.
        let right = direction(&camera, 1.0, 0.5, DVec2::ZERO).1;
        assert!((right.x + right.z).abs() < 1e-7 && right.x > 0.0, "{right}");
        let top = direction(&camera, 0.5, 1.0, DVec2::ZERO).1;
        assert!((top.y / -top.z - 0.5).abs() < 1e-7 && top.y > 0.0, "{top}");
    }

    #[test]
    fn shift_moves_the_image_plane() {
        let camera = Pinhole { frame: Frame { shift: DVec2::new(1.0, 0.0), ..frame() } };
        let middle = direction(&camera, 0.5, 0.5, DVec2::ZERO).1;
        assert!((middle.x / -middle.z - 1.0).abs() < 1e-7);
    }

    #[test]
    fn all_rays_through_a_lens_meet_in_the_plane_of_focus() {
        let lens = ThinLens { frame: frame(), focus_distance: 4.0, radius: 0.5, sides: 0, rotation_degrees: 0.0 };
        let focus = |random: DVec2| {
            let (origin, direction) = direction(&lens, 0.8, 0.3, random);
            origin + direction * ((1.0 - origin.z) / direction.z)
        };
        let middle = focus(DVec2::splat(0.5));
        for random in [DVec2::ZERO, DVec2::new(0.9, 0.1), DVec2::new(0.2, 0.7)] {
            assert!((focus(random) - middle).length() < 1e-5);
        }
    }

    #[test]
    fn lens_points_fill_the_disc_or_the_polygon() {
        let lens = |sides| ThinLens { frame: frame(), focus_distance: 1.0, radius: 1.0, sides, rotation_degrees: 30.0 };
        let grid = || (0..10_000).map(|i| DVec2::new(f64::from(i % 100) + 0.5, f64::from(i / 100) + 0.5) / 100.0);
        for (sides, mean_square) in [(0, 0.5), (4, 1.0 / 3.0)] {
            // The mean squared distance from the centre: 1/2 in the disc, 1/3 in the square with corners at 1.
            let total: f64 = grid().map(|random| lens(sides).place_on_lens(random).length_squared()).sum();
            assert!((total / 10_000.0 - mean_square).abs() < 1e-3, "{sides} sides");
            let centre = grid().map(|random| lens(sides).place_on_lens(random)).sum::<DVec2>() / 10_000.0;
            assert!(centre.length() < 1e-3, "{sides} sides");
        }
        assert!(grid().all(|random| lens(0).place_on_lens(random).length() <= 1.0 + 1e-12));
    }

    #[test]
    fn a_camera_in_its_target_or_looking_along_up_sees_nothing() {
        assert_eq!(Frame::look_at(DVec3::ONE, DVec3::ONE, DVec3::Y), None);
        assert_eq!(Frame::look_at(DVec3::ZERO, DVec3::Y, 2.0 * DVec3::Y), None);
    }
}
