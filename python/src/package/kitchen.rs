//! A kitchen in Python: built from a recipe, stepped, stored and restored.

use std::path::PathBuf;
use std::sync::{Arc, Mutex, PoisonError};

use pyo3::exceptions::{PyKeyError, PyTypeError};
use pyo3::prelude::*;
use pyo3::types::PyBytes;
use saute_kitchen::bytes::Models;
use saute_kitchen::hands::FoodVelocities;
use saute_kitchen::{Kitchen, Library, PieceOrder};
use saute_session::hearing::Sound;

use crate::package::own_data::Shelf;
use crate::package::piece::PyPiece;
use crate::package::recipe::Source;
use crate::package::{errors, expected};

/// Ticks between two looks for Ctrl-C [-] (chosen: some milliseconds to a second of a full pan).
pub(crate) const TICKS_PER_LOOK: u64 = 50;

/// Models that were built in this process, so that restored kitchens and batches share them, and how often they were looked up.
static MODELS: Mutex<Option<(Models, usize)>> = Mutex::new(None);

/// Look-ups after which the models are forgotten [-] (chosen: a search over ever new sizes must not fill the memory). Kitchens keep
/// their own.
const MOST_LOOK_UPS: usize = 512;

/// Does something with the models that are known.
fn with_models<T>(act: impl FnOnce(&mut Models) -> T) -> T {
    let mut known = MODELS.lock().unwrap_or_else(PoisonError::into_inner);
    if known.as_ref().is_some_and(|(_, count)| *count >= MOST_LOOK_UPS) {
        *known = None;
    }
    let (models, count) = known.get_or_insert_default();
    *count += 1;
    act(models)
}

