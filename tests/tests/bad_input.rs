//! What the program says to input that it cannot render, or not wholly: where, what was expected, what was found, what to do. Exit code
//! 1 for what fails and 2 for a wrong command line; never a panic, and never a file that was not asked for.
//!
//! Accept changed texts with `INSTA_UPDATE=always cargo test -p tests --test bad_input`, or look at each with `cargo insta review`.

use std::time::{Duration, Instant};

use tests::Folder;

const PROGRAM: &str = env!("CARGO_BIN_EXE_girasol-under-test");
const CAMERA: &str = "camera { type pinhole eye 0 -5 0 target 0 0 0 up 0 0 1 fov 30 aspect 1 }";
const WHITE: &str = "shader { name white type constant color 1 1 1 }";

fn folder() -> Folder {
    Folder::for_program(PROGRAM)
}

/// A scene with a camera, a shader `white`, and from its line 4 on what is given.
fn scene(more: &str) -> Folder {
    folder().with("scene.sc", format!("image {{ resolution 8 6 }}\n{CAMERA}\n{WHITE}\n{more}\n"))
}

/// The exit code and stderr of a run after which the folder holds what it held before, and what is `made`.
fn told_making(folder: &Folder, arguments: &[&str], made: &[&str]) -> String {
    let mut expected = folder.names();
    let ended = folder.run(arguments);
    expected.extend(made.iter().map(|&name| name.to_owned()));
    assert_eq!(folder.names(), expected);
    assert_eq!(ended.stdout, "");
    let code = ended.code.expect("no signal ends it");
    let stderr = ended.stderr.replace("girasol-under-test", "girasol");
    format!("exit code {code}\n{}", without_times(&stderr))
}

/// The exit code and stderr of a run that leaves no file.
fn told(folder: &Folder, arguments: &[&str]) -> String {
    told_making(folder, arguments, &[])
}

/// What is said of a scene that cannot be rendered.
fn refused(more: &str) -> String {
    told(&scene(more), &["render", "scene.sc"])
}

/// What is said of a scene that can be rendered all the same.
fn rendered(more: &str) -> String {
    told_making(&scene(more), &["render", "scene.sc"], &["scene.png"])
}

/// The time that a rendering took, as `[time]`.
fn without_times(text: &str) -> String {
    text.lines()
        .map(|line| match line.split_once(" pixels in ") {
            Some((before, _)) => format!("{before} pixels in [time]\n"),
            None => format!("{line}\n"),
        })
        .collect()
}

#[test]
fn a_missing_file() {
    insta::assert_snapshot!(told(&folder(), &["render", "nowhere.sc"]));
}

#[test]
fn a_misspelt_built_in_scene() {
    insta::assert_snapshot!(told(&folder(), &["render", "pyramyd"]));
}

#[test]
fn a_folder_instead_of_a_file() {
    let folder = folder();
    std::fs::create_dir(folder.path("scenes")).unwrap();
    insta::assert_snapshot!(told(&folder, &["render", "scenes"]));
}

#[test]
fn a_binary_file() {
    let folder = folder().with("scene.sc", b"\x89PNG\r\n\x1a\n\0\0\0\rIHDR\xff\xfe");
    insta::assert_snapshot!(told(&folder, &["render", "scene.sc"]));
}

#[test]
fn an_empty_file() {
    insta::assert_snapshot!(told(&folder().with("scene.sc", ""), &["render", "scene.sc"]));
}

#[test]
fn an_unknown_shader_type() {
    insta::assert_snapshot!(rendered(
        "shader { name a type fonk diff 1 0 0 }\nobject { shader a type sphere c 0 0 0 r 1 }"
    ));
}

#[test]
fn an_undeclared_shader() {
    insta::assert_snapshot!(rendered("object { shader wite type sphere c 0 0 0 r 1 }"));
}

#[test]
fn a_missing_texture() {
    insta::assert_snapshot!(refused(
        "shader { name a type diffuse texture nowhere.png }\nobject { shader a type sphere c 0 0 0 r 1 }"
    ));
}

#[test]
fn a_texture_that_is_no_picture() {
    let folder = scene("shader { name a type diffuse texture text.png }\nobject { shader a type sphere c 0 0 0 r 1 }");
    insta::assert_snapshot!(told(&folder.with("text.png", "no picture"), &["render", "scene.sc"]));
}

#[test]
fn a_texture_that_is_cut_off() {
    let mut bytes = std::io::Cursor::new(Vec::new());
    image::RgbImage::new(64, 64).write_to(&mut bytes, image::ImageFormat::Png).unwrap();
    let half = &bytes.get_ref()[..bytes.get_ref().len() / 2];
    let folder = scene("shader { name a type diffuse texture half.png }\nobject { shader a type sphere c 0 0 0 r 1 }");
    insta::assert_snapshot!(told(&folder.with("half.png", half), &["render", "scene.sc"]));
}

