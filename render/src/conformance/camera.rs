//! The kit of a camera.
//!
//! **The idea.** The picture hangs at distance 1 before the eye. A place in it is a direction.
//!
//! ```text
//!          up |   / -forward       half = tan(fov / 2), half / aspect
//!             |  /                 direction = forward + right (shift.x + half.x (2 x - 1)) + up (shift.y + half.y (2 y - 1))
//!         eye o------ right        x from 0 at the left to 1, y from 0 at the bottom to 1
//!
//!    lens        focus     through a lens: every ray of a place meets the same point in the plane of focus
//!     |\__         |
//!     |_______\____*
//!     |__/         |
//! ```
//!
//! **The contract.** A [`MakeCamera`] makes a [`Camera`] of a [`View`]; `None` where that defines none. [`Camera::ray`] is a function of its
//! arguments alone, its direction a unit vector. A lens asks for its random point, once; a pinhole does not. [`Camera::rays`] gives the same,
//! for a camera that knows a faster way for many.
//!
//! **Hard cases.** An eye 1e6 away, where a coordinate's rounding is larger than a pixel: the direction must not be computed from points. An
//! angle of 0.01 degrees. An up vector that leans towards the view, of any length. The eye in its target. NaN: a ray along NaN meets nothing.
//!
//! **Literature.** Cook, Porter, Carpenter: Distributed Ray Tracing, SIGGRAPH 1984. Shirley and Chiu: A Low Distortion Map Between Disk and
//! Square, 1997. Kolb, Mitchell, Hanrahan: A Realistic Camera Model for Computer Graphics, SIGGRAPH 1995.
//!
//! **Exercises.** Pass the kit up to the lens with a pinhole. Add a lens, then its polygon. A fisheye: which laws does it break? Let the plane of
//! focus tilt (Scheimpflug). Beat [`crate::ThinLens`] in noise at 16 rays by another map to the disc.
//!
//! | mistake | law that names it |
//! |---|---|
//! | no camera | [`the_middle_of_the_picture_shows_the_target`] |
//! | looks away from the target | [`the_middle_of_the_picture_shows_the_target`] |
//! | rays start at the target | [`a_pinhole_s_rays_start_at_the_eye`] |
//! | image mirrored | [`x_runs_to_the_right_and_y_upwards`] |
//! | image upside down | [`x_runs_to_the_right_and_y_upwards`] |
//! | fov vertical instead of horizontal | [`fov_is_the_full_horizontal_angle`] |
//! | half of fov forgotten | [`fov_is_the_full_horizontal_angle`] |
//! | aspect ignored | [`aspect_is_width_over_height`] |
//! | up not perpendicular | [`up_in_the_picture_is_at_right_angles_to_the_view`] |
//! | shift forgotten | [`shift_moves_the_image_plane`] |
//! | a transform ignored | [`a_transform_places_the_camera`] |
//! | a view made up where there is none | [`what_is_no_view_has_no_camera`] |
//! | the direction from rounded points | [`a_ray_goes_where_its_place_is_at_any_eye`] |
//! | the direction not normalised | [`a_direction_has_length_1`] |
//! | the lens asked in a pinhole | [`a_pinhole_asks_for_no_point_of_a_lens`] |
//! | the lens ignored | [`a_lens_spreads_the_rays_starts`] |
//! | lens focus at wrong distance: on a sphere around the eye | [`all_rays_through_a_lens_meet_in_the_plane_of_focus`] |
//! | lens focus at wrong distance: on the image plane | [`all_rays_through_a_lens_meet_in_the_plane_of_focus`] |
//! | more rays from the lens' middle | [`a_lens_is_filled_evenly`] |
//! | a square lens for a disc | [`a_lens_is_filled_evenly`] |
//! | polygon lens as a disc | [`a_polygon_lens_has_its_corners`] |
//! | the polygon's rotation ignored | [`a_polygon_lens_has_its_corners`] |
//! | many rays through one point of the lens | [`many_rays_are_those_asked_for_one_by_one`] |
//! | many rays without the last | [`many_rays_are_those_asked_for_one_by_one`] |
//! | many rays in single precision | [`many_rays_are_those_asked_for_one_by_one`] |

use std::cell::Cell;

use geometry::Ray;
use geometry::conformance::{Counterexample, Figure, Ink, Trial, Verdict, same, wild_numbers};
use glam::{DVec2, DVec3, Vec3};
use proptest::prelude::*;

