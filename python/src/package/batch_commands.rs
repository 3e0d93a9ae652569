//! Commands to the kitchens of a batch: to all of them, or to those that a mask names.

use pyo3::exceptions::PyTypeError;
use pyo3::prelude::*;
use saute_kitchen::Command;
use saute_kitchen::hands::ranges::{FAT_G, SHAKE_AMPLITUDE_MM, SHAKE_HZ, TOSS_HEIGHT_MM, WATER_G};

use crate::package::batch::{PyBatch, each};
use crate::package::commands::{rest_on, tool_of};
use crate::package::expected::{limited, pose, ranged};

/// Where kitchens are chosen.
type Mask = Option<Vec<bool>>;

impl PyBatch {
    /// Reads a number for each kitchen, or one for all, within a range.
    fn numbers(&self, value: &Bound<'_, PyAny>, what: &str, unit: &str, range: [f64; 2]) -> PyResult<Vec<f64>> {
        let count = self.count();
        let found = each::<f64>(value, count, &format!("{what} must be a number or {count} numbers, in {unit}"))?;
        found.iter().try_for_each(|v| ranged(*v, what, range).map(drop))?;
        Ok(found)
    }

    /// Reads a pose for each kitchen.
    fn poses(&self, value: &Bound<'_, PyAny>) -> PyResult<Vec<saute_kitchen::dynamics::Pose>> {
        let form = || PyTypeError::new_err(format!("poses_m must be {} × 7 numbers", self.count()));
        let poses = value.try_iter().map_err(|_| form())?.map(|row| pose(&row?)).collect::<PyResult<Vec<_>>>()?;
        if poses.len() == self.count() { Ok(poses) } else { Err(form()) }
    }
}

#[pymethods]
impl PyBatch {
    /// Sets the power of every hob [W]: one number, or one for each kitchen.
    #[pyo3(signature = (w, *, r#where = None))]
    fn hob(&mut self, w: &Bound<'_, PyAny>, r#where: Mask) -> PyResult<()> {
        let count = self.count();
        let powers = each::<f64>(w, count, &format!("w must be a number or {count} numbers, in W"))?;
        self.command(r#where, |i| Command::Hob(powers[i]))
    }

    /// Puts a piece into the middle of every pan.
    #[pyo3(signature = (food, *, r#where = None))]
    fn put(&mut self, food: &str, r#where: Mask) -> PyResult<()> {
        self.command(r#where, |_| Command::Put { food: food.to_owned(), at: [0.0; 2], heap: false })
    }

    /// Turns a piece over in every kitchen, or where the mask is true.
    #[pyo3(signature = (food, *, r#where = None))]
    fn flip(&mut self, food: &str, r#where: Mask) -> PyResult<()> {
        self.command(r#where, |_| Command::Flip { food: food.to_owned() })
    }

    /// Takes a piece out of every pan, or where the mask is true.
    #[pyo3(signature = (food, on = "board", *, r#where = None))]
    fn rest(&mut self, food: &str, on: &str, r#where: Mask) -> PyResult<()> {
        let on = rest_on(on)?;
        self.command(r#where, |_| Command::Rest { food: food.to_owned(), on })
    }

    /// Pours oil into the pans [g]: one number, or one for each kitchen.
    #[pyo3(signature = (g, kind = None, *, r#where = None))]
    fn oil(&mut self, g: &Bound<'_, PyAny>, kind: Option<String>, r#where: Mask) -> PyResult<()> {
        let masses = self.numbers(g, "g", "g", FAT_G)?;
        self.command(r#where, |i| Command::Oil { kind: kind.clone(), mass: 1e-3 * masses[i] })
    }

    /// Pours water into the pans [g]: one number, or one for each kitchen.
    #[pyo3(signature = (g, *, r#where = None))]
    fn water(&mut self, g: &Bound<'_, PyAny>, r#where: Mask) -> PyResult<()> {
        let masses = self.numbers(g, "g", "g", WATER_G)?;
        self.command(r#where, |i| Command::Water(1e-3 * masses[i]))
    }

    /// Tosses the contents of the pans to a height [mm].
    #[pyo3(signature = (height_mm = None, *, r#where = None))]
    fn toss(&mut self, height_mm: Option<f64>, r#where: Mask) -> PyResult<()> {
        let height = 1e-3 * limited(height_mm, "height_mm", TOSS_HEIGHT_MM)?;
        self.command(r#where, |_| Command::Toss { height })
    }

    /// Shakes the pans left and right: amplitude [mm], frequency [Hz], duration [s].
    #[pyo3(signature = (*, amplitude_mm = None, hz = None, for_s = 1.0, r#where = None))]
    fn shake(&mut self, amplitude_mm: Option<f64>, hz: Option<f64>, for_s: f64, r#where: Mask) -> PyResult<()> {
        let amplitude = 1e-3 * limited(amplitude_mm, "amplitude_mm", SHAKE_AMPLITUDE_MM)?;
        let hz = limited(hz, "hz", SHAKE_HZ)?;
        self.command(r#where, |_| Command::Shake { amplitude, hz, for_s })
    }

    /// Holds every pan at its pose, a row of n × 7 numbers: [x, y, z, qx, qy, qz, qw] (m).
    #[pyo3(signature = (poses_m, *, r#where = None))]
    fn hold_pan(&mut self, poses_m: &Bound<'_, PyAny>, r#where: Mask) -> PyResult<()> {
        let poses = self.poses(poses_m)?;
        self.command(r#where, |i| Command::HoldPan { pose: poses[i] })
    }

    /// Moves a tool, "turner" or "tongs", of every kitchen towards its pose, a row of n × 7 numbers.
    #[pyo3(signature = (tool, poses_m, *, r#where = None))]
    fn lead(&mut self, tool: &str, poses_m: &Bound<'_, PyAny>, r#where: Mask) -> PyResult<()> {
        let (tool, poses) = (tool_of(tool)?, self.poses(poses_m)?);
        self.command(r#where, |i| Command::Lead { tool, to: poses[i], grip: None })
    }

    /// Puts the tools away.
    #[pyo3(signature = (*, r#where = None))]
    fn let_go(&mut self, r#where: Mask) -> PyResult<()> {
        self.command(r#where, |_| Command::LetGo)
    }
}
