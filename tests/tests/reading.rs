//! What the program does with scenes' texts, and what it takes from other files.

use render::Modules;
use scene_format::Limits;
use tests::{Folder, MemoryFiles, Rendering};

const PROGRAM: &str = env!("CARGO_BIN_EXE_girasol-under-test");
const CAMERA: &str = "camera { type pinhole eye 0 -9 0 target 0 0 0 up 0 0 1 fov 40 aspect 1 }";
const WHITE: &str = "shader { name white type constant color 1 1 1 }";

fn folder() -> Folder {
    Folder::for_program(PROGRAM)
}

/// A scene of which an include has an unknown word in its second line.
fn with_include() -> Folder {
    folder()
        .with("scene.sc", format!("{CAMERA}\n{WHITE}\n  include part.sc\n"))
        .with("part.sc", "% a part\nimage { glow 3 }\n")
}

#[test]
fn check_tells_tools_in_json_what_it_tells_people() {
    let ended = with_include().run(&["check", "scene.sc", "--format", "json"]);
    assert_eq!((ended.code, ended.stderr.as_str()), (Some(0), ""));
    insta::assert_snapshot!(ended.stdout);
}

#[test]
fn a_message_about_an_include_says_who_includes_it() {
    insta::assert_snapshot!(with_include().run(&["check", "scene.sc"]).stderr);
}

#[test]
fn strict_fails_for_a_warning() {
    let folder = with_include();
    for arguments in [&["check", "scene.sc", "--strict"][..], &["render", "scene.sc", "--strict", "--size", "8x6"]] {
        assert_eq!(folder.run(arguments).code, Some(1), "{arguments:?}");
    }
    assert_eq!(folder.run(&["render", "scene.sc", "--size", "8x6"]).code, Some(0));
    assert_eq!(folder.run(&["check", "pyramid", "--strict"]).code, Some(0));
}

#[test]
fn a_file_without_camera_can_be_included_but_not_rendered() {
    let folder = folder().with("part.sc", WHITE);
    assert_eq!(folder.run(&["check", "part.sc"]).code, Some(0));
    assert_eq!(folder.run(&["render", "part.sc"]).code, Some(1));
}

#[test]
fn fmt_prints_checks_and_writes() {
    let folder = folder().with("scene.sc", "image{ aa 0 1 } % two by two\n");
    let laid_out = "image {\n  aa 0 1\n}  % two by two\n";
    assert_eq!(folder.run(&["fmt", "scene.sc"]).stdout, laid_out);
    assert_eq!(folder.run(&["fmt", "scene.sc", "--check"]).code, Some(1));
    assert_eq!(folder.run(&["fmt", "scene.sc", "--write"]).code, Some(0));
    assert_eq!(folder.read("scene.sc"), laid_out.as_bytes());
    assert_eq!(folder.run(&["fmt", "scene.sc", "--check"]).code, Some(0));
    let broken = folder.with("broken.sc", "image { aa x }");
    assert_eq!(broken.run(&["fmt", "broken.sc", "--write"]).code, Some(1));
    assert_eq!(broken.read("broken.sc"), b"image { aa x }");
}

#[test]
fn check_of_a_folder_is_a_table() {
    let folder = with_include().with("broken.sc", "object {");
    let ended = folder.run(&["check", "."]);
    assert_eq!(ended.code, Some(1));
    insta::assert_snapshot!(ended.stdout);
}

/// A tetrahedron that stands on its point at z = 0, in whatever format.
const OBJ: &str = "v 0 0 0\nv 2 0 3\nv -2 2 3\nv -2 -2 3\nf 1 2 3\nf 1 3 4\nf 1 4 2\nf 2 4 3\n";

#[test]
fn convert_writes_a_scene_that_renders_without_a_word() {
    for arguments in [&["convert", "a.obj"][..], &["convert", "a.obj", "--up", "z", "--smooth", "-o", "a.sc"]] {
        let folder = folder().with("a.obj", OBJ);
        assert_eq!(folder.run(arguments).code, Some(0));
        assert_eq!(folder.run(&["check", "a.sc", "--strict"]).code, Some(0));
        assert_eq!(folder.run(&["fmt", "a.sc", "--check"]).code, Some(0));
        let ended = folder.run(&["render", "a.sc", "--size", "40x30", "--quiet"]);
        assert_eq!((ended.code, ended.stderr.as_str()), (Some(0), ""));
        let text = String::from_utf8(folder.read("a.sc")).unwrap();
        assert_eq!(text.contains("normals vertex"), arguments.contains(&"--smooth"));
    }
}

#[test]
fn convert_says_what_is_wrong_with_a_mesh() {
    let folder = folder().with("a.obj", "v 0 0 0\nf 1 2 3\n").with("b.obj", "# empty\n").with("c.xyz", "");
    for (name, words) in [("a.obj", "line 2"), ("b.obj", "no triangle"), ("c.xyz", ".ra3"), ("d.obj", "no mesh")] {
        let ended = folder.run(&["convert", name]);
        assert!(ended.code == Some(1) && ended.stderr.contains(words), "{}", ended.stderr);
    }
    assert_eq!(folder.names().len(), 3);
}

