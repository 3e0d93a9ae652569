//! A sweep: a specification joined with its recipe and data. Its rows are numbered and independent.

use std::collections::BTreeMap;
use std::ops::Range;
use std::sync::Arc;

use saute_formats::parquet_file::TableError;
use saute_formats::summary_table::{Cell, cells, unit_of};
use saute_formats::{ColumnKind, Heading, Table, Value};
use saute_kitchen::{Library, OwnFiles};
use saute_recipe::{Cook, Recipe, StoppedBy, Summary};
use saute_schema::{InputError, InputText};

use crate::documents::Documents;
use crate::identity::hash;
use crate::manifest::Manifest;
use crate::place::Document;
use crate::row::{RowResult, Status};
use crate::spec::joined::{Factor, design, factors, size};
use crate::spec::spec_file::SpecFile;
use crate::spec::varied::Levels;

/// What a sweep varies: a recipe's text, its name for messages, and the user's data files.
#[derive(Clone, Debug, Default)]
pub struct Base {
    /// Text of the recipe.
    pub recipe: String,
    /// Name of the recipe's file in messages.
    pub file: String,
    /// Files of the user's.
    pub own: OwnFiles,
}

/// Most values of a list that are tried before the sweep begins [-] (chosen: more than there are kinds of anything; a moment).
const MOST_TRIED: usize = 64;

/// A specification joined with its recipe and data.
#[derive(Debug)]
pub struct Sweep {
    text: String,
    file: String,
    base: Base,
    documents: Documents,
    library: Arc<Library>,
    factors: Vec<Factor>,
    for_s: f64,
    coarseness: Option<f64>,
    columns: Vec<Heading>,
    doubts: Vec<InputError>,
    manifest: Manifest,
}

impl Sweep {
    /// Joins a specification with its recipe and data. `text` and `file` are those of the specification.
    ///
    /// # Errors
    /// Returns file, line, key and remedy of the first mistake: in the recipe, or in a path, value or size of the specification.
    pub fn new(text: &str, file: &str, base: Base) -> Result<Self, InputError> {
        let spec = SpecFile::parse(text, file)?;
        let input = InputText { text, file };
        let at_recipe = spec.recipe.span().start;
        let library = match Library::with_own(&base.own) {
            Ok((library, _)) => Arc::new(library),
            Err(e) => return input.error(0, e.to_string(), "correct that file"),
        };
        Recipe::parse(&base.recipe, &base.file, &library)?;
        let Ok(recipe) = base.recipe.parse() else {
            return input.error(at_recipe, "the recipe is not TOML", "name another recipe");
        };
        let mut data = Library::embedded_files();
        data.extend(base.own.texts.clone());
        data.retain(|path, _| !path.starts_with("recipes/"));
        let documents = Documents { recipe, data };
        let factors = factors(input, &spec, &documents)?;
        let design = design(input, &spec, &factors)?;
        let rows = size(input, &spec, &design)?;
        let varied = factors.iter().map(|f| f.path.clone()).collect();
        let mut sweep = Self {
            for_s: spec.for_s.unwrap_or(f64::INFINITY),
            coarseness: spec.coarseness,
            manifest: Manifest::new(hash(text, &base, &documents), spec.recipe.get_ref(), varied, design, rows),
            text: text.to_owned(),
            file: file.to_owned(),
            base,
            documents,
            library,
            factors,
            columns: Vec::new(),
            doubts: Vec::new(),
        };
        (sweep.columns, sweep.doubts) = sweep.tried_columns(input, &spec)?;
        Ok(sweep)
    }

    /// The content of a folder with its results.
    pub fn manifest(&self) -> &Manifest {
        &self.manifest
    }

    /// Values that were tried and cannot be cooked, one for each varied path: rows with them will fail.
    pub fn doubts(&self) -> &[InputError] {
        &self.doubts
    }

    /// Text of the specification.
    pub fn text(&self) -> &str {
        &self.text
    }

    /// Name of the specification's file in messages.
    pub(crate) fn file(&self) -> &str {
        &self.file
    }

    /// Recipe and data files.
    pub(crate) fn base(&self) -> &Base {
        &self.base
    }

    /// Text of the recipe.
    pub fn recipe_text(&self) -> &str {
        &self.base.recipe
    }

    /// Returns the rows of a part.
    pub fn part_rows(&self, part: u64) -> Range<u64> {
        self.manifest.part_rows(part)
    }

    /// Cooks a row. The result depends on nothing but the row's number.
    pub fn run_row(&self, row: u64) -> RowResult {
        self.run_row_while(row, &|| true).unwrap_or_else(|| self.failed_row(row, String::new()))
    }

