//! `saute validate`.

mod case_folder;
mod colorimeter;
mod colour;
mod frying;
mod groups;
mod listed_cases;
mod page;
mod picture;
mod segments;
mod twenty;
mod verdict_text;

use std::process::ExitCode;
use std::time::Instant;

use saute_kitchen::Library;
use saute_lab::cook_case::CookCase;
use saute_lab::{Case, Evidence, LabReport, Verdict, verdicts};
use serde::Serialize;

use crate::args::ValidateArgs;
use crate::commands::lab::bounded;
use crate::error::CliError;
use crate::exit_code;
use crate::input::data_library::DataLibrary;
use crate::output::{json, stderr, stdout};
use crate::workers::map_all;

use case_folder::CaseFolder;
use groups::GroupSummary;
use listed_cases::Differences;

/// All verdicts, as `--json` prints them: in the order of the groups, worst first.
#[derive(Serialize)]
struct Verdicts {
    cases: Vec<Verdict>,
    groups: Vec<GroupSummary>,
    #[serde(flatten)]
    differences: Differences,
}

/// A case that has been run.
struct CaseRun {
    /// Name of its file.
    id: String,
    /// The case if it is a lab case.
    lab: Option<Case>,
    /// Kind of evidence for its expected values.
    evidence: Evidence,
    /// Its verdicts.
    verdicts: Vec<Verdict>,
}

/// Runs the cases and prints their verdicts.
pub fn run(args: &ValidateArgs, data: &DataLibrary) -> Result<ExitCode, CliError> {
    let pages = args.write.then(page::Pages::prepare).transpose()?;
    let folder = args.folder.as_deref().map_or_else(|| Ok(CaseFolder::shipped()), CaseFolder::read)?;
    let runs = run_cases(&folder, args.case.as_deref(), data)?;
    if let Some(pages) = pages {
        stderr::say("writing pages and pictures");
        // The charts of docs/frying.md are cooked for themselves: of all shipped cases, not of some.
        let is_whole = args.folder.is_none() && args.case.is_none();
        pages.fill(&runs, is_whole.then_some(&data.library))?;
    }
    // One case gives no information about the others.
    let differences = if args.case.is_none() { folder.differences() } else { Differences::default() };
    differences.messages(&folder.path).into_iter().for_each(stderr::say);
    let falls_short = runs.iter().flat_map(|r| &r.verdicts).any(Verdict::falls_short);
    let is_met = !falls_short && differences.removed.is_empty();
    stdout::print(&if args.json { json::text(&Verdicts::new(&runs, differences))? } else { page::text(&runs) })?;
    Ok(exit_code::of_goal(is_met))
}

impl Verdicts {
    fn new(runs: &[CaseRun], differences: Differences) -> Self {
        let groups = groups::groups(runs);
        let rows = groups.iter().flat_map(|group| &group.rows);
        Self {
            cases: rows.map(|(_, v)| (*v).clone()).collect(),
            groups: groups.iter().map(groups::Group::summary).collect(),
            differences,
        }
    }
}

fn run_cases(folder: &CaseFolder, only: Option<&str>, data: &DataLibrary) -> Result<Vec<CaseRun>, CliError> {
    let cases = &folder.cases;
    if let Some(id) = only.filter(|id| !cases.contains_key(*id)) {
        let remedy = format!("use one of: {}", Library::names(cases));
        return Err(CliError::place(format!("--case {id}"), "there is no such case", remedy));
    }
    let chosen: Vec<_> = cases.iter().filter(|(id, _)| only.is_none_or(|o| o == *id)).collect();
    let run = |i: usize, (id, text): &(&String, &String)| {
        stderr::say(format!("{} of {}: {id}", i + 1, chosen.len()));
        run_case(&folder.path, id, text, data)
    };
    map_all(&chosen, run).into_iter().collect()
}

fn run_case(folder: &str, id: &str, text: &str, data: &DataLibrary) -> Result<CaseRun, CliError> {
    let file = format!("{folder}/{id}.toml");
    let library = &data.library;
    if CookCase::is_one(text) {
        let case = CookCase::parse(text, &file, library)?;
        let mut verdicts = case.verdicts(library)?;
        verdicts.extend(colour::verdicts(&case, library)?);
        return Ok(CaseRun { id: id.to_owned(), lab: None, evidence: case.evidence(), verdicts });
    }
    let case = Case::parse(text, &file, library)?;
    let Some(evidence) = case.evidence else {
        let remedy = "write evidence = \"exact\", \"measured\", \"kitchen-band\" or \"information\" after source";
        return Err(CliError::place(file, "evidence: the case does not state its kind", remedy));
    };
    bounded(&case, &file)?;
    let verdicts = verdicts(&case, &timed(&case));
    Ok(CaseRun { id: id.to_owned(), lab: Some(case), evidence, verdicts })
}

fn timed(case: &Case) -> LabReport {
    let start = Instant::now();
    saute_lab::run(case, || start.elapsed().as_secs_f64())
}
