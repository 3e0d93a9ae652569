//! `saute sweep report`: which of the varied values matter.

mod bars;
mod columns;
mod page;
mod tables;

use std::path::PathBuf;
use std::process::ExitCode;

use saute_formats::Heading;
use saute_sweep::Manifest;
use saute_sweep::design::DesignKind;
use saute_sweep::sensitivity::elementary_effects::{ElementaryEffects, elementary_effects};
use saute_sweep::sensitivity::sobol_indices::{SobolIndices, sobol_indices};

use crate::error::CliError;
use crate::output::out_dir::OutDir;
use crate::output::{stderr, stdout};
use columns::Rows;

/// `saute sweep report`.
#[derive(Debug, clap::Args)]
pub struct ReportArgs {
    /// Folder of a complete sweep with the design `saltelli` or `morris`.
    #[arg(value_name = "DIR")]
    pub sweep: PathBuf,
    /// Folder for sensitivity.csv and report.html; created if missing.
    #[arg(long, value_name = "DIR")]
    pub out: PathBuf,
    /// Number to plot, as food.steak.core_c.peak; may be repeated [default: peak of core and pan, loss, juiciness, browning]. The
    /// table has all numbers.
    #[arg(long, value_name = "NAME")]
    pub column: Vec<String>,
}

/// What a number of the results depends on.
#[derive(Debug)]
pub struct Sensitivity {
    heading: Heading,
    found: Indices,
}

/// By either method.
#[derive(Debug)]
enum Indices {
    Sobol(SobolIndices),
    Effects(ElementaryEffects),
}

/// Makes table and page.
pub fn run(args: &ReportArgs) -> Result<ExitCode, CliError> {
    let rows = Rows::open(&args.sweep)?;
    let plotted = rows.plotted(&args.column)?;
    let mut found = Vec::new();
    for chunk in rows.numbers().chunks(columns::AT_ONCE) {
        found.extend(
            rows.read(chunk)?
                .into_iter()
                .filter_map(|(heading, numbers)| sensitivity(&rows.manifest, heading, &numbers)),
        );
    }
    let out = OutDir::prepare(&args.out)?;
    let place = out.place();
    let page = page::page(&rows.manifest, &found, &plotted);
    let table = tables::csv(&rows.manifest, &found)?;
    out.fill(vec![("sensitivity.csv".to_owned(), table.into_bytes()), ("report.html".to_owned(), page.into_bytes())])?;
    stderr::say(format!("wrote {place}/report.html and sensitivity.csv"));
    let shown = found.iter().filter(|one| plotted.contains(&one.heading.name));
    stdout::print(&shown.map(|one| tables::text(&rows.manifest, one)).collect::<String>())?;
    Ok(ExitCode::SUCCESS)
}

fn sensitivity(manifest: &Manifest, heading: Heading, numbers: &[Option<f64>]) -> Option<Sensitivity> {
    let design = &manifest.design;
    let found = match design.kind {
        DesignKind::Saltelli => Indices::Sobol(sobol_indices(numbers, design.dimensions(), design.seed)?),
        DesignKind::Morris => Indices::Effects(elementary_effects(numbers, design)?),
        DesignKind::Grid | DesignKind::LatinHypercube | DesignKind::Sobol => return None,
    };
    Some(Sensitivity { heading, found })
}
