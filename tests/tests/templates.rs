//! `girasol new` makes crates that build, whose laws fail as said, and whose programs render.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

use geometry::conformance::{Law, Trial};
use tests::Folder;

const PROGRAM: &str = env!("CARGO_BIN_EXE_girasol-under-test");

/// Each stub as a module of this test.
macro_rules! stubs {
    ($($module:ident = $file:literal;)+) => { $(#[path = $file] #[expect(unreachable_pub, reason = "a crate's own there")] mod $module;)+ };
}

stubs! {
    accelerator = "../../cli/templates/accelerator.rs";
    bucket_order = "../../cli/templates/bucket-order.rs";
    camera = "../../cli/templates/camera.rs";
    constant = "../../cli/templates/constant.rs";
    cuboid = "../../cli/templates/box.rs";
    ellipsoid = "../../cli/templates/ellipsoid.rs";
    falloff = "../../cli/templates/falloff.rs";
    glass = "../../cli/templates/glass.rs";
    mirror = "../../cli/templates/mirror.rs";
    normal_matrix = "../../cli/templates/normal-matrix.rs";
    parser = "../../cli/templates/parser.rs";
    phong = "../../cli/templates/phong.rs";
    plane = "../../cli/templates/plane.rs";
    plane_uv = "../../cli/templates/plane-uv.rs";
    ray_origin = "../../cli/templates/ray-origin.rs";
    renderer = "../../cli/templates/renderer.rs";
    sampler = "../../cli/templates/sampler.rs";
    smooth_normal = "../../cli/templates/smooth-normal.rs";
    soft_shadows = "../../cli/templates/soft-shadows.rs";
    sphere = "../../cli/templates/sphere.rs";
    sphere_uv = "../../cli/templates/sphere-uv.rs";
    texture = "../../cli/templates/texture.rs";
    triangle = "../../cli/templates/triangle.rs";
    triangle_uv = "../../cli/templates/triangle-uv.rs";
}

/// The easiest law fails on a stub, whatever the seed, and says that nothing is there yet, and what to do.
#[track_caller]
fn begins<Part>(laws: &[Law<Part>], stub: &Part) {
    for seed in 0..3 {
        let broken = laws[0].check(stub, &Trial { cases: 64, seed }).expect_err(laws[0].name);
        let said = broken.usually;
        assert!(said.starts_with("nothing is "), "{}: {said}", broken.law);
    }
}

#[test]
fn the_first_law_of_each_kit_tells_a_stub_s_author_what_to_do_first() {
    begins(accel::conformance::accelerator::LAWS, &(accelerator::build as _));
    begins(geometry::conformance::sphere::LAWS, &(sphere::intersect as _));
    begins(geometry::conformance::ellipsoid::LAWS, &(ellipsoid::intersect as _));
    begins(geometry::conformance::triangle::LAWS, &(triangle::intersect as _));
    begins(geometry::conformance::plane::LAWS, &(plane::intersect as _));
    begins(geometry::conformance::plane_uv::LAWS, &(plane_uv::uv as _));
    begins(geometry::conformance::sphere_uv::LAWS, &(sphere_uv::uv as _));
    begins(geometry::conformance::triangle_uv::LAWS, &(triangle_uv::uv as _));
    begins(geometry::conformance::smooth_normal::LAWS, &(smooth_normal::normal as _));
    begins(geometry::conformance::normal_matrix::LAWS, &(normal_matrix::normals as _));
    begins(geometry::conformance::ray_origin::LAWS, &(ray_origin::origin_towards as _));
    begins(geometry::conformance::aabb::LAWS, &(cuboid::clip as _));
    begins(shading::conformance::constant::LAWS, &(constant::shader as _));
    begins(shading::conformance::phong::LAWS, &(phong::shader as _));
    begins(shading::conformance::mirror::LAWS, &(mirror::shader as _));
    begins(shading::conformance::glass::LAWS, &(glass::shader as _));
    begins(shading::conformance::texture::LAWS, &(texture::texture as _));
    begins(shading::conformance::falloff::LAWS, &(falloff::falloff as _));
    begins(shading::conformance::soft_shadows::LAWS, &(soft_shadows::cluster as _));
    begins(render::conformance::camera::LAWS, &(camera::camera as _));
    begins(render::conformance::bucket_order::LAWS, &(bucket_order::order as _));
    begins(render::conformance::renderer::LAWS, &(renderer::render as _));
    begins(scene_format::conformance::parser::LAWS, &(parser::parse as _));
    begins(render::conformance::sampler::LAWS, &(sampler::sampler as _));
}

fn workspace() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).parent().expect("the workspace is around this package").to_owned()
}

