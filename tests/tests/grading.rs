//! A program with a mirror of its own is graded: whatever it does in one law costs that law and no other.

use std::process::Output;

use tests::Folder;

const PROGRAM: &str = env!("CARGO_BIN_EXE_student-under-test");

/// The laws of a mirror; the last is the only one that asks for what the student's program does wrong.
const LAWS: usize = 11;
const ASKED_BY: &str = "a_mirror_casts_a_shadow";

/// Grades with a mistake; stdout and stderr.
fn graded(folder: &Folder, mistake: &str, options: &[&str]) -> (String, String) {
    let arguments = [&["grade", "--quiet", "--cases", "16"], options].concat();
    let Output { status, stdout, stderr } = folder.command(&arguments).env("MISTAKE", mistake).output().unwrap();
    let [stdout, stderr] = [stdout, stderr].map(|bytes| String::from_utf8(bytes).unwrap());
    assert_eq!(status.code(), Some(0), "{stderr}");
    (stdout, stderr)
}

/// Each law's result in the JSON.
fn results(folder: &Folder) -> Vec<(String, String)> {
    let json = String::from_utf8(folder.read("marks.json")).unwrap();
    let value = |line: &str| line.split('"').nth(3).unwrap_or_default().to_owned();
    let of = |name: &str| {
        let lines = json.lines().map(str::trim).filter(move |line| line.starts_with(&format!("\"{name}\":")));
        lines.map(value).collect::<Vec<_>>()
    };
    of("law").into_iter().zip(of("result")).collect()
}

#[test]
fn a_right_part_keeps_all_laws_and_its_time_is_measured() {
    let folder = Folder::for_program(PROGRAM);
    let (stdout, stderr) = graded(&folder, "", &["--scene", "pyramid"]);
    assert_eq!(stderr, "");
    assert_eq!(stdout.matches("| kept").count(), LAWS, "{stdout}");
    assert!(stdout.contains("| speed  | against the reference's time"), "{stdout}");
    assert!(stdout.contains("11 of 11 laws kept: 11 of 11 points; speed: "), "{stdout}");
}

#[test]
fn an_endless_loop_a_crash_and_a_panic_cost_their_own_law_and_no_other() {
    for (mistake, word, said) in [
        ("endless loop", "too long", "no answer within 2 s"),
        ("endless recursion", "too deep", "the stack overflowed"),
        ("endless memory", "too large", "more than 512 MiB of memory"),
        ("abort", "crashed", "SIGABRT"),
        ("exit", "crashed", "exit status: 0"),
        ("panic", "broken", "a panic: not today"),
    ] {
        let folder = Folder::for_program(PROGRAM);
        // Only the endless loop has to be waited for.
        let seconds = if mistake == "endless loop" { "2" } else { "60" };
        let limits = ["--no-speed", "--time-limit", seconds, "--memory-limit", "512"];
        let options = [&limits[..], &["--json", "marks.json", "--junit", "marks.xml"]].concat();
        let (stdout, _) = graded(&folder, mistake, &options);
        let results = results(&folder);
        assert_eq!(results.len(), LAWS, "{mistake}: {stdout}");
        for (law, result) in &results {
            let expected = if law == ASKED_BY { word } else { "kept" };
            assert_eq!(result, expected, "{mistake}, {law}: {stdout}");
        }
        assert!(stdout.contains(said), "{mistake}: {stdout}");
        assert!(stdout.contains("10 of 11 laws kept: 10 of 11 points"), "{mistake}: {stdout}");
        let errors = usize::from(word != "broken");
        let xml = String::from_utf8(folder.read("marks.xml")).unwrap();
        let totals = format!("tests=\"11\" failures=\"{}\" errors=\"{errors}\"", 1 - errors);
        assert_eq!(xml.matches(&totals).count(), 2, "{mistake}: {xml}");
    }
}