#[test]
fn a_texture_that_is_a_folder() {
    let folder = scene("shader { name a type diffuse texture pictures }\nobject { shader a type sphere c 0 0 0 r 1 }");
    std::fs::create_dir(folder.path("pictures")).unwrap();
    insta::assert_snapshot!(told(&folder, &["render", "scene.sc"]));
}

#[test]
fn no_camera() {
    let folder = folder().with("scene.sc", format!("{WHITE}\nobject {{ shader white type sphere c 0 0 0 r 1 }}\n"));
    insta::assert_snapshot!(told(&folder, &["render", "scene.sc"]));
}

#[test]
fn not_a_number() {
    insta::assert_snapshot!(refused("object { shader white type sphere c 0 NaN 0 r 1 }"));
}

#[test]
fn an_infinite_number() {
    insta::assert_snapshot!(refused("object { shader white type sphere c 0 1e99 0 r Infinity }"));
}

#[test]
fn a_word_where_a_number_is_due() {
    insta::assert_snapshot!(refused("object { shader white type sphere c 0 zero 0 r 1 }"));
}

#[test]
fn a_shader_behind_the_object_that_names_it() {
    insta::assert_snapshot!(rendered(
        "object { shader red type sphere c 0 0 0 r 1 }\nshader { name red type constant color 1 0 0 }"
    ));
}

#[test]
fn two_cameras() {
    insta::assert_snapshot!(rendered(CAMERA));
}

#[test]
fn a_singular_transform() {
    insta::assert_snapshot!(rendered("object { shader white transform { scale 1 0 1 } type sphere }"));
}

#[test]
fn a_transform_that_overflows() {
    insta::assert_snapshot!(refused("object { shader white transform { scaleu 1e30 scaleu 1e30 } type sphere }"));
}

#[test]
fn a_degenerate_triangle() {
    insta::assert_snapshot!(rendered(
        "object { shader white type generic-mesh points 3 0 0 0 1 1 1 2 2 2\ntriangles 1 0 1 2 normals none uvs none }"
    ));
}

#[test]
fn a_triangle_index_out_of_range() {
    insta::assert_snapshot!(refused(
        "object { shader white type generic-mesh points 3 0 0 0 1 1 1 2 2 3\ntriangles 2 0 1 2 0 1 3 normals none uvs none }"
    ));
}

#[test]
fn a_picture_of_no_size() {
    let folder = folder().with("scene.sc", format!("image {{ resolution 0 6 }}\n{CAMERA}\n"));
    insta::assert_snapshot!(told_making(&folder, &["render", "scene.sc"], &["scene.png"]));
}

#[test]
fn a_hundred_million_triangles_without_data() {
    let start = Instant::now();
    insta::assert_snapshot!(refused(
        "object { shader white type generic-mesh points 3 0 0 0 1 1 1 2 2 3\ntriangles 100000000"
    ));
    assert!(start.elapsed() < Duration::from_secs(5));
}

#[test]
fn a_hundred_million_points_without_data() {
    let start = Instant::now();
    insta::assert_snapshot!(refused("object { shader white type generic-mesh points 100000000"));
    assert!(start.elapsed() < Duration::from_secs(5));
}

#[test]
fn up_parallel_to_the_view() {
    let camera = "camera { type pinhole eye 0 0 5 target 0 0 0 up 0 0 1 fov 30 aspect 1 }";
    insta::assert_snapshot!(told(&folder().with("scene.sc", camera), &["render", "scene.sc"]));
}

#[test]
fn a_camera_in_its_own_target() {
    let camera = "camera { type pinhole eye 1 2 3 target 1 2 3 up 0 0 1 fov 30 aspect 1 }";
    insta::assert_snapshot!(told(&folder().with("scene.sc", camera), &["render", "scene.sc"]));
}

#[test]
fn huge_coordinates() {
    insta::assert_snapshot!(refused("object { shader white type sphere c 0 1e30 0 r 1 }"));
}

#[test]
fn a_plane_with_zero_normal() {
    insta::assert_snapshot!(refused("object { shader white type plane p 0 0 0 n 0 0 0 }"));
}

#[test]
fn a_plane_whose_three_points_lie_on_a_line() {
    insta::assert_snapshot!(refused("object { shader white type plane p 0 0 0 p 1 1 1 p 2 2 2 }"));
}

#[test]
fn a_block_that_is_never_closed() {
    insta::assert_snapshot!(refused("object { shader white type sphere c 0 0 0 r 1"));
}

#[test]
fn a_missing_include() {
    insta::assert_snapshot!(refused("include nowhere.sc"));
}

