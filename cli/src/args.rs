#[cfg(feature = "conformance")]
mod course;

use std::path::PathBuf;

use clap::builder::PossibleValuesParser;
use clap::{Args, Parser, Subcommand, ValueEnum};
use clap_complete::Shell;

use crate::accuracy::instructions::KernelRun;
use crate::compare::{Parts, parse_parts};
use crate::options::{RenderOptions, parse_positive_seconds};
use crate::scenes;
#[cfg(feature = "conformance")]
pub(crate) use course::{ExamineArguments, ExamineSpeedArguments, GradeArguments, NewArguments, ResultArguments};

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
    ///
    /// Of a folder, a table of all .sc files in it and in the folders below: what there is to say about each, and whether it renders.
    Check(CheckArguments),
    /// Lay a scene's text out in one style, comments and all.
    Fmt(FmtArguments),
    /// Say more about a message by its code, with an example that is wrong and one that is right.
    ExplainError(ExplainArguments),
    /// Write a scene around a mesh: a camera that frames it, a light and a floor.
    Convert(ConvertArguments),
    /// Show what a scene needs and what it will cost.
    Inspect(InspectArguments),
    /// List the built-in scenes, print one, or write it to a folder.
    Scenes(ScenesArguments),
    /// Render scenes with and without the accelerator and print a table of times.
    Bench(BenchArguments),
    /// Measure speed against error of every kernel, naive ones beside ours, and write a page of figures.
    Accuracy(AccuracyArguments),
    /// Render a scene with this program's own parts and with the reference's, and say whether the pictures are equal and what each took.
    ///
    /// Writes a page with both pictures, their difference, and a slider.
    Compare(CompareArguments),
    /// Make a crate for a part of one's own: a stub, its laws as tests, the task.
    ///
    /// It is a whole renderer whose other parts are girasol's. A mere NAME inside of girasol's checkout makes it beside the checkout.
    #[cfg(feature = "conformance")]
    New(NewArguments),
    /// Try the laws of the parts that this program has of its own, and say which are kept, with points.
    ///
    /// Each law is tried in a process of its own: an endless loop or a crash costs its own points and no others. The exit code is 0 whatever
    /// the score; `cargo test` in the crate of a part fails if a law is broken.
    #[cfg(feature = "conformance")]
    Grade(GradeArguments),
    /// Try one law and write what came of it to a file.
    #[cfg(feature = "conformance")]
    #[command(hide = true)]
    Examine(ExamineArguments),
    /// Measure the time of a scene against the reference's and write it to a file.
    #[cfg(feature = "conformance")]
    #[command(hide = true)]
    ExamineSpeed(ExamineSpeedArguments),
    /// Hold scenes, lit as by Sunflow, against Sunflow's own pictures of them, and print a table of differences.
    ///
    /// A scene misses its target if less than 99.5 % of its pixels are within 2 of 255 in every channel, or if another one is off and no
    /// edge passes within 1/50 of a pixel of its ray; one with a lens if its RMSE is above 0.01.
    Parity(ParityArguments),
    /// Print completions for a shell.
    ///
    /// For bash: girasol completions bash > ~/.local/share/bash-completion/completions/girasol
    Completions(CompletionsArguments),
}

impl Command {
    /// How a scene is to be rendered, where one is.
    pub(crate) fn render_options(&self) -> Option<&RenderOptions> {
        match self {
            Self::Render(RenderArguments { options, .. })
            | Self::Inspect(InspectArguments { options, .. })
            | Self::Bench(BenchArguments { options, .. })
            | Self::Compare(CompareArguments { options, .. }) => Some(options),
            _ => None,
        }
    }
}

#[derive(Debug, Args)]
pub(crate) struct SceneArgument {
    /// A built-in scene, or the path of a .sc file.
    pub(crate) scene: String,
}

#[derive(Debug, Args)]
pub(crate) struct CheckArguments {
    /// A built-in scene, the path of a .sc file, or a folder of them.
    pub(crate) scene: String,
    /// How to say it: text for people, or one JSON object a line for tools, on stdout.
    #[arg(long, value_name = "FORMAT", default_value = "text")]
    pub(crate) format: MessageFormat,
    /// Fail if there is a warning.
    #[arg(long)]
    pub(crate) strict: bool,
}

