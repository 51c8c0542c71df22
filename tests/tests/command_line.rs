//! The program's commands, as somebody at a terminal meets them.

use std::io::Read;
use std::process::Stdio;
use std::time::{Duration, Instant};

use cli::scenes;
use tests::{Ended, Folder};

const PROGRAM: &str = env!("CARGO_BIN_EXE_girasol-under-test");

const SCENE: &str = "image { resolution 20 10 }
camera { type pinhole eye 0 -5 0 target 0 0 0 up 0 0 1 fov 30 aspect 2 }
shader { name white type constant color 1 1 1 }
object { shader white type sphere c 0 0 0 r 1 }
";

fn folder() -> Folder {
    Folder::for_program(PROGRAM).with("tiny.sc", SCENE)
}

fn succeed(folder: &Folder, arguments: &[&str]) -> Ended {
    let ended = folder.run(arguments);
    assert_eq!(ended.code, Some(0), "{arguments:?}: {}", ended.stderr);
    ended
}

#[test]
fn scenes_lists_all_with_their_summaries() {
    let stdout = succeed(&folder(), &["scenes"]).stdout;
    let lines: Vec<&str> = stdout.lines().collect();
    assert_eq!(lines.len(), scenes::all().len());
    for (line, scene) in lines.iter().zip(scenes::all()) {
        let (name, summary) = line.split_once(' ').unwrap();
        assert_eq!((name, summary.trim_start()), (scene.name, scene.summary));
    }
}

#[test]
fn scenes_prints_a_text_that_is_read_without_a_word() {
    for scene in scenes::all() {
        let text = succeed(&folder(), &["scenes", scene.name]).stdout;
        assert_eq!(text, scene.source());
        let parsed = scene_format::parse(scene.name, &text, &scene_format::NoFiles);
        assert!(parsed.diagnostics.is_empty(), "{}: {:#?}", scene.name, parsed.diagnostics);
    }
}

#[test]
fn a_scene_that_was_written_gives_the_same_picture() {
    // Without and with textures.
    for name in ["pyramid", "textures"] {
        let folder = folder();
        let small = ["--size", "40x30", "--aa", "0", "--samples", "1", "--quiet"];
        succeed(&folder, &["scenes", name, "--write", "out/here"]);
        succeed(&folder, &[&["render", name, "-o", "embedded.png"][..], &small].concat());
        let written = format!("out/here/{name}.sc");
        succeed(&folder, &[&["render", &written, "-o", "written.png"][..], &small].concat());
        assert_eq!(folder.read("embedded.png"), folder.read("written.png"), "{name}");
    }
}

#[test]
fn check_says_that_a_scene_can_be_rendered_and_writes_nothing() {
    let folder = folder();
    let ended = succeed(&folder, &["check", "tiny.sc"]);
    assert_eq!(ended.stderr, "`tiny.sc` can be rendered: no errors or warnings\n");
    assert_eq!((ended.stdout.as_str(), folder.names().len()), ("", 1));
}

#[test]
fn check_fails_for_a_scene_that_cannot_be_rendered() {
    let ended = folder().with("bad.sc", "object {").run(&["check", "bad.sc"]);
    assert_eq!(ended.code, Some(1), "{}", ended.stderr);
}

#[test]
fn every_embedded_scene_passes_check() {
    for scene in scenes::all() {
        let expected = format!("`{}.sc` can be rendered: no errors or warnings\n", scene.name);
        assert_eq!(succeed(&folder(), &["check", scene.name]).stderr, expected);
    }
}

#[test]
fn inspect_shows_what_a_scene_needs_and_what_it_does_not() {
    let stdout = succeed(&folder(), &["inspect", "tiny.sc", "--aa", "1", "--samples", "3"]).stdout;
    let (needs, _) = stdout.split_once("\n\n").expect("a table below it");
    // How much memory the parts take is theirs to change.
    let (memory, rest): (Vec<&str>, Vec<&str>) = needs.lines().partition(|line| line.starts_with("  memory"));
    assert!(memory.len() == 1 && memory[0].contains("bytes"), "{memory:?}");
    insta::assert_snapshot!(rest.join("\n"));
}

