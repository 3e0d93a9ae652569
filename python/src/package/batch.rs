//! Many kitchens at once, on all cores.

use std::sync::Arc;

use pyo3::exceptions::{PyIndexError, PyTypeError, PyValueError};
use pyo3::prelude::*;
use pyo3::types::PyList;
use rayon::ThreadPool;
use rayon::prelude::*;
use saute_kitchen::{Command, Kitchen, Refused};

use crate::package::array::made;
use crate::package::errors;
use crate::package::kitchen::PyKitchen;
use crate::package::readings::{kind, row};
use crate::package::score::{goal, scored};
use crate::package::seat::{Mesh, Seat};

/// Ticks of all kitchens together between two looks for Ctrl-C [-] (chosen: about a second of one core; at a look the threads wait
/// for each other).
const WORK_PER_LOOK: u64 = 6400;

/// Kitchens that step together. Each one is what it would be alone, for any number of threads.
#[pyclass(name = "KitchenBatch", subclass, module = "saute")]
pub(crate) struct PyBatch {
    seats: Vec<Seat>,
    pool: Arc<ThreadPool>,
    pieces: usize,
    mesh: Mesh,
    /// NumPy's type of a row.
    kind: Py<PyAny>,
}

/// Which kitchens a mask names; all of them without one.
fn chosen(mask: Option<Vec<bool>>, count: usize) -> PyResult<Vec<bool>> {
    let Some(mask) = mask else { return Ok(vec![true; count]) };
    let found = mask.len();
    if found == count {
        Ok(mask)
    } else {
        Err(PyValueError::new_err(format!("where must have {count} truth values, not {found}")))
    }
}

