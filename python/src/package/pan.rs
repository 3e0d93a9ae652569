//! What hob and pan say of themselves: readings, fields, the pan's pose and the load on the hand that holds it.

use pyo3::prelude::*;
use saute_kitchen::{FRAME_S, celsius};

use crate::package::array::{made, shown, shown_rows};
use crate::package::expected::seven;
use crate::package::kitchen::PyKitchen;

#[pymethods]
impl PyKitchen {
    /// Name of the kind of pan, as "carbon-steel-26".
    #[getter]
    fn pan_name(&self) -> String {
        self.state.pan_model().description.name.clone()
    }

    /// Mean temperature of the pan's floor [°C].
    #[getter]
    fn pan_c(&self) -> f64 {
        celsius(self.state.pan_temperature())
    }

    /// Power to which the hob is set [W].
    #[getter]
    fn hob_w(&self) -> f64 {
        self.state.hob_w()
    }

    /// Power that the hob draws [W].
    #[getter]
    fn hob_drawn_w(&self) -> f64 {
        self.state.hob_drawn_w()
    }

    /// Oil in the pan [g].
    #[getter]
    fn oil_g(&self) -> f64 {
        1e3 * self.state.pan_state().oil_mass()
    }

    /// Water in the pan [g].
    #[getter]
    fn water_g(&self) -> f64 {
        1e3 * self.state.pan_state().water_mass()
    }

    /// Smoke from the oil [mg/s].
    #[getter]
    fn smoke_mg_s(&self) -> f64 {
        self.state.pan_state().smoke_mg_s()
    }

    /// True while the lid is on.
    #[getter]
    fn lid_is_on(&self) -> bool {
        self.state.pan_state().lid.is_some()
    }

    /// Events so far, as {"spatter": 12}.
    #[getter]
    fn events(&self) -> std::collections::BTreeMap<String, u64> {
        let name =
            |kind| serde_json::to_value(kind).ok().and_then(|v| v.as_str().map(str::to_owned)).unwrap_or_default();
        self.state.events().tallies().map(|tally| (name(tally.kind), tally.count)).collect()
    }

    /// Temperatures of the pan's nodes [K]: an array that shows them as they are now.
    #[getter]
    fn pan_temperature_k<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        shown(py, &self.state, |kitchen| &kitchen.pan_state().temperature)
    }

    /// Points of the pan's nodes from above [m], n × 2.
    #[getter]
    fn pan_points_m<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        shown_rows(py, &self.state, |kitchen| kitchen.pan_model().section.points.as_slice(), |point: &[f64; 2]| point)
    }

    /// Triangles of the pan's nodes, m × 3.
    #[getter]
    fn pan_triangles<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        shown_rows(py, &self.state, |kitchen| kitchen.pan_model().section.triangles.as_slice(), |t: &[u32; 3]| t)
    }

    /// Pose of the centre of the pan's floor in the kitchen, [x, y, z, qx, qy, qz, qw] (m).
    #[getter]
    fn pan_pose_m<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        made(py, seven(&self.state.world().motion.pose))
    }

    /// Velocity [m/s] and angular velocity [rad/s] of the pan, six numbers.
    #[getter]
    fn pan_twist<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        let motion = self.state.world().motion;
        made(py, [motion.velocity.to_array(), motion.turning.to_array()].concat())
    }

    /// Force [N] and torque about the centre of the pan's floor [N·m] of foods and liquids on the pan, as a mean over the last
    /// frame, six numbers in the kitchen's axes. The pan itself does not count.
    #[getter]
    fn pan_wrench<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        let wrench = self.state.pan_wrench(&self.before, FRAME_S);
        made(py, [wrench.force.to_array(), wrench.torque.to_array()].concat())
    }
}