#[test]
fn inspect_holds_the_accelerators_against_each_other() {
    let rows = |arguments: &[&str]| -> Vec<Vec<String>> {
        let stdout = succeed(&folder(), &[&["inspect", "pyramid"], arguments].concat()).stdout;
        let rows = stdout.lines().filter(|line| line.starts_with("| ")).skip(2);
        rows.map(|row| row.trim_matches('|').split('|').map(|cell| cell.trim().to_owned()).collect()).collect()
    };
    let usual = rows(&[]);
    let names: Vec<&str> = usual.iter().map(|row| &*row[0]).collect();
    assert_eq!(names, ["none", "octree", "wide"]);
    let number = |row: usize, column: usize| usual[row][column].parse::<f64>().expect("a number");
    // Without an accelerator a ray asks each primitive, and that is what it is expected to cost.
    assert_eq!(number(0, 4), number(0, 10));
    assert_eq!(number(0, 4), number(0, 7));
    for row in [1, 2] {
        assert!(number(row, 10) < number(0, 10), "{usual:?}");
        assert!(usual[row][8].ends_with(" ms"), "{usual:?}");
    }
    let watertight = rows(&["--hits", "watertight"]);
    assert_eq!((watertight.len(), &*watertight[3][0]), (4, "chosen"));
}

#[test]
fn inspect_says_how_rays_and_lights_are_sampled() {
    let rays = |arguments: &[&str]| {
        let stdout = succeed(&folder(), &[&["inspect"], arguments].concat()).stdout;
        stdout.lines().find(|line| line.starts_with("  rays")).unwrap()[17..].to_owned()
    };
    assert_eq!(
        rays(&["tiny.sc", "--aa", "1,2", "--adaptive=0.2"]),
        "up to 3,200 from the camera: 4 to 16 a pixel, more where its neighbours differ by 0.2"
    );
    // Its two lights become 27 each; of each a pixel's 16 rays ask 7.
    let soft = ["shadows-soft", "--size", "10x10", "--aa", "2"];
    let sixteen = "1,600 from the camera: 16 a pixel (4 x 4 zones, 1 in each); up to";
    assert_eq!(rays(&soft), format!("{sixteen} 14 to lights from each point seen"));
    for (light_samples, asked) in [("all", 54), ("1", 2), ("5", 10), ("shared", 14)] {
        let found = rays(&[&soft[..], &["--light-samples", light_samples]].concat());
        assert_eq!(found, format!("{sixteen} {asked} to lights from each point seen"));
    }
}

#[test]
fn samplers_and_adaptive_rays_change_the_picture() {
    let folder = folder();
    let picture = |options: &[&str]| {
        succeed(&folder, &[&["render", "tiny.sc", "-o", "a.png", "--quiet", "--aa", "2"], options].concat());
        folder.read("a.png")
    };
    let usual = picture(&[]);
    assert_eq!(usual, picture(&["--sampler", "sobol"]));
    assert_ne!(usual, picture(&["--sampler", "random"]));
    assert_ne!(usual, picture(&["--adaptive"]));
    assert_eq!(picture(&["--adaptive"]), picture(&["--adaptive=0.1"]));
    assert_ne!(picture(&["--adaptive"]), picture(&["--adaptive=0.9"]));
}

#[test]
fn completions_for_bash_name_every_command() {
    let script = succeed(&folder(), &["completions", "bash"]).stdout;
    for word in ["_girasol()", "render", "check", "inspect", "scenes", "bench", "completions", "--soft-shadows"] {
        assert!(script.contains(word), "{word}");
    }
}

