//! As much of Embree 3 as the bench asks for, declared by hand from its headers `rtcore_*.h` (version 3.13).
#![allow(unsafe_code)]

use std::ffi::{c_char, c_int, c_uint, c_void};
use std::ptr::{null, null_mut};

use geometry::{Interval, Ray};
use glam::Vec3;

type Handle = *mut c_void;

#[repr(C, align(16))]
#[derive(Clone, Copy)]
struct RtcRayHit {
    origin: [f32; 3],
    near: f32,
    direction: [f32; 3],
    time: f32,
    far: f32,
    mask: c_uint,
    id: c_uint,
    flags: c_uint,
    normal: [f32; 3],
    u: f32,
    v: f32,
    primitive: c_uint,
    geometry: c_uint,
    instance: c_uint,
}

#[repr(C, align(64))]
#[derive(Clone, Copy)]
struct RtcRayHit16 {
    origin: [[f32; 16]; 3],
    near: [f32; 16],
    direction: [[f32; 16]; 3],
    time: [f32; 16],
    far: [f32; 16],
    mask: [c_uint; 16],
    id: [c_uint; 16],
    flags: [c_uint; 16],
    normal: [[f32; 16]; 3],
    u: [f32; 16],
    v: [f32; 16],
    primitive: [c_uint; 16],
    geometry: [c_uint; 16],
    instance: [c_uint; 16],
}

#[repr(C)]
struct Context {
    flags: c_uint,
    filter: *const c_void,
    instance: c_uint,
}

const INVALID: c_uint = c_uint::MAX;
const TRIANGLES: c_uint = 0;
const INDICES: c_uint = 0;
const VERTICES: c_uint = 1;
const FORMAT_UINT3: c_uint = 0x5003;
const FORMAT_FLOAT3: c_uint = 0x9003;
const ROBUST: c_uint = 1 << 2;

#[link(name = "embree3")]
unsafe extern "C" {
    fn rtcNewDevice(config: *const c_char) -> Handle;
    fn rtcReleaseDevice(device: Handle);
    fn rtcNewScene(device: Handle) -> Handle;
    fn rtcReleaseScene(scene: Handle);
    fn rtcSetSceneFlags(scene: Handle, flags: c_uint);
    fn rtcNewGeometry(device: Handle, kind: c_uint) -> Handle;
    fn rtcReleaseGeometry(geometry: Handle);
    fn rtcSetNewGeometryBuffer(
        geometry: Handle,
        kind: c_uint,
        slot: c_uint,
        format: c_uint,
        stride: usize,
        count: usize,
    ) -> *mut c_void;
    fn rtcCommitGeometry(geometry: Handle);
    fn rtcAttachGeometry(scene: Handle, geometry: Handle) -> c_uint;
    fn rtcCommitScene(scene: Handle);
    fn rtcIntersect1(scene: Handle, context: *mut Context, ray: *mut RtcRayHit);
    fn rtcOccluded1(scene: Handle, context: *mut Context, ray: *mut RtcRayHit);
    fn rtcIntersect16(valid: *const c_int, scene: Handle, context: *mut Context, rays: *mut RtcRayHit16);
    fn rtcOccluded16(valid: *const c_int, scene: Handle, context: *mut Context, rays: *mut RtcRayHit16);
}

/// How careful Embree is to be.
#[derive(Clone, Copy, PartialEq, Eq)]
pub enum Mode {
    Default,
    Robust,
}

pub struct Embree {
    device: Handle,
    scene: Handle,
}

impl Embree {
    /// `threads` is how many build.
    pub fn build(positions: &[Vec3], triangles: &[[u32; 3]], mode: Mode, threads: usize) -> Self {
        let config = format!("threads={threads}\0");
        // SAFETY: the calls are those of Embree's tutorials; the buffers are written before they are committed, and are as long as asked.
        unsafe {
            let device = rtcNewDevice(config.as_ptr().cast());
            assert!(!device.is_null(), "Embree has no device");
            let scene = rtcNewScene(device);
            rtcSetSceneFlags(scene, if mode == Mode::Robust { ROBUST } else { 0 });
            let geometry = rtcNewGeometry(device, TRIANGLES);
            let vertices = rtcSetNewGeometryBuffer(geometry, VERTICES, 0, FORMAT_FLOAT3, 12, positions.len());
            std::ptr::copy_nonoverlapping(positions.as_ptr().cast::<u8>(), vertices.cast(), 12 * positions.len());
            let indices = rtcSetNewGeometryBuffer(geometry, INDICES, 0, FORMAT_UINT3, 12, triangles.len());
            std::ptr::copy_nonoverlapping(triangles.as_ptr().cast::<u8>(), indices.cast(), 12 * triangles.len());
            rtcCommitGeometry(geometry);
            rtcAttachGeometry(scene, geometry);
            rtcReleaseGeometry(geometry);
            rtcCommitScene(scene);
            Self { device, scene }
        }
    }

