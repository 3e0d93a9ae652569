//! What was measured, from the options and the log.

use saute_kitchen::Library;
use saute_plan::fit::compared::Compared;
use saute_plan::fit::log::log_error::LogError;
use saute_plan::fit::log::log_file::LogFile;
use saute_plan::fit::log::logger::Logger;
use saute_plan::fit::log::reading::{Choices, Pick, Reading};
use saute_plan::fit::log::times::TimeForm;
use saute_plan::fit::log::unit::Unit;
use saute_plan::fit::observed::{END, Observed};
use saute_recipe::Recipe;

use super::{FitArgs, TimesArg, UnitArg};
use crate::error::CliError;
use crate::input::data_library::DataLibrary;
use crate::input::text_file;

/// Largest log [MiB] (chosen: a day at one row a second).
const LARGEST_MIB: u64 = 16;

/// Returns what was measured, and how the log was read.
pub fn observed(args: &FitArgs, recipe: &Recipe, data: &DataLibrary) -> Result<(Observed, Option<Reading>), CliError> {
    let mut observed = Observed::default();
    let mut reading = None;
    if let Some(path) = &args.log {
        let bytes = text_file::bytes(path, LARGEST_MIB, ".csv", "the part of the log that holds the cook")?;
        let log = LogFile::parse(&path.display().to_string(), &bytes).map_err(of_log)?;
        let compared = compared(args, recipe);
        let read = log.read(&choices(args, &log, compared.begin(recipe))?).map_err(of_log)?;
        compared.add(&read, &mut observed);
        reading = Some(read);
    }
    if let Some(grams) = args.weight_g {
        if !(1.0..=1e4).contains(&grams) {
            return Err(CliError::place(format!("--weight-g {grams}"), "is out of range", "write 1 to 10000 g"));
        }
        observed.add_weight(END, 1e-3 * grams);
    }
    if let Some(class) = &args.class {
        add_class(&mut observed, class, &args.scale, data)?;
    }
    Ok((observed, reading))
}

/// The part of the log that is compared.
fn compared(args: &FitArgs, recipe: &Recipe) -> Compared {
    let mut compared = Compared::of(recipe, args.shift_s);
    if let Some(from_s) = args.from_s {
        (compared.core_from_s, compared.pan_from_s) = (from_s, from_s);
    }
    compared.to_s = args.to_s.unwrap_or(compared.to_s);
    compared
}

/// What is chosen for the log; where core or pan is named, the other one is not guessed.
fn choices(args: &FitArgs, log: &LogFile, begin: Option<(f64, f64)>) -> Result<Choices, CliError> {
    let logger = args.maker.as_deref().and_then(Logger::named);
    let column = |name: &Option<String>| name.as_ref().map(|name| log.column(name, logger)).transpose().map_err(of_log);
    let named = args.core.is_some() || args.pan.is_some();
    let pick = |column: Option<usize>| match column {
        Some(at) => Pick::Column(at),
        None if named => Pick::No,
        None => Pick::ByHeader,
    };
    Ok(Choices {
        logger,
        time: column(&args.time)?,
        core: pick(column(&args.core)?),
        pan: pick(column(&args.pan)?),
        unit: args.unit.map(unit),
        form: args.times.map(form),
        begin,
    })
}

fn add_class(observed: &mut Observed, class: &str, scale: &str, data: &DataLibrary) -> Result<(), CliError> {
    data.scales(scale)?;
    let found = data.library.scale(scale).is_some_and(|scale| observed.add_class(END, scale, class));
    if found {
        return Ok(());
    }
    let known = |library: &Library| {
        let classes = library.scale(scale).map(|s| s.class.iter().map(|c| c.name.clone()).collect::<Vec<_>>());
        classes.unwrap_or_default().join(", ")
    };
    let message = format!("is no class of temperatures of the scale \"{scale}\"");
    Err(CliError::place(format!("--class {class}"), message, format!("use one of: {}", known(&data.library))))
}

fn unit(unit: UnitArg) -> Unit {
    match unit {
        UnitArg::C => Unit::Celsius,
        UnitArg::F => Unit::Fahrenheit,
    }
}

fn form(form: TimesArg) -> TimeForm {
    match form {
        TimesArg::S => TimeForm::Seconds,
        TimesArg::Min => TimeForm::Minutes,
        TimesArg::H => TimeForm::Hours,
        TimesArg::Days => TimeForm::Days,
        TimesArg::Ms => TimeForm::Milliseconds,
        TimesArg::MinS => TimeForm::MinSec,
        TimesArg::HMin => TimeForm::HourMin,
    }
}

fn of_log(error: LogError) -> CliError {
    CliError::place(format!("{}:{}", error.file, error.line), error.message, error.remedy)
}