#[test]
fn help_names_every_command() {
    let help = succeed(&folder(), &["--help"]).stdout;
    for word in ["render", "check", "inspect", "scenes", "bench", "completions", "Exit codes"] {
        assert!(help.contains(word), "{word}");
    }
}

#[test]
fn bench_prints_a_table_with_and_without_the_accelerator() {
    let folder = folder();
    let ended = succeed(&folder, &["bench", "tiny.sc", "--limit", "20", "--threads", "2", "--quiet", "-o", "table.md"]);
    let lines: Vec<&str> = ended.stdout.lines().collect();
    assert_eq!(lines.len(), 3, "{}", ended.stdout);
    let cells =
        |line: &str| -> Vec<String> { line.trim_matches('|').split('|').map(|cell| cell.trim().to_owned()).collect() };
    let (heading, row) = (cells(lines[0]), cells(lines[2]));
    assert_eq!(heading[..7], ["scene", "pixels", "primitives", "1 thread", "2 threads", "ratio", "without, 2 thr."]);
    assert_eq!(row[..3], ["tiny", "20 x 10", "1"]);
    assert!(row[3..5].iter().chain([&row[6]]).all(|time| time.ends_with(" s")), "{row:?}");
    assert_eq!(folder.read("table.md"), ended.stdout.as_bytes());
    assert_eq!(ended.stderr, "");
}

#[test]
fn bench_gives_up_without_the_accelerator_at_its_limit() {
    let arguments = ["bench", "spheres64", "--limit", "0.001", "--size", "200x150", "--aa", "0", "--quiet"];
    let table = succeed(&folder(), &arguments).stdout;
    assert!(table.contains("> 0.001 s"), "{table}");
}

#[test]
fn quiet_prints_nothing() {
    // Not even the warning that an object has no shader.
    let folder = folder().with("warned.sc", SCENE.replace("shader white type sphere", "type sphere"));
    for scene in ["tiny.sc", "warned.sc"] {
        let ended = succeed(&folder, &["render", scene, "--quiet"]);
        assert_eq!((ended.stdout.as_str(), ended.stderr.as_str()), ("", ""));
    }
    assert!(!succeed(&folder, &["render", "warned.sc"]).stderr.is_empty());
}

#[test]
fn a_rendering_tells_the_picture_s_name_and_size() {
    let ended = succeed(&folder(), &["render", "tiny.sc"]);
    assert!(ended.stderr.starts_with("tiny.png: 20 x 10 pixels in 0."), "{}", ended.stderr);
    assert_eq!(ended.stdout, "");
}

#[test]
fn time_shows_each_part_and_the_rays() {
    let ended = succeed(&folder(), &["render", "tiny.sc", "--time", "--quiet"]);
    let lines: Vec<Vec<&str>> = ended.stderr.lines().map(|line| line.split_whitespace().collect()).collect();
    let names: Vec<&str> = lines.iter().map(|line| line[0]).collect();
    assert_eq!(names, ["reading", "assembling", "rendering", "writing", "rays"]);
    for line in &lines[..4] {
        assert!(line[1].parse::<f64>().is_ok_and(|seconds| seconds < 10.0) && line[2] == "s", "{line:?}");
    }
    assert_eq!(lines[4][1..7], ["200", "camera,", "0", "secondary,", "0", "shadow:"]);
}

/// Neither pixels nor what comes before them, here nearly all: a mesh is generated, and a tree built.
#[test]
#[cfg(unix)]
fn one_thread_takes_no_more_of_the_processors_than_the_clock_says() {
    let folder = folder();
    let mut shell = folder.command_of("sh".as_ref(), &["-c", "\"$@\" && times", "sh", PROGRAM]);
    shell.args(["render", "organic", "--size", "64x48", "--quiet", "--threads", "1"]);
    let start = Instant::now();
    let output = shell.output().unwrap();
    let clock = start.elapsed().as_secs_f64();
    // The last line is of what the shell has started: `0m0.412s 0m0.013s`, the program's own and the system's.
    let stdout = String::from_utf8(output.stdout).unwrap();
    let seconds = stdout.lines().last().unwrap().split_whitespace().map(|time| {
        let (minutes, seconds) = time.strip_suffix('s').unwrap().split_once('m').unwrap();
        60.0 * minutes.parse::<f64>().unwrap() + seconds.parse::<f64>().unwrap()
    });
    let taken: f64 = seconds.sum();
    assert!(taken > 0.05 && taken < 1.1 * clock, "{taken} s of {clock}");
}

