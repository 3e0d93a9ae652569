//! What was measured, from the options and the log.

use saute_kitchen::Library;
use saute_plan::fit::log_file::{CORE_WORDS, LogError, LogFile, PAN_WORDS, Unit};
use saute_plan::fit::observed::{END, Observed, Quantity};

use super::{FitArgs, UnitArg};
use crate::error::CliError;
use crate::input::data_library::DataLibrary;
use crate::input::text_file;

/// Largest log [MiB] (chosen: a day at one row a second).
const LARGEST_MIB: u64 = 16;

/// Returns what was measured.
pub fn observed(args: &FitArgs, data: &DataLibrary) -> Result<Observed, CliError> {
    let mut observed = Observed::default();
    if let Some(path) = &args.log {
        let bytes = text_file::bytes(path, LARGEST_MIB, ".csv", "the part of the log that holds the cook")?;
        let log = LogFile::parse(&path.display().to_string(), &String::from_utf8_lossy(&bytes)).map_err(of_log)?;
        add_curves(&mut observed, &log, args)?;
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
    Ok(observed)
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

fn add_curves(observed: &mut Observed, log: &LogFile, args: &FitArgs) -> Result<(), CliError> {
    let time = args.time.as_deref().map_or(Ok(log.time_column()), |name| log.column(name)).map_err(of_log)?;
    let guessed = args.core.is_none() && args.pan.is_none();
    let mut count = 0;
    for (quantity, named, words) in
        [(Quantity::Core, &args.core, &CORE_WORDS[..]), (Quantity::Pan, &args.pan, &PAN_WORDS[..])]
    {
        let column = match named {
            Some(name) => Some(log.column(name).map_err(of_log)?),
            None if guessed => log.column_with(words, time),
            None => None,
        };
        let Some(column) = column else { continue };
        let unit = args.unit.map_or_else(|| Unit::of_header(log.header(column)), unit);
        let mut curve = log.curve(time, column, unit).map_err(of_log)?;
        curve.iter_mut().for_each(|(at, _)| *at += args.shift_s);
        curve.retain(|(at, _)| *at >= 0.0);
        observed.add_curve(quantity, &curve);
        count += 1;
    }
    if count == 0 {
        let remedy = "name them: --core COLUMN, --pan COLUMN";
        let path = args.log.as_ref().map(|p| p.display().to_string()).unwrap_or_default();
        return Err(CliError::place(path, "no header says which column is the core's or the pan's", remedy));
    }
    Ok(())
}

fn unit(unit: UnitArg) -> Unit {
    match unit {
        UnitArg::C => Unit::Celsius,
        UnitArg::F => Unit::Fahrenheit,
    }
}

fn of_log(error: LogError) -> CliError {
    let place = format!("{}:{}", error.file, error.line);
    let (message, remedy) = error.message.split_once("; ").unwrap_or((&error.message, "see saute fit --help"));
    CliError::place(place, message, remedy)
}