/// What a kitchen is pickled as: what restores it, its bytes and its folder of data.
type Reduced<'py> = (Bound<'py, PyAny>, (Bound<'py, PyBytes>, Option<PathBuf>));

/// A hob, a pan, foods and hands.
///
/// The state is shared with the arrays that were taken from it. A change first copies it where an array lives.
#[derive(Clone)]
#[pyclass(name = "Kitchen", subclass, module = "saute", skip_from_py_object)]
pub(crate) struct PyKitchen {
    pub(crate) state: Arc<Kitchen>,
    /// Velocities of the foods before the last frame.
    pub(crate) before: FoodVelocities,
    /// True for a kitchen of a batch on the reduced mesh, which can only be read.
    pub(crate) is_reduced: bool,
    /// What it was built from.
    pub(crate) shelf: Shelf,
    /// Its sound so far, once that was requested; it is no part of the state.
    pub(crate) sound: Option<Arc<Sound>>,
}

impl PyKitchen {
    pub(crate) fn of(state: Kitchen, shelf: Shelf) -> Self {
        Self { before: FoodVelocities::of(&state), state: Arc::new(state), is_reduced: false, shelf, sound: None }
    }

    /// Checks that it can go on and be stored.
    pub(crate) fn whole(&self) -> PyResult<()> {
        if self.is_reduced {
            return Err(errors::on_reduced_mesh());
        }
        Ok(())
    }

    /// Advances frames or ticks; an array that lives keeps the state of before.
    pub(crate) fn frames(&mut self, count: u64) {
        let kitchen = Arc::make_mut(&mut self.state);
        for _ in 0..count {
            self.before.note(kitchen);
            kitchen.advance_frame();
        }
    }

    pub(crate) fn ticks(&mut self, count: u64) {
        let kitchen = Arc::make_mut(&mut self.state);
        for _ in 0..count {
            tick(kitchen, &mut self.before);
        }
    }
}

/// Advances a kitchen to its next tick, and notes the velocities before the last frame.
fn tick(kitchen: &mut Kitchen, before: &mut FoodVelocities) {
    loop {
        before.note(kitchen);
        if kitchen.advance_frame() {
            return;
        }
    }
}

/// Builds a kitchen, with the models that are known; the mesh is that of the recipe unless a coarseness is given.
fn built(source: &Source, coarseness: Option<f64>, library: &Library) -> PyResult<Kitchen> {
    let recipe = source.recipe(library)?;
    let mut kitchen = recipe.empty_kitchen(library).map_err(|error| errors::setup(&error, &recipe.file))?;
    for food in &recipe.foods {
        let order = PieceOrder { coarseness: coarseness.unwrap_or(food.coarseness), ..food.clone() };
        let added = with_models(|models| kitchen.add_with(library, &order, models));
        added.map_err(|error| errors::setup(&error, &recipe.file))?;
    }
    Ok(kitchen)
}

/// Restores a kitchen, with the models that are known.
fn restored(bytes: &[u8], library: &Library) -> PyResult<Kitchen> {
    with_models(|models| Kitchen::from_bytes_with(bytes, library, models)).map_err(|error| errors::bytes(&error))
}

#[pymethods]
impl PyKitchen {
    /// A kitchen as it is before the first step of a recipe (the steps are for saute.cook), or one with a pan and a food.
    #[new]
    #[pyo3(signature = (
        recipe = None, *, food = None, hob = None, pan = None, size_mm = None, initial_c = None, pan_c = None, seed = None, id = None,
        coarseness = None, data = None
    ))]
    #[allow(clippy::too_many_arguments, reason = "keywords of Python")]
    fn new(
        py: Python<'_>,
        recipe: Option<&Bound<'_, PyAny>>,
        food: Option<&str>,
        hob: Option<&str>,
        pan: Option<&str>,
        size_mm: Option<&Bound<'_, PyAny>>,
        initial_c: Option<f64>,
        pan_c: Option<f64>,
        seed: Option<u32>,
        id: Option<&str>,
        coarseness: Option<f64>,
        data: Option<PathBuf>,
    ) -> PyResult<Self> {
        let allowed = PieceOrder::COARSENESS;
        if let Some(coarseness) = coarseness {
            expected::ranged(coarseness, "coarseness", [*allowed.start(), *allowed.end()])?;
        }
        let shelf = Shelf::of(data)?;
        let others =
            [food, hob, pan].iter().any(Option::is_some) || size_mm.is_some() || initial_c.is_some() || pan_c.is_some();
        let source = match recipe {
            Some(_) if others || seed.is_some() || id.is_some() => {
                return Err(PyTypeError::new_err("give a recipe, or food and pan with their values, not both"));
            }
            Some(recipe) => Source::among(recipe, &shelf)?,
            None => {
                let about_pan = [("kind", pan.into_pyobject(py)?.into_any()), ("initial_c", pan_c.into_pyobject(py)?)];
                let mut about_food = vec![
                    ("kind", food.into_pyobject(py)?.into_any()),
                    ("id", id.unwrap_or("food").into_pyobject(py)?.into_any()),
                    ("initial_c", initial_c.into_pyobject(py)?),
                    ("seed", seed.into_pyobject(py)?),
                ];
                about_food.extend(size_mm.map(|size| ("size_mm", size.clone())));
                let about_hob = [("kind", hob.into_pyobject(py)?.into_any())];
                let about_hob = hob.map(|_| about_hob.as_slice());
                Source::of_parts(py, about_hob, &about_pan, food.map(|_| about_food.as_slice()))?
            }
        };
        let source = source.with_end();
        let state = py.detach(|| built(&source, coarseness, &shelf.library))?;
        Ok(Self::of(state, shelf))
    }

    /// Advances the kitchen by n ticks of 0.1 s, without Python's global lock.
    #[pyo3(signature = (n = 1))]
    fn step(&mut self, py: Python<'_>, n: u64) -> PyResult<()> {
        self.whole()?;
        let mut left = n;
        while left > 0 {
            let now = left.min(TICKS_PER_LOOK);
            py.detach(|| self.ticks(now));
            left -= now;
            py.check_signals()?;
        }
        Ok(())
    }

    /// Advances the kitchen by n frames of 1/60 s; in every sixth, heat flows.
    #[pyo3(signature = (n = 1))]
    fn step_frames(&mut self, py: Python<'_>, n: u64) -> PyResult<()> {
        self.whole()?;
        let mut left = n;
        while left > 0 {
            let now = left.min(TICKS_PER_LOOK);
            py.detach(|| self.frames(now));
            left -= now;
            py.check_signals()?;
        }
        Ok(())
    }

    /// Simulated time [s].
    #[getter]
    fn time_s(&self) -> f64 {
        self.state.time_s()
    }

    /// Ticks of 0.1 s since the start.
    #[getter]
    fn tick(&self) -> u64 {
        self.state.tick()
    }

    /// True while a gesture, a tool or a queued task is active.
    #[getter]
    fn busy(&self) -> bool {
        self.state.busy()
    }

    /// Names of the pieces, in order.
    #[getter]
    fn names(&self) -> Vec<String> {
        self.state.pieces().iter().map(|piece| piece.id.clone()).collect()
    }

    /// Names of the pieces whose last tasks failed because the tool was blocked.
    #[getter]
    fn blocked(&self) -> Vec<String> {
        self.state.blocked()
    }

    /// All pieces, in order.
    #[getter]
    fn pieces(slf: Bound<'_, Self>) -> Vec<PyPiece> {
        let names = slf.borrow().names();
        names.into_iter().map(|id| PyPiece::new(&slf, id)).collect()
    }

    fn __getitem__(slf: Bound<'_, Self>, food: &Bound<'_, PyAny>) -> PyResult<PyPiece> {
        let Ok(food) = food.extract::<String>() else {
            let found = expected::type_name(food);
            return Err(PyTypeError::new_err(format!("a piece is found by its name, text, not {found}")));
        };
        let names = slf.borrow().names();
        if names.contains(&food) {
            return Ok(PyPiece::new(&slf, food));
        }
        Err(PyKeyError::new_err(format!("there is no food \"{food}\" here; there are: {}", names.join(", "))))
    }

    fn __len__(&self) -> usize {
        self.state.pieces().len()
    }

    fn __contains__(&self, food: &str) -> bool {
        self.state.piece(food).is_some()
    }

    /// The whole state as bytes, which restore gives back exactly, on any machine.
    fn snapshot<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyBytes>> {
        self.whole()?;
        let state = Arc::clone(&self.state);
        Ok(PyBytes::new(py, &py.detach(|| state.to_bytes())))
    }

    /// Takes over the state of a snapshot.
    fn restore(&mut self, py: Python<'_>, snapshot: &[u8]) -> PyResult<()> {
        let state = py.detach(|| restored(snapshot, &self.shelf.library))?;
        *self = Self::of(state, self.shelf.clone());
        Ok(())
    }

    /// The kitchen of a snapshot; data is the folder that it was built with.
    #[staticmethod]
    #[pyo3(signature = (snapshot, data = None))]
    fn from_snapshot(py: Python<'_>, snapshot: &[u8], data: Option<PathBuf>) -> PyResult<Self> {
        let shelf = Shelf::of(data)?;
        let state = py.detach(|| restored(snapshot, &shelf.library))?;
        Ok(Self::of(state, shelf))
    }

    /// An independent kitchen in the same state; nothing is copied until one of them is changed.
    fn copy(&self) -> Self {
        self.clone()
    }

    fn __copy__(&self) -> Self {
        self.copy()
    }

    fn __deepcopy__(&self, _memo: &Bound<'_, PyAny>) -> Self {
        self.copy()
    }

    fn __reduce__<'py>(&self, py: Python<'py>) -> PyResult<Reduced<'py>> {
        let restore = py.import("saute._snapshot")?.getattr("kitchen_of")?;
        Ok((restore, (self.snapshot(py)?, self.shelf.folder.clone())))
    }

    /// A number that is equal for equal states: all that the next step reads.
    #[getter]
    fn state_hash(&self) -> u64 {
        self.state.state_hash()
    }

    fn __repr__(&self) -> String {
        format!("<saute.Kitchen at {:.1} s: {}>", self.time_s(), self.names().join(", "))
    }
}