#[test]
fn a_picture_is_called_like_its_scene_unless_told_otherwise() {
    let folder = folder();
    succeed(&folder, &["render", "tiny.sc"]);
    succeed(&folder, &["render", "pyramid", "--size", "8x6"]);
    assert!(folder.read("tiny.png").starts_with(b"\x89PNG"));
    assert!(folder.read("pyramid.png").starts_with(b"\x89PNG"));
}

#[test]
fn the_ending_of_the_output_says_its_format() {
    let folder = folder();
    for (name, magic) in
        [("x.bmp", &b"BM"[..]), ("x.exr", b"\x76\x2f\x31\x01"), ("x.png", b"\x89PNG"), ("y.PNG", b"\x89PNG")]
    {
        succeed(&folder, &["render", "tiny.sc", "-o", name]);
        assert!(folder.read(name).starts_with(magic), "{name}");
    }
}

#[test]
fn a_file_goes_before_a_built_in_scene_of_its_name() {
    let folder = folder().with("pyramid", SCENE);
    let ended = succeed(&folder, &["render", "pyramid"]);
    assert!(ended.stderr.starts_with("pyramid.png: 20 x 10 pixels"), "{}", ended.stderr);
}

#[test]
fn every_option_that_changes_the_picture_does() {
    let folder = folder();
    let picture = |options: &[&str]| {
        succeed(&folder, &[&["render", "shadows-hard", "--size", "40x30", "-o", "a.exr"], options].concat());
        folder.read("a.exr")
    };
    let usual = picture(&[]);
    for options in [
        &["--aa", "0"][..],
        &["--samples", "2"],
        &["--seed", "1"],
        &["--falloff", "log"],
        &["--soft-shadows"],
        &["--crop", "1,2,30,20"],
    ] {
        assert!(picture(options) != usual, "{options:?}");
    }
    for options in [&["--threads", "1"][..], &["--bucket", "5,reverse-spiral"], &["--accelerator", "none"], &["--time"]]
    {
        assert!(picture(options) == usual, "{options:?}");
    }
    let dark = |options: &[&str]| {
        succeed(&folder, &[&["render", "tiny.sc", "-o", "b.exr"], options].concat());
        folder.read("b.exr")
    };
    assert!(dark(&["--ambient", "0.5"]) != dark(&[]));
    assert!(dark(&["--ambient", "0.05"]) == dark(&[]));
}

#[test]
fn a_scene_meant_for_soft_shadows_gets_them() {
    let folder = folder();
    for (name, options) in [("a.exr", &[][..]), ("b.exr", &["--soft-shadows=3,0.1"]), ("c.exr", &["--soft-shadows=1"])]
    {
        succeed(&folder, &[&["render", "shadows-soft", "--size", "40x30", "-o", name], options].concat());
    }
    assert!(folder.read("a.exr") == folder.read("b.exr"));
    assert!(folder.read("a.exr") != folder.read("c.exr"));
}