/// How messages are written.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum MessageFormat {
    /// For people, on stderr.
    Text,
    /// For tools, on stdout.
    Json,
}

#[derive(Debug, Args)]
pub(crate) struct FmtArguments {
    /// A built-in scene, or the path of a .sc file; the text is printed.
    pub(crate) scene: String,
    /// Print nothing, and fail if the text is not laid out like this.
    #[arg(long, conflicts_with = "write")]
    pub(crate) check: bool,
    /// Put the text in the file's place instead of printing it.
    #[arg(short, long)]
    pub(crate) write: bool,
}

#[derive(Debug, Args)]
pub(crate) struct ConvertArguments {
    /// A mesh: .obj, .stl, .ply or .ra3.
    pub(crate) mesh: PathBuf,
    /// The scene to write. [default: the mesh's name with .sc]
    #[arg(short, long, value_name = "FILE")]
    pub(crate) output: Option<PathBuf>,
    /// The axis that points upwards. [default: y for .obj, else z]
    #[arg(long, value_name = "AXIS")]
    pub(crate) up: Option<Axis>,
    /// Give a mesh that has no normals those that let it look round.
    #[arg(long)]
    pub(crate) smooth: bool,
}

/// Which way is up.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum Axis {
    /// As in most pictures.
    Y,
    /// As in the course's scenes.
    Z,
}

#[derive(Debug, Args)]
pub(crate) struct ExplainArguments {
    /// The code that stands in brackets before a message, like SC107; all are listed without it.
    pub(crate) code: Option<String>,
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
    /// Render nothing if there is a warning.
    #[arg(long)]
    pub(crate) strict: bool,
    /// Paint the pixels with rays whose light is no number (NaN, infinite, or too much to add up) in magenta, on the picture
    /// dimmed to a quarter.
    #[arg(long)]
    pub(crate) show_nan: bool,
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
    /// The built-in scenes that image errors are measured with. [default: all of them]
    #[arg(long, value_name = "NAME,...", value_delimiter = ',', value_parser = scene_names())]
    pub(crate) scenes: Vec<String>,
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

fn scene_names() -> PossibleValuesParser {
    scenes::all().iter().map(|scene| scene.name).into()
}

#[derive(Debug, Args)]
pub(crate) struct CompareArguments {
    #[command(flatten)]
    pub(crate) scene: SceneArgument,
    /// The parts to set back to the reference's, as in accelerator=default,shaders=default. [default: all that this program has of its own]
    #[arg(long, value_name = "PART=default,...", value_delimiter = ',', value_parser = parse_parts)]
    pub(crate) with: Vec<Parts>,
    /// The page to write. [default: SCENE-compare.html]
    #[arg(short, long, value_name = "FILE")]
    pub(crate) output: Option<PathBuf>,
    /// Render this often with each, in turn, and show the medians.
    #[arg(long, value_name = "N", default_value = "3")]
    pub(crate) repeat: std::num::NonZeroU32,
    #[command(flatten)]
    pub(crate) options: RenderOptions,
    /// Show no progress.
    #[arg(short, long)]
    pub(crate) quiet: bool,
}

#[derive(Debug, Args)]
pub(crate) struct ParityArguments {
    /// A folder of scenes, NAME.sc each.
    pub(crate) scenes: PathBuf,
    /// The folder of Sunflow's pictures of them, NAME.png each.
    pub(crate) references: PathBuf,
    /// Write a picture of the differences of each scene to this folder: the lighter the more, red what no edge explains.
    #[arg(long, value_name = "FOLDER")]
    pub(crate) difference: Option<PathBuf>,
    /// Show no progress.
    #[arg(short, long)]
    pub(crate) quiet: bool,
}

#[derive(Debug, Args)]
pub(crate) struct CompletionsArguments {
    /// The shell to complete for.
    pub(crate) shell: Shell,
}
