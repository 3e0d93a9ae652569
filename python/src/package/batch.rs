//! Many kitchens at once, on all cores.

use std::sync::Arc;

use pyo3::exceptions::{PyIndexError, PyTypeError, PyValueError};
use pyo3::prelude::*;
use pyo3::types::PyList;
use rayon::ThreadPool;
use rayon::prelude::*;
use saute_kitchen::hands::FoodVelocities;
use saute_kitchen::{Command, Kitchen, Refused, celsius};

use crate::package::array::made;
use crate::package::commands::rest_on;
use crate::package::errors;
use crate::package::kitchen::{PyKitchen, tick};
use crate::package::score::{goal, scored};

/// Ticks between two looks for Ctrl-C [-] (chosen: seconds of a thousand kitchens).
const TICKS_PER_LOOK: u64 = 10;

/// One kitchen of a batch.
struct Seat {
    state: Arc<Kitchen>,
    before: FoodVelocities,
}

/// Kitchens that step together. Each one is what it would be alone, for any number of threads.
#[pyclass(name = "KitchenBatch", subclass, module = "saute")]
pub(crate) struct PyBatch {
    seats: Vec<Seat>,
    pool: ThreadPool,
    pieces: usize,
    /// NumPy's type of a row.
    kind: Py<PyAny>,
}

/// Columns of a kitchen, and of each of its pieces.
const OF_KITCHEN: [&str; 5] = ["time_s", "hob_w", "hob_drawn_w", "pan_c", "busy"];
const OF_PIECE: [&str; 15] = [
    "core_c",
    "core_peak_c",
    "top_c",
    "bottom_c",
    "mass_g",
    "lost_pct",
    "top_browned_pct",
    "bottom_browned_pct",
    "top_charred_pct",
    "bottom_charred_pct",
    "top_lab_l",
    "top_lab_a",
    "top_lab_b",
    "in_pan",
    "upside_down",
];

/// Reads the columns of a kitchen.
fn row(kitchen: &Kitchen) -> Vec<f64> {
    let truth = |value: bool| f64::from(u8::from(value));
    let own = [
        kitchen.time_s(),
        kitchen.hob_w(),
        kitchen.hob_drawn_w(),
        celsius(kitchen.pan_temperature()),
        truth(kitchen.busy()),
    ];
    let pieces: Vec<[f64; OF_PIECE.len()]> = kitchen
        .pieces()
        .iter()
        .map(|piece| {
            let face =
                |below: bool| piece.model.face_reading(&piece.state, piece.up().map(|u| if below { u } else { -u }));
            let (top, bottom) = (face(false), face(true));
            let mass = piece.mass();
            [
                celsius(piece.core()),
                celsius(piece.core_peak.0),
                celsius(piece.face(false)),
                celsius(piece.face(true)),
                1e3 * mass,
                100.0 * (1.0 - mass / piece.model.raw_mass()),
                top.browned_pct,
                bottom.browned_pct,
                top.charred_pct,
                bottom.charred_pct,
                top.lab.0[0],
                top.lab.0[1],
                top.lab.0[2],
                truth(piece.in_pan()),
                truth(piece.upside_down()),
            ]
        })
        .collect();
    // Column after column, as a structured array has them.
    let columns = (0..OF_PIECE.len()).flat_map(|k| pieces.iter().map(move |piece| piece[k]));
    own.into_iter().chain(columns).collect()
}