use super::{Axes, by_transform, lenses, ordinary_views, places, views};
use crate::{Camera, Lens, View, Viewpoint};

/// A camera from what a scene says of it.
pub type MakeCamera = fn(&View) -> Option<Box<dyn Camera>>;

/// Half the distance from 1 to the next `f32`.
const SINGLE: f64 = f32::EPSILON as f64 / 2.0;

/// What a unit vector's rounding is worth as an angle (u sqrt(3) / 2, half an ulp below 1 in three coordinates), and the steps before.
const ANGLE: f64 = 0.87 * SINGLE + 1e-13;

/// Ordinary views whose up is at right angles to the view, and of length 1.
fn upright_views() -> impl Strategy<Value = View> {
    ordinary_views().prop_map(|view| match view.place {
        Viewpoint::LookAt { eye, target, .. } => {
            View { place: Viewpoint::LookAt { eye, target, up: Axes::of(&view).up }, ..view }
        }
        Viewpoint::Transform(_) => view,
    })
}

fn made(make: &MakeCamera, view: &View) -> Result<Box<dyn Camera>, Box<Counterexample>> {
    make(view).ok_or_else(|| Counterexample::new("a camera", "None"))
}

fn ray(make: &MakeCamera, view: &View, film: DVec2) -> Result<Ray, Box<Counterexample>> {
    Ok(made(make, view)?.ray(film, &|| DVec2::splat(0.5)))
}

/// The sine of the angle between two directions, or more than 1 if they point apart.
fn sine(one: DVec3, other: DVec3) -> f64 {
    let (one, other) = (one.normalize(), other.normalize());
    if one.dot(other) > 0.0 { one.cross(other).length() } else { 2.0 }
}

/// The verdict on a direction, to an angle.
fn goes(ray: &Ray, expected: DVec3, exact: f64) -> Verdict {
    let found = ray.direction.as_dvec3();
    if sine(expected, found) <= exact {
        return Ok(());
    }
    let start = ray.origin.as_dvec3();
    let figure = Figure::through(ray, start + expected).line(start, start + expected.normalize(), Ink::Expected).line(
        start,
        start + found.normalize(),
        Ink::Found,
    );
    Err(Counterexample::new(format!("a ray along {:?}", expected.normalize()), format!("{:?}", ray.direction))
        .drawn(figure))
}

/// For ordinary scenes: 1e-5, a hundredth of a pixel.
const ORDINARY: f64 = 1e-5;

/// `forward = target - eye`.
pub fn the_middle_of_the_picture_shows_the_target(make: &MakeCamera, trial: &Trial) -> Verdict {
    trial.search(ordinary_views(), |view| goes(&ray(make, view, DVec2::splat(0.5))?, Axes::of(view).forward, ORDINARY))
}

/// All of them.
pub fn a_pinhole_s_rays_start_at_the_eye(make: &MakeCamera, trial: &Trial) -> Verdict {
    trial.search((views(), places()), |(view, film)| {
        same(&Axes::of(view).eye.as_vec3(), &ray(make, view, *film)?.origin)
    })
}

/// 0 is at the left and at the bottom, as the viewer sees them: `right = forward x up`.
pub fn x_runs_to_the_right_and_y_upwards(make: &MakeCamera, trial: &Trial) -> Verdict {
    trial.search(upright_views(), |view| {
        let axes = Axes::of(view);
        for (film, axis, side) in [(DVec2::new(1.0, 0.5), axes.right, "right"), (DVec2::new(0.5, 1.0), axes.up, "up")] {
            let found = ray(make, view, film)?;
            if found.direction.as_dvec3().dot(axis) <= 0.0 {
                return Err(Counterexample::new(format!("a ray to the {side} at {film:?}"), format!("{found:?}")));
            }
        }
        Ok(())
    })
}

/// From the left edge to the right, whatever the aspect.
pub fn fov_is_the_full_horizontal_angle(make: &MakeCamera, trial: &Trial) -> Verdict {
    trial.search(upright_views(), |view| {
        let axes = Axes::of(view);
        let (sin, cos) = libm::sincos(view.fov_degrees.to_radians() / 2.0);
        goes(&ray(make, view, DVec2::new(0.0, 0.5))?, axes.forward * cos - axes.right * sin, ORDINARY)?;
        goes(&ray(make, view, DVec2::new(1.0, 0.5))?, axes.forward * cos + axes.right * sin, ORDINARY)
    })
}

