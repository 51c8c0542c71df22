use geometry::conformance::{magnitude, times};
use glam::{DVec2, DVec3};
use proptest::prelude::*;
use render::{
    Camera, Frame, ThinLens,
    conformance::{View, places, views},
};

use crate::exact::{Real, SINGLE, Vector, real, tangent_of_half};

/// What a unit vector's rounding is worth as an angle (u sqrt(3) / 2, half an ulp below 1 in three coordinates), and the steps before.
const ANGLE: f64 = 0.87 * SINGLE + 1e-13;

/// The axes that a view asks for.
struct ExactFrame {
    right: Vector,
    up: Vector,
    forward: Vector,
    half: [Real; 2],
    shift: [Real; 2],
}

impl ExactFrame {
    fn new(view: &View) -> Self {
        let forward = Vector::from(view.target).minus(&view.eye.into()).normalized();
        let right = forward.cross(&view.up.into()).normalized();
        let up = right.cross(&forward);
        let half_width = tangent_of_half(view.fov_degrees);
        let half_height = &half_width / real(view.aspect);
        Self { right, up, forward, half: [half_width, half_height], shift: view.shift.to_array().map(real) }
    }

    /// From the eye to the plane at distance 1.
    fn towards(&self, film: DVec2) -> Vector {
        let place =
            |axis: usize| &self.shift[axis] + &self.half[axis] * (real(2.0) * real(film.to_array()[axis]) - real(1.0));
        self.right.times(&place(0)).plus(&self.up.times(&place(1))).plus(&self.forward)
    }

    /// The place of the picture, from -1 to 1, that a direction passes.
    fn place(&self, direction: &Vector) -> [Real; 2] {
        let ahead = direction.dot(&self.forward);
        [(&self.right, 0), (&self.up, 1)]
            .map(|(axis, i)| (direction.dot(axis) / &ahead - &self.shift[i]) / &self.half[i])
    }
}

proptest! {
    #![proptest_config(times(16))]

    #[test]
    fn a_ray_goes_where_its_place_is_to_a_rounding_at_any_eye(view in views(), film in places()) {
        let ray = view.pinhole().expect("a view").ray(film, &|| DVec2::ZERO);
        let angle = ExactFrame::new(&view).towards(film).sine(&ray.direction.as_dvec3().into());
        prop_assert!(angle <= ANGLE, "off by {} u", angle / SINGLE);
        prop_assert_eq!(ray.origin, view.eye.as_vec3());
    }

    /// A picture 1000 pixels wide that sees 40 to 90 degrees, no higher than wide, and not shifted.
    #[test]
    fn a_ray_passes_its_place_to_9e_5_pixels_at_any_eye(view in views(), film in places(), fov in 40.0..90.0) {
        let view = View { fov_degrees: fov, aspect: view.aspect.max(1.0), shift: DVec2::ZERO, ..view };
        let ray = view.pinhole().expect("a view").ray(film, &|| DVec2::ZERO);
        let place = ExactFrame::new(&view).place(&ray.direction.as_dvec3().into());
        let pixels = [1000.0, 1000.0 / view.aspect];
        for axis in 0..2 {
            let meant = real(2.0) * real(film.to_array()[axis]) - real(1.0);
            let off = ((&place[axis] - meant) * real(0.5 * pixels[axis])).to_f64().value().abs();
            prop_assert!(off <= 9e-5, "off by {} pixels along axis {}", off, axis);
        }
    }

    #[test]
    fn every_ray_of_a_lens_passes_the_point_in_focus_to_a_rounding(
        view in views(), film in places(), on_lens in places(), focus in magnitude(1e-2, 1e4), width in magnitude(1e-4, 0.5),
        sides in prop_oneof![Just(0_u32), 3_u32..8],
    ) {
        let lens = view.thin_lens(focus, width * focus, sides).expect("a view");
        passes_the_focus(&view, &lens, film, on_lens)?;
    }
}

fn passes_the_focus(view: &View, lens: &ThinLens, film: DVec2, on_lens: DVec2) -> Result<(), TestCaseError> {
    let ray = lens.ray(film, &|| on_lens);
    let in_focus = ExactFrame::new(view).towards(film).times(&real(lens.focus_distance)).plus(&view.eye.into());
    let start = Vector::from(ray.origin.as_dvec3());
    let angle = in_focus.minus(&start).sine(&ray.direction.as_dvec3().into());
    prop_assert!(angle <= ANGLE, "off by {} u", angle / SINGLE);
    let off_axis = (ray.origin.as_dvec3() - view.eye).abs();
    let rounding = SINGLE * (view.eye.abs() + lens.radius) + 1e-9 * lens.radius;
    prop_assert!(off_axis.cmple(DVec3::splat(lens.radius) + rounding).all(), "{} off the lens", off_axis);
    Ok(())
}

/// At 1e6 the numbers are 1/16 apart, and the lens is as wide as that: its rays start a quarter of it from where they were meant to.
#[test]
fn a_lens_far_off_is_sharp_in_its_focus() {
    let view = View {
        eye: DVec3::new(1e6, 1e6, 1e6),
        target: DVec3::new(1e6 + 3.0, 1e6 + 2.0, 1e6 + 1.0),
        up: DVec3::Z,
        fov_degrees: 60.0,
        aspect: 1.0,
        shift: DVec2::ZERO,
    };
    let frame: Frame = view.frame().unwrap();
    let lens = ThinLens { frame, focus_distance: 4.0, radius: 0.05, sides: 0, rotation_degrees: 0.0 };
    passes_the_focus(&view, &lens, DVec2::new(0.3, 0.6), DVec2::new(0.9, 0.2)).unwrap();
}
