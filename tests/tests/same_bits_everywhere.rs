//! Pictures have the same bits on every machine: with any instruction set, optimised or not.
//!
//! The digests of four pictures are recorded, so that every machine that runs these tests compares itself with all others. When a
//! picture is meant to change, record the new ones with
//!
//! ```text
//! INSTA_UPDATE=always cargo test -p tests --test same_bits_everywhere
//! ```
//!
//! A test that is left out unless asked for builds the program without optimisation, for the oldest and the newest processors, and for
//! aarch64, and renders with each; that takes some minutes:
//!
//! ```text
//! cargo test -p tests --test same_bits_everywhere -- --ignored --nocapture
//! ```
#![expect(clippy::print_stdout, reason = "whoever runs it must know which builds were left out")]

use std::fmt::Write;
use std::path::{Path, PathBuf};
use std::process::Command;

use tests::Folder;

/// Built-in scenes with all that could differ: textures and meshes with normals under soft shadows and logarithmic light; glass and
/// mirrors; a lens; and one of this file's own.
const PICTURES: [(&str, &[&str]); 4] = [
    ("textures", &["--soft-shadows=2,0.3", "--light-samples", "all", "--falloff", "log"]),
    ("glass-mirror", &[]),
    ("depth-of-field", &[]),
    ("odd.sc", &[]),
];

/// What the built-in scenes have not: broken exponents, absorption, turned ellipsoids, a lens with corners.
const ODD: &str = r#"
camera { type thinlens eye 1 -8 3 target 0 0 0.7 up 0.1 0 1 fov 41.3 aspect 1.333 shift 0.03 -0.02 fdist 7.7 lensr 0.13 sides 5 rotation 17 }
background { color { "sRGB nonlinear" 0.2 0.4 0.5 } }
light { type point color { "sRGB nonlinear" 0.9 0.8 0.7 } power 23.7 p 3 -5 6 }
light { type point color 0.3 0.4 0.9 power 17.3 p -4 -3 5 }
shader { name shine type phong diff 0.4 0.2 0.1 spec 0.5 0.6 0.4 17.3 samples 0 }
shader { name dark type glass eta 1.47 color 0.9 0.95 1 absorption.distance 0.7 absorption.color 0.3 0.8 0.5 }
shader { name steel type mirror refl 0.7 0.75 0.8 }
object { shader shine type plane p 0 0 -0.3 n 0.03 0.02 1 }
object { shader shine transform { scale 1 0.6 0.8 rotate 1 2 3 37.1 translate -1.3 0.2 0.7 } type sphere name egg }
object { shader dark transform { scale 0.8 0.8 1.1 rotatex 23 translate 0.6 -0.8 0.9 } type sphere name bead }
object { shader steel transform { scaleu 0.8 rotatez 33.3 translate 1.9 0.9 0.6 } type box name block }
"#;

/// 40 x 30 pixels with two rays in each of four zones.
const SETTINGS: [&str; 8] = ["--size", "40x30", "--aa", "1", "--samples", "2", "--sampler", "random"];

/// FNV-1a over the bits of a picture's linear values. (Fowler, Noll, Vo 1991.)
fn digest(open_exr: &[u8]) -> u64 {
    let picture = image::load_from_memory(open_exr).expect("the program writes OpenEXR").into_rgb32f();
    assert_eq!(picture.dimensions(), (40, 30));
    let bytes = picture.into_raw().into_iter().flat_map(|value| value.to_bits().to_le_bytes());
    bytes.fold(0xCBF2_9CE4_8422_2325, |hash, byte| (hash ^ u64::from(byte)).wrapping_mul(0x0100_0000_01B3))
}

/// The pictures' digests, one a line; `program` makes a command of its arguments.
fn digests(folder: &Folder, threads: &str, program: impl Fn(&[&str]) -> Command) -> String {
    let mut lines = String::new();
    for (scene, options) in PICTURES {
        let how = ["render", scene, "--quiet", "-o", "picture.exr", "--threads", threads];
        let output = program(&[&how, &SETTINGS[..], options].concat()).output().expect("the program can be started");
        assert!(output.status.success(), "{scene}: {}", String::from_utf8_lossy(&output.stderr));
        let _ = writeln!(lines, "{scene:16} {:016x}", digest(&folder.read("picture.exr")));
    }
    lines
}

fn folder() -> Folder {
    Folder::for_program(env!("CARGO_BIN_EXE_girasol-under-test")).with("odd.sc", ODD)
}

#[test]
fn pictures_have_the_bits_that_are_recorded() {
    let folder = folder();
    let found = digests(&folder, "2", |arguments| folder.command(arguments));
    insta::assert_snapshot!(found);
}

/// A way to build the program.
struct Build {
    name: &'static str,
    profile: &'static str,
    /// For rustc.
    flags: &'static str,
    /// For another machine than this one.
    target: Option<&'static str>,
    /// What runs the program, if it cannot be started itself.
    runner: Option<&'static str>,
}

