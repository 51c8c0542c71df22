//! As much of Embree 3 and 4 as the bench asks for, declared by hand from its headers `rtcore_*.h`, and found when the bench runs.
#![allow(unsafe_code)]

use std::ffi::{c_char, c_int, c_uint, c_void};
use std::mem::ManuallyDrop;
use std::path::Path;
use std::ptr::null;

use geometry::{Interval, Ray};
use glam::Vec3;
use libloading::Library;

use crate::meshes::Scene;
use crate::tracer::Tracer;

type Handle = *mut c_void;

/// Embree 4's; it is 16 bytes longer than Embree 3's, which has no `instance_primitive`.
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
    instance_primitive: c_uint,
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
    instance_primitive: [c_uint; 16],
}

/// What Embree 3 asks for with each call.
#[repr(C)]
struct Context3 {
    flags: c_uint,
    filter: *const c_void,
    instance: c_uint,
}

/// What Embree 4 does: `RTCIntersectArguments` and, of the same layout, `RTCOccludedArguments`.
#[repr(C)]
struct Arguments4 {
    flags: c_uint,
    features: c_uint,
    context: *const c_void,
    filter: *const c_void,
    intersect: *const c_void,
    min_width: f32,
}

const INVALID: c_uint = c_uint::MAX;
const TRIANGLES: c_uint = 0;
const INDICES: c_uint = 0;
const VERTICES: c_uint = 1;
const FORMAT_UINT3: c_uint = 0x5003;
const FORMAT_FLOAT3: c_uint = 0x9003;
const ROBUST: c_uint = 1 << 2;

/// Declares Embree's functions as pointers, and how to find them.
macro_rules! functions {
    ($($name:ident: fn($($argument:ty),*) $(-> $result:ty)?;)*) => {
        #[allow(non_snake_case)]
        struct Functions {
            $($name: unsafe extern "C" fn($($argument),*) $(-> $result)?,)*
            /// Never closed: its threads may outlive its scenes.
            _library: ManuallyDrop<Library>,
        }

        impl Functions {
            fn of(library: Library) -> Result<Self, libloading::Error> {
                // SAFETY: the types are those of the headers; the pointers live as long as the library, which stands beside them.
                unsafe { Ok(Self { $($name: *library.get(stringify!($name))?,)* _library: ManuallyDrop::new(library) }) }
            }
        }
    };
}

functions! {
    rtcNewDevice: fn(*const c_char) -> Handle;
    rtcReleaseDevice: fn(Handle);
    rtcNewScene: fn(Handle) -> Handle;
    rtcReleaseScene: fn(Handle);
    rtcSetSceneFlags: fn(Handle, c_uint);
    rtcNewGeometry: fn(Handle, c_uint) -> Handle;
    rtcReleaseGeometry: fn(Handle);
    rtcSetNewGeometryBuffer: fn(Handle, c_uint, c_uint, c_uint, usize, usize) -> *mut c_void;
    rtcCommitGeometry: fn(Handle);
    rtcAttachGeometry: fn(Handle, Handle) -> c_uint;
    rtcCommitScene: fn(Handle);
    rtcIntersect1: fn(Handle, *mut c_void, *mut c_void);
    rtcOccluded1: fn(Handle, *mut c_void, *mut c_void);
    rtcIntersect16: fn(*const c_int, Handle, *mut c_void, *mut c_void);
    rtcOccluded16: fn(*const c_int, Handle, *mut c_void, *mut c_void);
}

/// An Embree on this machine.
pub struct Installed {
    functions: Functions,
    version: Version,
}

#[derive(Clone, Copy)]
enum Version {
    Three,
    Four,
}

impl Installed {
    pub fn three() -> Result<Self, libloading::Error> {
        Self::load(Path::new("libembree3.so.3"), Version::Three)
    }

    /// That at the place given.
    pub fn four(place: &Path) -> Result<Self, libloading::Error> {
        Self::load(place, Version::Four)
    }

    fn load(place: &Path, version: Version) -> Result<Self, libloading::Error> {
        // SAFETY: what Embree does when it is loaded asks for nothing.
        let library = unsafe { Library::new(place)? };
        Ok(Self { functions: Functions::of(library)?, version })
    }
}

/// How careful Embree is to be.
#[derive(Clone, Copy, PartialEq, Eq)]
pub enum Mode {
    Default,
    Robust,
}

/// A scene as Embree has built it.
pub struct Embree<'a> {
    installed: &'a Installed,
    device: Handle,
    scene: Handle,
}

impl<'a> Embree<'a> {
    /// `threads` is how many build.
    pub fn build(installed: &'a Installed, scene: &Scene, mode: Mode, threads: usize) -> Self {
        let config = format!("threads={threads}\0");
        let (positions, triangles) = (&scene.mesh.positions, &scene.mesh.triangles);
        let all = &installed.functions;
        // SAFETY: the calls are those of Embree's tutorials; the buffers are written before they are committed, and are as long as asked.
        unsafe {
            let device = (all.rtcNewDevice)(config.as_ptr().cast());
            assert!(!device.is_null(), "Embree has no device");
            let scene = (all.rtcNewScene)(device);
            (all.rtcSetSceneFlags)(scene, if mode == Mode::Robust { ROBUST } else { 0 });
            let geometry = (all.rtcNewGeometry)(device, TRIANGLES);
            let buffer = |kind, format, count| (all.rtcSetNewGeometryBuffer)(geometry, kind, 0, format, 12, count);
            let vertices = buffer(VERTICES, FORMAT_FLOAT3, positions.len());
            vertices.cast::<Vec3>().copy_from_nonoverlapping(positions.as_ptr(), positions.len());
            let indices = buffer(INDICES, FORMAT_UINT3, triangles.len());
            indices.cast::<[u32; 3]>().copy_from_nonoverlapping(triangles.as_ptr(), triangles.len());
            (all.rtcCommitGeometry)(geometry);
            (all.rtcAttachGeometry)(scene, geometry);
            (all.rtcReleaseGeometry)(geometry);
            (all.rtcCommitScene)(scene);
            Self { installed, device, scene }
        }
    }

