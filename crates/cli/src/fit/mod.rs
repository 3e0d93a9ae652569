//! `saute fit`.

mod answer;
mod log;

use std::path::{Path, PathBuf};
use std::process::ExitCode;
use std::sync::Arc;
use std::time::{Duration, Instant};

use clap::builder::PossibleValuesParser;
use saute_plan::fit::found::FitResult;
use saute_plan::fit::log::logger::loggers;
use saute_plan::fit::observed::Observed;
use saute_plan::fit::predict::FitError;
use saute_plan::fit::search::Fit;
use saute_recipe::Recipe;

use crate::error::CliError;
use crate::exit_code;
use crate::input::data_library::DataLibrary;
use crate::input::recipe_source;
use crate::output::out_file::OutFile;
use crate::output::progress::Progress;
use crate::output::{json, stderr, stdout};
use crate::workers::map_all;

/// `saute fit`.
#[derive(Debug, clap::Args)]
pub struct FitArgs {
    /// Log of a thermometer: a CSV file with a column of times and columns of temperatures, as makers, loggers and spreadsheets write
    /// it. Optional if a weight or a class is given.
    #[arg(value_name = "LOG.csv")]
    pub log: Option<PathBuf>,
    /// Recipe of what was cooked: its steps at the times (at_s, after_s) at which they were done.
    #[arg(long, value_name = "RECIPE")]
    pub recipe: String,
    /// Column of the times, by header or number from 1 [default: the one with a header of time, else the first].
    #[arg(long, value_name = "COLUMN", requires = "log")]
    pub time: Option<String>,
    /// Column of the core's temperature, by header or number from 1.
    #[arg(long, value_name = "COLUMN", requires = "log")]
    pub core: Option<String>,
    /// Column of the pan's temperature, by header or number from 1.
    #[arg(long, value_name = "COLUMN", requires = "log")]
    pub pan: Option<String>,
    /// Preset of the thermometer's maker [default: the log states enough].
    #[arg(long, value_name = "MAKER", requires = "log", value_parser = makers())]
    pub maker: Option<String>,
    /// What the times are, where the log can be read in two ways.
    #[arg(long, value_name = "FORM", requires = "log")]
    pub times: Option<TimesArg>,
    /// Unit of the temperatures [default: as header, rows or the lines above the table state, else °C].
    #[arg(long, value_name = "UNIT", requires = "log")]
    pub unit: Option<UnitArg>,
    /// Time in the recipe at which the log begins [s].
    #[arg(long, value_name = "S", default_value_t = 0.0, allow_negative_numbers = true, requires = "log")]
    pub shift_s: f64,
    /// Time in the recipe from which the log is compared [s] [default: the core from the put on, the pan from the beginning].
    #[arg(long, value_name = "S", allow_negative_numbers = true, requires = "log")]
    pub from_s: Option<f64>,
    /// Time in the recipe up to which the log is compared [s] [default: the end of the recipe].
    #[arg(long, value_name = "S", allow_negative_numbers = true, requires = "log")]
    pub to_s: Option<f64>,
    /// Weight of the food at the end [g].
    #[arg(long, value_name = "G", allow_negative_numbers = true)]
    pub weight_g: Option<f64>,
    /// Class of the core that was seen on the cut at the end.
    #[arg(long, value_name = "CLASS")]
    pub class: Option<String>,
    /// Scale of doneness of the class, see `saute list scales`.
    #[arg(long, value_name = "SCALE", default_value = "chefs")]
    pub scale: String,
    /// Folder in which kitchen-at-home.toml is written; `saute --data DIR` cooks in the kitchen that was found.
    #[arg(long, value_name = "DIR")]
    pub out: Option<PathBuf>,
    /// Writes the kitchen although it does not describe what was measured.
    #[arg(long, requires = "out")]
    pub force: bool,
    /// Prints the numbers as JSON.
    #[arg(long)]
    pub json: bool,
}

/// The makers that have a preset.
fn makers() -> PossibleValuesParser {
    PossibleValuesParser::new(loggers().iter().map(|logger| logger.id.as_str()))
}

