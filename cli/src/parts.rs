use std::fmt::{self, Display};
use std::ptr::fn_addr_eq;

use clap::ValueEnum;
use geometry::Kernels;
use render::{Modules, Shaders};

/// A part of the renderer that the course teaches: what may differ between a program of one's own and the reference.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, ValueEnum)]
pub(crate) enum Part {
    /// How a ray meets a sphere.
    Sphere,
    /// How a ray meets an ellipsoid.
    Ellipsoid,
    /// How a ray meets a triangle.
    Triangle,
    /// How a ray meets a plane.
    Plane,
    /// How a ray passes a box.
    Box,
    /// Where on a sphere's texture a direction lies.
    SphereUv,
    /// Where on a plane's texture a point lies.
    PlaneUv,
    /// Where on a mesh's texture a point of a triangle lies.
    TriangleUv,
    /// The normal that lets a mesh look round.
    SmoothNormal,
    /// What moves normals as a map moves points.
    NormalMatrix,
    /// Where new rays start.
    RayOrigin,
    /// What finds the nearest hit.
    #[value(alias = "octree")]
    Accelerator,
    /// The shader that shows its colour.
    Constant,
    /// The matt shader with a highlight.
    Phong,
    /// The shader of mirrors.
    Mirror,
    /// The shader of glass.
    Glass,
    /// The colour of a picture at a place.
    Texture,
    /// How light falls off.
    Falloff,
    /// The cluster of lights in place of one.
    SoftShadows,
    /// From a place in the picture to a ray.
    Camera,
    /// Where samples fall.
    Sampler,
    /// The order of buckets.
    BucketOrder,
    /// The whole renderer: threads, buckets, film.
    Renderer,
    /// From text to scene.
    Parser,
}

impl Part {
    /// All of them, in the order in which a ray meets them.
    pub(crate) fn all() -> &'static [Self] {
        Self::value_variants()
    }

    /// What it is called on the command line.
    pub(crate) fn name(self) -> String {
        self.to_possible_value().map_or_else(String::new, |value| value.get_name().to_owned())
    }

    /// Whether a program has another one than the reference.
    ///
    /// By the addresses of functions. A copy of the reference's function may count as another one, which only means that it is asked to prove
    /// itself; another one never counts as the reference's, unless it is the same instruction for instruction.
    pub(crate) fn is_swapped(self, modules: &Modules) -> bool {
        let reference = &Modules::default();
        match self {
            Self::Sphere => modules.kernels.sphere.is_some(),
            Self::Ellipsoid => modules.kernels.ellipsoid.is_some(),
            Self::Triangle => modules.kernels.triangle.is_some(),
            Self::Plane => modules.kernels.plane.is_some(),
            Self::Box => modules.kernels.aabb.is_some(),
            Self::SphereUv => modules.kernels.sphere_uv.is_some(),
            Self::PlaneUv => modules.kernels.plane_uv.is_some(),
            Self::TriangleUv => modules.kernels.triangle_uv.is_some(),
            Self::SmoothNormal => modules.kernels.smooth_normal.is_some(),
            Self::NormalMatrix => modules.kernels.normal_matrix.is_some(),
            Self::RayOrigin => !fn_addr_eq(modules.ray_origin, reference.ray_origin),
            Self::Accelerator => !fn_addr_eq(modules.accelerator, reference.accelerator),
            Self::Constant => !fn_addr_eq(modules.shaders.constant, reference.shaders.constant),
            Self::Phong => !fn_addr_eq(modules.shaders.phong, reference.shaders.phong),
            Self::Mirror => !fn_addr_eq(modules.shaders.mirror, reference.shaders.mirror),
            Self::Glass => !fn_addr_eq(modules.shaders.glass, reference.shaders.glass),
            Self::Texture => !fn_addr_eq(modules.texture, reference.texture),
            Self::Falloff => !fn_addr_eq(modules.falloff, reference.falloff),
            Self::SoftShadows => !fn_addr_eq(modules.soft_shadows, reference.soft_shadows),
            Self::Camera => !fn_addr_eq(modules.camera, reference.camera),
            Self::Sampler => !fn_addr_eq(modules.sampler, reference.sampler),
            Self::BucketOrder => !fn_addr_eq(modules.bucket_order, reference.bucket_order),
            Self::Renderer => !fn_addr_eq(modules.render, reference.render),
            Self::Parser => !fn_addr_eq(modules.parse, reference.parse),
        }
    }

    /// The same modules with the reference's part in this one's place.
    pub(crate) fn set_back(self, modules: Modules) -> Modules {
        let reference = Modules::default();
        let kernels = |kernels| Modules { kernels, ..modules };
        let shaders = |shaders| Modules { shaders, ..modules };
        match self {
            Self::Sphere => kernels(Kernels { sphere: None, ..modules.kernels }),
            Self::Ellipsoid => kernels(Kernels { ellipsoid: None, ..modules.kernels }),
            Self::Triangle => kernels(Kernels { triangle: None, ..modules.kernels }),
            Self::Plane => kernels(Kernels { plane: None, ..modules.kernels }),
            Self::Box => kernels(Kernels { aabb: None, ..modules.kernels }),
            Self::SphereUv => kernels(Kernels { sphere_uv: None, ..modules.kernels }),
            Self::PlaneUv => kernels(Kernels { plane_uv: None, ..modules.kernels }),
            Self::TriangleUv => kernels(Kernels { triangle_uv: None, ..modules.kernels }),
            Self::SmoothNormal => kernels(Kernels { smooth_normal: None, ..modules.kernels }),
            Self::NormalMatrix => kernels(Kernels { normal_matrix: None, ..modules.kernels }),
            Self::RayOrigin => Modules { ray_origin: reference.ray_origin, ..modules },
            Self::Accelerator => Modules { accelerator: reference.accelerator, ..modules },
            Self::Constant => shaders(Shaders { constant: reference.shaders.constant, ..modules.shaders }),
            Self::Phong => shaders(Shaders { phong: reference.shaders.phong, ..modules.shaders }),
            Self::Mirror => shaders(Shaders { mirror: reference.shaders.mirror, ..modules.shaders }),
            Self::Glass => shaders(Shaders { glass: reference.shaders.glass, ..modules.shaders }),
            Self::Texture => Modules { texture: reference.texture, ..modules },
            Self::Falloff => Modules { falloff: reference.falloff, ..modules },
            Self::SoftShadows => Modules { soft_shadows: reference.soft_shadows, ..modules },
            Self::Camera => Modules { camera: reference.camera, ..modules },
            Self::Sampler => Modules { sampler: reference.sampler, ..modules },
            Self::BucketOrder => Modules { bucket_order: reference.bucket_order, ..modules },
            Self::Renderer => Modules { render: reference.render, ..modules },
            Self::Parser => Modules { parse: reference.parse, ..modules },
        }
    }
}

