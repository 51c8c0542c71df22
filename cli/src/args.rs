use std::path::PathBuf;

use clap::{Args, Parser, Subcommand};
use clap_complete::Shell;

use crate::accuracy::instructions::KernelRun;
use crate::options::{RenderOptions, parse_positive_seconds};

/// Renders Sunflow .sc scenes: the ray tracer of a computer-graphics course.
#[derive(Debug, Parser)]
#[command(name = "girasol", version, after_help = EXIT_CODES, max_term_width = 100)]
pub(crate) struct Arguments {
    #[command(subcommand)]
    pub(crate) command: Command,
}

const EXIT_CODES: &str = "\
A SCENE is the name of a built-in scene (see `girasol scenes`) or the path of a .sc file.

Exit codes: 0 all went well, 1 something failed (a message on stderr says what), 2 the command line is wrong, 130 interrupted.";

#[derive(Debug, Subcommand)]
pub(crate) enum Command {
    /// Render a scene to a picture.
    Render(RenderArguments),
    /// Read a scene and say everything that is wrong with it, without rendering.
    Check(SceneArgument),
    /// Show what a scene needs and what it will cost.
    Inspect(InspectArguments),
    /// List the built-in scenes, print one, or write it to a folder.
    Scenes(ScenesArguments),
    /// Render scenes with and without the accelerator and print a table of times.
    Bench(BenchArguments),
    /// Measure speed against error of every kernel, naive ones beside ours, and write a page of figures.
    Accuracy(AccuracyArguments),
    /// Print completions for a shell.
    ///
    /// For bash: girasol completions bash > ~/.local/share/bash-completion/completions/girasol
    Completions(CompletionsArguments),
}

#[derive(Debug, Args)]
pub(crate) struct SceneArgument {
    /// A built-in scene, or the path of a .sc file.
    pub(crate) scene: String,
}

#[derive(Debug, Args)]
pub(crate) struct RenderArguments {
    #[command(flatten)]
    pub(crate) scene: SceneArgument,
    /// The picture to write: .png and .bmp hold 8-bit sRGB, .exr linear 32-bit values. [default: the scene's name with .png]
    #[arg(short, long, value_name = "FILE")]
    pub(crate) output: Option<PathBuf>,
    #[command(flatten)]
    pub(crate) options: RenderOptions,
    /// Show no progress and no warnings: only errors.
    #[arg(short, long)]
    pub(crate) quiet: bool,
    /// Show where the time went: reading, assembling, rendering, writing.
    #[arg(long)]
    pub(crate) time: bool,
}

#[derive(Debug, Args)]
pub(crate) struct InspectArguments {
    #[command(flatten)]
    pub(crate) scene: SceneArgument,
    #[command(flatten)]
    pub(crate) options: RenderOptions,
}

#[derive(Debug, Args)]
pub(crate) struct ScenesArguments {
    /// The scene to print; all are listed without it.
    pub(crate) name: Option<String>,
    /// Write the scene and its textures to this folder instead of printing it.
    #[arg(long, value_name = "FOLDER", requires = "name")]
    pub(crate) write: Option<PathBuf>,
}

#[derive(Debug, Args)]
pub(crate) struct BenchArguments {
    /// Built-in scenes, .sc files, or folders of them. [default: all built-in scenes]
    pub(crate) scenes: Vec<String>,
    /// Give up on a rendering without the accelerator after this many seconds.
    #[arg(long, value_name = "SECONDS", default_value = "20", value_parser = parse_positive_seconds)]
    pub(crate) limit: f64,
    /// Render this often on one thread and on all, in turn, and show the medians.
    #[arg(long, value_name = "N", default_value = "1")]
    pub(crate) repeat: std::num::NonZeroU32,
    /// Also write the table, as Markdown, to this file.
    #[arg(short, long, value_name = "FILE")]
    pub(crate) output: Option<PathBuf>,
    #[command(flatten)]
    pub(crate) options: RenderOptions,
    /// Show no progress.
    #[arg(short, long)]
    pub(crate) quiet: bool,
}

#[derive(Debug, Args)]
pub(crate) struct AccuracyArguments {
    /// The page to write: one HTML file, with all figures in it.
    #[arg(short, long, value_name = "FILE", default_value = "accuracy.html")]
    pub(crate) output: PathBuf,
    /// The same numbers as JSON. [default: beside the page, with the ending .json]
    #[arg(long, value_name = "FILE")]
    pub(crate) json: Option<PathBuf>,
    /// Choose other random cases. The same seed gives the same errors on every run; times vary.
    #[arg(long, value_name = "N", default_value = "0")]
    pub(crate) seed: u64,
    /// A tenth of the cases, in a few seconds: for a first look.
    #[arg(long)]
    pub(crate) quick: bool,
    /// Run only this kernel, so often, and write nothing: for tools that count instructions.
    #[arg(long, value_name = "PRIMITIVE,WHOSE,PASSES", hide = true)]
    pub(crate) run_kernel: Option<KernelRun>,
    /// Show no progress.
    #[arg(short, long)]
    pub(crate) quiet: bool,
}

#[derive(Debug, Args)]
pub(crate) struct CompletionsArguments {
    /// The shell to complete for.
    pub(crate) shell: Shell,
}
