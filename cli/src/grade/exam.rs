use geometry::conformance::{self as shapes, Broken, Law, Trial};
use geometry::{Aabb, BoxProbe, Interval, Kernels, Plane, Primitive, Ray, Transform};
use render::{Modules, conformance as pictures};
use shading::conformance as looks;

use crate::parts::Part;

type TryOn = dyn Fn(&Modules, &Trial) -> Result<(), Broken> + Send;

/// A law of a part's kit, to be tried on whatever modules a program has.
pub(crate) struct Exam {
    /// The law's name.
    pub(crate) law: &'static str,
    /// What is usually wrong where it is broken.
    pub(crate) usually: &'static str,
    try_on: Box<TryOn>,
}

impl Exam {
    /// Whether the law is kept.
    pub(crate) fn try_on(&self, modules: &Modules, trial: &Trial) -> Result<(), Broken> {
        (self.try_on)(modules, trial)
    }
}

/// The kit of a part, from its easiest law to its hardest.
pub(crate) fn exams(part: Part) -> Vec<Exam> {
    match part {
        Part::Sphere => kit(shapes::sphere::LAWS, |modules| modules.kernels.sphere.unwrap_or(Primitive::intersect)),
        Part::Ellipsoid => {
            kit(shapes::ellipsoid::LAWS, |modules| modules.kernels.ellipsoid.unwrap_or(Primitive::intersect))
        }
        Part::Triangle => {
            kit(shapes::triangle::LAWS, |modules| modules.kernels.triangle.unwrap_or(Primitive::intersect))
        }
        Part::Plane => kit(shapes::plane::LAWS, |modules| modules.kernels.plane.unwrap_or(Primitive::intersect)),
        Part::Box => kit(shapes::aabb::LAWS, |modules| modules.kernels.aabb.unwrap_or(clip)),
        Part::SphereUv => kit(shapes::sphere_uv::LAWS, |modules| {
            modules.kernels.sphere_uv.unwrap_or(|outward| Kernels::default().uv_of_sphere(outward))
        }),
        Part::PlaneUv => kit(shapes::plane_uv::LAWS, |modules| modules.kernels.plane_uv.unwrap_or(Plane::uv_at)),
        Part::TriangleUv => kit(shapes::triangle_uv::LAWS, |modules| {
            modules.kernels.triangle_uv.unwrap_or(|corners, u, v| Kernels::default().uv_of_triangle(corners, u, v))
        }),
        Part::SmoothNormal => kit(shapes::smooth_normal::LAWS, |modules| {
            modules.kernels.smooth_normal.unwrap_or(|corners, u, v| Kernels::default().normal_between(corners, u, v))
        }),
        Part::NormalMatrix => {
            kit(shapes::normal_matrix::LAWS, |modules| modules.kernels.normal_matrix.unwrap_or(Transform::normals))
        }
        Part::RayOrigin => kit(shapes::ray_origin::LAWS, |modules| modules.ray_origin),
        Part::Accelerator => kit(accel::conformance::accelerator::LAWS, |modules| modules.accelerator),
        Part::Constant => kit(looks::constant::LAWS, |modules| modules.shaders.constant),
        Part::Phong => kit(looks::phong::LAWS, |modules| modules.shaders.phong),
        Part::Mirror => kit(looks::mirror::LAWS, |modules| modules.shaders.mirror),
        Part::Glass => kit(looks::glass::LAWS, |modules| modules.shaders.glass),
        Part::Texture => kit(looks::texture::LAWS, |modules| modules.texture),
        Part::Falloff => kit(looks::falloff::LAWS, |modules| modules.falloff),
        Part::SoftShadows => kit(looks::soft_shadows::LAWS, |modules| modules.soft_shadows),
        Part::Camera => kit(pictures::camera::LAWS, |modules| modules.camera),
        Part::Sampler => kit(pictures::sampler::LAWS, |modules| modules.sampler),
        Part::BucketOrder => kit(pictures::bucket_order::LAWS, |modules| modules.bucket_order),
        Part::Renderer => kit(pictures::renderer::LAWS, |modules| modules.render),
        Part::Parser => kit(scene_format::conformance::parser::LAWS, |modules| modules.parse),
    }
}

/// The reference's box test, which its trees take apart.
fn clip(aabb: &Aabb, ray: &Ray, within: Interval) -> Option<Interval> {
    BoxProbe::new(ray, aabb.magnitude()).clip(*aabb, within)
}

/// The laws of a kit; `part` takes from the modules what they are laws of.
fn kit<Kind: 'static>(laws: &'static [Law<Kind>], part: fn(&Modules) -> Kind) -> Vec<Exam> {
    let exam = |law: &'static Law<Kind>| Exam {
        law: law.name,
        usually: law.usually,
        try_on: Box::new(move |modules, trial| law.check(&part(modules), trial)),
    };
    laws.iter().map(exam).collect()
}
