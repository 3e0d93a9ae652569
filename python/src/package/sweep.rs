//! Sweeps for Python: a specification whose rows can be cooked anywhere, and the folder of its results.
//!
//! Whoever cooks, this writes the files: the results of a cluster come here as bytes.

use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Arc, Mutex, MutexGuard, PoisonError, mpsc};
use std::time::Duration;

use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;
use pyo3::types::PyBytes;
use saute_schema::InputError;
use saute_sweep::{Base, RowResult, SpecFile, Sweep};
use saute_sweep_folder::cooking::{cook_all, cores, guarded};
use saute_sweep_folder::{SweepFolder, Tally};

use crate::package::errors;
use crate::package::own_data::Shelf;
use crate::package::recipe::Source;

/// How often Python receives the progress, and may interrupt [s] (chosen: smooth to the eye, no cost in time).
const EVERY: Duration = Duration::from_millis(200);

/// Rows of a sweep, those that are in the folder, those of them that failed, and those that came since it was opened.
type Counts = (u64, u64, u64, u64);

/// A sweep: a specification joined with its recipe and data.
#[pyclass(name = "Sweep", module = "saute._core", frozen)]
pub(crate) struct PySweep(Arc<Sweep>);

#[pymethods]
impl PySweep {
    /// Reads a specification: a dict, the text of one, or the path of one; data is a folder of the user's foods, pans and recipes.
    #[new]
    #[pyo3(signature = (spec, data = None))]
    fn new(py: Python<'_>, spec: &Bound<'_, PyAny>, data: Option<PathBuf>) -> PyResult<Self> {
        let (shelf, own) = Shelf::with_files(data)?;
        let spec = Source::of(spec)?;
        // A recipe has lines, even where the specification is a dict.
        let refused = |error: InputError| {
            let has_lines = spec.has_lines || error.file != spec.file();
            errors::at_line(error, has_lines)
        };
        let name = SpecFile::parse(spec.text(), spec.file()).map_err(refused)?.recipe.into_inner();
        let beside = Path::new(spec.file()).with_file_name(&name);
        let recipe = if beside.is_file() { Source::of_path(&beside)? } else { Source::of_words_among(&name, &shelf)? };
        let base = Base { recipe: recipe.text().to_owned(), file: recipe.file().to_owned(), own };
        py.detach(|| Sweep::new(spec.text(), spec.file(), base)).map(Self::of).map_err(refused)
    }

    /// Makes the sweep again from what `parts` gave, perhaps on another machine.
    #[staticmethod]
    fn of_parts(py: Python<'_>, parts: &[u8]) -> PyResult<Self> {
        let made = py.detach(|| Sweep::from_bytes(parts));
        let made = made.ok_or_else(|| PyValueError::new_err("bytes that are no sweep of this version"))?;
        made.map(Self::of).map_err(|error| errors::at_line(error, true))
    }

    /// All that the sweep is made of as bytes: specification, recipe and the user's files.
    fn parts<'py>(&self, py: Python<'py>) -> Bound<'py, PyBytes> {
        PyBytes::new(py, &self.0.to_bytes())
    }

    /// What its rows follow from, as a hash.
    #[getter]
    fn hash(&self) -> String {
        self.0.manifest().hash.clone()
    }

    /// Number of rows.
    #[getter]
    fn rows(&self) -> u64 {
        self.0.manifest().rows
    }

    /// Values that cannot be cooked, with file, line and remedy: rows with them will fail.
    #[getter]
    fn doubts(&self) -> Vec<String> {
        self.0.doubts().iter().map(ToString::to_string).collect()
    }

    /// Cooks rows; returns their results as bytes, for `SweepFolder.take`.
    fn run<'py>(&self, py: Python<'py>, rows: Vec<u64>) -> PyResult<Vec<Bound<'py, PyBytes>>> {
        let rows_of_all = self.rows();
        if let Some(row) = rows.iter().find(|row| **row >= rows_of_all) {
            return Err(PyValueError::new_err(format!("there is no row {row}: the sweep has {rows_of_all}")));
        }
        let mut results = Vec::with_capacity(rows.len());
        for row in rows {
            let cooked = py.detach(|| guarded(&self.0, row, &|| true).map(|result| result.to_bytes()));
            py.check_signals()?;
            results.extend(cooked.map(|bytes| PyBytes::new(py, &bytes)));
        }
        Ok(results)
    }
}

