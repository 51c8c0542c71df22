use glam::Vec3;
use shading::{PointLight, SoftShadows, conformance::soft_shadows, light_cluster};

use crate::Kit;

/// The right cluster, each light changed.
fn changed(light: PointLight, soft: SoftShadows, change: impl Fn(PointLight) -> PointLight) -> Vec<PointLight> {
    light_cluster(light, soft).into_iter().map(change).collect()
}

#[test]
fn every_mistake_in_soft_shadows_is_named() {
    let shares = "a_cluster_shares_its_light_s_colour";
    let centred = "a_cluster_is_centred_at_its_light";
    Kit { page: "shading/src/conformance/soft_shadows.rs", laws: soft_shadows::LAWS }.catches([
        ("no lights", (|_, _| Vec::new()) as soft_shadows::Cluster, "one_light_along_the_edge_is_the_light_itself"),
        (
            "cluster not sharing its colour: 27 times too bright",
            |light, soft| changed(light, soft, |one| PointLight { color: light.color, ..one }),
            shares,
        ),
        (
            "each light with a third of the colour",
            |light, soft| changed(light, soft, |one| PointLight { color: light.color / soft.along_edge as f32, ..one }),
            shares,
        ),
        (
            "a square of lights instead of a cube",
            |light, soft| {
                let square = (soft.along_edge * soft.along_edge) as usize;
                let mut lights = light_cluster(light, soft);
                lights.truncate(square);
                lights
            },
            "a_cluster_has_as_many_lights_as_a_cube",
        ),
        (
            "cluster off-centre",
            |light, soft| {
                let half = Vec3::splat(0.5 * (soft.along_edge - 1) as f32 * soft.spacing);
                changed(light, soft, |one| PointLight { position: one.position + half, ..one })
            },
            centred,
        ),
        (
            "cluster at the origin of space",
            |light, soft| match soft.along_edge {
                1 => vec![light],
                _ => changed(light, soft, |one| PointLight { position: one.position - light.position, ..one }),
            },
            centred,
        ),
        (
            "the spacing taken for the cube's edge",
            |light, soft| {
                light_cluster(
                    light,
                    SoftShadows { spacing: soft.spacing / (soft.along_edge - 1).max(1) as f32, ..soft },
                )
            },
            "neighbours_in_a_cluster_stand_a_spacing_apart",
        ),
        (
            "power shared as well",
            |light, soft| {
                let count = soft.along_edge.pow(3) as f32;
                changed(light, soft, |one| PointLight { power: light.power / count, ..one })
            },
            "lights_of_a_cluster_keep_power_and_falloff",
        ),
    ]);
}
