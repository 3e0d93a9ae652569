//! `saute cook`.

use std::path::PathBuf;
use std::process::ExitCode;
use std::time::{Duration, Instant};

use saute_formats::{series_table, summary_table};
use saute_kitchen::doneness::ScaleChoice;
use saute_recipe::{Cook, Fired, StoppedBy, Summary};

use crate::args::CookArgs;
use crate::error::CliError;
use crate::input::data_library::DataLibrary;
use crate::input::recipe_source;
use crate::input::session_source::{self, Source};
use crate::output::field_files::FieldFiles;
use crate::output::interruption::Interruption;
use crate::output::out_dir::OutDir;
use crate::output::progress::Progress;
use crate::output::section_files::{Snapshot, pictured};
use crate::output::session_out::SessionOut;
use crate::output::wav_out::WavOut;
use crate::output::{coloured_surfaces, json, stderr, stdout, text_summary};
use crate::{exit_code, report};

/// Cooks a recipe, writes its files and prints its numbers.
pub fn run(args: &CookArgs, data: &DataLibrary) -> Result<ExitCode, CliError> {
    let scales = data.scales(&args.doneness)?;
    let recipe = recipe_source::load(&args.recipe, data)?;
    let cook = session_source::cook(Source::Recipe(Box::new(recipe)), data)?;
    let pictured = if args.out.is_some() { pictured(&cook, args.every_piece) } else { Vec::new() };
    let mut out = args.out.as_deref().map(OutDir::prepare).transpose()?;
    let begin = |path: &PathBuf| SessionOut::begin(path, cook.runner.recipe(), &data.library, &cook.kitchen);
    let session = args.record.as_ref().map(begin).transpose()?;
    let listen = |path: &PathBuf| WavOut::begin(path, args.wav_rate, &cook.kitchen);
    let wav = args.wav.as_ref().map(listen).transpose()?;
    let fields = args.fields.map(FieldFiles::every);
    let onlookers = Onlookers { pictured, out: out.as_mut(), fields, session, wav };
    let (cook, snapshots, wall) = onlookers.cook(cook)?;
    let summary = cook.summary(wall.as_secs_f64());
    if let Some(out) = out {
        let place = out.place();
        let files = files(&cook, &summary, snapshots, &scales)?;
        let count = files.len() + out.kept();
        out.fill(files)?;
        stderr::say(format!("wrote {count} files to {place}; start with report.html"));
    }
    stdout::print(&if args.json { json::text(&summary)? } else { text_summary::text(&summary, scales.chosen()) })?;
    Ok(report_end(&cook, &summary))
}

/// Those who look on while a recipe cooks.
struct Onlookers<'a> {
    /// Foods of which pictures are taken.
    pictured: Vec<usize>,
    out: Option<&'a mut OutDir>,
    fields: Option<FieldFiles>,
    session: Option<SessionOut>,
    wav: Option<WavOut>,
}

impl Onlookers<'_> {
    /// Cooks to the end; returns it with its pictures and the wall time of the simulation, without pictures and fields.
    ///
    /// A signal ends a cook early, with an error that states what is left; later it is too late to matter.
    fn cook(mut self, mut cook: Cook) -> Result<(Cook, Vec<Snapshot>, Duration), CliError> {
        let interruption = Interruption::watch();
        let progress = Progress::start(&cook);
        let mut snapshots = Vec::new();
        let (started, mut looking) = (Instant::now(), Duration::ZERO);
        while cook.stopped().is_none() {
            let fired = cook.fire()?;
            if let Some(session) = &mut self.session {
                session.on_steps(&mut cook.kitchen);
            }
            let begun = Instant::now();
            snapshots.extend(self.look(&cook, &fired)?);
            looking += begun.elapsed();
            cook.tick();
            if let Some(session) = &mut self.session {
                session.on_tick(&cook.kitchen)?;
            }
            if let Some(wav) = &mut self.wav {
                wav.on_tick(&cook.kitchen)?;
            }
            progress.show(&cook);
            if interruption.is_asked() {
                let left = self.out.as_ref().map_or_else(|| "nothing was written".to_owned(), |out| out.left());
                return Err(CliError::Interrupted { at_s: cook.kitchen.time_s(), left });
            }
        }
        let wall = started.elapsed().saturating_sub(looking);
        self.session.map_or(Ok(()), SessionOut::finish)?;
        self.wav.map_or(Ok(()), WavOut::finish)?;
        if let (Some(fields), Some(out)) = (self.fields, self.out) {
            fields.end(&cook.kitchen, out)?;
        }
        Ok((cook, snapshots, wall))
    }

    /// Takes the pictures of steps that were just carried out, and writes the fields that are due.
    fn look(&mut self, cook: &Cook, fired: &[Fired]) -> Result<Vec<Snapshot>, CliError> {
        if let (Some(fields), Some(out)) = (&mut self.fields, &mut self.out) {
            fields.look(&cook.kitchen, out)?;
        }
        if self.pictured.is_empty() || fired.is_empty() {
            return Ok(Vec::new());
        }
        Ok(Snapshot::take(cook, fired, &self.pictured)?)
    }
}

fn files(
    cook: &Cook,
    summary: &Summary,
    snapshots: Vec<Snapshot>,
    scales: &ScaleChoice,
) -> Result<Vec<(String, Vec<u8>)>, CliError> {
    let ids: Vec<&str> = cook.kitchen.pieces().iter().map(|p| p.id.as_str()).collect();
    let groups = &cook.runner.recipe().groups;
    let report = report::page(cook, summary, &snapshots, scales);
    let mut files = vec![
        ("summary.json".to_owned(), json::text(summary)?.into_bytes()),
        ("series.csv".to_owned(), cook.recorder.csv(&ids, groups)?.into_bytes()),
        ("summary.parquet".to_owned(), summary_table::table(summary).parquet()?),
        ("series.parquet".to_owned(), series_table::table(&cook.recorder, &ids, groups).parquet()?),
        (coloured_surfaces::FILE.to_owned(), coloured_surfaces::cooked(&cook.kitchen)),
        ("report.html".to_owned(), report.into_bytes()),
    ];
    files.extend(snapshots.into_iter().flat_map(Snapshot::into_files));
    Ok(files)
}

/// Prints the warnings of a cook, and why it stopped if it did not end by itself; returns the exit code.
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
