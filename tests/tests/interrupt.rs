//! Ctrl-C.
#![cfg(unix)]

use std::process::{Command, Stdio};
use std::thread::sleep;
use std::time::{Duration, Instant};

use tests::Folder;

const PROGRAM: &str = env!("CARGO_BIN_EXE_girasol-under-test");

#[test]
fn ctrl_c_ends_a_rendering_within_a_second_with_exit_code_130_and_leaves_no_file() {
    let folder = Folder::for_program(PROGRAM);
    // Hours of work.
    let arguments = ["render", "marbles", "--size", "4000x3000", "--samples", "256", "-o", "a.png"];
    let mut child = folder.command(&arguments).stderr(Stdio::piped()).spawn().unwrap();
    sleep(Duration::from_millis(700));
    assert!(child.try_wait().unwrap().is_none(), "it has ended by itself");
    let start = Instant::now();
    assert!(Command::new("kill").args(["-INT", &child.id().to_string()]).status().unwrap().success());
    while child.try_wait().unwrap().is_none() {
        if start.elapsed() > Duration::from_secs(10) {
            child.kill().unwrap();
        }
        sleep(Duration::from_millis(5));
    }
    let took = start.elapsed();
    let output = child.wait_with_output().unwrap();
    assert_eq!(output.status.code(), Some(130));
    assert!(took < Duration::from_secs(1), "{took:?}");
    assert!(folder.names().is_empty(), "{:?}", folder.names());
    assert!(String::from_utf8_lossy(&output.stderr).contains("interrupted"), "{output:?}");
}

#[test]
fn ctrl_c_leaves_the_picture_that_was_there() {
    let folder = Folder::for_program(PROGRAM).with("a.png", "the old picture");
    let arguments = ["render", "marbles", "--size", "4000x3000", "--samples", "256", "-o", "a.png", "--quiet"];
    let mut child = folder.command(&arguments).stderr(Stdio::null()).spawn().unwrap();
    sleep(Duration::from_millis(700));
    assert!(Command::new("kill").args(["-INT", &child.id().to_string()]).status().unwrap().success());
    assert_eq!(child.wait().unwrap().code(), Some(130));
    assert_eq!(folder.read("a.png"), b"the old picture");
    assert_eq!(folder.names().len(), 1);
}
