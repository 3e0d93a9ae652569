//! The arguments of the command line.

use std::path::PathBuf;

use clap::{Parser, Subcommand, ValueEnum};
use saute_kitchen::data::library::DEFAULT_SCALE;

use crate::bench_heat::BenchHeatArgs;
use crate::bench_paper::BenchPaperArgs;
use crate::class::ClassCommand;
use crate::fit::FitArgs;
use crate::gallery::GalleryArgs;
use crate::haptics::{CheckArgs, DevicesArgs};
use crate::output::wav_out::wav_rate;
use crate::picture::bench_frame::BenchFrameArgs;
use crate::picture::shot::{ShotArgs, every};
use crate::plan::PlanArgs;
use crate::study::StudyArgs;
use crate::sweep::SweepArgs;

/// Simulates a frying pan and the food in it. Without a command the window opens.
#[derive(Debug, Parser)]
#[command(name = "saute", version, after_help = EXIT_CODES)]
pub struct Args {
    /// Folder with your own foods/, pans/, hobs/, recipes/, kinetics/, coatings/ or oils/, doneness.toml, goals.toml or kitchen-at-home.toml. Its files are added to
    /// the shipped ones; a file of the same name replaces the shipped one.
    #[arg(long, global = true, value_name = "DIR")]
    pub data: Option<PathBuf>,
    /// Haptic devices for the window.
    #[command(flatten)]
    pub hands: HandArgs,
    /// The command; without one the window opens.
    #[command(subcommand)]
    pub command: Option<Command>,
}

/// Haptic devices for the window.
#[derive(Clone, Debug, clap::Args)]
pub struct HandArgs {
    /// Haptic device that holds the pan in the window: a name from `saute haptics list` or a geometry file. It is simulated
    /// unless @HOST:PORT or @SERIAL-PORT names a real one.
    #[arg(long, value_name = "NAME[@PLACE]")]
    pub device: Option<String>,
    /// Device with 6 sensed degrees of freedom that moves the turner in the window.
    #[arg(long, value_name = "NAME[@PLACE]")]
    pub turner: Option<String>,
    /// Pairing code that the real device displays.
    #[arg(long, value_name = "CODE", default_value_t = 0)]
    pub pairing: u32,
    /// File that stores the calibration of --device [default: with the settings].
    #[arg(long, value_name = "FILE", requires = "device")]
    pub calibration: Option<PathBuf>,
}

const EXIT_CODES: &str = "Exit codes: 0 done; 1 ran but fell short: max_s stopped the recipe, a replay departed, a fit does not describe its log, a validation case failed, `plan` missed its target, a row of a sweep could not be cooked, `lab` warned, or `bench paper` or `haptics check` missed a goal; 2 wrong usage or input.";

/// The commands.
#[derive(Debug, Subcommand)]
pub enum Command {
    /// Opens the window and plays a recipe, goes on with a recorded session, or begins a lesson.
    Open(OpenArgs),
    /// Cooks a recipe without a window.
    Cook(CookArgs),
    /// Plays a recorded session again, bit by bit, and prints its numbers. Exit code 1 if it departs.
    Replay(ReplayArgs),
    /// Solves heat conduction in a plain body with given boundary conditions, from a case file.
    Lab(LabArgs),
    /// Fits hob efficiency, contact and thickness to what was measured at a real stove, with 90 % intervals. Exit code 1 if the
    /// model does not describe the measurements.
    Fit(FitArgs),
    /// Runs the validation cases and compares them with published values and exact solutions.
    Validate(ValidateArgs),
    /// Finds the schedule (preheating, flips, power, pull, rest) that meets a target best. Exit code 1 if the target cannot be
    /// met.
    Plan(PlanArgs),
    /// Cooks a recipe many times with values that vary, on all cores, into Parquet files; goes on where it was broken off. Exit code
    /// 1 if a row could not be cooked.
    Sweep(SweepArgs),
    /// Opens the window in study mode, or analyses the logs of a study.
    Study(StudyArgs),
    /// Collects the results of a class.
    #[command(subcommand)]
    Class(ClassCommand),
    /// Renders one picture of a recipe at a given time, or at the end of the cook.
    Shot(ShotArgs),
    /// Renders the figures of the 2013 paper with this simulator's foods, each with its numbers.
    Gallery(GalleryArgs),
    /// Benchmarks of the renderer and the solvers.
    #[command(subcommand)]
    Bench(Bench),
    /// Lists foods, pans, recipes, scales, studies, scenarios, views or actions.
    List(ListArgs),
    /// Tools for your own foods.
    #[command(subcommand)]
    Food(Food),
    /// Prints the JSON Schema of a file format, or its reference page.
    Schema(SchemaArgs),
    /// Lists and checks haptic devices.
    #[command(subcommand)]
    Haptics(Haptics),
    /// Prints a shell's completions of this command.
    Completions {
        /// The shell.
        shell: clap_complete::Shell,
    },
    /// Prints the manual page of this command, or of one of its commands, as roff: `saute man cook | man -l -`.
    Man {
        /// The command, for instance `bench frame`.
        #[arg(value_name = "COMMAND")]
        command: Vec<String>,
    },
}

