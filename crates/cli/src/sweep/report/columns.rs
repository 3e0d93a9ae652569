//! The rows of a sweep, read a few columns at a time.

use std::path::{Path, PathBuf};

use saute_files::checksums::Checksums;
use saute_files::regular_file;
use saute_formats::{ColumnKind, Heading, Table};
use saute_sweep::design::DesignKind;
use saute_sweep::{Manifest, manifest};
use saute_sweep_folder::{MANIFEST_MIB, PART_MIB, ROWS};

use crate::error::CliError;

/// Columns that are in memory at once [-] (chosen: a million rows of them take 64 MB).
pub const AT_ONCE: usize = 8;
/// Endings of the numbers that are plotted unless others are named.
const PLOTTED: [&str; 5] = ["core_c.peak", "lost_pct", "juiciness_pct", "bottom.browned_pct", "pan_c.peak"];

/// A column with its values, in the order of the rows.
pub type Column = (Heading, Vec<Option<f64>>);

/// The rows of a complete sweep.
#[derive(Debug)]
pub struct Rows {
    /// Which sweep it is.
    pub manifest: Manifest,
    folder: PathBuf,
    headings: Vec<Heading>,
}

impl Rows {
    /// Finds the rows of a sweep.
    pub fn open(sweep: &Path) -> Result<Self, CliError> {
        let place = sweep.join(manifest::FILE);
        let refused = |message: String, remedy: &str| CliError::place(sweep.display(), message, remedy);
        let text = regular_file::read_text(&place, MANIFEST_MIB)
            .map_err(|e| refused(format!("holds no sweep: {e}"), "name the folder of: saute sweep --out"))?;
        let manifest = Manifest::parse(&text)
            .map_err(|why| CliError::place(place.display(), why, "name the folder of: saute sweep --out"))?;
        if !matches!(manifest.design.kind, DesignKind::Saltelli | DesignKind::Morris) {
            let remedy = "write kind = \"saltelli\" or kind = \"morris\" under [design], and sweep again";
            return Err(refused("has a design from which neither indices nor effects follow".to_owned(), remedy));
        }
        let mut rows = Self { manifest, folder: sweep.join(ROWS), headings: Vec::new() };
        rows.headings = rows.part(0, |_| true)?.headings;
        Ok(rows)
    }

    fn part(&self, part: u64, wanted: impl Fn(&str) -> bool) -> Result<Table, CliError> {
        let path = self.folder.join(Manifest::part_name(part));
        let refused = |why: String| {
            CliError::place(path.display(), why, "complete the sweep first, with the command that began it")
        };
        let bytes = regular_file::read(&path, PART_MIB).map_err(|unread| refused(unread.to_string()))?;
        if !Checksums::in_folder(&self.folder).holds(&Manifest::part_name(part), &bytes) {
            let remedy = "remove this file and sweep again: its rows are cooked again";
            return Err(CliError::place(path.display(), "has not the checksum with which it was written", remedy));
        }
        Table::from_parquet(bytes, wanted).map_err(|e| refused(e.to_string()))
    }

    /// Returns the numbers of the results: columns that are not given by the design.
    pub fn numbers(&self) -> Vec<Heading> {
        let is_result = |h: &&Heading| h.kind == ColumnKind::Float && !h.name.starts_with("vary.");
        self.headings.iter().filter(is_result).cloned().collect()
    }

    /// Returns the names of the numbers to plot: those that are named, or the usual ones.
    pub fn plotted(&self, named: &[String]) -> Result<Vec<String>, CliError> {
        let all: Vec<String> = self.numbers().into_iter().map(|heading| heading.name).collect();
        if let Some(unknown) = named.iter().find(|name| !all.contains(name)) {
            let remedy = format!("name one of: {}", all.join(", "));
            return Err(CliError::place(format!("--column {unknown}"), "is no number of this sweep", remedy));
        }
        let usual = || all.iter().filter(|name| PLOTTED.iter().any(|ending| name.ends_with(ending))).cloned().collect();
        Ok(if named.is_empty() { usual() } else { named.to_vec() })
    }

    /// Returns the values of some columns, in the order of the rows.
    pub fn read(&self, headings: &[Heading]) -> Result<Vec<Column>, CliError> {
        let mut columns: Vec<Column> = headings.iter().map(|h| (h.clone(), Vec::new())).collect();
        for part in 0..self.manifest.parts() {
            let table = self.part(part, |name| headings.iter().any(|h| h.name == name))?;
            for (heading, values) in &mut columns {
                values.extend(table.numbers(&heading.name).unwrap_or_default());
            }
        }
        Ok(columns)
    }
}