/// What the times of a log are.
#[derive(Clone, Copy, Debug, clap::ValueEnum)]
pub enum TimesArg {
    /// Seconds.
    S,
    /// Minutes.
    Min,
    /// Hours.
    H,
    /// Days, as spreadsheets count.
    Days,
    /// Milliseconds.
    Ms,
    /// Minutes and seconds: 1:30.
    #[value(name = "min:s")]
    MinS,
    /// Hours and minutes: 18:03.
    #[value(name = "h:min")]
    HMin,
}

/// Unit of temperatures.
#[derive(Clone, Copy, Debug, clap::ValueEnum)]
pub enum UnitArg {
    /// °C.
    C,
    /// °F.
    F,
}

/// Parts of the progress bar [-] (about as many rounds as a fit has).
const PARTS: u64 = 10;

/// Fits a kitchen, prints what was found and writes it as a data file.
pub fn run(args: &FitArgs, data: &DataLibrary) -> Result<ExitCode, CliError> {
    let recipe = recipe_source::load(&args.recipe, data)?;
    let data = &data.on_hob(recipe.hob_kind.as_deref())?;
    let (observed, reading) = log::observed(args, &recipe, data)?;
    let file = args.out.as_deref().map(prepare).transpose()?;
    let (found, wall) = fitted(recipe.clone(), data, &observed).map_err(|error| of_fit(&error, args))?;
    let describes = found.describes();
    let answer = answer::FitReport::new(&found, &recipe, &data.library, reading, wall);
    if let Some(file) = file.filter(|_| describes || args.force) {
        let place = file.place().to_string();
        file.fill(answer.data_file(args.log.as_deref()).as_bytes())?;
        stderr::say(format!(
            "wrote {place}; use it with: saute --data {}",
            args.out.as_deref().unwrap_or(Path::new("")).display()
        ));
    }
    stdout::print(&if args.json { json::text(&answer)? } else { answer.text() })?;
    if !describes {
        no_description(&found, args);
    }
    Ok(exit_code::of_goal(describes))
}

fn no_description(found: &FitResult, args: &FitArgs) {
    stderr::say(format!(
        "the model does not describe the measurements: they miss it by {:.1} times their errors; the intervals are widened by that",
        found.misfit
    ));
    stderr::say(format!("  it fits worst {}", answer::worst(&found.worst)));
    stderr::say("  remedy: check the times and powers of the recipe, the columns, their unit and --shift-s");
    if args.out.is_some() && !args.force {
        stderr::say("  no kitchen was written; --force writes it all the same");
    }
}

fn prepare(dir: &Path) -> Result<OutFile, CliError> {
    let place = |e: std::io::Error| {
        let remedy = "name a folder that can be written";
        CliError::place(format!("--out {}", dir.display()), format!("cannot be made: {e}"), remedy)
    };
    std::fs::create_dir_all(dir).map_err(place)?;
    OutFile::prepare_as("--out", &dir.join(answer::FILE), "DIR")
}

/// Runs the rounds of a fit on every core.
fn fitted(recipe: Recipe, data: &DataLibrary, observed: &Observed) -> Result<(FitResult, Duration), FitError> {
    let started = Instant::now();
    let progress = Progress::over(PARTS);
    let mut fit = Fit::new(recipe, Arc::new(data.library.clone()), observed)?;
    loop {
        if let Some(found) = fit.found() {
            return Ok((*found, started.elapsed()));
        }
        progress.next(format!("round {}", fit.progress().0 + 1));
        let values = map_all(&fit.next_jobs(), |_, job| job.run());
        fit.take(&values.into_iter().collect::<Result<Vec<_>, _>>()?);
    }
}

fn of_fit(error: &FitError, args: &FitArgs) -> CliError {
    let message = error.to_string();
    let (message, remedy) = message.split_once("; ").unwrap_or((&message, "check the recipe with: saute cook"));
    CliError::place(&args.recipe, message, remedy)
}
