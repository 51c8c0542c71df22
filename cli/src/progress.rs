//! How far a rendering is: a bar on a terminal, a plain line now and then elsewhere.

use std::io::{IsTerminal, stderr};
use std::sync::{Mutex, PoisonError};
use std::time::{Duration, Instant};

use indicatif::{ProgressBar, ProgressStyle};

use crate::report;

/// The least time between two plain lines.
const BETWEEN_LINES: Duration = Duration::from_secs(5);

/// Shows the share of finished buckets with the time left, on stderr.
pub(crate) enum Progress {
    Silent,
    Bar(ProgressBar),
    Lines { parts: &'static str, started: Instant, last: Mutex<Instant> },
}

impl Progress {
    /// Begins a rendering, under a name.
    pub(crate) fn start(name: &str, quiet: bool) -> Self {
        Self::counting("buckets", name, quiet)
    }

    /// Begins something else that is done in so many parts.
    pub(crate) fn counting(parts: &'static str, name: &str, quiet: bool) -> Self {
        if quiet {
            return Self::Silent;
        }
        if !stderr().is_terminal() {
            let now = Instant::now();
            return Self::Lines { parts, started: now, last: Mutex::new(now) };
        }
        let bar = ProgressBar::new(0).with_message(name.to_owned());
        let template = format!("{{msg}} [{{wide_bar}}] {{percent:>3}} % of {{len}} {parts}, {{eta}} left");
        if let Ok(style) = ProgressStyle::with_template(&template) {
            bar.set_style(style.progress_chars("=> "));
        }
        Self::Bar(bar)
    }

    /// So many buckets are finished.
    pub(crate) fn advance(&self, finished: usize, total: usize) {
        match self {
            Self::Silent => {}
            Self::Bar(bar) => {
                bar.set_length(total as u64);
                bar.set_position(finished as u64);
            }
            Self::Lines { parts, started, last } => {
                let mut last = last.lock().unwrap_or_else(PoisonError::into_inner);
                if last.elapsed() >= BETWEEN_LINES && finished < total {
                    *last = Instant::now();
                    report::line(plain_line(parts, finished, total, started.elapsed()));
                }
            }
        }
    }

    /// Ends; a bar disappears.
    pub(crate) fn finish(&self) {
        if let Self::Bar(bar) = self {
            bar.finish_and_clear();
        }
    }
}

fn plain_line(parts: &str, finished: usize, total: usize, elapsed: Duration) -> String {
    let share = finished as f64 / total as f64;
    let left = elapsed.as_secs_f64() * (1.0 - share) / share;
    format!("{:3.0} % of {total} {parts}, {left:.0} s left", 100.0 * share)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_time_left_is_in_proportion_to_the_buckets_left() {
        assert_eq!(plain_line("buckets", 25, 100, Duration::from_secs(10)), " 25 % of 100 buckets, 30 s left");
    }
}