    /// Cooks a row as long as it may go on, which is queried at every tick; none if it was broken off.
    pub fn run_row_while(&self, row: u64, may_go_on: &dyn Fn() -> bool) -> Option<RowResult> {
        let values = self.values(row);
        match self.cook(&values, may_go_on) {
            Ok(None) => None,
            Ok(Some((summary, status))) => {
                let varied = values.iter().map(to_cell).collect();
                let mut found: BTreeMap<String, Option<Value>> = by_name(numbers(&summary));
                let number = |h: &Heading| found.remove(&h.name).flatten().and_then(|value| value.to_kind(h.kind));
                let numbers = self.columns.iter().map(number).collect();
                Some(RowResult { row, status, message: None, varied, numbers })
            }
            Err(message) => Some(self.failed_row(row, message)),
        }
    }

    /// Returns the result of a row that could not be cooked.
    pub fn failed_row(&self, row: u64, message: String) -> RowResult {
        let varied = self.values(row).iter().map(to_cell).collect();
        RowResult {
            row,
            status: Status::Failed,
            message: Some(message),
            varied,
            numbers: vec![None; self.columns.len()],
        }
    }

    /// Returns the Parquet file of a part, from the results of its rows in their order.
    ///
    /// # Errors
    /// If the table cannot be written.
    pub fn part_file(&self, results: &[RowResult]) -> Result<Vec<u8>, TableError> {
        let m = &self.manifest;
        let constant = [&m.recipe, &m.version].map(|text| Some(Value::Text(text.clone())));
        let row = |r: &RowResult| {
            let head = [
                Some(Value::Integer(r.row as i64)),
                Some(Value::Text(r.status.name().to_owned())),
                r.message.clone().map(Value::Text),
                Some(Value::Integer(m.design.seed as i64)),
            ];
            let varied = r.varied.iter().cloned().map(Some);
            head.into_iter().chain(constant.clone()).chain(varied).chain(r.numbers.iter().cloned()).collect()
        };
        let notes = [("saute.version", &m.version), ("saute.recipe", &m.recipe), ("saute.sweep", &m.hash)];
        let notes = notes.map(|(name, note)| (name.to_owned(), note.clone())).into();
        Table { headings: self.headings(), rows: results.iter().map(row).collect(), notes }.parquet()
    }

    /// Returns the headings of a part's table: row, status, message, seed, recipe, version, the varied values under `vary.` and
    /// their paths, and the summary's numbers.
    pub fn headings(&self) -> Vec<Heading> {
        let head = [
            ("row", ColumnKind::Integer),
            ("status", ColumnKind::Text),
            ("message", ColumnKind::Text),
            ("seed", ColumnKind::Integer),
            ("recipe", ColumnKind::Text),
            ("version", ColumnKind::Text),
        ];
        let head = head.map(|(name, kind)| Heading::new(name, "", kind));
        let varied = self.factors.iter().map(|f| {
            let kind = f.levels.samples().first().map_or(ColumnKind::Float, |v| to_cell(v).kind());
            let unit = if matches!(kind, ColumnKind::Float | ColumnKind::Integer) {
                unit_of(f.path.split('[').next().unwrap_or_default())
            } else {
                ""
            };
            Heading::new(format!("vary.{}", f.path), unit, kind)
        });
        head.into_iter().chain(varied).chain(self.columns.iter().cloned()).collect()
    }

    /// Returns the varied values of a row, in the order of the file.
    fn values(&self, row: u64) -> Vec<toml::Value> {
        let point = self.manifest.design.point(row);
        self.factors.iter().zip(point).map(|(factor, u)| factor.levels.at(u)).collect()
    }

    /// Cooks with varied values; none if it was broken off. An error states why it cannot.
    fn cook(&self, values: &[toml::Value], may_go_on: &dyn Fn() -> bool) -> Result<Option<(Summary, Status)>, String> {
        let (recipe, library) = self.set(self.factors.iter().zip(values))?;
        let mut cook = Cook::new(recipe, &library).map_err(|e| e.to_string())?;
        while cook.stopped().is_none() {
            if cook.kitchen.time_s() >= self.for_s {
                return Ok(Some((cook.summary(0.0), Status::ForS)));
            }
            if !may_go_on() {
                return Ok(None);
            }
            cook.advance().map_err(|e| format!("{}; {}", e.message, e.remedy))?;
        }
        let status = if cook.stopped() == Some(StoppedBy::MaxS) { Status::MaxS } else { Status::Done };
        Ok(Some((cook.summary(0.0), status)))
    }