/// How many pixels of 40 x 40 an object covers, white before black.
fn covered(object: &str, files: MemoryFiles) -> usize {
    let text = format!("image {{ resolution 40 40 }} {CAMERA} {WHITE} object {{ shader white {object} }}");
    let film = Rendering { files, ..Rendering::flat(text) }.film();
    film.pixels.iter().filter(|pixel| pixel.r > 0.5).count()
}

fn alone(object: &str) -> usize {
    covered(object, MemoryFiles::default())
}

#[test]
fn objects_cover_what_their_shape_says() {
    // The picture is 2 x 9 x tan(20) = 6.55 wide, so a unit is 6.1 pixels, a little more where it is nearer.
    let sphere = alone("transform { } type sphere");
    assert!((100..140).contains(&sphere), "{sphere}");
    // A square of 2 by 2.
    let cylinder = alone("type cylinder");
    assert!((140..190).contains(&cylinder), "{cylinder}");
    // A bar 5 wide and 1 high with round ends: 4.8 square units, 179 pixels, and up to (9 / 6.5)^2 = 1.9 as many where it is nearer.
    let torus = alone("type torus r 0.5 2");
    assert!((179..340).contains(&torus), "{torus}");
    // From above, with a hole: pi (2.5^2 - 1.5^2) = 12.6 square units.
    let ring = alone("transform { rotatex 90 } type torus r 0.5 2");
    assert!((440..520).contains(&ring), "{ring}");
    let flake = alone("type sphereflake level 1");
    assert!(flake > sphere + 20, "{flake}");
    assert_eq!(alone("type sphereflake level 0"), sphere);
    assert_eq!(alone("type particles points 1 0 0 0 radius 1"), sphere);
    let two = alone("type particles points 2 -2 0 0 2 0 0 radius 1");
    assert!((two as i64 - 2 * sphere as i64).abs() < 16, "{two}");
    assert!(alone("type particles points 2 -2 0 0 2 0 0 num 1 radius 1") < two);
    let teapot = alone("transform { scaleu 0.02 translate 0 0 -1 } type teapot");
    assert!((200..320).contains(&teapot), "{teapot}");
    // Catmull's elephant is 24 long and 20 high, and about half of that rectangle is elephant.
    let gumbo = alone("transform { translate -12 -7 -10 scaleu 0.2 } type gumbo");
    assert!((250..600).contains(&gumbo), "{gumbo}");
    let patch = "type bezier-mesh n 4 4 points -1 0 -1 -.3 0 -1 .3 0 -1 1 0 -1 -1 0 -.3 -.3 0 -.3 .3 0 -.3 1 0 -.3 \
        -1 0 .3 -.3 0 .3 .3 0 .3 1 0 .3 -1 0 1 -.3 0 1 .3 0 1 1 0 1 subdivs 2";
    assert_eq!(alone(patch), 144);
}

#[test]
fn an_object_without_extent_is_left_out_and_the_rest_is_rendered() {
    // As Sunflow does: a transform without inverse drops its object. Beside each stands a sphere that stays.
    let said = |object: &str| {
        let text = format!(
            "{CAMERA} {WHITE} object {{ shader white {object} }} object {{ shader white type sphere c 0 0 0 r -1 }}"
        );
        let modules = Modules::default();
        let parsed = (modules.parse)("scene.sc", &text, &MemoryFiles::default(), &Limits::default());
        let assembled =
            render::assemble(&parsed.scene, &modules, &render::Lighting::default(), &MemoryFiles::default());
        let assembled = assembled.unwrap_or_else(|errors| panic!("{errors:?}"));
        let inventory = assembled.scene.inventory(&assembled.settings);
        assert_eq!(inventory.bounded.spheres + inventory.bounded.ellipsoids, 1, "{object}");
        assembled.warnings.iter().map(|said| said.code.as_str()).collect::<Vec<_>>()
    };
    assert_eq!(said("transform { scaleu 0 } type sphere"), ["SC308"]);
    assert_eq!(said("transform { scale 1 0 1 } type box"), ["SC308"]);
    assert_eq!(said("type sphere c 0 0 0 r 0"), ["SC312"]);
    // Turned inside out, a sphere covers the same pixels.
    assert_eq!(alone("type sphere c 0 0 0 r -1"), alone("type sphere c 0 0 0 r 1"));
}

