use std::io::Read;
use std::process::{Child, Command, ExitStatus, Stdio};
use std::sync::{Arc, Mutex, PoisonError};
use std::thread;
use std::time::{Duration, Instant};

use serde_json::Value;
use tempfile::TempDir;

use super::{Limits, Reason};
use crate::report::Failure;

/// How often a process is asked whether it has ended.
const BETWEEN_LOOKS: Duration = Duration::from_millis(5);

/// So much of what a process says is kept, from the end.
const KEPT: usize = 2_000;

/// Runs this program once more, with arguments and `--result FILE`, until it has written a result to that file, or died, or the time is up.
/// What it says on stdout is lost.
pub(crate) fn run(arguments: &[String], limits: Limits) -> Result<Result<Value, Reason>, Failure> {
    let program = std::env::current_exe().map_err(|error| Failure::of("this program cannot find itself", error))?;
    let folder = TempDir::new().map_err(|error| Failure::of("a temporary folder cannot be made", error))?;
    let result = folder.path().join("result.json");
    let mut command = Command::new(&program);
    command.args(arguments).arg("--result").arg(&result).env("RUST_BACKTRACE", "0");
    command.stdin(Stdio::null()).stdout(Stdio::null()).stderr(Stdio::piped());
    let mut child = command.spawn().map_err(|error| Failure::of("this program cannot be started once more", error))?;
    let said = listen(&mut child);
    let ended = wait(&mut child, limits.time).map_err(|error| Failure::of("a process cannot be waited for", error))?;
    let Some(status) = ended else { return Ok(Err(Reason::Time(limits.time.as_millis() as u64))) };
    let written = std::fs::read(&result).ok().and_then(|bytes| serde_json::from_slice(&bytes).ok());
    match written {
        Some(value) if status.success() => Ok(Ok(value)),
        _ => Ok(Err(reason(status, &last_words(&said), limits))),
    }
}

/// Waits for the end, or makes it when the time is up: then `None`.
fn wait(child: &mut Child, limit: Duration) -> std::io::Result<Option<ExitStatus>> {
    let start = Instant::now();
    loop {
        if let Some(status) = child.try_wait()? {
            return Ok(Some(status));
        }
        if start.elapsed() >= limit {
            child.kill()?;
            child.wait()?;
            return Ok(None);
        }
        thread::sleep(BETWEEN_LOOKS);
    }
}

/// Keeps the last that a process says, however much it is.
fn listen(child: &mut Child) -> Arc<Mutex<Vec<u8>>> {
    let said = Arc::new(Mutex::new(Vec::new()));
    if let Some(mut stderr) = child.stderr.take() {
        let kept = Arc::clone(&said);
        thread::spawn(move || {
            let mut some = [0; 4096];
            while let Ok(length @ 1..) = stderr.read(&mut some) {
                let mut kept = kept.lock().unwrap_or_else(PoisonError::into_inner);
                kept.extend_from_slice(&some[..length]);
                let surplus = kept.len().saturating_sub(KEPT);
                kept.drain(..surplus);
            }
        });
    }
    said
}

/// What was kept; the thread that listens may be a moment behind.
fn last_words(said: &Mutex<Vec<u8>>) -> String {
    thread::sleep(BETWEEN_LOOKS);
    String::from_utf8_lossy(&said.lock().unwrap_or_else(PoisonError::into_inner)).trim().to_owned()
}

/// Why a process died, from how it ended and its last words, which are those of Rust's runtime.
fn reason(status: ExitStatus, said: &str, limits: Limits) -> Reason {
    if said.contains("has overflowed its stack") {
        Reason::Stack
    } else if said.contains("memory allocation of") {
        Reason::Memory(limits.memory)
    } else if said.is_empty() {
        Reason::Other(status.to_string())
    } else {
        Reason::Other(format!("{status}; it said: {said}"))
    }
}

#[cfg(all(test, unix))]
mod tests {
    use super::*;

    fn shell(script: &str) -> Child {
        Command::new("sh").args(["-c", script]).stderr(Stdio::piped()).spawn().unwrap()
    }

    #[test]
    fn a_process_is_ended_at_the_limit_and_not_before() {
        let start = Instant::now();
        assert!(
            wait(&mut shell("exit 3"), Duration::from_secs(60)).unwrap().is_some_and(|status| status.code() == Some(3))
        );
        assert!(wait(&mut shell("exec sleep 60"), Duration::from_millis(50)).unwrap().is_none());
        assert!(start.elapsed() < Duration::from_secs(30));
    }

    #[test]
    fn of_much_that_is_said_the_end_is_kept() {
        let mut child = shell("yes 0123456789 | head -c 1000000 >&2; echo the end >&2");
        let said = listen(&mut child);
        child.wait().unwrap();
        // The listener has all there is when it has the end.
        let start = Instant::now();
        while !last_words(&said).ends_with("the end") && start.elapsed() < Duration::from_secs(30) {}
        assert!(last_words(&said).ends_with("the end"));
        assert!(last_words(&said).len() <= KEPT);
    }

    #[test]
    fn a_death_is_told_by_its_last_words() {
        let limits = Limits { time: Duration::from_secs(1), memory: 64 };
        let status = shell("kill -ABRT $$").wait().unwrap();
        assert_eq!(reason(status, "thread 'law' has overflowed its stack\nfatal runtime error", limits), Reason::Stack);
        assert_eq!(reason(status, "memory allocation of 99 bytes failed", limits), Reason::Memory(64));
        assert!(matches!(reason(status, "", limits), Reason::Other(how) if how.contains("signal: 6")));
        assert!(matches!(reason(status, "bye", limits), Reason::Other(how) if how.ends_with("it said: bye")));
    }
}
