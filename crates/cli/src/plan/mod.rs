//! `saute plan`.

mod answer;
mod options;
mod text;

use std::path::Path;
use std::process::ExitCode;
use std::sync::Arc;
use std::time::{Duration, Instant};

use saute_controls::plan::kitchen_card;
use saute_kitchen::Library;
use saute_plan::schedule::{Cooking, Job, JobError, JobResult, Order, Plan, Planner};
use saute_words::speech::Speech;

use crate::error::CliError;
use crate::exit_code;
use crate::input::data_library::DataLibrary;
use crate::output::interruption::Interruption;
use crate::output::out_file::OutFile;
use crate::output::progress::Progress;
use crate::output::{json, stderr, stdout};
use crate::workers::map_all;

pub use options::PlanArgs;

/// Parts of the progress bar [-] (about as many jobs as a search has).
const PARTS: u64 = 60;

/// Searches a schedule, prints it, and writes its recipe and its card.
pub fn run(args: &PlanArgs, data: &DataLibrary) -> Result<ExitCode, CliError> {
    let data = &data.on_hob(args.hob_kind.as_deref())?;
    let order = options::order(args, data)?;
    let prepare =
        |option, path: Option<&Path>, example| path.map(|p| OutFile::prepare_as(option, p, example)).transpose();
    let recipe = prepare("--out", args.out.as_deref(), "RECIPE.toml")?;
    let card = prepare("--card", args.card.as_deref(), "CARD.html")?;
    let (plan, wall) = search(order, &data.library).map_err(|error| options::of_job(error, args))?;
    let plan = plan.ok_or(CliError::PlanInterrupted)?;
    let is_met = plan.shortfalls().is_empty();
    if let Some(file) = recipe {
        write(file, &text::recipe(&plan))?;
    }
    if let Some(file) = card {
        write(file, &kitchen_card::page(&plan, &data.library, Speech::default()))?;
    }
    stdout::print(&if args.json {
        json::text(&answer::PlanReport::new(&plan, wall))?
    } else {
        text::text(&plan, wall)
    })?;
    if !is_met {
        text::why_not(&plan).into_iter().for_each(stderr::say);
    }
    if plan.is_stopped {
        stderr::say("stopped: this is the best so far; started again, the search gives the whole plan");
        return Ok(exit_code::interrupted());
    }
    Ok(exit_code::of_goal(is_met))
}

fn write(file: OutFile, text: &str) -> Result<(), CliError> {
    let place = file.place().path().display().to_string();
    file.fill(text.as_bytes())?;
    stderr::say(format!("wrote {place}"));
    Ok(())
}

/// Runs the jobs of a search on every core, until a signal requests the best found so far: no plan before a candidate was cooked.
fn search(order: Order, library: &Library) -> Result<(Option<Plan>, Duration), JobError> {
    let started = Instant::now();
    let (progress, interruption) = (Progress::over(PARTS), Interruption::watch());
    let mut planner = Planner::new(order, Arc::new(library.clone()))?;
    loop {
        if let plan @ Some(_) = planner.plan() {
            return Ok((plan, started.elapsed()));
        }
        let (jobs, doing) = (planner.next_jobs(), planner.doing());
        let run = |_, job: &Job| {
            progress.next(doing.to_owned());
            cook(job, library, &interruption)
        };
        let results = map_all(&jobs, run).into_iter().collect::<Result<Option<Vec<_>>, _>>()?;
        match results {
            Some(results) => planner.take(results),
            None => return Ok((planner.so_far(), started.elapsed())),
        }
    }
}

/// Cooks a candidate; returns nothing if a signal came before its end.
fn cook(job: &Job, library: &Library, interruption: &Interruption) -> Result<Option<JobResult>, JobError> {
    let mut cooking = Cooking::begin(job.clone(), library)?;
    while !interruption.is_asked() {
        if let Some(result) = cooking.second()? {
            return Ok(Some(result));
        }
    }
    Ok(None)
}