/// Returns NumPy's type of a row of readings.
fn kind(py: Python<'_>, pieces: usize) -> PyResult<Py<PyAny>> {
    let own = OF_KITCHEN.map(|name| (name, "<f8").into_pyobject(py).map(Bound::into_any));
    let piece = OF_PIECE.map(|name| (name, "<f8", (pieces,)).into_pyobject(py).map(Bound::into_any));
    let columns: Vec<Bound<'_, PyAny>> = own.into_iter().chain(piece).collect::<PyResult<_>>()?;
    Ok(py.import("numpy")?.getattr("dtype")?.call1((columns,))?.unbind())
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

impl PyBatch {
    fn each(&mut self, py: Python<'_>, act: impl Fn(&mut Seat) + Send + Sync) {
        let Self { seats, pool, .. } = self;
        py.detach(|| pool.install(|| seats.par_iter_mut().for_each(act)));
    }

    /// Sends a command to the chosen kitchens. Those that do not take it stay as they are and are named in the error.
    fn command(&mut self, mask: Option<Vec<bool>>, command: impl Fn(usize) -> Command) -> PyResult<()> {
        let chosen = chosen(mask, self.seats.len())?;
        let mut refused: Option<Refused> = None;
        let mut places = Vec::new();
        for (i, seat) in self.seats.iter_mut().enumerate().filter(|(i, _)| chosen[*i]) {
            if let Err(reason) = Arc::make_mut(&mut seat.state).apply(&command(i)) {
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
}

#[pymethods]
impl PyBatch {
    /// Kitchens with equally many pieces; threads is the number of cores by default.
    #[new]
    #[pyo3(signature = (kitchens, *, threads = None))]
    fn new(py: Python<'_>, kitchens: &Bound<'_, PyAny>, threads: Option<usize>) -> PyResult<Self> {
        if threads == Some(0) {
            return Err(PyValueError::new_err("threads = 0: write 1 or more, or None for all cores"));
        }
        let wrong = || PyTypeError::new_err("kitchens must be a list of Kitchen");
        let mut batch = Self {
            seats: Vec::new(),
            pool: rayon::ThreadPoolBuilder::new()
                .num_threads(threads.unwrap_or(0))
                .build()
                .map_err(|error| errors::fault(&error))?,
            pieces: 0,
            kind: py.None(),
        };
        for kitchen in kitchens.try_iter().map_err(|_| wrong())? {
            let kitchen = kitchen?;
            let kitchen = kitchen.cast::<PyKitchen>().map_err(|_| wrong())?.borrow();
            if batch.seats.is_empty() {
                batch.pieces = kitchen.state.pieces().len();
            }
            batch.check(&kitchen.state)?;
            batch.seats.push(Seat { state: Arc::clone(&kitchen.state), before: kitchen.before.clone() });
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

    fn __len__(&self) -> usize {
        self.seats.len()
    }

    /// Advances every kitchen by n ticks of 0.1 s, without Python's global lock, and returns the readings.
    #[pyo3(signature = (n = 1))]
    fn step<'py>(&mut self, py: Python<'py>, n: u64) -> PyResult<Bound<'py, PyAny>> {
        let mut left = n;
        while left > 0 {
            let now = left.min(TICKS_PER_LOOK);
            self.each(py, |Seat { state, before }| {
                let kitchen = Arc::make_mut(state);
                (0..now).for_each(|_| tick(kitchen, before));
            });
            left -= now;
            py.check_signals()?;
        }
        self.readings(py)
    }

    /// The readings of all kitchens: a structured array with a row for each one.
    fn readings<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        let Self { seats, pool, .. } = self;
        let rows: Vec<Vec<f64>> =
            py.detach(|| pool.install(|| seats.par_iter().map(|seat| row(&seat.state)).collect()));
        made(py, rows.concat())?.call_method1("view", (self.kind.bind(py),))
    }

    /// Scores against a goal [points], one for each kitchen; flips are those of each one.
    #[pyo3(signature = (target = "medium", *, crust_pct = 60.0, scale = "chefs", flips = None))]
    fn scores<'py>(
        &self,
        py: Python<'py>,
        target: &str,
        crust_pct: f64,
        scale: &str,
        flips: Option<Vec<usize>>,
    ) -> PyResult<Bound<'py, PyAny>> {
        let goal = goal(target, crust_pct, scale)?;
        let flips = flips.unwrap_or_else(|| vec![0; self.seats.len()]);
        if flips.len() != self.seats.len() || self.pieces == 0 {
            let wrong = format!("flips must have {} numbers, and the kitchens a piece", self.seats.len());
            return Err(PyValueError::new_err(wrong));
        }
        let Self { seats, pool, .. } = self;
        let score = |(seat, flips): (&Seat, &usize)| scored(&seat.state, &goal, *flips).1;
        let scores: Vec<f64> = py.detach(|| pool.install(|| seats.par_iter().zip(&flips).map(score).collect()));
        made(py, scores)
    }

    /// Sets the power of every hob [W]: one number, or one for each kitchen.
    #[pyo3(signature = (w, *, r#where = None))]
    fn hob(&mut self, w: &Bound<'_, PyAny>, r#where: Option<Vec<bool>>) -> PyResult<()> {
        let count = self.seats.len();
        let powers = match w.extract::<Vec<f64>>() {
            Ok(powers) => powers,
            Err(_) => w.extract::<f64>().map(|power| vec![power; count]).unwrap_or_default(),
        };
        if powers.len() != count {
            return Err(PyTypeError::new_err(format!("w must be a number or {count} numbers, in W")));
        }
        self.command(r#where, |i| Command::Hob(powers[i]))
    }

    /// Puts a piece into the middle of every pan.
    #[pyo3(signature = (food, *, r#where = None))]
    fn put(&mut self, food: &str, r#where: Option<Vec<bool>>) -> PyResult<()> {
        self.command(r#where, |_| Command::Put { food: food.to_owned(), at: [0.0; 2], heap: false })
    }

    /// Turns a piece over in every kitchen, or where the mask says so.
    #[pyo3(signature = (food, *, r#where = None))]
    fn flip(&mut self, food: &str, r#where: Option<Vec<bool>>) -> PyResult<()> {
        self.command(r#where, |_| Command::Flip { food: food.to_owned() })
    }

    /// Takes a piece out of every pan, or where the mask says so.
    #[pyo3(signature = (food, on = "board", *, r#where = None))]
    fn rest(&mut self, food: &str, on: &str, r#where: Option<Vec<bool>>) -> PyResult<()> {
        let on = rest_on(on)?;
        self.command(r#where, |_| Command::Rest { food: food.to_owned(), on })
    }

    /// A kitchen of the batch, as it is now; what is done to it does not change the batch.
    fn __getitem__(&self, index: isize) -> PyResult<PyKitchen> {
        let seat = &self.seats[self.seat(index)?];
        Ok(PyKitchen { state: Arc::clone(&seat.state), before: seat.before.clone() })
    }

    /// Puts a kitchen in the place of another.
    fn __setitem__(&mut self, index: isize, kitchen: PyRef<'_, PyKitchen>) -> PyResult<()> {
        self.check(&kitchen.state)?;
        let at = self.seat(index)?;
        self.seats[at] = Seat { state: Arc::clone(&kitchen.state), before: kitchen.before.clone() };
        Ok(())
    }

    /// Numbers that are equal for equal states.
    fn state_hashes<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyList>> {
        PyList::new(py, self.seats.iter().map(|seat| seat.state.state_hash()))
    }
}