/// Of the image plane, so its half height is `tan(fov / 2) / aspect`.
pub fn aspect_is_width_over_height(make: &MakeCamera, trial: &Trial) -> Verdict {
    trial.search(upright_views(), |view| {
        [0.0, 1.0].into_iter().try_for_each(|y| {
            let film = DVec2::new(0.5, y);
            goes(&ray(make, view, film)?, Axes::of(view).towards(view, film), ORDINARY)
        })
    })
}

/// Of an up vector only what is at right angles to the view counts.
pub fn up_in_the_picture_is_at_right_angles_to_the_view(make: &MakeCamera, trial: &Trial) -> Verdict {
    trial.search((ordinary_views(), places()), |(view, film)| {
        goes(&ray(make, view, *film)?, Axes::of(view).towards(view, *film), ORDINARY)
    })
}

/// In units of the plane at distance 1.
pub fn shift_moves_the_image_plane(make: &MakeCamera, trial: &Trial) -> Verdict {
    let shifted = (ordinary_views(), -1.0..1.0, -1.0..1.0);
    trial.search((shifted, places()), |&((view, x, y), film)| {
        let view = View { shift: DVec2::new(x, y), ..view };
        goes(&ray(make, &view, film)?, Axes::of(&view).towards(&view, film), ORDINARY)
    })
}

/// The camera looks along -z of its own space, x to the right and y upwards.
pub fn a_transform_places_the_camera(make: &MakeCamera, trial: &Trial) -> Verdict {
    trial.search((ordinary_views(), places()), |(view, film)| {
        let view = by_transform(view);
        let found = ray(make, &view, *film)?;
        goes(&found, Axes::of(&view).towards(&view, *film), ORDINARY)?;
        same(&Axes::of(&view).eye.as_vec3(), &found.origin)
    })
}

/// The eye in its target, or up along the view, or of no length.
pub fn what_is_no_view_has_no_camera(make: &MakeCamera, trial: &Trial) -> Verdict {
    trial.search((ordinary_views(), 0..3_usize), |&(view, case)| {
        let Viewpoint::LookAt { eye, target, up } = view.place else { return Ok(()) };
        let (target, up) = [(eye, up), (target, 2.0 * (target - eye)), (target, DVec3::ZERO)][case];
        let view = View { place: Viewpoint::LookAt { eye, target, up }, ..view };
        if make(&view).is_none() { Ok(()) } else { Err(Counterexample::new("None", format!("a camera for {view:?}"))) }
    })
}

/// To the rounding of a unit vector, even a million units from the origin of space and at a hundredth of a degree.
pub fn a_ray_goes_where_its_place_is_at_any_eye(make: &MakeCamera, trial: &Trial) -> Verdict {
    trial.times(16).search((views(), places()), |(view, film)| {
        goes(&ray(make, view, *film)?, Axes::of(view).towards(view, *film), ANGLE)
    })
}

/// A picture 1000 pixels wide that sees 40 to 90 degrees, no higher than wide, and not shifted: to 9e-5 of a pixel.
pub fn a_ray_passes_its_pixel_at_any_eye(make: &MakeCamera, trial: &Trial) -> Verdict {
    trial.times(16).search((views(), places(), 40.0..90.0), |&(view, film, fov_degrees)| {
        let view = View { fov_degrees, aspect: view.aspect.max(1.0), shift: DVec2::ZERO, ..view };
        let axes = Axes::of(&view);
        let direction = ray(make, &view, film)?.direction.as_dvec3();
        let half_width = libm::tan(fov_degrees.to_radians() / 2.0);
        let on_plane = DVec2::new(direction.dot(axes.right), direction.dot(axes.up)) / direction.dot(axes.forward);
        let place = on_plane / DVec2::new(half_width, half_width / view.aspect);
        let off = (place - (2.0 * film - DVec2::ONE)) * DVec2::new(500.0, 500.0 / view.aspect);
        let near = off.abs().max_element() <= 9e-5;
        if near { Ok(()) } else { Err(Counterexample::new("at most 9e-5 pixels off", format!("{off:?} pixels"))) }
    })
}