const DEBUG: Build = Build { name: "debug", profile: "dev", flags: "", target: None, runner: None };

const AARCH64: &str = "aarch64-unknown-linux-gnu";

/// Those that this machine can build and run; of the others it says why not.
fn builds() -> Vec<Build> {
    let release = |name, flags| Build { name, profile: "release", flags, ..DEBUG };
    let mut builds = vec![DEBUG, release("native", "-Ctarget-cpu=native")];
    #[cfg(target_arch = "x86_64")]
    {
        // The oldest has SSE2 and nothing newer. Unless flags say otherwise, it is what this test itself was built for: the recorded
        // digests are held against that build on every run.
        if std::env::var_os("RUSTFLAGS").is_some() {
            builds.push(release("x86-64", "-Ctarget-cpu=x86-64"));
        }
        if is_x86_feature_detected!("avx2") && is_x86_feature_detected!("fma") {
            builds.push(release("avx2", "-Ctarget-cpu=x86-64-v3"));
        } else {
            println!("left out: a build for AVX2, which this machine does not have");
        }
    }
    let missing = missing_for_aarch64();
    if missing.is_empty() {
        let runner = Some("qemu-aarch64");
        builds.push(Build { target: Some(AARCH64), runner, ..release("aarch64", "-Ctarget-feature=+crt-static") });
    } else {
        println!("left out: a build for aarch64, for want of {}", missing.join(" and "));
    }
    builds
}

fn missing_for_aarch64() -> Vec<&'static str> {
    let runs =
        |program: &str| Command::new(program).arg("--version").output().is_ok_and(|output| output.status.success());
    let library = Command::new("rustc").args(["--print", "target-libdir", "--target", AARCH64]).output();
    let has_library = library.is_ok_and(|output| Path::new(String::from_utf8_lossy(&output.stdout).trim()).is_dir());
    let wanted = [
        (has_library, "its standard library (`rustup target add aarch64-unknown-linux-gnu`)"),
        (runs("aarch64-linux-gnu-gcc"), "a linker (aarch64-linux-gnu-gcc)"),
        (runs("qemu-aarch64"), "an emulator (qemu-aarch64)"),
    ];
    wanted.into_iter().filter(|(is_there, _)| !is_there).map(|(_, what)| what).collect()
}

impl Build {
    /// Builds the program, without the laws, and says where it is. In a folder of its own, so that a second run finds it again; with what
    /// makes building faster and the program slower.
    fn program(&self) -> PathBuf {
        let workspace = Path::new(env!("CARGO_MANIFEST_DIR")).parent().expect("the workspace is around this package");
        let built = PathBuf::from(env!("CARGO_TARGET_TMPDIR")).join("every-build").join(self.name);
        let mut cargo = Command::new(env!("CARGO"));
        cargo
            .current_dir(workspace)
            .args(["build", "--locked", "--quiet", "-p", "cli", "--no-default-features"])
            .args(["--bin", "girasol", "--profile", self.profile, "--target-dir"])
            .arg(&built)
            // Of what is not ours, only what computes pixels is optimised.
            .args(["--config", "profile.release.package.'*'.opt-level=0"])
            .args(["glam", "libm"].map(|crate_| format!("--config=profile.release.package.{crate_}.opt-level=3")))
            .args(self.target.iter().flat_map(|target| ["--target", target]))
            .env("RUSTFLAGS", self.flags)
            .env("CARGO_TARGET_AARCH64_UNKNOWN_LINUX_GNU_LINKER", "aarch64-linux-gnu-gcc")
            .env("CARGO_PROFILE_DEV_OPT_LEVEL", "0")
            .env("CARGO_PROFILE_RELEASE_LTO", "off")
            .env("CARGO_PROFILE_RELEASE_CODEGEN_UNITS", "16");
        let status = cargo.status().expect("cargo can be started");
        assert!(status.success(), "{}: {cargo:?}", self.name);
        let profile = if self.profile == "dev" { "debug" } else { self.profile };
        self.target.map_or(built.clone(), |target| built.join(target)).join(profile).join("girasol")
    }
}

#[test]
#[ignore = "builds the program four or five times: cargo test -p tests --test same_bits_everywhere -- --ignored --nocapture"]
fn every_build_renders_the_same_bits() {
    let folder = folder();
    let expected = digests(&folder, "2", |arguments| folder.command(arguments));
    for build in builds() {
        let program = build.program();
        for threads in ["1", "2"] {
            let found = digests(&folder, threads, |arguments| match build.runner {
                None => folder.command_of(&program, arguments),
                Some(runner) => {
                    let mut command = folder.command_of(Path::new(runner), &[]);
                    command.arg(&program).args(arguments);
                    command
                }
            });
            assert_eq!(found, expected, "{}, {threads} threads", build.name);
        }
        println!("the same bits: {}", build.name);
    }
}