impl Display for Part {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.name())
    }
}

/// The parts that a program has of its own.
pub(crate) fn swapped(modules: &Modules) -> Vec<Part> {
    Part::all().iter().copied().filter(|part| part.is_swapped(modules)).collect()
}

/// Parts as a sentence has them: "the sphere, the plane and the box".
pub(crate) fn listed(parts: &[Part]) -> String {
    let names: Vec<String> = parts.iter().map(|part| format!("`{part}`")).collect();
    match names.split_last() {
        Some((last, [])) => last.clone(),
        Some((last, before)) => format!("{} and {last}", before.join(", ")),
        None => "nothing".to_owned(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use geometry::Surface;
    use glam::{DMat3, Vec2};
    use shading::{Color, Constant};

    /// Every part another one than the reference's.
    fn all_swapped() -> Modules {
        Modules {
            parse: |name, text, files, limits| {
                let mut parsed = scene_format::parse_within(name, text, files, limits);
                parsed.diagnostics.clear();
                parsed
            },
            kernels: Kernels {
                sphere: Some(|_, _, _| None),
                ellipsoid: Some(|_, _, _| None),
                triangle: Some(|_, _, _| None),
                plane: Some(|_, _, _| None),
                aabb: Some(|_, _, _| None),
                sphere_uv: Some(|_| Vec2::ZERO),
                plane_uv: Some(|_, _| Vec2::ZERO),
                triangle_uv: Some(|_, _, _| Vec2::ZERO),
                smooth_normal: Some(|_, _, _| None),
                normal_matrix: Some(|_| DMat3::ZERO),
            },
            ray_origin: |surface: &Surface, _| surface.position,
            accelerator: accel::none,
            shaders: Shaders {
                constant: |_| Box::new(Constant { color: Color::grey(0.1) }),
                phong: |_, _, _| Box::new(Constant { color: Color::grey(0.2) }),
                mirror: |_| Box::new(Constant { color: Color::grey(0.3) }),
                glass: |_, _, _| Box::new(Constant { color: Color::grey(0.4) }),
            },
            texture: |_| std::sync::Arc::new(Color::grey(0.5)),
            falloff: |_, _| 0.5,
            soft_shadows: |_, _| Vec::new(),
            camera: |_| None,
            sampler: render::random,
            render: render::one_by_one,
            bucket_order: |_, _, _| Vec::new(),
            ..Modules::default()
        }
    }

    #[test]
    fn the_reference_has_nothing_swapped() {
        assert_eq!(swapped(&Modules::default()), []);
        let one = Modules { falloff: |_, _| 0.5, shaders: Shaders::default(), ..Modules::default() };
        assert_eq!(swapped(&one), [Part::Falloff]);
    }

    #[test]
    fn each_part_is_set_back_alone() {
        let all = all_swapped();
        assert_eq!(swapped(&all), Part::all());
        for &part in Part::all() {
            let without = swapped(&part.set_back(all));
            let others: Vec<Part> = Part::all().iter().copied().filter(|&other| other != part).collect();
            assert_eq!(without, others, "{part}");
        }
    }

    #[test]
    fn parts_are_listed_as_in_a_sentence() {
        assert_eq!(listed(&[Part::Box]), "`box`");
        assert_eq!(listed(&[Part::Box, Part::RayOrigin, Part::Parser]), "`box`, `ray-origin` and `parser`");
    }
}
