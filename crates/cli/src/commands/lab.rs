//! `saute lab`.

use std::fmt::Write;
use std::process::ExitCode;
use std::time::Instant;

use saute_formats::fields::{array, product};
use saute_formats::vtk::Collection;
use saute_kitchen::food::NodeField;
use saute_kitchen::heat::conduction::tensor::TensorBody;
use saute_lab::{Case, LabReport, MOST_WORK, Watch};

use crate::args::LabArgs;
use crate::error::CliError;
use crate::exit_code;
use crate::input::data_library::DataLibrary;
use crate::input::text_file;
use crate::output::field_files::SERIES;
use crate::output::out_dir::OutDir;
use crate::output::{json, stderr, stdout};

/// Runs a case and prints its numbers.
pub fn run(args: &LabArgs, data: &DataLibrary) -> Result<ExitCode, CliError> {
    let text = text_file::read(&args.case)?;
    let case = Case::parse(&text, &args.case.display().to_string(), &data.library)?;
    bounded(&case, &args.case.display().to_string())?;
    let mut out = args.out.as_deref().map(OutDir::prepare).transpose()?;
    let report = run_with_fields(&case, args.fields, out.as_mut())?;
    if let Some(out) = out {
        let (place, count) = (out.place(), out.kept() + 1);
        out.fill(vec![("report.json".to_owned(), json::text(&report)?.into_bytes())])?;
        stderr::say(format!("wrote {count} files to {place}"));
    }
    stdout::print(&if args.json { json::text(&report)? } else { table(&report) })?;
    report.warnings.iter().for_each(|warning| stderr::say(format!("warning: {warning}")));
    Ok(exit_code::of_goal(report.warnings.is_empty()))
}

/// Runs a case; if an interval [s] and a folder are given, its fields are written there.
fn run_with_fields(case: &Case, every_s: Option<f64>, out: Option<&mut OutDir>) -> Result<LabReport, CliError> {
    let start = Instant::now();
    let clock = || start.elapsed().as_secs_f64();
    let (Some(every_s), Some(out)) = (every_s, out) else { return Ok(saute_lab::run(case, clock)) };
    let (mut series, mut count, mut written) = (Collection::default(), 0, Ok(()));
    let mut tell = |time_s: f64, body: &TensorBody, fields: Vec<NodeField<'_>>| {
        let grid = product::product(body, fields.into_iter().map(array).collect(), time_s);
        let file = format!("fields_{count:04}.vtu");
        series.push(time_s, 0, &case.name, &file);
        count += 1;
        if written.is_ok() {
            written = out.keep(&file, &grid.vtu());
        }
    };
    let report = saute_lab::run_watched(case, clock, &mut Watch::every(every_s, &mut tell));
    written?;
    out.keep(SERIES, series.pvd().as_bytes())?;
    Ok(report)
}

/// Refuses a case whose work would take more than a day; `place` names its file.
pub fn bounded(case: &Case, place: &str) -> Result<(), CliError> {
    let work = saute_lab::work(case);
    // A work that is not finite is refused too.
    if work <= MOST_WORK {
        return Ok(());
    }
    let message = format!("needs about {work:.1e} node steps; at most {MOST_WORK:.0e} are allowed");
    let remedy = "use a larger resolution_mm, a shorter duration_s, or properties of real materials";
    Err(CliError::place(place, message, remedy))
}

fn table(report: &LabReport) -> String {
    let mut text = format!("{}\n{} nodes, {} steps, {:.3} s\n", report.name, report.nodes, report.steps, report.wall_s);
    let mut line = |s: String| writeln!(text, "{s}").unwrap_or(());
    if let Some(t) = report.stopped_at_s {
        line(format!("stopped at {t:.2} s"));
    }
    for (i, t) in report.phases_ended_s.iter().enumerate() {
        line(format!("phase {} ended at {t:.2} s", i + 1));
    }
    for (name, series) in &report.probes {
        line(name.clone());
        series.iter().for_each(|[t, c]| line(format!("  {t:10.2} s  {c:10.4} °C")));
    }
    for (name, series) in &report.flux {
        line(format!("{name}, upward heat flux"));
        series.iter().for_each(|[t, q]| line(format!("  {t:10.2} s  {q:12.2} W/m²")));
    }
    let mut above: Vec<(f64, f64)> =
        report.volume_pct_above.iter().filter_map(|(c, share)| Some((c.parse().ok()?, *share))).collect();
    above.sort_by(|a, b| a.0.total_cmp(&b.0));
    for (above, share) in &above {
        line(format!("volume that exceeded {above} °C: {share:.2} %"));
    }
    whole_run(report).into_iter().for_each(&mut line);
    for (face, [l, a, b]) in &report.surface_lab {
        line(format!("{face}: L* {l:.1}  a* {a:.1}  b* {b:.1}"));
    }
    text
}

/// Returns the lines for the numbers of the whole run that the case has.
fn whole_run(report: &LabReport) -> Vec<String> {
    let per = if report.per_m2 { "/m²" } else { "" };
    let shrunk = report.section_shrunk_pct.zip(report.thickness_shrunk_pct);
    let peak = report.core_peak_c.zip(report.core_peak_at_s);
    let ratio = report.compared.as_ref().and_then(|c| c.stopped_at_s).zip(report.stopped_at_s);
    [
        peak.map(|(c, t)| format!("core, highest: {c:.4} °C at {t:.2} s")),
        report.evaporated_kg_m2.map(|kg| format!("evaporated: {kg:.4} kg/m²")),
        report.evaporated_g.filter(|_| !report.per_m2).map(|g| format!("evaporated: {g:.3} g")),
        report.dripped_g.map(|g| format!("juice run off: {g:.3} g{per}")),
        report.rendered_g.map(|g| format!("fat run off: {g:.3} g{per}")),
        report.lost_pct.map(|pct| format!("mass lost: {pct:.2} %")),
        shrunk.map(|(across, along)| format!("shrunk: section by {across:.2} %, thickness by {along:.2} %")),
        report.crust_mm.map(|mm| format!("dried: {mm:.4} mm")),
        ratio.map(|(other, this)| format!("with the other flips: {other:.2} s, {:.4} times as long", other / this)),
        Some(format!("heat absorbed: {:.4e} J{per}", report.absorbed_j)),
        Some(format!("all nodes, all times: {:.4} to {:.4} °C", report.min_c, report.max_c)),
    ]
    .into_iter()
    .flatten()
    .collect()
}