/// Of any view; NaN where there is no answer, since a ray along NaN meets nothing.
pub fn a_direction_has_length_1(make: &MakeCamera, trial: &Trial) -> Verdict {
    let wild = || [wild_numbers(), wild_numbers(), wild_numbers()].prop_map(|v| DVec3::from(v.map(f64::from)));
    let pair = || [wild_numbers(), wild_numbers()].prop_map(|v| DVec2::from(v.map(f64::from)));
    let look_at = (wild(), wild(), wild()).prop_map(|(eye, target, up)| Viewpoint::LookAt { eye, target, up });
    let lens = (wild_numbers(), wild_numbers(), any::<u32>()).prop_map(|(focus, radius, sides)| Lens {
        focus_distance: focus.into(),
        radius: radius.into(),
        sides,
        rotation_degrees: focus.into(),
    });
    let view = (look_at, wild_numbers(), wild_numbers(), pair(), prop::option::of(lens)).prop_map(
        |(place, fov, aspect, shift, lens)| View { place, fov_degrees: fov.into(), aspect: aspect.into(), shift, lens },
    );
    let is_unit = |direction: Vec3| direction.is_nan() || direction.is_normalized();
    trial.times(32).search((prop_oneof![1 => views(), 3 => view], pair(), pair()), |&(view, film, on_lens)| {
        let Some(camera) = make(&view) else { return Ok(()) };
        let found = camera.ray(film, &|| on_lens).direction;
        if is_unit(found) { Ok(()) } else { Err(Counterexample::new("a unit vector, or NaN", format!("{found:?}"))) }
    })
}

/// What a scene does not use costs it nothing.
pub fn a_pinhole_asks_for_no_point_of_a_lens(make: &MakeCamera, trial: &Trial) -> Verdict {
    trial.search((ordinary_views(), places()), |(view, film)| {
        let asked = Cell::new(0);
        let camera = made(make, view)?;
        camera.ray(*film, &|| {
            asked.set(asked.get() + 1);
            DVec2::ZERO
        });
        same(&(0, false), &(asked.get(), camera.has_lens()))
    })
}

/// With a lens: places in the square are spread over it, in its plane, and the camera says that it has one.
fn through_lens() -> impl Strategy<Value = (View, DVec2, DVec2)> {
    (views(), lenses(), places(), places())
        .prop_map(|(view, lens, film, on_lens)| (View { lens: Some(lens), ..view }, film, on_lens))
}

/// Two points of the square are two starts, neither further from the eye than the radius; and the camera says that it has a lens.
pub fn a_lens_spreads_the_rays_starts(make: &MakeCamera, trial: &Trial) -> Verdict {
    let lenses = (ordinary_views(), lenses()).prop_map(|(view, lens)| View { lens: Some(lens), ..view });
    trial.search((lenses, places()), |(view, film)| {
        let (Some(Lens { radius, .. }), axes) = (view.lens, Axes::of(view)) else { return Ok(()) };
        let camera = made(make, view)?;
        let start = |on_lens: DVec2| camera.ray(*film, &|| on_lens).origin.as_dvec3() - axes.eye;
        let starts = [DVec2::new(0.05, 0.5), DVec2::new(0.95, 0.5)].map(start);
        let rounding = 4.0 * SINGLE * (axes.eye.length() + radius);
        let apart = (starts[0] - starts[1]).length() >= 0.5 * radius - rounding;
        let within = starts.iter().all(|start| start.length() <= radius * 1.0001 + rounding);
        let in_plane = starts.iter().all(|start| start.dot(axes.forward).abs() <= rounding);
        if apart && within && in_plane && camera.has_lens() {
            return Ok(());
        }
        let expected = format!("two starts on a lens of radius {radius} around the eye, and `has_lens`");
        Err(Counterexample::new(expected, format!("{starts:?} from the eye, {}", camera.has_lens())))
    })
}

/// The verdict on a ray that starts on a lens: it passes the point in focus to the rounding of its direction, seen from where it starts.
fn passes_the_focus(make: &MakeCamera, view: &View, film: DVec2, on_lens: DVec2) -> Verdict {
    let (Some(lens), axes) = (view.lens, Axes::of(view)) else { return Ok(()) };
    let found = made(make, view)?.ray(film, &|| on_lens);
    // From differences alone: far off, the point itself would be rounded.
    let from_start = axes.towards(view, film) * lens.focus_distance - (found.origin.as_dvec3() - axes.eye);
    goes(&found, from_start, ANGLE)
}