#[test]
fn a_long_rendering_tells_its_share_and_the_time_left_in_plain_lines() {
    let folder = folder();
    let arguments = ["render", "marbles", "--size", "640x480", "--samples", "200", "--threads", "1", "--bucket", "16"];
    let mut child = folder.command(&arguments).stderr(Stdio::piped()).spawn().unwrap();
    // Longer than the five seconds between two lines.
    let start = Instant::now();
    while child.try_wait().unwrap().is_none() && start.elapsed() < Duration::from_millis(7_500) {
        std::thread::sleep(Duration::from_millis(50));
    }
    child.kill().unwrap();
    let mut stderr = String::new();
    child.stderr.take().unwrap().read_to_string(&mut stderr).unwrap();
    child.wait().unwrap();
    // 640 x 480 pixels in buckets of 16: 40 x 30.
    let words: Vec<&str> = stderr.lines().next().unwrap_or_default().split_whitespace().collect();
    assert!(
        matches!(words[..], [share, "%", "of", "1200", "buckets,", left, "s", "left"]
            if share.parse::<u32>().is_ok() && left.parse::<f64>().is_ok()),
        "{stderr}"
    );
}

#[test]
fn ambient_light_where_sunflow_has_none_is_an_error_that_says_so() {
    let ended = folder().run(&["render", "tiny.sc", "--lighting", "sunflow", "--ambient", "0.2"]);
    assert_eq!(ended.code, Some(1));
    assert!(ended.stderr.contains("`--ambient` has no meaning with `--lighting sunflow`"), "{}", ended.stderr);
    assert!(ended.stderr.contains("leave one of the two out"), "{}", ended.stderr);
    succeed(&folder(), &["render", "tiny.sc", "--lighting", "sunflow", "-q"]);
    succeed(&folder(), &["render", "tiny.sc", "--ambient", "0.2", "-q"]);
}

#[test]
fn accuracy_writes_a_page_and_the_same_numbers_for_programs() {
    let folder = folder();
    let ended = succeed(&folder, &["accuracy", "--quick", "--scenes", "globe", "-o", "page.html"]);
    assert!(ended.stderr.contains("page.html"), "{}", ended.stderr);
    let page = String::from_utf8(folder.read("page.html")).unwrap();
    assert!(
        page.starts_with("<!DOCTYPE html>") && page.contains("data:image/png;base64,") && !page.contains("<script")
    );
    let numbers = String::from_utf8(folder.read("page.json")).unwrap();
    assert!(
        numbers.starts_with('{')
            && numbers.contains("\"p99.9\"")
            && numbers.contains("\"globe\"")
            && numbers.ends_with("}\n")
    );
}

#[test]
fn accuracy_turns_down_one_name_for_both_files_before_it_measures() {
    let folder = folder();
    let ended = folder.run(&["accuracy", "-o", "both.json"]);
    assert_eq!(ended.code, Some(1), "{}", ended.stderr);
    assert!(ended.stderr.contains("choose two names"), "{}", ended.stderr);
    assert!(!folder.names().contains("both.json"));
}

#[test]
fn naive_kernels_change_the_picture_of_a_hard_scene_one_by_one() {
    let folder = folder();
    let rendered = |name: &str, more: &[&str]| {
        let size = ["render", "scales", "--size", "80x24", "--aa", "0", "-q", "-o", name];
        succeed(&folder, &[&size, more].concat());
        folder.read(name)
    };
    let robust = rendered("robust.bmp", &[]);
    for kernel in ["sphere", "triangle", "offset", "sphere,offset", "all"] {
        assert_ne!(rendered("naive.bmp", &["--naive", kernel]), robust, "{kernel}");
    }
    // There is neither in the scene.
    for kernel in ["plane", "ellipsoid"] {
        assert_eq!(rendered("naive.bmp", &["--naive", kernel]), robust, "{kernel}");
    }
}

/// Eight triangles in one plane: the box around them is flat, and the naive box test loses it.
#[test]
fn the_naive_box_test_loses_what_is_flat() {
    let fan =
        "object { shader white type generic-mesh name fan points 9 0 0 0  3 0 0  2 0 2  0 0 3  -2 0 2  -3 0 0  -2 0 -2
        0 0 -3  2 0 -2  triangles 8  0 1 2  0 2 3  0 3 4  0 4 5  0 5 6  0 6 7  0 7 8  0 8 1  normals none uvs none }
