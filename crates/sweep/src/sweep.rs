//! A sweep: a specification joined with its recipe and data. Its rows are numbered and independent.

use std::collections::{BTreeMap, BTreeSet};
use std::hash::Hasher;
use std::ops::Range;
use std::sync::Arc;

use saute_formats::parquet_file::TableError;
use saute_formats::summary_table::{Cell, cells, unit_of};
use saute_formats::{Heading, Kind, Table, Value};
use saute_kitchen::{InputError, InputText, Library, OwnFiles};
use saute_recipe::{Cook, Recipe, StoppedBy, Summary};
use siphasher::sip::SipHasher13;
use toml::Spanned;

use crate::design::{Design, DesignKind, MOST_DIMENSIONS};
use crate::documents::Documents;
use crate::manifest::Manifest;
use crate::place::{Document, Place};
use crate::row::{RowResult, Status};
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

/// Fewest and most rows of a part unless the file says it [-] (chosen: a killed program loses little, and a folder has few files).
const PART: [u64; 2] = [16, 4096];
/// Parts of a sweep of middle size [-] (chosen as above).
const PARTS: u64 = 64;
/// Most rows of a sweep [-] (chosen: the digits of a Sobol' sequence end there).
const MOST_ROWS: u64 = 1 << 32;
/// Most texts of a list that are tried before the sweep begins [-] (chosen: more than there are kinds of anything).
const MOST_TRIED: usize = 64;

/// A value that varies.
#[derive(Clone, Debug)]
struct Factor {
    path: String,
    place: Place,
    levels: Levels,
}

