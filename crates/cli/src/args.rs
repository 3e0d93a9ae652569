//! What may stand on the command line.

use std::path::PathBuf;

use clap::{Parser, Subcommand, ValueEnum};
use saute_kitchen::library::DEFAULT_SCALE;

use crate::bench_heat::BenchHeatArgs;
use crate::bench_paper::BenchPaperArgs;
use crate::gallery::GalleryArgs;
use crate::haptics::{CheckArgs, DevicesArgs};
use crate::picture::bench_frame::BenchFrameArgs;
use crate::picture::shot::ShotArgs;

/// A frying pan, what lies in it, and your hands on it. Without a command the window opens.
#[derive(Debug, Parser)]
#[command(name = "saute", version, after_help = EXIT_CODES)]
pub struct Args {
    /// Folder with foods/, pans/, recipes/, kinetics/, coatings/ or oils/ of your own, or doneness.toml; adds to the
    /// shipped ones or replaces those of the same name.
    #[arg(long, global = true, value_name = "DIR")]
    pub data: Option<PathBuf>,
    /// Devices that hands hold.
    #[command(flatten)]
    pub hands: HandArgs,
    /// What to do.
    #[command(subcommand)]
    pub command: Option<Command>,
}

/// Devices for the window.
#[derive(Clone, Debug, clap::Args)]
pub struct HandArgs {
    /// A device of `saute haptics list` or a geometry file that holds the pan in the window: simulated; with @HOST:PORT or
    /// @SERIAL-PORT the real one there.
    #[arg(long, value_name = "NAME[@PLACE]")]
    pub device: Option<String>,
    /// A device of 6 sensed degrees of freedom that leads the turner in the window.
    #[arg(long, value_name = "NAME[@PLACE]")]
    pub turner: Option<String>,
    /// Pairing code that the real device shows.
    #[arg(long, value_name = "CODE", default_value_t = 0)]
    pub pairing: u32,
    /// Where the calibration of --device is kept; among the settings unless given.
    #[arg(long, value_name = "FILE", requires = "device")]
    pub calibration: Option<PathBuf>,
}

const EXIT_CODES: &str = "Exit codes: 0 done, 1 the recipe was stopped by its max_s, a validation case falls short or a goal of `bench paper` or `haptics check` is missed, 2 something was wrong.";

/// What to do.
#[derive(Debug, Subcommand)]
pub enum Command {
    /// Opens the window and plays a recipe in it.
    Open {
        /// A recipe file, or the id of a shipped recipe.
        #[arg(value_name = "RECIPE")]
        recipe: String,
    },
    /// Cooks a recipe without a window.
    Cook(CookArgs),
    /// Runs the solver on a plain body with any boundary, for checks.
    Lab(LabArgs),
    /// Runs the cases whose answers come from outside, and compares.
    Validate(ValidateArgs),
    /// Draws one picture of a recipe at one moment.
    Shot(ShotArgs),
    /// Draws the figures of the 2013 paper with this simulator's foods, each with its numbers.
    Gallery(GalleryArgs),
    /// Measures the program.
    #[command(subcommand)]
    Bench(Bench),
    /// Lists what there is to cook with.
    List(ListArgs),
    /// Helps with foods of one's own.
    #[command(subcommand)]
    Food(Food),
    /// Prints the schema of a file format.
    #[command(subcommand)]
    Schema(Schema),
    /// Devices that hands hold.
    #[command(subcommand)]
    Haptics(Haptics),
}

/// `saute haptics`.
#[derive(Debug, Subcommand)]
pub enum Haptics {
    /// Lists devices with what they can do.
    List(DevicesArgs),
    /// Closes the control loop through a device, or through a simulated one in a process of its own, while a steak fries;
    /// exit code 1 where a goal is missed.
    Check(CheckArgs),
}

/// `saute cook`.
#[derive(Debug, clap::Args)]
pub struct CookArgs {
    /// A recipe file, or the id of a shipped recipe.
    #[arg(value_name = "RECIPE")]
    pub recipe: String,
    /// Folder for summary.json, series.csv, report.html and pictures of the cross-section at each step; made if it is
    /// missing. Those of an earlier cook in it are replaced.
    #[arg(long, value_name = "DIR")]
    pub out: Option<PathBuf>,
    /// Scale of doneness of the summary and the report: see `saute list scales`. JSON holds them all.
    #[arg(long, value_name = "SCALE", default_value = DEFAULT_SCALE)]
    pub doneness: String,
    /// Pictures of every piece of a group; of its first piece alone unless given.
    #[arg(long, requires = "out")]
    pub every_piece: bool,
    /// Prints the numbers as JSON.
    #[arg(long)]
    pub json: bool,
}

/// `saute lab`.
#[derive(Debug, clap::Args)]
pub struct LabArgs {
    /// A case file.
    #[arg(value_name = "CASE.toml")]
    pub case: PathBuf,
    /// Prints the numbers as JSON.
    #[arg(long)]
    pub json: bool,
}

/// `saute validate`.
#[derive(Debug, clap::Args)]
pub struct ValidateArgs {
    /// Runs this case alone: its id, the name of its file.
    #[arg(long, value_name = "ID")]
    pub case: Option<String>,
    /// Prints the verdicts as JSON.
    #[arg(long)]
    pub json: bool,
    /// Writes VALIDATION.md in the current folder and its pictures and pages under docs/.
    #[arg(long, conflicts_with = "case")]
    pub write: bool,
}

/// `saute bench`.
#[derive(Debug, Subcommand)]
pub enum Bench {
    /// Draws whole frames off-screen as the window would and counts them.
    Frame(BenchFrameArgs),
    /// Times the solver on one thread, checks it against an exact series, and compares it with the machine's memory.
    Heat(BenchHeatArgs),
    /// Runs the tables of the 2013 paper anew: cycles a second of pans full of carrots and shrimps; exit code 1 where a
    /// goal is missed.
    Paper(BenchPaperArgs),
}

/// `saute food`.
#[derive(Debug, Subcommand)]
pub enum Food {
    /// Explains what is wrong with a food's file, or what it makes.
    Check(FoodCheckArgs),
}

/// `saute food check`.
#[derive(Debug, clap::Args)]
pub struct FoodCheckArgs {
    /// A food's file (.toml), or a surface alone (.stl, .obj, .gltf, .glb).
    #[arg(value_name = "FILE")]
    pub file: PathBuf,
    /// Prints the findings and numbers as JSON.
    #[arg(long)]
    pub json: bool,
}

/// `saute list`.
#[derive(Debug, clap::Args)]
pub struct ListArgs {
    /// Which list.
    pub what: Listed,
    /// Prints the list as JSON.
    #[arg(long)]
    pub json: bool,
}

/// What can be listed.
#[derive(Clone, Copy, Debug, ValueEnum)]
pub enum Listed {
    /// Foods, for the `kind` of a food.
    Foods,
    /// Pans, for the `kind` of the pan.
    Pans,
    /// Recipes that `saute cook` knows by id.
    Recipes,
    /// Scales of doneness, for `--doneness`.
    Scales,
    /// Views, for `--view` and `--split`, with what their colours say.
    Views,
    /// Actions of a recipe's steps, with the keys of their tables and the defaults.
    Actions,
}

/// `saute schema`.
#[derive(Clone, Copy, Debug, Subcommand)]
pub enum Schema {
    /// JSON Schema of recipe files.
    Recipe,
    /// JSON Schema of lab cases.
    Lab,
}
