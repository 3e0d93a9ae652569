//! A piece of food in a kitchen: readings of the present state.

mod fields;

use std::collections::BTreeMap;
use std::sync::Arc;

use pyo3::exceptions::{PyKeyError, PyValueError};
use pyo3::prelude::*;
use saute_kitchen::food::change::Lab;
use saute_kitchen::{Kitchen, Piece, Place, celsius, doneness};

use crate::package::array::made;
use crate::package::expected::seven;
use crate::package::kitchen::PyKitchen;

/// A piece of food. It reads the present state of its kitchen; arrays show the state as it was when requested.
#[pyclass(name = "Piece", frozen, module = "saute")]
pub(crate) struct PyPiece {
    kitchen: Py<PyKitchen>,
    id: String,
}

impl PyPiece {
    pub(crate) fn new(kitchen: &Bound<'_, PyKitchen>, id: String) -> Self {
        Self { kitchen: kitchen.clone().unbind(), id }
    }

    /// Returns the state of the kitchen and the index of the piece.
    pub(crate) fn found(&self, py: Python<'_>) -> PyResult<(Arc<Kitchen>, usize)> {
        let state = Arc::clone(&self.kitchen.bind(py).try_borrow()?.state);
        let index = state.pieces().iter().position(|piece| piece.id == self.id);
        let gone = || PyKeyError::new_err(format!("there is no food \"{}\" in the kitchen any more", self.id));
        Ok((state, index.ok_or_else(gone)?))
    }

    fn read<T>(&self, py: Python<'_>, read: impl FnOnce(&Piece) -> T) -> PyResult<T> {
        let (state, index) = self.found(py)?;
        Ok(read(&state.pieces()[index]))
    }
}

/// Readings of a face.
fn face(piece: &Piece, below: bool) -> BTreeMap<&'static str, f64> {
    let up = piece.up().map(|u| if below { u } else { -u });
    let face = piece.model.face_reading(&piece.state, up);
    let Lab([l, a, b]) = face.lab;
    BTreeMap::from([
        ("temperature_c", celsius(face.temperature)),
        ("browning", face.browning),
        ("browned_pct", face.browned_pct),
        ("charred_pct", face.charred_pct),
        ("water_pct", 100.0 * face.moisture),
        ("l", l),
        ("a", a),
        ("b", b),
    ])
}

#[pymethods]
impl PyPiece {
    /// Name in the recipe.
    #[getter]
    fn id(&self) -> &str {
        &self.id
    }

    /// Kind of food.
    #[getter]
    fn kind(&self, py: Python<'_>) -> PyResult<String> {
        self.read(py, |piece| piece.kind.clone())
    }

