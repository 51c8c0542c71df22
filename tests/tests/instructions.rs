//! What a pixel costs, in instructions: of a plain picture, and of the same with one thing more.
//!
//! Time is noise on a busy machine; instructions are the same on every run. Valgrind's callgrind counts them, on a processor with AVX2
//! and without AVX-512, whatever the machine has. A test that is left out unless asked for holds the program as it is released against the
//! figures in `instructions.txt`, and fails where a picture takes 5 % more:
//!
//! ```text
//! cargo test -p tests --test instructions -- --ignored --nocapture
//! ```
//!
//! Where more is meant, or less has been gained, record the new figures with
//!
//! ```text
//! GIRASOL_RECORD=1 cargo test -p tests --test instructions -- --ignored --nocapture
//! ```
#![expect(clippy::print_stdout, reason = "whoever runs it wants to see the figures")]

use std::fmt::Write;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

use image::{ImageFormat, Rgb, RgbImage};
use tests::Folder;

/// So much more than recorded fails.
const TOLERANCE: f64 = 1.05;

const WIDTH: u32 = 64;
const HEIGHT: u32 = 48;

const RECORDED: &str = "tests/instructions.txt";

/// A picture to count: what it has that the plain one has not.
struct Picture {
    feature: &'static str,
    /// The scene, where it differs from the plain one.
    scene: Scene,
    options: &'static [&'static str],
}

/// A ball, or what stands in its place, over an endless floor.
struct Scene {
    camera: &'static str,
    /// Of ball and floor.
    shaders: [&'static str; 2],
    ball: fn() -> String,
    light: &'static str,
}

const PINHOLE: &str = "type pinhole eye 0 -6 2.5 target 0 0 0.8 up 0 0 1 fov 45 aspect 1.333";
const THIN_LENS: &str =
    "type thinlens eye 0 -6 2.5 target 0 0 0.8 up 0 0 1 fov 45 aspect 1.333 fdist 6 lensr 0.1 sides 0 rotation 0";
const CONSTANT: &str = "type constant color 0.6 0.5 0.4";
const PHONG: &str = "type phong diff 0.6 0.5 0.4 spec 0.5 0.5 0.5 30 samples 0";
const LIGHT: &str = "light { type point color 1 1 1 power 30 p 3 -5 6 }";

const PLAIN: Scene = Scene { camera: PINHOLE, shaders: [CONSTANT; 2], ball: sphere, light: "" };
const LIT: Scene = Scene { light: LIGHT, ..PLAIN };

fn pictures() -> [Picture; 12] {
    let picture = |feature, scene| Picture { feature, scene, options: &[] };
    [
        picture("plain", PLAIN),
        picture("mesh", Scene { ball: mesh, ..PLAIN }),
        picture("phong", Scene { shaders: [PHONG; 2], ..PLAIN }),
        picture("texture", Scene { shaders: ["type diffuse texture texture.png"; 2], ..PLAIN }),
        picture("light", LIT),
        picture("light and phong", Scene { shaders: [PHONG; 2], ..LIT }),
        picture("light and mesh", Scene { ball: mesh, ..LIT }),
        Picture { options: &["--soft-shadows"], ..picture("soft light", LIT) },
        picture("mirror", Scene { shaders: ["type mirror refl 0.8 0.8 0.8", CONSTANT], ..PLAIN }),
        picture("glass", Scene { shaders: ["type glass eta 1.5 color 0.9 0.9 0.9", CONSTANT], ..PLAIN }),
        picture("thin lens", Scene { camera: THIN_LENS, ..PLAIN }),
        Picture { options: &["--aa", "1"], ..picture("aa 1", PLAIN) },
    ]
}

fn sphere() -> String {
    "type sphere name globe c 0 0 1 r 1".to_owned()
}

/// A ring of 64 x 32 squares, each of two triangles.
fn mesh() -> String {
    const AROUND: u32 = 64;
    const ACROSS: u32 = 32;
    let mut text = format!("type generic-mesh name ring points {}", AROUND * ACROSS);
    for (step, turn) in (0..AROUND).flat_map(|step| (0..ACROSS).map(move |turn| (step, turn))) {
        let angle = |number: u32, of: u32| std::f64::consts::TAU * f64::from(number) / f64::from(of);
        let ((sin, cos), (up, out)) = (angle(step, AROUND).sin_cos(), angle(turn, ACROSS).sin_cos());
        let radius = 0.8 + 0.35 * out;
        let _ = write!(text, "\n {:.4} {:.4} {:.4}", radius * cos, 0.35 * up, 1.2 + radius * sin);
    }
    let _ = write!(text, "\n triangles {}", 2 * AROUND * ACROSS);
    for (step, turn) in (0..AROUND).flat_map(|step| (0..ACROSS).map(move |turn| (step, turn))) {
        let point = |step: u32, turn: u32| step % AROUND * ACROSS + turn % ACROSS;
        let [a, b, c, d] = [point(step, turn), point(step + 1, turn), point(step + 1, turn + 1), point(step, turn + 1)];
        let _ = write!(text, "\n {a} {b} {c} {a} {c} {d}");
    }
    text + " normals none uvs none"
}

impl Scene {
    fn text(&self) -> String {
        let Self { camera, shaders: [ball_shader, floor_shader], ball, light } = self;
        format!(
            "camera {{ {camera} }} {light} shader {{ name ball {ball_shader} }} shader {{ name floor {floor_shader} }}
             object {{ shader ball {} }} object {{ shader floor type plane p 0 0 0 n 0 0 1 }}",
            ball()
        )
    }
}

/// The program as it is released.
fn program() -> PathBuf {
    let workspace = Path::new(env!("CARGO_MANIFEST_DIR")).parent().expect("the workspace is around this package");
    let built = Path::new(env!("CARGO_TARGET_TMPDIR")).parent().expect("the folder for what is built");
    let mut cargo = Command::new(env!("CARGO"));
    cargo
        .current_dir(workspace)
        .args(["build", "--locked", "--quiet", "--release", "--package", "cli", "--target-dir"])
        .arg(built)
        .env_remove("RUSTFLAGS");
    assert!(cargo.status().expect("cargo can be started").success(), "{cargo:?}");
    built.join("release").join("girasol")
}

/// The instructions of a whole run of the program.
fn instructions(folder: &Folder, program: &Path, options: &[&str]) -> f64 {
    let mut valgrind =
        folder.command_of(Path::new("valgrind"), &["--tool=callgrind", "--callgrind-out-file=/dev/null"]);
    valgrind.arg(program).args(["render", "scene.sc", "--quiet", "--threads", "1", "-o", "picture.bmp"]).args(options);
    let output = valgrind.stdin(Stdio::null()).output().expect("Valgrind can be started");
    let said = String::from_utf8_lossy(&output.stderr);
    assert!(output.status.success(), "{said}");
    let collected = said.lines().find_map(|line| line.split_once("Collected :")).map(|(_, count)| count.trim().parse());
    collected.unwrap_or_else(|| panic!("no count in {said}")).expect("a number of instructions")
}

/// The instructions of a pixel: what a picture takes beyond its first pixel alone, which has the reading, the building and the writing, too.
fn per_pixel(program: &Path, picture: &Picture) -> f64 {
    let texture = RgbImage::from_fn(64, 64, |x, y| Rgb([(4 * x) as u8, (4 * y) as u8, 128]));
    let mut png = std::io::Cursor::new(Vec::new());
    texture.write_to(&mut png, ImageFormat::Png).expect("a picture can be encoded");
    let folder = Folder::for_program("girasol").with("texture.png", png.into_inner());
    let folder = folder.with("scene.sc", picture.scene.text());
    let size = format!("{WIDTH}x{HEIGHT}");
    let count =
        |options: &[&str]| instructions(&folder, program, &[&["--size", &size], picture.options, options].concat());
    (count(&[]) - count(&["--crop", "0,0,1,1"])) / f64::from(WIDTH * HEIGHT - 1)
}

/// Why nothing can be counted here, if so.
fn missing() -> Option<&'static str> {
    let valgrind = Command::new("valgrind").arg("--version").stdout(Stdio::null()).status();
    if !valgrind.is_ok_and(|status| status.success()) {
        return Some("Valgrind");
    }
    #[cfg(target_arch = "x86_64")]
    if is_x86_feature_detected!("avx2") && is_x86_feature_detected!("fma") {
        return None;
    }
    Some("a processor with AVX2, as the recorded figures are of")
}

