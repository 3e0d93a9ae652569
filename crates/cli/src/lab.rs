//! `saute lab`.

use std::fmt::Write;
use std::process::ExitCode;
use std::time::Instant;

use saute_kitchen::lab::{Case, LabReport, run};

use crate::args::LabArgs;
use crate::error::CliError;
use crate::shelf::Shelf;
use crate::{stdout, text_file};

/// Runs a case and tells its numbers.
pub fn lab(args: &LabArgs, shelf: &Shelf) -> Result<ExitCode, CliError> {
    let text = text_file::read(&args.case)?;
    let case = Case::parse(&text, &args.case.display().to_string(), &shelf.library)?;
    let start = Instant::now();
    let report = run(&case, || start.elapsed().as_secs_f64());
    stdout::print(&if args.json { format!("{}\n", serde_json::to_string_pretty(&report)?) } else { table(&report) })?;
    Ok(ExitCode::SUCCESS)
}

fn table(report: &LabReport) -> String {
    let mut text = format!("{}\n{} nodes, {} steps, {:.3} s\n", report.name, report.nodes, report.steps, report.wall_s);
    let mut line = |s: String| writeln!(text, "{s}").unwrap_or(());
    if let Some(t) = report.stopped_at_s {
        line(format!("stopped at {t:.2} s"));
    }
    for (name, series) in &report.probes {
        line(name.clone());
        series.iter().for_each(|[t, c]| line(format!("  {t:10.2} s  {c:10.4} °C")));
    }
    for (above, share) in &report.volume_pct_above {
        line(format!("volume ever above {above} °C: {share:.2} %"));
    }
    line(format!("heat taken up: {:.4e} J", report.absorbed_j));
    line(format!("all nodes, all times: {:.4} to {:.4} °C", report.min_c, report.max_c));
    text
}
