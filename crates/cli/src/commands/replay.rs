//! `saute replay`.

use std::process::ExitCode;
use std::time::Instant;

use saute_recipe::Cook;

use crate::args::ReplayArgs;
use crate::commands::cook::report_end;
use crate::error::CliError;
use crate::exit_code;
use crate::input::data_library::DataLibrary;
use crate::input::session_source;
use crate::output::interruption::Interruption;
use crate::output::out_file::OutFile;
use crate::output::progress::Progress;
use crate::output::{json, stderr, stdout, text_summary};

/// Plays a session again and prints its numbers.
pub fn run(args: &ReplayArgs, data: &DataLibrary) -> Result<ExitCode, CliError> {
    let scales = data.scales(&args.doneness)?;
    let recording = session_source::load_session(&args.session)?;
    let out =
        args.to_recipe.as_deref().map(|path| OutFile::prepare_as("--to-recipe", path, "FILE.toml")).transpose()?;
    let mut cook = session_source::play_again(recording, data)?;
    let started = Instant::now();
    let (interruption, progress) = (Interruption::watch(), Progress::start(&cook));
    while cook.stopped().is_none() {
        cook.advance()?;
        progress.show(&cook);
        if interruption.is_asked() {
            let left = "nothing was written".to_owned();
            return Err(CliError::Interrupted { at_s: cook.kitchen.time_s(), left });
        }
    }
    drop(progress);
    let summary = cook.summary(started.elapsed().as_secs_f64());
    if let Some(out) = out {
        write_recipe(&cook, out, data)?;
    }
    stdout::print(&if args.json { json::text(&summary)? } else { text_summary::text(&summary, scales.chosen()) })?;
    let end = report_end(&cook, &summary);
    let Some(departure) = cook.departure() else { return Ok(end) };
    stderr::say(format!("{departure}"));
    stderr::say("  remedy: replay it with the program and the --data folder with which it was recorded");
    Ok(exit_code::of_goal(false))
}

/// Writes the session as a recipe; what it cannot state is reported on stderr.
fn write_recipe(cook: &Cook, out: OutFile, data: &DataLibrary) -> Result<(), CliError> {
    let made = cook.to_recipe(&data.library).map_err(|error| {
        CliError::place(out.place(), error.to_string(), "replay the session instead; it needs no recipe")
    })?;
    for words in &made.left_out {
        stderr::say(format!("warning: a recipe cannot state {words}: left out"));
    }
    out.fill(made.text.as_bytes())
}