    /// Where it is: "waiting", "pan", "held", "board", "rack", "foil", "glass" or "table".
    #[getter]
    fn place(&self, py: Python<'_>) -> PyResult<&'static str> {
        self.read(py, |piece| piece.place.name())
    }

    /// Its centre in the pan, relative to the pan's [mm]; None elsewhere.
    #[getter]
    fn at_mm(&self, py: Python<'_>) -> PyResult<Option<(f64, f64)>> {
        self.read(py, |piece| match piece.place {
            Place::Pan([x, y]) => Some((1e3 * x, 1e3 * y)),
            _ => None,
        })
    }

    /// Temperature of the core [°C].
    #[getter]
    fn core_c(&self, py: Python<'_>) -> PyResult<f64> {
        self.read(py, |piece| celsius(piece.core()))
    }

    /// Highest temperature of the core so far [°C].
    #[getter]
    fn core_peak_c(&self, py: Python<'_>) -> PyResult<f64> {
        self.read(py, |piece| celsius(piece.core_peak.0))
    }

    /// Mean temperature of the upper face [°C].
    #[getter]
    fn top_c(&self, py: Python<'_>) -> PyResult<f64> {
        self.read(py, |piece| celsius(piece.face(false)))
    }

    /// Mean temperature of the lower face [°C].
    #[getter]
    fn bottom_c(&self, py: Python<'_>) -> PyResult<f64> {
        self.read(py, |piece| celsius(piece.face(true)))
    }

    /// Readings of the upper face: temperature_c, browning, browned_pct, charred_pct, water_pct (of the raw water) and its
    /// colour l, a, b (CIELAB).
    #[getter]
    fn top(&self, py: Python<'_>) -> PyResult<BTreeMap<&'static str, f64>> {
        self.read(py, |piece| face(piece, false))
    }

    /// Readings of the lower face, as of the upper one.
    #[getter]
    fn bottom(&self, py: Python<'_>) -> PyResult<BTreeMap<&'static str, f64>> {
        self.read(py, |piece| face(piece, true))
    }

    /// Mass [g].
    #[getter]
    fn mass_g(&self, py: Python<'_>) -> PyResult<f64> {
        self.read(py, |piece| 1e3 * piece.mass())
    }

    /// Mass when it was raw [g].
    #[getter]
    fn raw_mass_g(&self, py: Python<'_>) -> PyResult<f64> {
        self.read(py, |piece| 1e3 * piece.model.raw_mass())
    }

    /// Mass that was lost, of the raw mass [%].
    #[getter]
    fn lost_pct(&self, py: Python<'_>) -> PyResult<f64> {
        self.read(py, |piece| 100.0 * (1.0 - piece.mass() / piece.model.raw_mass()))
    }

    /// Shares of the classes of doneness in the section [%], in the words of a scale; by default of one that fits the food.
    #[pyo3(signature = (scale = None))]
    fn doneness_pct(&self, py: Python<'_>, scale: Option<&str>) -> PyResult<BTreeMap<String, f64>> {
        let (state, index) = self.found(py)?;
        let piece = &state.pieces()[index];
        let library = Arc::clone(&self.kitchen.bind(py).try_borrow()?.shelf.library);
        let fitting = doneness::fitting(&library.scales, &piece.model);
        let chosen = fitting.iter().find(|s| scale.is_none_or(|id| s.id == id));
        let Some(chosen) = chosen else {
            let known: Vec<&str> = fitting.iter().map(|s| s.id.as_str()).collect();
            return Err(PyValueError::new_err(format!(
                "no such scale fits a {}; there are: {}",
                piece.kind,
                known.join(", ")
            )));
        };
        let shares = piece.model.cut_shares(&piece.state, &piece.model.cut_across(0.0), chosen).0;
        Ok(chosen.class.iter().zip(shares).map(|(class, share)| (class.name.clone(), share)).collect())
    }

    /// True if it is upside down.
    #[getter]
    fn upside_down(&self, py: Python<'_>) -> PyResult<bool> {
        self.read(py, Piece::upside_down)
    }

    /// Where the cut that halved it lies, from the middle [mm]; None if it is whole.
    #[getter]
    fn halved_at_mm(&self, py: Python<'_>) -> PyResult<Option<f64>> {
        self.read(py, |piece| piece.halved().map(|cut| 1e3 * cut.at))
    }

    /// Force on the pan [N].
    #[getter]
    fn pan_force_n(&self, py: Python<'_>) -> PyResult<f64> {
        self.read(py, Piece::pan_force)
    }

    /// Heat that it took from the pan and its liquids so far [J].
    #[getter]
    fn heat_j(&self, py: Python<'_>) -> PyResult<f64> {
        self.read(py, |piece| piece.heat_taken)
    }

    /// Vapour that leaves it [g/s].
    #[getter]
    fn vapour_g_s(&self, py: Python<'_>) -> PyResult<f64> {
        self.read(py, |piece| 1e3 * piece.vapour_flow)
    }

    /// False after a value that is not finite; it no longer changes then.
    #[getter]
    fn healthy(&self, py: Python<'_>) -> PyResult<bool> {
        self.read(py, |piece| piece.state.healthy)
    }

    /// Pose of its body in the kitchen, [x, y, z, qx, qy, qz, qw] (m).
    #[getter]
    fn pose_m<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        made(py, self.read(py, |piece| seven(&piece.pose))?)
    }

    /// Velocity [m/s] and angular velocity [rad/s] of its body, six numbers; None while it waits.
    #[getter]
    fn twist<'py>(&self, py: Python<'py>) -> PyResult<Option<Bound<'py, PyAny>>> {
        let (state, index) = self.found(py)?;
        let twist = state.world().velocity(state.pieces()[index].key);
        twist.map(|(v, w)| made(py, [v.to_array(), w.to_array()].concat())).transpose()
    }

    fn __repr__(&self, py: Python<'_>) -> PyResult<String> {
        self.read(py, |p| {
            format!("<saute.Piece {}: {}, core {:.1} °C, {}>", p.id, p.kind, celsius(p.core()), p.place.name())
        })
    }
}
