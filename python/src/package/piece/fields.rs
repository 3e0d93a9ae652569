//! Fields and meshes of a piece as arrays that show its state.

use std::sync::Arc;

use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;
use pyo3::types::PyDict;
use saute_kitchen::food::{FoodState, Patch, PatchPose};
use saute_kitchen::{Kitchen, Piece};

use crate::package::array::{made, shown, shown_rows};
use crate::package::piece::PyPiece;

/// Names of the fields of the nodes.
const FIELDS: [&str; 12] = [
    "temperature_k",
    "enthalpy_j",
    "water_kg",
    "juice_kg",
    "rising_kg",
    "fat_kg",
    "peak_k",
    "browning",
    "charring",
    "lethality",
    "oiled",
    "stretch",
];

/// Returns a field by its place in [`FIELDS`]; those after it are the changes of the flesh.
fn field_of(state: &FoodState, index: usize) -> &[f64] {
    match index {
        0 => &state.temperature,
        1 => &state.enthalpy,
        2 => &state.water,
        3 => &state.juice,
        4 => &state.rising,
        5 => &state.fat,
        6 => &state.peak,
        7 => &state.browning,
        8 => &state.charring,
        9 => &state.lethality,
        10 => &state.oiled,
        11 => &state.stretch.axial,
        _ => &state.changed[index - FIELDS.len()],
    }
}

/// Names of all fields of a piece: those of every food, and the changes of its kinetics, as "changed.myosin".
fn names(piece: &Piece) -> Vec<String> {
    let changes = piece.model.kinetics().names().into_iter().map(|name| format!("changed.{name}"));
    FIELDS.iter().map(|name| (*name).to_owned()).chain(changes).collect()
}

fn view<'py>(py: Python<'py>, state: &Arc<Kitchen>, piece: usize, index: usize) -> PyResult<Bound<'py, PyAny>> {
    shown(py, state, |kitchen| field_of(&kitchen.pieces()[piece].state, index))
}

#[pymethods]
impl PyPiece {
    /// Names of its fields.
    #[getter]
    fn field_names(&self, py: Python<'_>) -> PyResult<Vec<String>> {
        let (state, index) = self.found(py)?;
        Ok(names(&state.pieces()[index]))
    }

    /// A field of its nodes by name: an array, without a copy, that shows the state as it is now.
    fn field<'py>(&self, py: Python<'py>, name: &str) -> PyResult<Bound<'py, PyAny>> {
        let (state, index) = self.found(py)?;
        let known = names(&state.pieces()[index]);
        let found = known.iter().position(|known| known == name);
        let unknown =
            || PyValueError::new_err(format!("there is no field \"{name}\"; there are: {}", known.join(", ")));
        view(py, &state, index, found.ok_or_else(unknown)?)
    }

    /// All fields of its nodes by their names.
    fn fields<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        let (state, index) = self.found(py)?;
        let all = PyDict::new(py);
        for (place, name) in names(&state.pieces()[index]).into_iter().enumerate() {
            all.set_item(name, view(py, &state, index, place)?)?;
        }
        Ok(all)
    }

    /// Temperatures of its nodes [K].
    #[getter]
    fn temperature_k<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        self.field(py, "temperature_k")
    }

    /// Browning of its nodes [-].
    #[getter]
    fn browning<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        self.field(py, "browning")
    }

    /// Water of its nodes [kg].
    #[getter]
    fn water_kg<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        self.field(py, "water_kg")
    }

    /// Volumes of its nodes when it was raw [m³].
    #[getter]
    fn volumes_m3<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        let (state, index) = self.found(py)?;
        shown(py, &state, |kitchen| kitchen.pieces()[index].model.mesh().volumes())
    }

    /// Points of its nodes when it was raw, in its own frame [m], n × 3. These are computed, so the array is a new one.
    #[getter]
    fn points_m<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        let (state, index) = self.found(py)?;
        let mesh = state.pieces()[index].model.mesh();
        let points: Vec<[f64; 3]> = (0..mesh.node_count()).map(|node| mesh.position(node)).collect();
        shown_rows(py, &Arc::new(points), |points| points.as_slice(), |point| point)
    }

    /// Points of its surface now, in its own frame [m], one for each patch, p × 3. Its pose brings them into the kitchen.
    #[getter]
    fn surface_points_m<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        let (state, index) = self.found(py)?;
        shown_rows(py, &state, |k| k.pieces()[index].patch_poses(), |patch: &PatchPose| &patch.position)
    }

    /// Outward unit normals of its surface now, in its own frame [-], p × 3.
    #[getter]
    fn surface_normals<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        let (state, index) = self.found(py)?;
        shown_rows(py, &state, |k| k.pieces()[index].patch_poses(), |patch: &PatchPose| &patch.normal)
    }

    /// Triangles of its surface over the patches, m × 3; none for a body from a user's surface.
    #[getter]
    fn surface_triangles<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        let (state, index) = self.found(py)?;
        shown_rows(py, &state, |k| k.pieces()[index].model.surface().patches.as_slice(), |triangle: &[u32; 3]| triangle)
    }

    /// Node of each patch of its surface: field[surface_nodes] is the field on the surface.
    #[getter]
    fn surface_nodes<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        let (state, index) = self.found(py)?;
        let nodes: Vec<u32> = state.pieces()[index].model.patches().iter().map(|patch: &Patch| patch.node).collect();
        made(py, nodes)
    }

    /// Its surface as it is in the kitchen now, as a PyVista mesh with all fields (needs pyvista).
    fn to_pyvista<'py>(slf: &Bound<'py, Self>) -> PyResult<Bound<'py, PyAny>> {
        slf.py().import("saute._pyvista")?.call_method1("surface", (slf,))
    }
}
