//! `saute cook`.

use std::path::PathBuf;
use std::process::ExitCode;
use std::time::{Duration, Instant};

use saute_kitchen::doneness::ScaleChoice;
use saute_recipe::{Cook, StoppedBy, Summary};

use crate::args::CookArgs;
use crate::error::CliError;
use crate::input::data_library::DataLibrary;
use crate::input::recipe_source;
use crate::input::session_source::{self, Source};
use crate::output::interruption::Interruption;
use crate::output::out_dir::OutDir;
use crate::output::progress::Progress;
use crate::output::section_files::{Snapshot, pictured};
use crate::output::session_out::SessionOut;
use crate::output::{json, stderr, stdout, text_summary};
use crate::{exit_code, report};

/// Cooks a recipe, writes its files and prints its numbers.
pub fn run(args: &CookArgs, data: &DataLibrary) -> Result<ExitCode, CliError> {
    let scales = data.scales(&args.doneness)?;
    let recipe = recipe_source::load(&args.recipe, data)?;
    let cook = session_source::cook(Source::Recipe(recipe), data)?;
    let pictured = if args.out.is_some() { pictured(&cook, args.every_piece) } else { Vec::new() };
    let out = args.out.as_deref().map(OutDir::prepare).transpose()?;
    let begin = |path: &PathBuf| SessionOut::begin(path, cook.runner.recipe(), &data.library, &cook.kitchen);
    let session = args.record.as_ref().map(begin).transpose()?;
    let (cook, snapshots, wall) = cook_through(cook, &pictured, out.as_ref(), session)?;
    let summary = cook.summary(wall.as_secs_f64());
    if let Some(out) = out {
        let place = out.place();
        let files = files(&cook, &summary, snapshots, &scales)?;
        let count = files.len();
        out.fill(files)?;
        stderr::say(format!("wrote {count} files to {place}; start with report.html"));
    }
    stdout::print(&if args.json { json::text(&summary)? } else { text_summary::text(&summary, scales.chosen()) })?;
    Ok(report_end(&cook, &summary))
}

/// Cooks to the end and takes pictures of some foods. The wall time is the time of the simulation without the pictures.
///
/// A signal ends a cook with an output folder early, with an error that says what is left; later it is too late to matter.
fn cook_through(
    mut cook: Cook,
    pictured: &[usize],
    out: Option<&OutDir>,
    mut session: Option<SessionOut>,
) -> Result<(Cook, Vec<Snapshot>, Duration), CliError> {
    let interruption = out.map_or_else(Interruption::default, |_| Interruption::watch());
    let progress = Progress::start(&cook);
    let mut snapshots = Vec::new();
    let started = Instant::now();
    let mut painting = Duration::ZERO;
    while cook.stopped().is_none() {
        let fired = cook.fire()?;
        if let Some(session) = &mut session {
            session.on_steps(&mut cook.kitchen);
        }
        if !pictured.is_empty() && !fired.is_empty() {
            let begun = Instant::now();
            snapshots.extend(Snapshot::take(&cook, &fired, pictured)?);
            painting += begun.elapsed();
        }
        cook.tick();
        if let Some(session) = &mut session {
            session.on_tick(&cook.kitchen)?;
        }
        progress.show(&cook);
        if let (true, Some(out)) = (interruption.is_asked(), out) {
            return Err(CliError::Interrupted { at_s: cook.kitchen.time_s(), left: out.left() });
        }
    }
    session.map_or(Ok(()), SessionOut::finish)?;
    Ok((cook, snapshots, started.elapsed().saturating_sub(painting)))
}

fn files(
    cook: &Cook,
    summary: &Summary,
    snapshots: Vec<Snapshot>,
    scales: &ScaleChoice,
) -> Result<Vec<(String, Vec<u8>)>, CliError> {
    let ids: Vec<&str> = cook.kitchen.pieces().iter().map(|p| p.id.as_str()).collect();
    let report = report::page(cook, summary, &snapshots, scales);
    let mut files = vec![
        ("summary.json".to_owned(), json::text(summary)?.into_bytes()),
        ("series.csv".to_owned(), cook.recorder.csv(&ids, &cook.runner.recipe().groups)?.into_bytes()),
        ("report.html".to_owned(), report.into_bytes()),
    ];
    files.extend(snapshots.into_iter().flat_map(Snapshot::into_files));
    Ok(files)
}

/// Says the warnings of a cook, and why it stopped if it did not end by itself; returns the exit code.
pub fn report_end(cook: &Cook, summary: &Summary) -> ExitCode {
    for warning in &summary.warnings {
        stderr::say(format!("warning: {warning}"));
    }
    if summary.stopped_by != StoppedBy::MaxS {
        return ExitCode::SUCCESS;
    }
    let (recipe, waiting) = (cook.runner.recipe(), cook.runner.waiting_step());
    let line = recipe.steps.get(waiting).map_or(1, |s| s.line);
    stderr::say(format!(
        "stopped: {}:{line}: step {} was still waiting at max_s = {} s: {}",
        recipe.file,
        waiting + 1,
        recipe.max_s,
        cook.runner.waiting_for()
    ));
    stderr::say("  remedy: raise max_s, or change that step or the hob so that its condition is met");
    exit_code::of_goal(false)
}
