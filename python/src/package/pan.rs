//! What hob and pan report: readings, fields, the pan's pose and the load on the hand that holds it.

use std::sync::Arc;

use pyo3::prelude::*;
use saute_kitchen::dynamics::RIGID_S;
use saute_kitchen::hands::FoodVelocities;
use saute_kitchen::{Command, FRAME_S, Kitchen, celsius};

use crate::package::array::{made, shown, shown_rows};
use crate::package::errors;
use crate::package::expected::{pose, seven};
use crate::package::kitchen::PyKitchen;

/// Lets a partner in Python see the load on the pan since the last step and the poses of the foods, and moves the pan to where it states.
fn asked(py: Python<'_>, kitchen: &mut Kitchen, last: &mut FoodVelocities, partner: &Bound<'_, PyAny>) -> PyResult<()> {
    let wrench = kitchen.pan_wrench(last, RIGID_S);
    last.note(kitchen);
    let poses: Vec<f64> = kitchen.pieces().iter().flat_map(|piece| seven(&piece.pose)).collect();
    let rows = (kitchen.pieces().len(), 7);
    let load = made(py, [wrench.force.to_array(), wrench.torque.to_array()].concat())?;
    let answer = partner.call1((load, made(py, poses)?.call_method1("reshape", (rows,))?))?;
    if answer.is_none() {
        return Ok(());
    }
    kitchen.apply(&Command::HoldPan { pose: pose(&answer)? }).map_err(|reason| errors::refused(&reason))
}

#[pymethods]
impl PyKitchen {
    /// Advances n frames together with another simulator. Before each rigid step of 1/240 s, four in a frame, partner(wrench, poses)
    /// is called: with force [N] and torque [N·m] of foods and liquids on the pan in the last of these steps, six numbers as
    /// `pan_wrench`, and the poses of the foods in order, n × 7. It returns the pose at which the pan is to be held, or None to
    /// leave it. The kitchen itself must not be used in it. After an exception of the partner the frame is completed.
    #[pyo3(signature = (partner, n = 1))]
    fn couple(&mut self, py: Python<'_>, partner: &Bound<'_, PyAny>, n: u64) -> PyResult<()> {
        self.whole()?;
        let kitchen = Arc::make_mut(&mut self.state);
        let mut last = FoodVelocities::of(kitchen);
        for _ in 0..n {
            self.before.note(kitchen);
            let mut result = Ok(());
            kitchen.advance_frame_with(|kitchen| {
                if result.is_ok() {
                    result = asked(py, kitchen, &mut last, partner);
                }
            });
            result?;
        }
        py.check_signals()
    }

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
