use geometry::Ray;
use glam::{DVec2, DVec3};
use render::conformance::{Axes, camera as kit};
use render::{Camera, Frame, Lens, Pinhole, View, Viewpoint, camera};

use crate::Kit;

/// A camera that is a function of the place in the picture and of what gives a point of the lens.
struct Student<F> {
    ray: F,
    has_lens: bool,
}

impl<F: Fn(DVec2, &dyn Fn() -> DVec2) -> Ray + Send + Sync> Camera for Student<F> {
    fn ray(&self, film: DVec2, lens: &dyn Fn() -> DVec2) -> Ray {
        (self.ray)(film, lens)
    }

    fn has_lens(&self) -> bool {
        self.has_lens
    }
}

/// The right camera, its rays changed.
fn changed(
    view: &View,
    ray: impl Fn(&dyn Camera, DVec2, &dyn Fn() -> DVec2) -> Ray + Send + Sync + 'static,
) -> Option<Box<dyn Camera>> {
    let right = camera(view)?;
    let has_lens = right.has_lens();
    Some(Box::new(Student { ray: move |film, lens: &dyn Fn() -> DVec2| ray(&*right, film, lens), has_lens }))
}

/// The right camera of another view, if a scene gives eye, target and up.
fn looking(view: &View, change: impl Fn(DVec3, DVec3, DVec3) -> Viewpoint) -> View {
    match view.place {
        Viewpoint::LookAt { eye, target, up } => View { place: change(eye, target, up), ..*view },
        Viewpoint::Transform(_) => *view,
    }
}

/// A pinhole, or a lens by a map of the unit square to it.
fn through(view: &View, on_lens: fn(DVec2) -> DVec2) -> Option<Box<dyn Camera>> {
    let Some(lens) = view.lens.filter(|lens| lens.sides < 3) else { return camera(view) };
    camera(view)?;
    let (view, axes) = (*view, Axes::of(view));
    let ray = move |film: DVec2, random: &dyn Fn() -> DVec2| {
        let place = on_lens(random()) * lens.radius;
        let origin = (axes.eye + axes.right * place.x + axes.up * place.y).as_vec3();
        let offset = origin.as_dvec3() - axes.eye;
        let direction = axes.towards(&view, film) - offset / lens.focus_distance;
        Ray::new(origin, direction.normalize().as_vec3())
    };
    Some(Box::new(Student { ray, has_lens: true }))
}

/// The right camera, what it makes of many places changed.
struct Many<F> {
    right: Box<dyn Camera>,
    rays: F,
}

type ManyRays = fn(&dyn Camera, &[DVec2], &dyn Fn(usize) -> DVec2, &mut Vec<Ray>);

impl Camera for Many<ManyRays> {
    fn ray(&self, film: DVec2, lens: &dyn Fn() -> DVec2) -> Ray {
        self.right.ray(film, lens)
    }

    fn rays(&self, films: &[DVec2], lens: &dyn Fn(usize) -> DVec2, rays: &mut Vec<Ray>) {
        (self.rays)(&*self.right, films, lens, rays);
    }

    fn has_lens(&self) -> bool {
        self.right.has_lens()
    }
}

fn many(view: &View, rays: ManyRays) -> Option<Box<dyn Camera>> {
    Some(Box::new(Many { right: camera(view)?, rays }))
}

fn with_lens(view: &View, change: impl Fn(Lens) -> Lens) -> View {
    View { lens: view.lens.map(change), ..*view }
}