/// Measured along the view axis, whichever point of the lens a ray comes from. At 1e6 numbers are 1/16 apart: there the start that was
/// rounded counts, not the one that was meant.
pub fn all_rays_through_a_lens_meet_in_the_plane_of_focus(make: &MakeCamera, trial: &Trial) -> Verdict {
    trial.times(16).search(through_lens(), |&(view, film, on_lens)| passes_the_focus(make, &view, film, on_lens))?;
    let (eye, up) = (DVec3::splat(1e6), DVec3::Z);
    let far_off = View {
        place: Viewpoint::LookAt { eye, target: eye + DVec3::new(3.0, 2.0, 1.0), up },
        fov_degrees: 60.0,
        aspect: 1.0,
        shift: DVec2::ZERO,
        lens: Some(Lens { focus_distance: 4.0, radius: 0.05, sides: 0, rotation_degrees: 0.0 }),
    };
    passes_the_focus(make, &far_off, DVec2::new(0.3, 0.6), DVec2::new(0.9, 0.2))
}

/// Where rays start on a lens of radius 1, in the plane of right and up, for an even grid of the square.
fn on_lens(make: &MakeCamera, view: &View) -> Result<Vec<DVec2>, Box<Counterexample>> {
    let (camera, axes) = (made(make, view)?, Axes::of(view));
    let radius = view.lens.map_or(1.0, |lens| lens.radius);
    let start = |number: u32| {
        let place = DVec2::new(f64::from(number % 64), f64::from(number / 64)) / 64.0 + 1.0 / 128.0;
        let start = camera.ray(DVec2::splat(0.5), &|| place).origin.as_dvec3() - axes.eye;
        DVec2::new(start.dot(axes.right), start.dot(axes.up)) / radius
    };
    Ok((0..64 * 64).map(start).collect())
}

/// A camera with a wide lens at the origin of space.
fn wide(lens: impl Strategy<Value = (u32, f64)>) -> impl Strategy<Value = View> {
    (ordinary_views(), lens).prop_map(|(view, (sides, rotation_degrees))| {
        let Viewpoint::LookAt { eye, target, up } = view.place else { return view };
        let place = Viewpoint::LookAt { eye: DVec3::ZERO, target: target - eye, up };
        View { place, lens: Some(Lens { focus_distance: 4.0, radius: 1.0, sides, rotation_degrees }), ..view }
    })
}

fn starts_drawn(starts: &[DVec2]) -> Figure {
    let points = starts.iter().step_by(7);
    points.fold(Figure::flat(), |figure, start| figure.point(start.extend(0.0), Ink::Found, ""))
}

/// Equal parts of the square become equal parts of the disc. Then the mean of the starts is the middle, and that of their squared distances
/// from it 1/2 of the radius'; none is outside.
pub fn a_lens_is_filled_evenly(make: &MakeCamera, trial: &Trial) -> Verdict {
    let trial = Trial { cases: trial.cases.div_ceil(8), ..*trial };
    trial.search(wide((Just(0_u32), -360.0..360.0)), |view| {
        let starts = on_lens(make, view)?;
        let count = starts.len() as f64;
        let mean = starts.iter().sum::<DVec2>() / count;
        let square = starts.iter().map(|start| start.length_squared()).sum::<f64>() / count;
        let reach = starts.iter().map(|start| start.length()).fold(0.0, f64::max);
        // A quarter of the disc by area, inside half the radius.
        let inner = starts.iter().filter(|start| start.length() < 0.5).count() as f64 / count;
        if mean.length() < 2e-3 && (square - 0.5).abs() < 2e-3 && reach <= 1.0001 && (inner - 0.25).abs() < 0.02 {
            return Ok(());
        }
        let found = format!("{mean:?}, {square:.3}, {inner:.3}, {reach:.3}");
        let expected = "a mean of 0, of squares 1/2, a quarter within half the radius, none beyond it";
        Err(Counterexample::new(expected, found).drawn(starts_drawn(&starts)))
    })
}