/// A specification joined with its recipe and data.
#[derive(Debug)]
pub struct Sweep {
    base: Base,
    documents: Documents,
    library: Arc<Library>,
    factors: Vec<Factor>,
    for_s: f64,
    coarseness: f64,
    columns: Vec<Heading>,
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
        let ranged = |key, value: &Option<Spanned<f64>>, default, low, high| {
            value.as_ref().map_or(Ok(default), |value| input.ranged(key, value, low, high))
        };
        let varied = factors.iter().map(|f| f.path.clone()).collect();
        let mut sweep = Self {
            for_s: ranged("for_s", &spec.for_s, f64::INFINITY, 0.1, 86_400.0)?,
            coarseness: ranged("coarseness", &spec.coarseness, 1.0, 1.0, 8.0)?,
            manifest: Manifest::new(hash(text, &base, &documents), spec.recipe.get_ref(), varied, design, rows),
            base,
            documents,
            library,
            factors,
            columns: Vec::new(),
        };
        sweep.columns = sweep.tried_columns(input, &spec)?;
        Ok(sweep)
    }

    /// What a folder with its results holds.
    pub fn manifest(&self) -> &Manifest {
        &self.manifest
    }

    /// Returns the rows of a part.
    pub fn part_rows(&self, part: u64) -> Range<u64> {
        self.manifest.part_rows(part)
    }

    /// Cooks a row. The result depends on nothing but the row's number.
    pub fn run_row(&self, row: u64) -> RowResult {
        let values = self.values(row);
        let varied: Vec<Value> = values.iter().map(to_cell).collect();
        match self.cook(&values) {
            Ok((summary, status)) => {
                let mut found: BTreeMap<String, Option<Value>> = by_name(cells(&summary));
                let number = |h: &Heading| found.remove(&h.name).flatten().and_then(|value| value.to_kind(h.kind));
                let numbers = self.columns.iter().map(number).collect();
                RowResult { row, status, message: None, varied, numbers }
            }
            Err(message) => {
                let numbers = vec![None; self.columns.len()];
                RowResult { row, status: Status::Failed, message: Some(message), varied, numbers }
            }
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
            ("row", Kind::Integer),
            ("status", Kind::Text),
            ("message", Kind::Text),
            ("seed", Kind::Integer),
            ("recipe", Kind::Text),
            ("version", Kind::Text),
        ];
        let head = head.map(|(name, kind)| Heading::new(name, "", kind));
        let varied = self.factors.iter().map(|f| {
            let kind = f.levels.samples().first().map_or(Kind::Float, |v| to_cell(v).kind());
            let unit = if matches!(kind, Kind::Float | Kind::Integer) {
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

    /// Cooks with varied values; says why it cannot.
    fn cook(&self, values: &[toml::Value]) -> Result<(Summary, Status), String> {
        let (recipe, library) = self.set(self.factors.iter().zip(values))?;
        let mut cook = Cook::new(recipe, &library).map_err(|e| e.to_string())?;
        while cook.stopped().is_none() {
            if cook.kitchen.time_s() >= self.for_s {
                return Ok((cook.summary(0.0), Status::ForS));
            }
            cook.advance().map_err(|e| format!("{}; {}", e.message, e.remedy))?;
        }
        let status = if cook.stopped() == Some(StoppedBy::MaxS) { Status::MaxS } else { Status::Done };
        Ok((cook.summary(0.0), status))
    }

    /// Returns recipe and library with values set; says why they cannot be used.
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
        recipe.foods.iter_mut().for_each(|food| food.coarseness = self.coarseness);
        Ok((recipe, library))
    }

    fn library_with(&self, data: &BTreeMap<&str, toml::Table>) -> Result<Library, String> {
        let mut own = self.base.own.clone();
        for (file, table) in data {
            own.texts.insert((*file).to_owned(), toml::to_string(table).map_err(|e| e.to_string())?);
        }
        let (library, faults) = Library::with_own(&own).map_err(|e| e.message)?;
        // Faults of files that do not vary were told before the sweep began.
        match faults.into_iter().find(|fault| data.contains_key(fault.file.as_str())) {
            Some(fault) => Err(fault.message),
            None => Ok(library),
        }
    }

    /// Tries values one at a time; returns the columns that the summaries of all have.
    fn tried_columns(&self, input: InputText, spec: &SpecFile) -> Result<Vec<Heading>, InputError> {
        let mut columns = BTreeMap::new();
        let mut add = |(recipe, library): (Recipe, Arc<Library>)| -> Result<(), String> {
            let cook = Cook::new(recipe, &library).map_err(|e| e.to_string())?;
            let found = cells(&cook.summary(0.0));
            columns.extend(found.into_iter().map(|(heading, _)| (heading.name.clone(), heading)));
            Ok(())
        };
        self.set(std::iter::empty()).and_then(&mut add).or_else(|e| input.error(0, e, "try it with: saute cook"))?;
        for factor in &self.factors {
            let samples = tried(&factor.levels);
            let mut failures = Vec::new();
            for value in &samples {
                let outcome = self.set(std::iter::once((factor, value))).and_then(&mut add);
                failures.extend(outcome.err());
            }
            if failures.len() == samples.len() {
                let at = spec.vary.keys().find(|key| *key.get_ref() == factor.path).map_or(0, |key| key.span().start);
                let failure = failures.swap_remove(0);
                let (message, remedy) = failure.split_once("; ").unwrap_or((&failure, "change its values"));
                return input.error(at, format!("\"{}\": {message}", factor.path), remedy);
            }
        }
        Ok(columns.into_values().collect())
    }
}

/// Returns the values to try: the first and the last number, every text.
fn tried(levels: &Levels) -> Vec<toml::Value> {
    let mut samples = levels.samples();
    if samples.first().is_some_and(toml::Value::is_str) {
        samples.truncate(MOST_TRIED);
    } else if samples.len() > 2 {
        let last = samples.len() - 1;
        samples.swap(1, last);
        samples.truncate(2);
    }
    samples
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

/// Returns the varied values in the order of the file.
fn factors(input: InputText, spec: &SpecFile, documents: &Documents) -> Result<Vec<Factor>, InputError> {
    let mut entries: Vec<_> = spec.vary.iter().collect();
    entries.sort_by_key(|(path, _)| path.span().start);
    let kind = spec.design.get_ref().kind;
    let mut factors = Vec::new();
    let mut places = BTreeSet::new();
    for (key, value) in entries {
        let (path, at) = (key.get_ref(), key.span().start);
        let levels = Levels::read(input, at, path, value.get_ref(), kind)?;
        let place = Place::find(path, documents).or_else(|(message, remedy)| input.error(at, message, remedy))?;
        if !places.insert((place.document.clone(), format!("{:?}", place.steps))) {
            return input.error(at, format!("\"{path}\" varies twice"), "leave one of the lines out");
        }
        factors.push(Factor { path: path.clone(), place, levels });
    }
    if factors.is_empty() {
        let remedy = "write a line such as \"pan.initial_c\" = [20, 40] under [vary]";
        return input.error(spec.design.span().start, "nothing varies: [vary] is empty", remedy);
    }
    Ok(factors)
}

fn design(input: InputText, spec: &SpecFile, factors: &[Factor]) -> Result<Design, InputError> {
    let (entry, at) = (spec.design.get_ref(), spec.design.span().start);
    let n = match (&entry.n, entry.kind) {
        (None, DesignKind::Grid) => 0,
        (Some(n), DesignKind::Grid) => {
            let remedy = "leave n out: a grid has every combination of the levels";
            return input.error(n.span().start, "n is no key of a grid", remedy);
        }
        (Some(n), _) if *n.get_ref() >= 1 => n.get_ref().unsigned_abs(),
        (Some(n), _) => return input.error(n.span().start, "n is out of range", "write a whole number of 1 or more"),
        (None, _) => return input.error(at, "[design] has no n", "write, for instance, n = 64"),
    };
    let needed = if entry.kind == DesignKind::Saltelli { 2 * factors.len() } else { factors.len() };
    if matches!(entry.kind, DesignKind::Saltelli | DesignKind::Sobol) && needed > MOST_DIMENSIONS {
        let message = format!("{} values vary, for which a Sobol' sequence has too few dimensions", factors.len());
        let remedy = "vary fewer, or use kind = \"morris\" or \"latin-hypercube\"";
        return input.error(at, message, remedy);
    }
    let levels = factors.iter().map(|f| f.levels.count()).collect();
    Ok(Design { kind: entry.kind, n, seed: u64::from(entry.seed.unwrap_or(1)), levels })
}

/// Returns the number of rows and of rows in a part.
fn size(input: InputText, spec: &SpecFile, design: &Design) -> Result<[u64; 2], InputError> {
    let Some(rows) = design.rows().filter(|rows| *rows <= MOST_ROWS) else {
        let message = format!("the design has more than {MOST_ROWS} rows");
        return input.error(spec.design.span().start, message, "vary fewer values, or fewer levels of them");
    };
    let part = match &spec.rows_per_part {
        None => (rows / PARTS).clamp(PART[0], PART[1]),
        Some(part) if (1..=100_000).contains(part.get_ref()) => part.get_ref().unsigned_abs(),
        Some(part) => return input.error(part.span().start, "rows_per_part is out of range", "write 1 to 100000"),
    };
    Ok([rows, part])
}

/// Returns the hash of what the rows follow from.
fn hash(text: &str, base: &Base, documents: &Documents) -> u64 {
    let mut hasher = SipHasher13::new();
    let mut add = |bytes: &[u8]| {
        hasher.write(&(bytes.len() as u64).to_le_bytes());
        hasher.write(bytes);
    };
    // Comments and line ends change no row.
    let canonical =
        |text: &str| text.parse().ok().and_then(|t: toml::Table| toml::to_string(&t).ok()).unwrap_or_default();
    add(env!("CARGO_PKG_VERSION").as_bytes());
    add(canonical(text).as_bytes());
    add(canonical(&base.recipe).as_bytes());
    for (path, text) in &documents.data {
        add(path.as_bytes());
        add(text.replace('\r', "").as_bytes());
    }
    for (path, soup) in &base.own.surfaces {
        add(path.as_bytes());
        let numbers: Vec<u8> = soup.vertices.iter().flatten().flat_map(|v| v.to_le_bytes()).collect();
        add(&numbers);
    }
    hasher.finish()
}