#[test]
fn every_mistake_in_a_camera_is_named() {
    let middle = "the_middle_of_the_picture_shows_the_target";
    let sides = "x_runs_to_the_right_and_y_upwards";
    let focus = "all_rays_through_a_lens_meet_in_the_plane_of_focus";
    Kit { page: "render/src/conformance/camera.rs", laws: kit::LAWS }.catches([
        ("no camera", (|_| None) as kit::MakeCamera, middle),
        (
            "looks away from the target",
            |view| camera(&looking(view, |eye, target, up| Viewpoint::LookAt { eye, target: 2.0 * eye - target, up })),
            middle,
        ),
        (
            "rays start at the target",
            |view| {
                let Viewpoint::LookAt { target, .. } = view.place else { return camera(view) };
                changed(view, move |right, film, lens| Ray::new(target.as_vec3(), right.ray(film, lens).direction))
            },
            "a_pinhole_s_rays_start_at_the_eye",
        ),
        (
            "image mirrored",
            |view| changed(view, |right, film, lens| right.ray(DVec2::new(1.0 - film.x, film.y), lens)),
            sides,
        ),
        (
            "image upside down",
            |view| changed(view, |right, film, lens| right.ray(DVec2::new(film.x, 1.0 - film.y), lens)),
            sides,
        ),
        (
            "fov vertical instead of horizontal",
            |view| {
                let half_width = (view.fov_degrees.to_radians() / 2.0).tan() * view.aspect;
                camera(&View { fov_degrees: 2.0 * half_width.atan().to_degrees(), ..*view })
            },
            "fov_is_the_full_horizontal_angle",
        ),
        (
            "half of fov forgotten",
            |view| camera(&View { fov_degrees: 2.0 * view.fov_degrees, ..*view }),
            "fov_is_the_full_horizontal_angle",
        ),
        ("aspect ignored", |view| camera(&View { aspect: 1.0, ..*view }), "aspect_is_width_over_height"),
        (
            "up not perpendicular",
            |view| {
                let Viewpoint::LookAt { eye, target, up } = view.place else { return camera(view) };
                let frame = Frame::look_at(eye, target, up)?.seeing(view.fov_degrees, view.aspect);
                Some(Box::new(Pinhole { frame: Frame { up: up.normalize(), shift: view.shift, ..frame } }))
            },
            "up_in_the_picture_is_at_right_angles_to_the_view",
        ),
        ("shift forgotten", |view| camera(&View { shift: DVec2::ZERO, ..*view }), "shift_moves_the_image_plane"),
        (
            "a transform ignored",
            |view| {
                let place = match view.place {
                    Viewpoint::Transform(_) => {
                        Viewpoint::LookAt { eye: DVec3::ZERO, target: DVec3::NEG_Z, up: DVec3::Y }
                    }
                    given => given,
                };
                camera(&View { place, ..*view })
            },
            "a_transform_places_the_camera",
        ),
        (
            "a view made up where there is none",
            |view| {
                let place = Viewpoint::LookAt { eye: DVec3::ZERO, target: DVec3::NEG_Z, up: DVec3::Y };
                camera(view).or_else(|| camera(&View { place, ..*view }))
            },
            "what_is_no_view_has_no_camera",
        ),
        (
            "the direction from rounded points",
            |view| {
                camera(view)?;
                let (view, axes) = (*view, Axes::of(view));
                let ray = move |film: DVec2, _: &dyn Fn() -> DVec2| {
                    let eye = axes.eye.as_vec3();
                    let on_plane = (axes.eye + axes.towards(&view, film)).as_vec3();
                    Ray::new(eye, (on_plane - eye).normalize())
                };
                Some(Box::new(Student { ray, has_lens: false }))
            },
            "a_ray_goes_where_its_place_is_at_any_eye",
        ),
        (
            "the direction not normalised",
            |view| {
                changed(view, |right, film, lens| {
                    let Ray { origin, direction } = right.ray(film, lens);
                    Ray::new(origin, direction * 2.0)
                })
            },
            "a_direction_has_length_1",
        ),
        (
            "the lens asked in a pinhole",
            |view| {
                changed(view, |right, film, lens| {
                    let asked = lens();
                    right.ray(film, &|| asked)
                })
            },
            "a_pinhole_asks_for_no_point_of_a_lens",
        ),
        ("the lens ignored", |view| camera(&View { lens: None, ..*view }), "a_lens_spreads_the_rays_starts"),
        (
            "lens focus at wrong distance: on a sphere around the eye",
            |view| {
                let Some(lens) = view.lens else { return camera(view) };
                let (seen, axes) = (*view, Axes::of(view));
                changed(view, move |right, film, random| {
                    let origin = right.ray(film, random).origin;
                    let in_focus = axes.towards(&seen, film).normalize() * lens.focus_distance;
                    let direction = in_focus - (origin.as_dvec3() - axes.eye);
                    Ray::new(origin, direction.normalize().as_vec3())
                })
            },
            focus,
        ),
        (
            "lens focus at wrong distance: on the image plane",
            |view| camera(&with_lens(view, |lens| Lens { focus_distance: 1.0, ..lens })),
            focus,
        ),
        (
            "more rays from the lens' middle",
            |view| {
                through(view, |random| {
                    let (sin, cos) = (std::f64::consts::TAU * random.y).sin_cos();
                    random.x * DVec2::new(cos, sin)
                })
            },
            "a_lens_is_filled_evenly",
        ),
        (
            "a square lens for a disc",
            |view| through(view, |random| 2.0 * random.clamp(DVec2::splat(0.01), DVec2::splat(0.99)) - 1.0),
            "a_lens_is_filled_evenly",
        ),
        (
            "polygon lens as a disc",
            |view| camera(&with_lens(view, |lens| Lens { sides: 0, ..lens })),
            "a_polygon_lens_has_its_corners",
        ),
        (
            "the polygon's rotation ignored",
            |view| camera(&with_lens(view, |lens| Lens { rotation_degrees: 0.0, ..lens })),
            "a_polygon_lens_has_its_corners",
        ),
        (
            "many rays through one point of the lens",
            |view| many(view, |right, films, lens, rays| right.rays(films, &|_| lens(0), rays)),
            "many_rays_are_those_asked_for_one_by_one",
        ),
        (
            "many rays without the last",
            |view| {
                many(view, |right, films, lens, rays| right.rays(&films[..films.len().saturating_sub(1)], lens, rays))
            },
            "many_rays_are_those_asked_for_one_by_one",
        ),
        (
            "many rays in single precision",
            |view| {
                many(view, |right, films, lens, rays| {
                    let films: Vec<DVec2> = films.iter().map(|film| film.as_vec2().as_dvec2()).collect();
                    right.rays(&films, lens, rays);
                })
            },
            "many_rays_are_those_asked_for_one_by_one",
        ),
    ]);
}