    /// The nearest triangle and its `t`.
    pub fn closest(&self, ray: &Ray) -> Option<(u32, f32)> {
        let mut hit = ray_hit(ray, Interval::FORWARD);
        // SAFETY: the structures are laid out as in `rtcore_ray.h` and live through the call.
        unsafe { rtcIntersect1(self.scene, &mut context(), &mut hit) };
        (hit.geometry != INVALID).then_some((hit.primitive, hit.far))
    }

    pub fn any(&self, ray: &Ray, within: Interval) -> bool {
        let mut hit = ray_hit(ray, within);
        // SAFETY: as above; only the ray's part is read and written.
        unsafe { rtcOccluded1(self.scene, &mut context(), &mut hit) };
        hit.far == f32::NEG_INFINITY
    }

    /// The nearest triangle of each of 16 rays.
    pub fn closest_16(&self, rays: &[Ray], found: &mut [Option<(u32, f32)>]) {
        let mut hits = ray_hits(rays, Interval::FORWARD);
        // SAFETY: as above.
        unsafe { rtcIntersect16(ALL.0.as_ptr(), self.scene, &mut coherent(), &mut hits) };
        for (lane, found) in found.iter_mut().enumerate() {
            *found = (hits.geometry[lane] != INVALID).then_some((hits.primitive[lane], hits.far[lane]));
        }
    }

    pub fn any_16(&self, rays: &[Ray], within: Interval, found: &mut [bool]) {
        let mut hits = ray_hits(rays, within);
        // SAFETY: as above.
        unsafe { rtcOccluded16(ALL.0.as_ptr(), self.scene, &mut coherent(), &mut hits) };
        for (lane, found) in found.iter_mut().enumerate() {
            *found = hits.far[lane] == f32::NEG_INFINITY;
        }
    }
}

impl Drop for Embree {
    fn drop(&mut self) {
        // SAFETY: both were made by `build` and are released once.
        unsafe {
            rtcReleaseScene(self.scene);
            rtcReleaseDevice(self.device);
        }
        self.scene = null_mut();
    }
}

#[repr(align(64))]
struct Aligned([c_int; 16]);

static ALL: Aligned = Aligned([-1; 16]);

fn context() -> Context {
    Context { flags: 0, filter: null(), instance: INVALID }
}

fn coherent() -> Context {
    Context { flags: 1, ..context() }
}

fn ray_hit(ray: &Ray, within: Interval) -> RtcRayHit {
    RtcRayHit {
        origin: ray.origin.to_array(),
        near: within.min,
        direction: ray.direction.to_array(),
        time: 0.0,
        far: within.max,
        mask: INVALID,
        id: 0,
        flags: 0,
        normal: [0.0; 3],
        u: 0.0,
        v: 0.0,
        primitive: INVALID,
        geometry: INVALID,
        instance: INVALID,
    }
}

fn ray_hits(rays: &[Ray], within: Interval) -> RtcRayHit16 {
    let row = |value: &dyn Fn(&Ray) -> f32| std::array::from_fn(|lane| value(&rays[lane]));
    RtcRayHit16 {
        origin: [row(&|ray| ray.origin.x), row(&|ray| ray.origin.y), row(&|ray| ray.origin.z)],
        near: [within.min; 16],
        direction: [row(&|ray| ray.direction.x), row(&|ray| ray.direction.y), row(&|ray| ray.direction.z)],
        time: [0.0; 16],
        far: [within.max; 16],
        mask: [INVALID; 16],
        id: [0; 16],
        flags: [0; 16],
        normal: [[0.0; 16]; 3],
        u: [0.0; 16],
        v: [0.0; 16],
        primitive: [INVALID; 16],
        geometry: [INVALID; 16],
        instance: [INVALID; 16],
    }
}