#[test]
fn an_include_cycle() {
    let folder = scene("include a.sc").with("a.sc", "\ninclude b.sc\n").with("b.sc", "\n\ninclude a.sc\n");
    insta::assert_snapshot!(told(&folder, &["render", "scene.sc"]));
}

#[test]
fn an_error_in_an_include() {
    let folder = scene("include a.sc").with("a.sc", "% nothing\nobject { shader white type sphere c 0 0 r 1 }\n");
    insta::assert_snapshot!(told(&folder, &["render", "scene.sc"]));
}

#[test]
fn bounces_without_end_between_two_mirrors() {
    insta::assert_snapshot!(rendered(
        "trace-depths { diff 1 refl 1000000000 refr 1000000000 }
shader { name mirror type mirror refl 1 1 1 }
object { shader mirror type plane p 0 9 0 n 0 1 0 }
object { shader mirror type plane p 0 -9 0 n 0 1 0 }"
    ));
}

#[test]
fn an_output_folder_that_does_not_exist() {
    insta::assert_snapshot!(told(&scene(""), &["render", "scene.sc", "-o", "no/such/folder/a.png"]));
}

#[test]
fn an_output_folder_that_does_not_exist_is_noticed_before_the_work() {
    let folder = scene("");
    let folder_missing = ["render", "scene.sc", "--size", "16384x16384", "--samples", "60000", "-o", "no/a.png"];
    let mut child = folder.command(&folder_missing).spawn().unwrap();
    let start = Instant::now();
    while child.try_wait().unwrap().is_none() {
        if start.elapsed() > Duration::from_secs(10) {
            child.kill().unwrap();
            child.wait().unwrap();
            panic!("it renders for hours a picture that it cannot write");
        }
        std::thread::sleep(Duration::from_millis(10));
    }
}

#[test]
fn an_output_that_is_a_folder() {
    let folder = scene("");
    std::fs::create_dir(folder.path("a.png")).unwrap();
    insta::assert_snapshot!(told(&folder, &["render", "scene.sc", "-o", "a.png"]));
}

#[test]
fn an_unknown_output_ending() {
    insta::assert_snapshot!(told(&scene(""), &["render", "scene.sc", "-o", "a.tiff"]));
}

#[test]
fn an_output_without_ending() {
    insta::assert_snapshot!(told(&scene(""), &["render", "scene.sc", "-o", "picture"]));
}

/// Not that there is none: it is there, and cannot be read.
#[test]
fn a_camera_that_cannot_be_read_is_told_once() {
    let folder = folder().with("scene.sc", CAMERA.replace("aspect 1", "aspect 0"));
    insta::assert_snapshot!(told(&folder, &["render", "scene.sc"]));
}

#[test]
fn a_light_that_reaches_nothing() {
    insta::assert_snapshot!(rendered(
        "light { type point color 1 1 1 power 2 p 0 -9 0 }\nobject { shader white type plane p 0 0 0 n 0 1 0 }"
    ));
}

/// Once it took half a minute: each message showed the whole line.
#[test]
fn a_very_long_line_is_shown_in_part() {
    let folder = folder().with("scene.sc", "object { ".repeat(200_000));
    let start = Instant::now();
    let text = told(&folder, &["check", "scene.sc"]);
    assert!(start.elapsed() < Duration::from_secs(5), "{:?}", start.elapsed());
    assert!(text.lines().all(|line| line.len() < 1000));
    assert!(text.contains("scene.sc:1:9001"), "the column is that of the whole line");
}

#[test]
fn a_crop_outside_the_picture() {
    insta::assert_snapshot!(told(&scene(""), &["render", "scene.sc", "--crop", "4,4,8,8"]));
}

#[test]
fn a_wrong_command_line() {
    insta::assert_snapshot!(told(&scene(""), &["render", "scene.sc", "--size", "640"]));
}

#[test]
fn an_unknown_command() {
    insta::assert_snapshot!(told(&folder(), &["rendre", "pyramid"]));
}

#[test]
fn more_rays_a_pixel_than_can_be_counted() {
    // 4^8 zones of 65536 rays are 2^32: one more than 32 bits can hold.
    insta::assert_snapshot!(told(&scene(""), &["inspect", "scene.sc", "--aa", "8", "--samples", "65536"]));
    let most = scene("").run(&["inspect", "scene.sc", "--aa", "8", "--samples", "65535"]);
    assert!(most.stdout.contains("4294901760 a pixel"), "{}", most.stdout);
}

#[test]
fn all_problems_are_told_in_one_run() {
    insta::assert_snapshot!(refused(
        "object { shader white type sphere c 0 NaN 0 r 1 }
object { shader white type plane p 0 0 0 n 0 0 0 }
object { shader white transform { scaleu 0 } type sphere }"
    ));
}