/// A folder outside of the workspace, and the option that says where girasol is.
fn outside() -> (Folder, String) {
    (Folder::for_program(PROGRAM), workspace().display().to_string())
}

/// The parts that `new` knows.
fn parts() -> Vec<String> {
    let help = Folder::for_program(PROGRAM).run(&["new", "--help"]).stdout;
    let (_, after) = help.split_once("Possible values:").expect("the parts are listed");
    let lines = after.lines().map(str::trim).skip_while(|line| line.is_empty());
    lines
        .take_while(|line| line.starts_with("- "))
        .map(|line| line[2..].split(':').next().unwrap().to_owned())
        .collect()
}

#[test]
fn a_new_crate_has_the_stub_the_task_and_every_law() {
    let (folder, girasol) = outside();
    let ended = folder.run(&["new", "mirror", "my-mirror", "--girasol", &girasol]);
    assert_eq!(ended.code, Some(0), "{}", ended.stderr);
    assert!(ended.stderr.contains("my-mirror: a crate with a stub for your own mirror"), "{}", ended.stderr);
    let text = |path: &str| fs::read_to_string(folder.path("my-mirror").join(path)).unwrap();
    assert!(text("src/mirror.rs").contains("A stub"));
    let main = text("src/main.rs");
    assert!(main.contains("Shaders { mirror: my_mirror::shader, ..Shaders::default() }"), "{main}");
    assert!(main.lines().count() <= 12, "a dozen lines: {main}");
    assert_eq!(text("tests/laws.rs"), "//! A test for each law.\n\nshading::mirror_conformance!(my_mirror::shader);\n");
    let readme = text("README.md");
    for law in shading::conformance::mirror::LAWS {
        let sentence = &law.name.replace('_', " ")[1..];
        assert!(readme.contains(sentence) && readme.contains(law.usually), "{}", law.name);
    }
    for heading in ["## Task", "## The laws", "## Hints", "## Papers"] {
        assert_eq!(readme.matches(heading).count(), 1, "{readme}");
    }
}

#[test]
fn a_manifest_names_what_the_workspace_has() {
    let workspace: toml::Table = fs::read_to_string(workspace().join("Cargo.toml")).unwrap().parse().unwrap();
    let (folder, girasol) = outside();
    for (name, place) in [("by-path", girasol.as_str()), ("by-git", "https://example.org/girasol.git")] {
        folder.run(&["new", "sphere", name, "--girasol", place]);
        let manifest: toml::Table = fs::read_to_string(folder.path(name).join("Cargo.toml")).unwrap().parse().unwrap();
        assert_eq!(manifest["package"]["edition"], workspace["workspace"]["package"]["edition"]);
        assert_eq!(manifest["profile"], workspace["profile"]);
        let dependencies = manifest["dependencies"].as_table().unwrap();
        assert_eq!(dependencies["glam"], workspace["workspace"]["dependencies"]["glam"]);
        for krate in ["accel", "cli", "geometry", "render", "scene-format", "shading"] {
            match dependencies[krate].get("path").and_then(toml::Value::as_str) {
                Some(path) => assert!(folder.path(name).join(path).join("Cargo.toml").is_file(), "{path}"),
                None => assert_eq!(dependencies[krate]["git"].as_str(), Some(place)),
            }
        }
    }
    assert!(folder.path("by-path").join("Cargo.lock").exists() && !folder.path("by-git").join("Cargo.lock").exists());
}