/// Reads a number for each kitchen, or one for all; `form` states what they are.
pub(crate) fn each<T>(value: &Bound<'_, PyAny>, count: usize, form: &str) -> PyResult<Vec<T>>
where
    T: Clone + for<'a, 'py> FromPyObject<'a, 'py>,
{
    let found = match value.extract::<Vec<T>>() {
        Ok(list) => list,
        Err(_) => value.extract::<T>().map(|one| vec![one; count]).unwrap_or_default(),
    };
    if found.len() == count { Ok(found) } else { Err(PyTypeError::new_err(form.to_owned())) }
}

impl PyBatch {
    /// Number of kitchens.
    pub(crate) fn count(&self) -> usize {
        self.seats.len()
    }

    /// Lets every kitchen go on by its own number of ticks or frames.
    fn advance(&mut self, py: Python<'_>, counts: &[u64], go: impl Fn(&mut Seat, u64) + Sync) -> PyResult<()> {
        let Self { seats, pool, .. } = self;
        let most = counts.iter().copied().max().unwrap_or_default();
        // Kitchens that go further than the others do so in one piece of work: the others wait for no look.
        let even = (WORK_PER_LOOK / counts.len().max(1) as u64).max(1);
        let per_look = if counts.iter().all(|n| *n == most) { even } else { most };
        let mut done = 0;
        while done < most {
            let share = |count: u64| count.saturating_sub(done).min(per_look);
            let each = |(seat, count): (&mut Seat, &u64)| go(seat, share(*count));
            py.detach(|| pool.install(|| seats.par_iter_mut().zip(counts).with_max_len(1).for_each(each)));
            done += per_look;
            py.check_signals()?;
        }
        Ok(())
    }

    /// Reads how far the kitchens are to go: all by one number, or each by its own; 1 by default.
    fn counts(&self, n: Option<&Bound<'_, PyAny>>, what: &str) -> PyResult<Vec<u64>> {
        let count = self.count();
        n.map_or(Ok(vec![1; count]), |n| each(n, count, &format!("n must be a number of {what}, or {count} of them")))
    }

    /// Sends a command to the chosen kitchens. Those that do not take it stay as they are and are named in the error.
    pub(crate) fn command(&mut self, mask: Option<Vec<bool>>, command: impl Fn(usize) -> Command) -> PyResult<()> {
        let chosen = chosen(mask, self.seats.len())?;
        let mut refused: Option<Refused> = None;
        let mut places = Vec::new();
        for (i, seat) in self.seats.iter_mut().enumerate().filter(|(i, _)| chosen[*i]) {
            if let Err(reason) = seat.apply(&command(i)) {
                refused.get_or_insert(reason);
                places.push(i);
            }
        }
        refused.map_or(Ok(()), |reason| Err(errors::refused_at(&reason, &places)))
    }

    fn seat(&self, index: isize) -> PyResult<usize> {
        let count = self.seats.len();
        let at = if index < 0 { index + count as isize } else { index };
        let in_range = usize::try_from(at).ok().filter(|i| *i < count);
        in_range.ok_or_else(|| PyIndexError::new_err(format!("there is no kitchen {index}; there are {count}")))
    }

    fn check(&self, kitchen: &Kitchen) -> PyResult<()> {
        let found = kitchen.pieces().len();
        if found == self.pieces {
            return Ok(());
        }
        let expected = self.pieces;
        Err(PyValueError::new_err(format!("all kitchens of a batch must have as many pieces: {expected}, not {found}")))
    }

    fn add(&mut self, kitchen: &Bound<'_, PyAny>) -> PyResult<()> {
        let kitchen = kitchen.cast::<PyKitchen>().map_err(|_| not_kitchens())?.borrow();
        if self.seats.is_empty() {
            self.pieces = kitchen.state.pieces().len();
        }
        self.check(&kitchen.state)?;
        self.seats.push(Seat::of(&kitchen, self.mesh)?);
        Ok(())
    }
}

fn not_kitchens() -> PyErr {
    PyTypeError::new_err("kitchens must be a list of Kitchen")
}

fn pool(threads: Option<usize>) -> PyResult<Arc<ThreadPool>> {
    if threads == Some(0) {
        return Err(PyValueError::new_err("threads = 0: write 1 or more, or None for all cores"));
    }
    let pool = rayon::ThreadPoolBuilder::new().num_threads(threads.unwrap_or(0)).build();
    pool.map(Arc::new).map_err(|error| errors::fault(&error))
}

#[pymethods]
impl PyBatch {
    /// Kitchens with equally many pieces; threads is the number of cores by default. With reduced, pan and slices go on with
    /// coarse meshes and steps of half a second, in a few per cent of the time; nothing moves there but what is turned over or
    /// taken out.
    #[new]
    #[pyo3(signature = (kitchens, *, threads = None, reduced = false))]
    fn new(py: Python<'_>, kitchens: &Bound<'_, PyAny>, threads: Option<usize>, reduced: bool) -> PyResult<Self> {
        let mesh = if reduced { Mesh::Reduced } else { Mesh::Whole };
        let mut batch = Self { seats: Vec::new(), pool: pool(threads)?, pieces: 0, mesh, kind: py.None() };
        for kitchen in kitchens.try_iter().map_err(|_| not_kitchens())? {
            batch.add(&kitchen?)?;
        }
        if batch.seats.is_empty() {
            return Err(PyValueError::new_err("kitchens must have at least one Kitchen"));
        }
        batch.kind = kind(py, batch.pieces)?;
        Ok(batch)
    }

    /// Number of threads.
    #[getter]
    fn threads(&self) -> usize {
        self.pool.current_num_threads()
    }

    /// True on the reduced mesh.
    #[getter]
    fn reduced(&self) -> bool {
        self.mesh == Mesh::Reduced
    }

    fn __len__(&self) -> usize {
        self.seats.len()
    }

    /// Advances every kitchen by n ticks of 0.1 s, or each one by its own number, without Python's global lock, and returns the
    /// readings.
    #[pyo3(signature = (n = None))]
    fn step<'py>(&mut self, py: Python<'py>, n: Option<&Bound<'py, PyAny>>) -> PyResult<Bound<'py, PyAny>> {
        let ticks = self.counts(n, "ticks")?;
        ticks.iter().try_for_each(|ticks| self.mesh.check(*ticks))?;
        self.advance(py, &ticks, Seat::ticks)?;
        self.readings(py)
    }

    /// Advances every kitchen by n frames of 1/60 s, or each one by its own number, and returns the readings.
    #[pyo3(signature = (n = None))]
    fn step_frames<'py>(&mut self, py: Python<'py>, n: Option<&Bound<'py, PyAny>>) -> PyResult<Bound<'py, PyAny>> {
        if self.mesh == Mesh::Reduced {
            return Err(PyValueError::new_err("on the reduced mesh nothing moves: use step"));
        }
        let frames = self.counts(n, "frames")?;
        self.advance(py, &frames, Seat::frames)?;
        self.readings(py)
    }

    /// The readings of all kitchens: a structured array with a row for each one.
    fn readings<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        let Self { seats, pool, .. } = self;
        let rows: Vec<Vec<f64>> =
            py.detach(|| pool.install(|| seats.par_iter().map(|seat| row(seat.kitchen())).collect()));
        made(py, rows.concat())?.call_method1("view", (self.kind.bind(py),))
    }

    /// Scores against a goal [points], one for each kitchen, or for those that the mask names; flips are those of each one.
    #[pyo3(signature = (target = "medium", *, crust_pct = 60.0, scale = "chefs", flips = None, r#where = None))]
    fn scores<'py>(
        &self,
        py: Python<'py>,
        target: &str,
        crust_pct: f64,
        scale: &str,
        flips: Option<Vec<usize>>,
        r#where: Option<Vec<bool>>,
    ) -> PyResult<Bound<'py, PyAny>> {
        let goal = goal(target, crust_pct, scale, self.seats[0].library())?;
        let chosen = chosen(r#where, self.seats.len())?;
        let flips = flips.unwrap_or_else(|| vec![0; self.seats.len()]);
        if flips.len() != self.seats.len() || self.pieces == 0 {
            let wrong = format!("flips must have {} numbers, and the kitchens a piece", self.seats.len());
            return Err(PyValueError::new_err(wrong));
        }
        let Self { seats, pool, .. } = self;
        let score = |i: usize| scored(seats[i].kitchen(), &goal, flips[i]).1;
        let all = (0..seats.len()).into_par_iter().filter(|i| chosen[*i]).map(score);
        let scores: Vec<f64> = py.detach(|| pool.install(|| all.collect()));
        made(py, scores)
    }

    /// A kitchen of the batch, as it is now; what is done to it does not change the batch. One on the reduced mesh can only be
    /// read.
    fn __getitem__(&self, index: isize) -> PyResult<PyKitchen> {
        Ok(self.seats[self.seat(index)?].taken())
    }

    /// Puts a kitchen in the place of another.
    fn __setitem__(&mut self, index: isize, kitchen: PyRef<'_, PyKitchen>) -> PyResult<()> {
        let at = self.seat(index)?;
        self.check(&kitchen.state)?;
        self.seats[at] = Seat::of(&kitchen, self.mesh)?;
        Ok(())
    }

    /// Numbers that are equal for equal states.
    fn state_hashes<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyList>> {
        PyList::new(py, self.seats.iter().map(|seat| seat.kitchen().state_hash()))
    }
}
