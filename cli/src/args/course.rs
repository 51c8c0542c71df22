use std::num::{NonZeroU16, NonZeroU32};
use std::path::PathBuf;
use std::time::Duration;

use clap::Args;

use crate::grade::Limits;
use crate::options::parse_positive_seconds;
use crate::parts::Part;

#[derive(Debug, Args)]
pub(crate) struct NewArguments {
    /// The part that is to be one's own.
    #[arg(value_enum)]
    pub(crate) part: Part,
    /// What the crate is called, or a path whose last part is that.
    pub(crate) name: PathBuf,
    /// Where girasol's own crates are: the folder of a checkout, or the URL of a git repository. [default: the checkout that the current folder
    /// or this program lies in]
    #[arg(long, value_name = "PATH|GIT-URL")]
    pub(crate) girasol: Option<String>,
}

#[derive(Debug, Args)]
pub(crate) struct GradeArguments {
    /// The parts to grade. [default: all that this program has of its own]
    #[arg(value_enum)]
    pub(crate) parts: Vec<Part>,
    /// Points for each law and for speed: a TOML file with a table for each part. Without it each law has one point and speed none.
    #[arg(long, value_name = "FILE")]
    pub(crate) weights: Option<PathBuf>,
    /// Write the marks as JUnit XML.
    #[arg(long, value_name = "FILE")]
    pub(crate) junit: Option<PathBuf>,
    /// Write the marks as Gradescope's results.json.
    #[arg(long, value_name = "FILE")]
    pub(crate) gradescope: Option<PathBuf>,
    /// Write all that is known as JSON.
    #[arg(long, value_name = "FILE")]
    pub(crate) json: Option<PathBuf>,
    /// Try the same cases again. [default: PROPTEST_RNG_SEED, or another one each time]
    #[arg(long, value_name = "N")]
    pub(crate) seed: Option<u64>,
    /// Cases for a law of ordinary cost. [default: PROPTEST_CASES, or 256]
    #[arg(long, value_name = "N")]
    pub(crate) cases: Option<NonZeroU16>,
    /// Show neither the seed nor a case.
    #[arg(long)]
    pub(crate) hide_seed: bool,
    /// End a law after so many seconds.
    #[arg(long, value_name = "SECONDS", default_value = "20", value_parser = parse_positive_seconds)]
    pub(crate) time_limit: f64,
    /// The address space that a law may take, in MiB.
    #[arg(long, value_name = "MIB", default_value = "4096", value_parser = clap::value_parser!(u64).range(64..=1 << 24))]
    pub(crate) memory_limit: u64,
    /// The scene that speed is measured on.
    #[arg(long, default_value = "marbles")]
    pub(crate) scene: String,
    /// Measure no speed.
    #[arg(long)]
    pub(crate) no_speed: bool,
    /// Show no progress.
    #[arg(short, long)]
    pub(crate) quiet: bool,
}

impl GradeArguments {
    pub(crate) fn limits(&self) -> Limits {
        Limits { time: Duration::from_secs_f64(self.time_limit), memory: self.memory_limit }
    }
}

#[derive(Debug, Args)]
pub(crate) struct ExamineArguments {
    #[arg(value_enum)]
    pub(crate) part: Part,
    pub(crate) law: String,
    #[arg(long)]
    pub(crate) seed: u64,
    #[arg(long)]
    pub(crate) cases: u32,
    #[command(flatten)]
    pub(crate) result: ResultArguments,
}

#[derive(Debug, Args)]
pub(crate) struct ExamineSpeedArguments {
    pub(crate) scene: String,
    #[arg(long, default_value = "3")]
    pub(crate) rounds: NonZeroU32,
    #[command(flatten)]
    pub(crate) result: ResultArguments,
}

/// Where an answer goes, and what it may take.
#[derive(Debug, Args)]
pub(crate) struct ResultArguments {
    #[arg(long)]
    pub(crate) result: PathBuf,
    #[arg(long, value_parser = parse_positive_seconds)]
    time_limit: f64,
    #[arg(long)]
    memory_limit: u64,
}

impl ResultArguments {
    pub(crate) fn limits(&self) -> Limits {
        Limits { time: Duration::from_secs_f64(self.time_limit), memory: self.memory_limit }
    }
}