#[test]
fn what_is_there_is_not_touched_and_what_cannot_be_is_said() {
    let (folder, girasol) = outside();
    fs::create_dir(folder.path("there")).unwrap();
    for (arguments, said) in [
        (["new", "sphere", "there", "--girasol", &girasol], "is there already"),
        (["new", "sphere", "My Sphere", "--girasol", &girasol], "a crate cannot be called `My Sphere`"),
        (["new", "sphere", "render", "--girasol", &girasol], "`render` is something else already"),
        (["new", "sphere", "no/where/mine", "--girasol", &girasol], "cannot be opened"),
        (["new", "sphere", "mine", "--girasol", "there"], "`there` is no checkout of girasol"),
        (["new", "sphere", "mine", "--girasol", "nowhere"], "`nowhere` cannot be opened"),
    ] {
        let ended = folder.run(&arguments);
        assert_eq!(ended.code, Some(1), "{arguments:?}");
        assert!(ended.stderr.contains(said), "{arguments:?}: {}", ended.stderr);
    }
    assert_eq!(folder.names().len(), 1);
    assert_eq!(folder.run(&["new", "lens", "mine"]).code, Some(2));
}

#[test]
fn a_mere_name_inside_of_the_checkout_means_beside_it() {
    // A checkout as far as can be seen from outside.
    let folder = Folder::for_program(PROGRAM);
    for krate in ["geometry", "cli"] {
        fs::create_dir_all(folder.path("girasol").join(krate)).unwrap();
        fs::write(folder.path("girasol").join(krate).join("Cargo.toml"), "").unwrap();
    }
    let output =
        folder.command(&["new", "plane", "my-plane"]).current_dir(folder.path("girasol/cli")).output().unwrap();
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    let manifest = fs::read_to_string(folder.path("my-plane/Cargo.toml")).unwrap();
    assert!(manifest.contains("cli = { path = \"../girasol/cli\" }"), "{manifest}");
}

/// Whether the program of a stub makes a picture: one that reads nothing finds no camera, and one may make no picture of its own.
fn renders(part: &str) -> bool {
    !["parser", "renderer"].contains(&part)
}

#[test]
#[ignore = "builds a program for each part: cargo test -p tests --test templates -- --ignored --nocapture"]
fn every_new_crate_builds_fails_its_kit_and_renders() {
    let (folder, girasol) = outside();
    // Some of them, if they are named.
    let named = std::env::var("GIRASOL_PARTS").ok();
    let is_asked = |part: &String| named.as_ref().is_none_or(|named| named.split(' ').any(|name| name == part));
    // Once for all of them: what they do not share is small.
    let built = PathBuf::from(env!("CARGO_TARGET_TMPDIR")).join("templates");
    let asked: Vec<String> = parts().into_iter().filter(is_asked).collect();
    assert!(!asked.is_empty(), "none of {named:?} is a part");
    for part in asked {
        let name = format!("my-{part}");
        assert_eq!(folder.run(&["new", &part, &name, "--girasol", &girasol]).code, Some(0));
        let cargo = |arguments: &[&str]| {
            let mut command = Command::new(env!("CARGO"));
            command.args(arguments).current_dir(folder.path(&name)).env("CARGO_TARGET_DIR", &built);
            let Output { status, stdout, stderr } = command.env("PROPTEST_CASES", "16").output().unwrap();
            let text = |bytes: Vec<u8>| String::from_utf8_lossy(&bytes).into_owned();
            (status.success(), text(stdout), text(stderr))
        };
        let (is_built, _, stderr) = cargo(&["test", "--offline", "--no-run"]);
        assert!(is_built && !stderr.contains(&format!("warning: `{name}`")), "{part}: {stderr}");
        let (passed, stdout, _) = cargo(&["test", "--offline"]);
        assert!(!passed && stdout.contains("   usually: nothing is "), "{part}: {stdout}");
        let (rendered, _, stderr) = cargo(&["run", "--offline", "--", "render", "pyramid", "--size", "40x30"]);
        assert_eq!(rendered, renders(&part), "{part}: {stderr}");
    }
}