    /// Returns recipe and library with values set; states why they cannot be used.
    fn set<'a>(
        &self,
        values: impl Iterator<Item = (&'a Factor, &'a toml::Value)>,
    ) -> Result<(Recipe, Arc<Library>), String> {
        let mut recipe = self.documents.recipe.clone();
        let mut data = BTreeMap::<&str, toml::Table>::new();
        for (factor, value) in values {
            let table = match &factor.place.document {
                Document::Recipe => &mut recipe,
                Document::Data(file) => {
                    data.entry(file).or_insert_with(|| self.documents.table(&factor.place.document).unwrap_or_default())
                }
            };
            let done = Documents::set(table, &factor.place, value.clone());
            done.ok_or_else(|| format!("\"{}\" cannot be set", factor.path))?;
        }
        let library = if data.is_empty() { Arc::clone(&self.library) } else { Arc::new(self.library_with(&data)?) };
        let text = toml::to_string(&recipe).map_err(|e| e.to_string())?;
        let mut recipe =
            Recipe::parse(&text, &self.base.file, &library).map_err(|e| format!("{}; {}", e.message, e.remedy))?;
        if let Some(coarseness) = self.coarseness {
            recipe.foods.iter_mut().for_each(|food| food.coarseness = coarseness);
        }
        Ok((recipe, library))
    }

    fn library_with(&self, data: &BTreeMap<&str, toml::Table>) -> Result<Library, String> {
        let mut own = self.base.own.clone();
        for (file, table) in data {
            own.texts.insert((*file).to_owned(), toml::to_string(table).map_err(|e| e.to_string())?);
        }
        let (library, faults) = Library::with_own(&own).map_err(|e| e.message)?;
        // Faults of files that do not vary were reported before the sweep began.
        match faults.into_iter().find(|fault| data.contains_key(fault.file.as_str())) {
            Some(fault) => Err(fault.message),
            None => Ok(library),
        }
    }

    /// Tries values one at a time; returns the columns that the summaries of all have, and what cannot be cooked.
    fn tried_columns(&self, input: InputText, spec: &SpecFile) -> Result<(Vec<Heading>, Vec<InputError>), InputError> {
        let (mut columns, mut doubts) = (BTreeMap::new(), Vec::new());
        let whole = self.set(std::iter::empty()).and_then(|made| add_columns(made, &mut columns));
        whole.or_else(|e| input.error(0, e, "try it with: saute cook"))?;
        for factor in &self.factors {
            let samples = tried(&factor.levels);
            let failures = self.failures(factor, &samples, &mut columns);
            let Some(failure) = failures.first() else { continue };
            let at = spec.vary.keys().find(|key| *key.get_ref() == factor.path).map_or(0, |key| key.span().start);
            let (message, remedy) = failure.split_once("; ").unwrap_or((failure, "change its values"));
            let doubt = input.error(at, format!("\"{}\": {message}", factor.path), remedy);
            if failures.len() == samples.len() {
                return doubt;
            }
            doubts.extend(doubt.err());
        }
        Ok((columns.into_values().collect(), doubts))
    }

    /// Tries values of one path; states why some cannot be cooked. The ends of numbers and all texts are built: they may differ in
    /// their columns.
    fn failures(&self, factor: &Factor, samples: &[toml::Value], columns: &mut Columns) -> Vec<String> {
        let attempt = |(i, value): (usize, &toml::Value)| {
            let made = self.set(std::iter::once((factor, value)));
            let done =
                if i < 2 || value.is_str() { made.and_then(|m| add_columns(m, columns)) } else { made.map(drop) };
            done.err()
        };
        samples.iter().enumerate().filter_map(attempt).collect()
    }
}

/// Columns by their names.
type Columns = BTreeMap<String, Heading>;

/// Adds the columns of a cook; states why it cannot begin.
fn add_columns((recipe, library): (Recipe, Arc<Library>), columns: &mut Columns) -> Result<(), String> {
    let cook = Cook::new(recipe, &library).map_err(|e| e.to_string())?;
    let found = numbers(&cook.summary(0.0));
    columns.extend(found.into_iter().map(|(heading, _)| (heading.name.clone(), heading)));
    Ok(())
}

/// Returns the values to try, the first and the last before the others.
fn tried(levels: &Levels) -> Vec<toml::Value> {
    let mut samples = levels.samples();
    if samples.len() > 2 && !samples[0].is_str() {
        let last = samples.len() - 1;
        samples.swap(1, last);
    }
    samples.dedup();
    samples.truncate(MOST_TRIED);
    samples
}

/// Returns the numbers of a summary; what stopped the cook is in the status of the row.
fn numbers(summary: &Summary) -> Vec<Cell> {
    let mut found = cells(summary);
    found.retain(|(heading, _)| heading.name != "stopped_by");
    found
}

fn by_name(cells: Vec<Cell>) -> BTreeMap<String, Option<Value>> {
    cells.into_iter().map(|(heading, value)| (heading.name, value)).collect()
}

fn to_cell(value: &toml::Value) -> Value {
    match value {
        toml::Value::Integer(v) => Value::Integer(*v),
        toml::Value::Float(v) => Value::Float(*v),
        toml::Value::Boolean(v) => Value::Flag(*v),
        other => Value::Text(other.as_str().map_or_else(|| other.to_string(), str::to_owned)),
    }
}