#[test]
fn weights_say_what_a_law_is_worth() {
    let weights = format!("default = 0.5\n[mirror]\n{ASKED_BY} = 7\n[speed]\npoints = 2\nfull = 1000\nnone = 1001\n");
    let folder = Folder::for_program(PROGRAM).with("weights.toml", weights);
    let options = ["--weights", "weights.toml", "--scene", "glass-mirror", "--gradescope", "results.json"];
    let (stdout, _) = graded(&folder, "abort", &options);
    // Ten laws of a half; of the scene's speed there is nothing to measure, as the mirror takes the process with it.
    assert!(stdout.contains("10 of 11 laws kept: 5 of 14 points; speed: not measured: "), "{stdout}");
    let (stdout, _) = graded(&folder, "", &options);
    assert!(stdout.contains("11 of 11 laws kept: 14 of 14 points"), "{stdout}");
    let results = String::from_utf8(folder.read("results.json")).unwrap();
    assert!(results.contains("\"score\": 14.0") && results.contains("\"leaderboard\""), "{results}");
}

#[test]
fn weights_of_what_does_not_exist_are_errors_that_say_where_and_what_was_meant() {
    for (weights, said) in [
        ("[miror]\n", "weights.toml:1: `miror` is not a part"),
        ("[mirror]\na_mirror_casts_a_shadw = 1\n", "weights.toml:2: `a_mirror_casts_a_shadw` is not a law of `mirror`"),
        ("default = -1\n", "weights.toml:1: `default` is -1"),
        ("mirror = 3\n", "weights.toml:1: `mirror` is 3, not a table"),
        ("[speed]\nfull = 3\nnone = 2\n", "`full` must be greater than 0, and less than `none`"),
        ("[speed\n", "`weights.toml` is no TOML"),
    ] {
        let folder = Folder::for_program(PROGRAM).with("weights.toml", weights);
        let ended = folder.run(&["grade", "--weights", "weights.toml"]);
        assert_eq!((ended.code, ended.stdout.as_str()), (Some(1), ""), "{weights}");
        assert!(ended.stderr.contains(said), "{weights}: {}", ended.stderr);
    }
    let folder = Folder::for_program(PROGRAM).with("weights.toml", "[miror]\n");
    let ended = folder.run(&["grade", "--weights", "weights.toml"]);
    assert!(ended.stderr.contains("did you mean `mirror`?"), "{}", ended.stderr);
}

#[test]
fn a_seed_makes_the_same_report_and_can_be_hidden() {
    let folder = Folder::for_program(PROGRAM);
    let report = |seed: &str, more: &[&str]| {
        let options = [&["--no-speed", "--seed", seed, "--json", "marks.json"], more].concat();
        let (stdout, _) = graded(&folder, "black", &options);
        let json = String::from_utf8(folder.read("marks.json")).unwrap();
        let same = |text: &str| text.lines().filter(|line| !line.contains("seconds")).collect::<Vec<_>>().join("\n");
        (stdout, same(&json))
    };
    let (stdout, json) = report("77", &[]);
    assert!(stdout.contains("--seed 77") && stdout.contains("case: Stage {"), "{stdout}");
    assert!(json.contains("\"seed\": 77") && json.contains("Stage {"));
    assert_eq!(json, report("77", &[]).1);
    let (stdout, json) = report("77", &["--hide-seed"]);
    assert!(stdout.contains("usually: nothing is returned yet"), "{stdout}");
    for hidden in ["77", "Stage {"] {
        assert!(!stdout.contains(hidden) && !json.contains(hidden), "{hidden}: {stdout}\n{json}");
    }
}

#[test]
fn a_program_without_a_part_of_its_own_says_what_can_be_graded() {
    let folder = Folder::for_program(env!("CARGO_BIN_EXE_girasol-under-test"));
    let ended = folder.run(&["grade"]);
    assert_eq!(ended.code, Some(1));
    assert!(ended.stderr.contains("there is nothing to grade") && ended.stderr.contains("`grade sphere plane`"));
    // The reference keeps its own laws.
    let ended = folder.run(&["grade", "mirror", "--no-speed", "--quiet", "--cases", "16"]);
    assert!(ended.stdout.contains("11 of 11 laws kept"), "{}{}", ended.stdout, ended.stderr);
}

#[test]
fn a_place_where_no_report_can_stand_is_turned_down_before_any_work() {
    let folder = Folder::for_program(PROGRAM);
    let ended = folder.run(&["grade", "--junit", "nowhere/marks.xml"]);
    assert_eq!((ended.code, ended.stdout.as_str()), (Some(1), ""));
    assert!(ended.stderr.contains("there is no folder `nowhere`"), "{}", ended.stderr);
}