#[test]
fn a_mesh_is_the_same_from_whatever_file() {
    let files = || {
        let points: [[f32; 3]; 4] = [[0., 0., 0.], [2., 0., 3.], [-2., 2., 3.], [-2., -2., 3.]];
        let corners: [[i32; 3]; 4] = [[0, 1, 2], [0, 2, 3], [0, 3, 1], [1, 3, 2]];
        let bytes = |numbers: &[i32]| numbers.iter().flat_map(|number| number.to_le_bytes()).collect::<Vec<_>>();
        let floats = |numbers: &[f32]| numbers.iter().flat_map(|number| number.to_le_bytes()).collect::<Vec<_>>();
        let ra3 = [bytes(&[4, 4]), floats(points.as_flattened()), bytes(corners.as_flattened())].concat();
        let stl: String = corners
            .iter()
            .map(|corners| {
                let vertex = |at: &i32| format!("vertex {:?}\n", points[*at as usize]).replace(['[', ']', ','], " ");
                format!("facet\nouter loop\n{}endloop\n", corners.iter().map(vertex).collect::<String>())
            })
            .collect();
        let faces = corners.map(|[a, b, c]| format!("3 {a} {b} {c}\n")).concat();
        let vertices = points.map(|[x, y, z]| format!("{x} {y} {z}\n")).concat();
        let ply = format!(
            "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\n\
            element face 4\nproperty list uchar int vertex_index\nend_header\n{vertices}{faces}"
        );
        MemoryFiles::default()
            .with("meshes/a.obj", OBJ.into())
            .with("meshes/a.ra3", ra3)
            .with("meshes/a.stl", format!("solid a\n{stl}endsolid a\n").into())
            .with("meshes/a.ply", ply.into())
    };
    let picture = |name: &str, smooth: bool| {
        let text = format!(
            "image {{ resolution 40 40 }} {CAMERA} {WHITE} includepath meshes \
            light {{ type point color 1 1 1 power 40 p 3 -9 5 }} \
            object {{ shader white type file-mesh filename {name} smooth_normals {smooth} }}"
        );
        Rendering { files: files(), ..Rendering::of(text) }.film().pixels
    };
    let obj = picture("a.obj", false);
    assert!(obj.iter().any(|pixel| pixel.r > 0.1));
    for name in ["a.ra3", "a.stl", "a.ply"] {
        assert_eq!(picture(name, false), obj, "{name}");
    }
    assert_ne!(picture("a.obj", true), obj);
}

#[test]
fn limits_are_the_caller_s() {
    let said = |text: &str, files: MemoryFiles, limits: Limits| {
        let modules = Modules { limits, ..Modules::default() };
        let parsed = (modules.parse)("scene.sc", text, &files, &limits);
        let assembled = render::assemble(&parsed.scene, &modules, &render::Lighting::default(), &files);
        let assembled = assembled.map_or_else(|said| said, |assembled| assembled.warnings);
        let codes = parsed.diagnostics.iter().chain(&assembled).map(|said| said.code.as_str()).collect::<Vec<_>>();
        codes.join(" ")
    };
    let none = MemoryFiles::default;
    let ball = format!("{CAMERA} {WHITE} object {{ shader white type teapot }}");
    let few = Limits { elements: 1000, ..Limits::default() };
    assert_eq!(said(&ball, none(), Limits::default()), "");
    assert_eq!(said(&ball, none(), few), "SC701");
    let flake = format!("{CAMERA} {WHITE} object {{ shader white type sphereflake level 2000000000 }}");
    assert_eq!(said(&flake, none(), Limits::default()), "SC701");
    assert_eq!(said(&flake, none(), few), "SC701 SC701");
    let small = Limits { picture_edge: 100, ..Limits::default() };
    assert_eq!(said(&format!("image {{ resolution 101 5 }} {CAMERA}"), none(), small), "SC701");
    let mesh = format!("{CAMERA} {WHITE} object {{ shader white type file-mesh filename a.obj }}");
    let files = || none().with("a.obj", OBJ.into());
    assert_eq!(said(&mesh, files(), Limits::default()), "");
    assert_eq!(said(&mesh, files(), Limits { elements: 3, ..Limits::default() }), "SC701");
    assert_eq!(said(&mesh, files(), Limits { bytes: 20, ..Limits::default() }), "SC701");
    let deep = || none().with("a.sc", b"include b.sc".to_vec()).with("b.sc", b"bucket 8 row".to_vec());
    let text = format!("{CAMERA} include a.sc");
    assert_eq!(said(&text, deep(), Limits::default()), "");
    assert_eq!(said(&text, deep(), Limits { include_depth: 1, ..Limits::default() }), "SC701");
    assert_eq!(said(&text, deep(), Limits { files: 2, ..Limits::default() }), "SC701");
}

/// One of the real scenes asks for ten times: 9^10 spheres.
#[test]
fn a_flake_is_grown_six_times_at_most_with_a_warning() {
    let spheres = |level: u32| {
        let text = format!("{CAMERA} {WHITE} object {{ shader white type sphereflake level {level} }}");
        let modules = Modules::default();
        let parsed = (modules.parse)("scene.sc", &text, &MemoryFiles::default(), &Limits::default());
        let assembled =
            render::assemble(&parsed.scene, &modules, &render::Lighting::default(), &MemoryFiles::default());
        let assembled = assembled.unwrap_or_else(|errors| panic!("{errors:?}"));
        let count = assembled.scene.inventory(&assembled.settings).bounded.spheres;
        (count, assembled.warnings.iter().map(|said| said.code.as_str()).collect::<Vec<_>>())
    };
    assert_eq!(spheres(2), (1 + 9 + 81, vec![]));
    // (9^7 - 1) / 8
    assert_eq!(spheres(10), (597_871, vec!["SC701"]));
}