/// Corners at the radius, the first at `rotation`; its sides are straight, and it is filled evenly: a mean square of `(2 + cos(2 pi / n)) / 6`.
pub fn a_polygon_lens_has_its_corners(make: &MakeCamera, trial: &Trial) -> Verdict {
    let trial = Trial { cases: trial.cases.div_ceil(8), ..*trial };
    trial.search(wide((3_u32..8, -360.0..360.0)), |view| {
        let Some(Lens { sides, rotation_degrees, .. }) = view.lens else { return Ok(()) };
        let starts = on_lens(make, view)?;
        let turn = std::f64::consts::TAU / f64::from(sides);
        let reach = |corners: f64| {
            let (sin, cos) = libm::sincos(rotation_degrees.to_radians() + turn * corners);
            starts.iter().map(|start| start.dot(DVec2::new(cos, sin))).fold(0.0, f64::max)
        };
        let inner = libm::cos(turn / 2.0);
        let square = starts.iter().map(|start| start.length_squared()).sum::<f64>() / starts.len() as f64;
        let even = (2.0 + libm::cos(turn)) / 6.0;
        let is_shape =
            (0..sides).map(f64::from).all(|number| reach(number) > 0.9 && reach(number + 0.5) <= inner * 1.0001);
        if is_shape && (square - even).abs() < 5e-3 {
            return Ok(());
        }
        let expected = format!("corners at 1, sides at {inner:.3}, a mean square of {even:.3}");
        let found = format!("{:.3}, {:.3}, {square:.3}", reach(0.0), reach(0.5));
        Err(Counterexample::new(expected, found).drawn(starts_drawn(&starts)))
    })
}

/// Bit for bit, after what is in the list already.
pub fn many_rays_are_those_asked_for_one_by_one(make: &MakeCamera, trial: &Trial) -> Verdict {
    let view = (views(), prop::option::of(lenses())).prop_map(|(view, lens)| View { lens, ..view });
    let asked = prop::collection::vec((places(), places()), 0..20);
    trial.search((view, asked), |(view, asked)| {
        let camera = made(make, view)?;
        let (films, on_lens): (Vec<_>, Vec<_>) = asked.iter().copied().unzip();
        let mut expected = vec![Ray::new(Vec3::ONE, Vec3::X)];
        let mut found = expected.clone();
        expected.extend(asked.iter().map(|&(film, on_lens)| camera.ray(film, &|| on_lens)));
        camera.rays(&films, &|number| on_lens[number], &mut found);
        same(&expected, &found)
    })
}

geometry::kit! { $crate
    /// Names the laws of a camera as tests: of a function from a [`crate::View`] to a [`crate::Camera`].
    camera_conformance, MakeCamera, camera;
    the_middle_of_the_picture_shows_the_target: "nothing is returned yet: begin with the direction from the eye to the target";
    a_pinhole_s_rays_start_at_the_eye: "the ray starts on the image plane, or at the target";
    x_runs_to_the_right_and_y_upwards: "the factors of a cross product are exchanged, or y counts from the top";
    fov_is_the_full_horizontal_angle: "the angle is taken for the height, or as half, or degrees for radians, or up's length changes the axes";
    aspect_is_width_over_height: "the aspect is not used, or multiplied instead of divided by";
    up_in_the_picture_is_at_right_angles_to_the_view: "up is taken as it is: take right x forward instead";
    shift_moves_the_image_plane: "the shift is not used, or multiplied by the plane's size";
    a_transform_places_the_camera: "only eye, target and up are read; or z is taken for forward";
    what_is_no_view_has_no_camera: "a vector of no length is normalised to NaN, or another up is made up";
    a_ray_goes_where_its_place_is_at_any_eye: "the direction is the difference of two points, or computed in single precision";
    a_ray_passes_its_pixel_at_any_eye: "as above";
    a_direction_has_length_1: "the direction is not normalised, or by a length that overflows";
    a_pinhole_asks_for_no_point_of_a_lens: "the lens is asked for before it is known to be there";
    a_lens_spreads_the_rays_starts: "the lens is not used, or lies in another plane than right and up, or `has_lens` does not say so";
    all_rays_through_a_lens_meet_in_the_plane_of_focus: "the distance is measured along the ray, or from the image plane; or the start that was meant is taken, not the rounded one";
    a_lens_is_filled_evenly: "the radius is the random number, not its root, so the middle is too dense; or the square is used as it is";
    a_polygon_lens_has_its_corners: "the sides are ignored, or the first corner is not at the rotation";
    many_rays_are_those_asked_for_one_by_one: "`rays` does other steps than `ray`, or gives a ray another's point of the lens, or empties the list: leave it out, and the rays come from `ray`";
}
