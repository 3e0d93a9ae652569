//! `saute cook`.

use std::process::ExitCode;
use std::time::{Duration, Instant};

use saute_kitchen::food::Scale;
use saute_recipe::{Cook, Recipe, StoppedBy, Summary};

use crate::args::CookArgs;
use crate::error::CliError;
use crate::out_dir::OutDir;
use crate::progress::Progress;
use crate::section_files::{Snapshot, disk_space, pictured};
use crate::shelf::Shelf;
use crate::{recipe_source, report, stderr, stdout, text_summary};

/// Exit code of a cook that `max_s` stopped.
const STOPPED: u8 = 1;

/// Cooks a recipe and says what came of it.
pub fn run(args: &CookArgs, shelf: &Shelf) -> Result<ExitCode, CliError> {
    let scale = shelf.scale(&args.doneness)?;
    let recipe = recipe_source::load(&args.recipe, shelf)?;
    let cook = set_out(recipe, shelf)?;
    let pictured = if args.out.is_some() { pictured(&cook, args.every_piece) } else { Vec::new() };
    let out = args.out.as_deref().map(|dir| OutDir::prepare(dir, disk_space(&cook, &pictured))).transpose()?;
    let (cook, snapshots, wall) = cook_through(cook, &pictured)?;
    let summary = cook.summary(wall.as_secs_f64());
    if let Some(out) = out {
        let place = out.place();
        let files = files(&cook, &summary, snapshots, &scale)?;
        let count = files.len();
        out.fill(files)?;
        stderr::say(format!("wrote {count} files to {place}; begin with report.html"));
    }
    stdout::print(&if args.json { json(&summary)? } else { text_summary::text(&summary, &scale) })?;
    Ok(say_how_it_ended(&cook, &summary))
}

fn set_out(recipe: Recipe, shelf: &Shelf) -> Result<Cook, CliError> {
    let file = recipe.file.clone();
    Cook::new(recipe, &shelf.library).map_err(|source| CliError::Setup { file, source })
}

/// Cooks to the end and takes pictures of some foods; the wall time is that of the simulation alone, without the pictures.
fn cook_through(mut cook: Cook, pictured: &[usize]) -> Result<(Cook, Vec<Snapshot>, Duration), CliError> {
    let progress = Progress::start(cook.runner.recipe().max_s);
    let mut snapshots = Vec::new();
    let started = Instant::now();
    let mut painting = Duration::ZERO;
    while cook.stopped().is_none() {
        let fired = cook.fire()?;
        if !pictured.is_empty() && !fired.is_empty() {
            let begun = Instant::now();
            snapshots.extend(Snapshot::take(&cook, &fired, pictured)?);
            painting += begun.elapsed();
        }
        cook.tick();
        progress.show(&cook);
    }
    Ok((cook, snapshots, started.elapsed().saturating_sub(painting)))
}

fn files(
    cook: &Cook,
    summary: &Summary,
    snapshots: Vec<Snapshot>,
    scale: &Scale,
) -> Result<Vec<(String, Vec<u8>)>, CliError> {
    let ids: Vec<&str> = cook.kitchen.pieces().iter().map(|p| p.id.as_str()).collect();
    let report = report::html(cook, summary, &snapshots, scale);
    let mut files = vec![
        ("summary.json".to_owned(), json(summary)?.into_bytes()),
        ("series.csv".to_owned(), cook.recorder.csv(&ids, &cook.runner.recipe().groups).into_bytes()),
        ("report.html".to_owned(), report.into_bytes()),
    ];
    files.extend(snapshots.into_iter().flat_map(Snapshot::into_files));
    Ok(files)
}

fn json(summary: &Summary) -> Result<String, CliError> {
    Ok(serde_json::to_string_pretty(summary)? + "\n")
}

fn say_how_it_ended(cook: &Cook, summary: &Summary) -> ExitCode {
    for warning in &summary.warnings {
        stderr::say(format!("warning: {warning}"));
    }
    if summary.stopped_by == StoppedBy::End {
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
    stderr::say("  remedy: raise max_s, or change that step or the hob so that it comes to pass");
    ExitCode::from(STOPPED)
}