";
    let folder = folder().with("fan.sc", SCENE.replace("object { shader white type sphere c 0 0 0 r 1 }\n", fan));
    let is_black = |more: &[&str]| {
        succeed(&folder, &[&["render", "fan.sc", "-q", "-o", "fan.bmp", "--aa", "0"], more].concat());
        // Behind the header of 54 bytes.
        folder.read("fan.bmp")[54..].iter().all(|&byte| byte == 0)
    };
    assert!(!is_black(&["--accelerator", "octree"]));
    assert!(is_black(&["--naive", "box"]));
    assert!(!is_black(&["--naive", "box", "--accelerator", "none"]));
}

#[test]
fn compare_says_that_another_way_to_the_same_picture_is_equal() {
    let folder = folder();
    let arguments = ["compare", "tiny.sc", "--accelerator", "octree", "--with", "accelerator=default", "--repeat", "1"];
    let ended = succeed(&folder, &arguments);
    let lines: Vec<&str> = ended.stdout.lines().collect();
    assert_eq!(lines[0], "`accelerator` of this program against the reference's: tiny, 20 x 10 pixels");
    assert!(lines[6].starts_with("| rays") && lines[6].matches(" 200 |").count() == 2, "{}", ended.stdout);
    assert_eq!(lines.last(), Some(&"equal: every pixel has the same bits"));
    assert_eq!(ended.stderr, "tiny-compare.html: both pictures, their difference, and a slider\n");
    let page = String::from_utf8(folder.read("tiny-compare.html")).unwrap();
    assert_eq!(page.matches("src=\"data:image/png;base64,").count(), 6);
    assert!(page.contains("type=\"range\"") && !page.contains("http"), "{page}");
}

#[test]
fn compare_names_the_first_pixel_that_differs_and_how_far_the_pictures_are_apart() {
    let scene = SCENE.replace("type constant color 1 1 1", "type diffuse diff 1 1 1");
    let lit = format!("{scene}light {{ type point color 1 1 1 power 10 p 0 -5 0 }}\n");
    let folder = folder().with("lit.sc", lit);
    let ended = succeed(&folder, &["compare", "lit.sc", "--falloff", "log", "-o", "page.html", "--aa", "0", "--quiet"]);
    assert!(ended.stdout.starts_with("`falloff` of this program"), "{}", ended.stdout);
    let verdict: Vec<&str> = ended.stdout.lines().rev().take(2).collect();
    assert!(
        verdict[1].starts_with("different: ") && verdict[1].contains(" of 200 pixels; the first is column "),
        "{verdict:?}"
    );
    assert!(verdict[0].starts_with("RMSE 2.0") && verdict[0].contains("FLIP 0."), "{verdict:?}");
    assert!(!folder.read("page.html").is_empty());
    assert_eq!(ended.stderr, "");
}

#[test]
fn compare_without_a_part_of_one_s_own_says_what_to_do() {
    for (with, said) in [
        (&[][..], "every part of this program is the reference's"),
        (&["--with", "sphere=default,plane=default"], "`sphere` and `plane` is the reference's in this program"),
    ] {
        let ended = folder().run(&[&["compare", "tiny.sc"], with].concat());
        assert_eq!(ended.code, Some(1));
        assert!(ended.stderr.contains(said) && ended.stderr.contains("girasol new"), "{}", ended.stderr);
    }
    let ended = folder().run(&["compare", "tiny.sc", "--accelerator", "none", "--with", "sphere=default"]);
    assert!(ended.stderr.contains("this program has `accelerator` of its own"), "{}", ended.stderr);
    let ended = folder().run(&["compare", "tiny.sc", "--with", "acelerator=default"]);
    assert_eq!(ended.code, Some(2));
    assert!(ended.stderr.contains("did you mean `accelerator`?"), "{}", ended.stderr);
}