/// A feature and its figure in each line.
fn figures(text: &str) -> Vec<(&str, f64)> {
    let lines = text.lines().filter_map(|line| line.rsplit_once(char::is_whitespace));
    lines.map(|(feature, figure)| (feature.trim(), figure.parse().expect("a figure"))).collect()
}

#[test]
#[ignore = "counts the program as it is released: cargo test -p tests --test instructions -- --ignored --nocapture"]
fn no_pixel_takes_more_instructions_than_recorded() {
    if let Some(missing) = missing() {
        println!("left out, for want of {missing}");
        return;
    }
    let file = Path::new(env!("CARGO_MANIFEST_DIR")).join(RECORDED);
    let program = program();
    let mut counted = String::new();
    for picture in pictures() {
        let _ = writeln!(counted, "{:16} {:.0}", picture.feature, per_pixel(&program, &picture));
    }
    println!("instructions a pixel:\n{counted}");
    if std::env::var_os("GIRASOL_RECORD").is_some() {
        fs::write(&file, counted).expect("the figures can be recorded");
        return;
    }
    let recorded = fs::read_to_string(&file).expect("the recorded figures can be read");
    let (counted, recorded) = (figures(&counted), figures(&recorded));
    let names = |figures: &[(&str, f64)]| figures.iter().map(|(feature, _)| (*feature).to_owned()).collect::<Vec<_>>();
    assert_eq!(names(&counted), names(&recorded), "record the figures anew");
    let worse = counted.iter().zip(&recorded).filter(|((_, now), (_, then))| *now > TOLERANCE * then);
    let worse: Vec<_> = worse.map(|((name, now), (_, then))| format!("{name}: {now} instead of {then}")).collect();
    assert!(worse.is_empty(), "instructions a pixel: {worse:?}");
}
