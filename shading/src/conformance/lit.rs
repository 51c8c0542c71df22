//! What every matt surface keeps, whatever else it does: the laws that the kits of two shaders share.

use geometry::conformance::{Trial, Verdict, same};
use proptest::prelude::*;

use super::stage::times;
use super::{
    Stage, blocked_at, colors, from_inside, from_outside, lamps, leaning, lit, lit_from_behind,
    lit_through_the_surface, stages, straight, undimmed,
};
use crate::{Color, Shader};

/// A matt surface of a colour.
pub(super) type Matt<'a> = &'a dyn Fn(Color) -> Box<dyn Shader>;

/// The verdict on a matt surface that nothing shades.
fn shows(matt: Matt<'_>, stage: &Stage, color: Color) -> Verdict {
    stage.shows(&stage.shown(&*matt(color)), times(color, stage.matt_light()))
}

fn dark(matt: Matt<'_>, stage: &Stage, color: Color) -> Verdict {
    stage.shows(&stage.shown(&*matt(color)), [0.0; 3])
}

pub(super) fn ambient(matt: Matt<'_>, trial: &Trial) -> Verdict {
    trial.search((stages(), colors()), |(stage, color)| {
        stage.shows(&stage.shown(&*matt(*color)), times(*color, [stage.ambient.into(); 3]))
    })
}

/// Straight above the surface.
pub(super) fn straight_above(matt: Matt<'_>, trial: &Trial) -> Verdict {
    let above = undimmed(lit(straight())).prop_map(|stage| {
        let to_light = stage.outward() * stage.to_lamp().length();
        let position = (stage.surface.position.as_dvec3() + to_light).as_vec3();
        Stage { lamps: stage.lamps.map(|lamp| lamp.map(|lamp| super::Lamp { position, ..lamp })), ..stage }
    });
    trial.search((above, colors()), |(stage, color)| shows(matt, stage, *color))
}

pub(super) fn by_the_cosine(matt: Matt<'_>, trial: &Trial) -> Verdict {
    trial.search((undimmed(lit(from_outside())), colors()), |(stage, color)| shows(matt, stage, *color))
}

pub(super) fn by_the_distance(matt: Matt<'_>, trial: &Trial) -> Verdict {
    trial.search((lit(from_outside()), colors()), |(stage, color)| shows(matt, stage, *color))
}

pub(super) fn behind(matt: Matt<'_>, trial: &Trial) -> Verdict {
    trial.search((lit_from_behind(from_outside()), colors()), |(stage, color)| dark(matt, stage, *color))
}

pub(super) fn add_up(matt: Matt<'_>, trial: &Trial) -> Verdict {
    let two = lamps(from_outside()).prop_map(|stage| Stage { ambient: 0.0, ..stage });
    trial.search((two, colors()), |(stage, color)| shows(matt, stage, *color))
}

/// In the dark for two reasons, so that no other mistake shows: its light is behind the surface, and something is in the way.
pub(super) fn no_ambient(matt: Matt<'_>, trial: &Trial) -> Verdict {
    let unlit = blocked_at(lit_from_behind(from_outside()), 0.4..0.7);
    trial.search((unlit, colors()), |(stage, color)| dark(matt, &Stage { ambient: 0.5, ..stage.clone() }, *color))
}

pub(super) fn in_shadow(matt: Matt<'_>, trial: &Trial) -> Verdict {
    let blocked = blocked_at(lit(from_outside()), 0.4..0.7);
    // The blocker is left of the point and of the light, and above the surface or in it.
    trial.search((blocked, colors()), |(stage, color)| dark(matt, stage, *color))
}

pub(super) fn beyond_the_light(matt: Matt<'_>, trial: &Trial) -> Verdict {
    let beyond = blocked_at(lit(from_outside()), 1.3..4.0);
    trial.search((beyond, colors()), |(stage, color)| shows(matt, stage, *color))
}

pub(super) fn behind_the_point(matt: Matt<'_>, trial: &Trial) -> Verdict {
    let behind = blocked_at(lit(from_outside()), -4.0..-0.3);
    trial.search((behind, colors()), |(stage, color)| shows(matt, stage, *color))
}

pub(super) fn the_back(matt: Matt<'_>, trial: &Trial) -> Verdict {
    let either = prop_oneof![lit(from_inside()), lit_from_behind(from_inside())];
    trial.search((either, colors()), |(stage, color)| shows(matt, stage, *color))
}

pub(super) fn the_mesh_s_normal(matt: Matt<'_>, trial: &Trial) -> Verdict {
    trial.search((lit(leaning()), colors()), |(stage, color)| shows(matt, stage, *color))
}

pub(super) fn through_the_surface(matt: Matt<'_>, trial: &Trial) -> Verdict {
    trial.search((lit_through_the_surface(), colors()), |(stage, color)| dark(matt, stage, *color))
}

pub(super) fn shadow_rays_leave(matt: Matt<'_>, trial: &Trial) -> Verdict {
    trial.search(lit(stages()), |stage| {
        let shown = stage.shown(&*matt(Color::WHITE));
        shown.segments.iter().try_for_each(|segment| stage.leaves(&shown, segment))
    })
}

pub(super) fn casts_a_shadow(matt: Matt<'_>, trial: &Trial) -> Verdict {
    trial.search(colors(), |&color| same(&true, &matt(color).casts_shadow()))
}