    /// The nearest triangle of each of 16 rays, and its `t`.
    pub fn closest_16(&self, packet: &mut Packet, rays: &[Ray; 16], found: &mut [Option<(u32, f32)>; 16]) {
        packet.load(rays, Interval::FORWARD);
        let intersect = self.installed.functions.rtcIntersect16;
        // SAFETY: as of `closest`.
        self.call(&mut packet.0, Order::Coherent, |a, b| unsafe { intersect(ALL.0.as_ptr(), self.scene, a, b) });
        for (lane, found) in found.iter_mut().enumerate() {
            *found = (packet.0.geometry[lane] != INVALID).then_some((packet.0.primitive[lane], packet.0.far[lane]));
        }
    }

    pub fn any_16(&self, packet: &mut Packet, rays: &[Ray; 16], within: Interval, found: &mut [bool; 16]) {
        packet.load(rays, within);
        let occluded = self.installed.functions.rtcOccluded16;
        // SAFETY: as of `any`.
        self.call(&mut packet.0, Order::Coherent, |a, b| unsafe { occluded(ALL.0.as_ptr(), self.scene, a, b) });
        for (found, far) in found.iter_mut().zip(&packet.0.far) {
            *found = *far == f32::NEG_INFINITY;
        }
    }

    /// Calls with the rays and the arguments that this version asks for, in its order.
    #[inline(always)]
    fn call<R>(&self, rays: &mut R, order: Order, function: impl FnOnce(*mut c_void, *mut c_void)) {
        let rays = (&raw mut *rays).cast();
        match self.installed.version {
            Version::Three => {
                let mut context = Context3 { flags: order as c_uint, filter: null(), instance: INVALID };
                function((&raw mut context).cast(), rays);
            }
            Version::Four => {
                let (flags, features) = ((order as c_uint) << 16, c_uint::MAX);
                let (context, filter, intersect) = (null(), null(), null());
                let mut arguments = Arguments4 { flags, features, context, filter, intersect, min_width: 0.0 };
                function(rays, (&raw mut arguments).cast());
            }
        }
    }
}

impl Tracer for Embree<'_> {
    fn closest(&self, ray: &Ray) -> Option<(u32, f32)> {
        let mut hit = ray_hit(ray, Interval::FORWARD);
        let intersect = self.installed.functions.rtcIntersect1;
        // SAFETY: the structures are laid out as in `rtcore_ray.h` and live through the call.
        self.call(&mut hit, Order::Incoherent, |a, b| unsafe { intersect(self.scene, a, b) });
        (hit.geometry != INVALID).then_some((hit.primitive, hit.far))
    }

    fn any(&self, ray: &Ray, within: Interval) -> bool {
        let mut hit = ray_hit(ray, within);
        let occluded = self.installed.functions.rtcOccluded1;
        // SAFETY: as above; only the ray's part is read and written.
        self.call(&mut hit, Order::Incoherent, |a, b| unsafe { occluded(self.scene, a, b) });
        hit.far == f32::NEG_INFINITY
    }
}

impl Drop for Embree<'_> {
    fn drop(&mut self) {
        // SAFETY: both were made by `build` and are released once.
        unsafe {
            (self.installed.functions.rtcReleaseScene)(self.scene);
            (self.installed.functions.rtcReleaseDevice)(self.device);
        }
    }
}

/// What Embree is told of the rays of a call: its flags, in the order of their numbers.
#[derive(Clone, Copy)]
enum Order {
    Incoherent,
    Coherent,
}

#[repr(align(64))]
struct Aligned([c_int; 16]);

static ALL: Aligned = Aligned([-1; 16]);

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
        instance_primitive: INVALID,
    }
}

/// Room for 16 rays, to be used again: what Embree does not write stays.
pub struct Packet(RtcRayHit16);

impl Default for Packet {
    fn default() -> Self {
        Self(RtcRayHit16 {
            origin: [[0.0; 16]; 3],
            near: [0.0; 16],
            direction: [[0.0; 16]; 3],
            time: [0.0; 16],
            far: [0.0; 16],
            mask: [INVALID; 16],
            id: [0; 16],
            flags: [0; 16],
            normal: [[0.0; 16]; 3],
            u: [0.0; 16],
            v: [0.0; 16],
            primitive: [INVALID; 16],
            geometry: [INVALID; 16],
            instance: [INVALID; 16],
            instance_primitive: [INVALID; 16],
        })
    }
}

impl Packet {
    #[inline(always)]
    fn load(&mut self, rays: &[Ray; 16], within: Interval) {
        let Self(packet) = self;
        for axis in 0..3 {
            for (lane, ray) in rays.iter().enumerate() {
                packet.origin[axis][lane] = ray.origin[axis];
                packet.direction[axis][lane] = ray.direction[axis];
            }
        }
        (packet.near, packet.far) = ([within.min; 16], [within.max; 16]);
        packet.geometry = [INVALID; 16];
    }
}