/// `saute open`.
#[derive(Debug, clap::Args)]
pub struct OpenArgs {
    /// Recipe file, id of a shipped recipe, or session file (.saute).
    #[arg(value_name = "RECIPE", required_unless_present = "scenario", conflicts_with = "scenario")]
    pub recipe: Option<String>,
    /// Scenario file, or id of a shipped scenario (`saute list scenarios`): begins its lesson.
    #[arg(long, value_name = "SCENARIO")]
    pub scenario: Option<String>,
    /// The lesson cannot be left: no other food, recipe, file or link.
    #[arg(long, requires = "scenario")]
    pub lock: bool,
    /// Code of the student, for the result: 1 to 12 letters, digits and hyphens. No names.
    #[arg(long, value_name = "CODE", requires = "scenario")]
    pub student: Option<String>,
}

/// `saute haptics`.
#[derive(Debug, Subcommand)]
pub enum Haptics {
    /// Lists devices and their capabilities.
    List(DevicesArgs),
    /// Runs the control loop with a device, or with a simulated one in its own process, while a steak fries. Exit code 1 if
    /// a goal is missed.
    Check(CheckArgs),
}

/// `saute cook`.
#[derive(Debug, clap::Args)]
pub struct CookArgs {
    /// Recipe file, or id of a shipped recipe.
    #[arg(value_name = "RECIPE")]
    pub recipe: String,
    /// Folder for report.html, summary and series (JSON and CSV, and both as Parquet), the cooked food as cooked.glb and pictures
    /// of the cross-section at each step; created if missing. Files of an earlier cook in it are replaced.
    #[arg(long, value_name = "DIR")]
    pub out: Option<PathBuf>,
    /// Writes all fields of foods and pan every so many seconds, for ParaView and PyVista: fields.pvd with its .vtu files, which
    /// take some megabytes each time.
    #[arg(long, value_name = "EVERY_S", value_parser = every, requires = "out")]
    pub fields: Option<f64>,
    /// Scale of doneness for the summary and the report, for foods that it fits, see `saute list scales`. Other foods keep
    /// their own. JSON contains all scales that fit a food.
    #[arg(long, value_name = "SCALE", default_value = DEFAULT_SCALE)]
    pub doneness: String,
    /// Writes pictures of every piece of a group instead of its first piece only.
    #[arg(long, requires = "out")]
    pub every_piece: bool,
    /// Session file to write while it cooks, for `saute replay`, `saute shot` and `saute open`; a file that is there is replaced.
    /// A program that is killed loses at most a second.
    #[arg(long, value_name = "FILE.saute")]
    pub record: Option<PathBuf>,
    /// Writes what the cook sounds like: 16-bit stereo, as long as the simulated time. A file that is there is replaced.
    #[arg(long, value_name = "FILE.wav")]
    pub wav: Option<PathBuf>,
    /// Sample rate of that file [Hz].
    #[arg(long, value_name = "HZ", value_parser = wav_rate, default_value_t = 48_000, requires = "wav")]
    pub wav_rate: u32,
    /// Prints the numbers as JSON.
    #[arg(long)]
    pub json: bool,
}

/// `saute replay`.
#[derive(Debug, clap::Args)]
pub struct ReplayArgs {
    /// Session file, as `saute cook --record` and the window write it.
    #[arg(value_name = "FILE.saute")]
    pub session: PathBuf,
    /// Recipe file to write: what was done becomes steps at their times. Motions of pan and tools in the hand are left out.
    #[arg(long, value_name = "OUT.toml")]
    pub to_recipe: Option<PathBuf>,
    /// Scale of doneness for the summary, for foods that it fits, see `saute list scales`. Other foods keep their own.
    #[arg(long, value_name = "SCALE", default_value = DEFAULT_SCALE)]
    pub doneness: String,
    /// Prints the numbers as JSON: those of the cook that was recorded, apart from `wall_s`.
    #[arg(long)]
    pub json: bool,
}

/// `saute lab`.
#[derive(Debug, clap::Args)]
pub struct LabArgs {
    /// Case file.
    #[arg(value_name = "CASE.toml")]
    pub case: PathBuf,
    /// Folder for report.json and the fields; created if missing.
    #[arg(long, value_name = "DIR")]
    pub out: Option<PathBuf>,
    /// Writes all fields of the body every so many seconds, for ParaView and PyVista: fields.pvd with its .vtu files. Each is that
    /// after the first step that reaches its time, so that the run gives the same numbers.
    #[arg(long, value_name = "EVERY_S", value_parser = every, requires = "out")]
    pub fields: Option<f64>,
    /// Prints the numbers as JSON.
    #[arg(long)]
    pub json: bool,
}