impl PySweep {
    fn of(sweep: Sweep) -> Self {
        Self(Arc::new(sweep))
    }
}

/// The folder of a sweep, to which this program alone writes.
#[pyclass(name = "SweepFolder", module = "saute._core", frozen)]
pub(crate) struct PySweepFolder(Mutex<Option<SweepFolder>>);

impl PySweepFolder {
    fn held(&self) -> MutexGuard<'_, Option<SweepFolder>> {
        self.0.lock().unwrap_or_else(PoisonError::into_inner)
    }

    fn with<R>(&self, work: impl FnOnce(&mut SweepFolder) -> R) -> PyResult<R> {
        let mut held = self.held();
        held.as_mut().map(work).ok_or_else(|| PyValueError::new_err("the folder is closed"))
    }
}

#[pymethods]
impl PySweepFolder {
    /// Opens the folder of a sweep, or makes it.
    #[new]
    fn new(py: Python<'_>, path: PathBuf, sweep: &PySweep) -> PyResult<Self> {
        let sweep = Arc::clone(&sweep.0);
        let folder = py.detach(|| SweepFolder::open(&path, sweep)).map_err(|error| errors::folder(&error))?;
        Ok(Self(Mutex::new(Some(folder))))
    }

    /// Returns up to so many rows to cook; none if all were handed out.
    fn next_rows(&self, most: usize) -> PyResult<Vec<u64>> {
        self.with(|folder| std::iter::from_fn(|| folder.next_row()).take(most).collect())
    }

    /// Takes back rows that have no result; they will be handed out again.
    fn give_back(&self, rows: Vec<u64>) -> PyResult<()> {
        self.with(|folder| rows.into_iter().for_each(|row| folder.give_back(row)))
    }

    /// Takes results; one that is there already is not taken twice.
    fn take(&self, results: Vec<Bound<'_, PyBytes>>) -> PyResult<()> {
        for bytes in results {
            let result = RowResult::from_bytes(bytes.as_bytes());
            let result = result.ok_or_else(|| PyValueError::new_err("bytes that are no result of this version"))?;
            self.with(|folder| folder.take(&result))?.map_err(|error| errors::folder(&error))?;
        }
        Ok(())
    }

    /// How far it is: rows, those that are there, those of them that failed, those that came since it was opened.
    fn tally(&self) -> PyResult<Counts> {
        self.with(|folder| counts(folder.tally()))
    }

    /// Lets others write to the folder.
    fn close(&self) {
        self.held().take();
    }

    /// Cooks all that is missing on threads of this machine, calls `watch` with the progress, and closes the folder.
    #[pyo3(signature = (jobs, watch))]
    fn cook_all(&self, py: Python<'_>, jobs: Option<usize>, watch: &Bound<'_, PyAny>) -> PyResult<Counts> {
        let folder = self.held().take().ok_or_else(|| PyValueError::new_err("the folder is closed"))?;
        let (asked, latest) = (AtomicBool::new(false), Mutex::new(folder.tally()));
        let (finished, done) = mpsc::channel();
        let done = Mutex::new(done);
        let now = || *latest.lock().unwrap_or_else(PoisonError::into_inner);
        std::thread::scope(|scope| {
            scope.spawn(|| {
                let note = |tally: Tally| *latest.lock().unwrap_or_else(PoisonError::into_inner) = tally;
                let goes_on = || !asked.load(Ordering::Relaxed);
                // Whoever waits for it is there as long as this thread.
                let _ = finished.send(cook_all(folder, jobs.unwrap_or_else(cores), &note, &goes_on));
            });
            let wait = || done.lock().unwrap_or_else(PoisonError::into_inner).recv_timeout(EVERY).ok();
            loop {
                if let Some(ended) = py.detach(wait) {
                    return ended.map(counts).map_err(|error| errors::folder(&error));
                }
                let told = py.check_signals().and_then(|()| watch.call1(counts(now())).map(drop));
                if let Err(error) = told {
                    asked.store(true, Ordering::Relaxed);
                    py.detach(|| while wait().is_none() {});
                    return Err(error);
                }
            }
        })
    }
}

fn counts(tally: Tally) -> Counts {
    (tally.rows, tally.done, tally.failed, tally.fresh)
}