/// `saute validate`.
#[derive(Debug, clap::Args)]
pub struct ValidateArgs {
    /// Runs this case only: its id is the name of its file.
    #[arg(long, value_name = "ID")]
    pub case: Option<String>,
    /// Prints the verdicts as JSON.
    #[arg(long)]
    pub json: bool,
    /// Writes VALIDATION.md to the current folder and its pictures and pages to docs/. With --folder, of the cases of that folder.
    #[arg(long, conflicts_with = "case")]
    pub write: bool,
    /// Runs the cases of this folder instead of the shipped ones. Where it has an index.txt, its names are compared with the
    /// files, and with the CHANGELOG.md next to the folder.
    #[arg(long, value_name = "DIR")]
    pub folder: Option<PathBuf>,
}

/// `saute bench`.
#[derive(Debug, Subcommand)]
pub enum Bench {
    /// Renders whole frames of the window off-screen and measures the frame rate.
    Frame(BenchFrameArgs),
    /// Times the heat solver on one thread, checks it against an exact series, and compares it with the memory bandwidth.
    Heat(BenchHeatArgs),
    /// Repeats the tables of the 2013 paper: cycles per second of pans full of carrots and shrimps. Exit code 1 if a goal is
    /// missed.
    Paper(BenchPaperArgs),
}

/// `saute food`.
#[derive(Debug, Subcommand)]
pub enum Food {
    /// Checks a food file or a surface: reports every mistake, or the properties of the food.
    Check(FoodCheckArgs),
}

/// `saute food check`.
#[derive(Debug, clap::Args)]
pub struct FoodCheckArgs {
    /// Food file (.toml), or a surface on its own (.stl, .obj, .gltf, .glb).
    #[arg(value_name = "FILE")]
    pub file: PathBuf,
    /// Millimetres in one unit of a surface on its own: 1000 for metres, 25.4 for inches; by default 1000 for glTF, else 1.
    #[arg(long, value_name = "MM", value_parser = scale_mm, allow_negative_numbers = true)]
    pub scale_mm: Option<f64>,
    /// Prints the findings and numbers as JSON.
    #[arg(long)]
    pub json: bool,
}

/// `saute list`.
#[derive(Debug, clap::Args)]
pub struct ListArgs {
    /// The list to print.
    pub what: Listed,
    /// Prints the list as JSON.
    #[arg(long)]
    pub json: bool,
}

/// The lists.
#[derive(Clone, Copy, Debug, ValueEnum)]
pub enum Listed {
    /// Foods, for the `kind` of a food.
    Foods,
    /// Pans, for the `kind` of the pan.
    Pans,
    /// Hobs, for the `kind` of the hob.
    Hobs,
    /// Recipes that `saute cook` finds by id.
    Recipes,
    /// Scales of doneness, for `--doneness`.
    Scales,
    /// Goals of a cook, with what they require.
    Goals,
    /// Protocols that `saute study` finds by id.
    Studies,
    /// Scenarios that `saute open --scenario` finds by id.
    Scenarios,
    /// Views, for `--view` and `--split`, with the meaning of their colours.
    Views,
    /// Actions of a recipe's steps, with the keys of their tables and their defaults.
    Actions,
}

/// `saute schema`.
#[derive(Debug, clap::Args)]
pub struct SchemaArgs {
    /// Format.
    #[command(subcommand)]
    pub format: Schema,
    /// Prints the reference page of the format as Markdown: a table of keys for every TOML table.
    #[arg(long, global = true)]
    pub markdown: bool,
}

/// A file format.
#[derive(Clone, Copy, Debug, Subcommand)]
pub enum Schema {
    /// JSON Schema of food files.
    Food,
    /// JSON Schema of pan files.
    Pan,
    /// JSON Schema of coating files.
    Coating,
    /// JSON Schema of oil files.
    Oil,
    /// JSON Schema of kinetics files.
    Kinetics,
    /// JSON Schema of hob files.
    Hob,
    /// JSON Schema of recipe files.
    Recipe,
    /// JSON Schema of lab cases.
    Lab,
    /// JSON Schema of half-mirror rigs.
    Rig,
    /// JSON Schema of study protocols.
    Study,
    /// JSON Schema of scenarios for lessons.
    Scenario,
    /// JSON Schema of sweeps.
    Sweep,
}

/// Lengths of a unit that a surface may have [mm] (as of the key `scale_mm` of a food).
const SCALES_MM: std::ops::RangeInclusive<f64> = 1e-6..=1e6;

/// Returns the length that an option states [mm].
fn scale_mm(text: &str) -> Result<f64, String> {
    let stated = text.parse::<f64>().ok().filter(|mm| SCALES_MM.contains(mm));
    stated.ok_or_else(|| format!("give a length from {:e} to {:e} mm", SCALES_MM.start(), SCALES_MM.end()))
}
