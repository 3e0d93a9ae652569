//! Commands of hands to a kitchen, as methods with units in the names of their values. Limits are those of recipes.

use std::sync::Arc;

use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;
use saute_kitchen::dynamics::Tool;
use saute_kitchen::hands::ranges::{
    COOL_S, FAT_G, FOR_S, HALVE_AT_MM, LIFT_MM, Limits, PRESS_N, SHAKE_AMPLITUDE_MM, SHAKE_HZ, TILT_DEG,
    TOSS_HEIGHT_MM, TOWARDS_DEG, WATER_G,
};
use saute_kitchen::{Command, RestOn, kelvin};

use crate::package::errors;
use crate::package::expected::{limited, numbers, pose, ranged};
use crate::package::kitchen::PyKitchen;

/// How a place is written.
const PLACE: &str = "[x, y] in mm";

impl PyKitchen {
    /// Carries out a command.
    pub(crate) fn apply(&mut self, command: &Command) -> PyResult<()> {
        self.whole()?;
        Arc::make_mut(&mut self.state).apply(command).map_err(|reason| errors::refused(&reason))
    }
}

/// Reads a place [m]; the centre by default.
fn place(at_mm: Option<&Bound<'_, PyAny>>, what: &str) -> PyResult<[f64; 2]> {
    at_mm.map_or(Ok([0.0; 2]), |at| Ok(numbers::<2>(at, what, PLACE)?.map(|mm| 1e-3 * mm)))
}

/// Reads where food rests.
pub(crate) fn rest_on(on: &str) -> PyResult<RestOn> {
    match on {
        "board" => Ok(RestOn::Board),
        "rack" => Ok(RestOn::Rack),
        "foil" => Ok(RestOn::Foil),
        _ => Err(PyValueError::new_err(format!("on = \"{on}\": food rests on \"board\", \"rack\" or \"foil\""))),
    }
}

/// Reads which tool it is.
pub(crate) fn tool_of(tool: &str) -> PyResult<Tool> {
    match tool {
        "turner" => Ok(Tool::Turner),
        "tongs" => Ok(Tool::Tongs),
        _ => Err(PyValueError::new_err(format!("tool = \"{tool}\": there are \"turner\" and \"tongs\""))),
    }
}

#[pymethods]
impl PyKitchen {
    /// Sets the hob's electrical power [W].
    fn hob(&mut self, w: f64) -> PyResult<()> {
        self.apply(&Command::Hob(w))
    }

    /// Lets the hob hold the pan at a temperature [°C], with at most a power [W]; its largest by default.
    #[pyo3(signature = (c, w = None))]
    fn hob_hold(&mut self, c: f64, w: Option<f64>) -> PyResult<()> {
        let power = w.unwrap_or(self.state.hob().largest_w());
        self.apply(&Command::HobHold { temperature: kelvin(c), power })
    }

    /// Puts a piece into the pan, with its centre at a place relative to the pan's [mm].
    #[pyo3(signature = (food, at_mm = None, *, heap = false))]
    fn put(&mut self, food: String, at_mm: Option<&Bound<'_, PyAny>>, heap: bool) -> PyResult<()> {
        self.apply(&Command::Put { food, at: place(at_mm, "at_mm")?, heap })
    }

    /// Turns a piece over.
    fn flip(&mut self, food: String) -> PyResult<()> {
        self.apply(&Command::Flip { food })
    }

    /// Takes a piece out of the pan, onto "board", "rack" or "foil".
    #[pyo3(signature = (food, on = "board"))]
    fn rest(&mut self, food: String, on: &str) -> PyResult<()> {
        self.apply(&Command::Rest { food, on: rest_on(on)? })
    }

    /// Cuts a piece on the board in halves, at a distance from its middle along its long axis [mm].
    #[pyo3(signature = (food, at_mm = None))]
    fn halve(&mut self, food: String, at_mm: Option<f64>) -> PyResult<()> {
        self.apply(&Command::Halve { food, at: 1e-3 * limited(at_mm, "at_mm", HALVE_AT_MM)? })
    }

    /// Presses a piece onto the floor of the pan with a force [N] for a time [s].
    #[pyo3(signature = (food, n = None, *, for_s = None))]
    fn press(&mut self, food: String, n: Option<f64>, for_s: Option<f64>) -> PyResult<()> {
        let (newtons, for_s) = (limited(n, "n", PRESS_N)?, limited(for_s, "for_s", FOR_S)?);
        self.apply(&Command::Press { food, newtons, for_s })
    }

    /// Spoons hot fat of the pan over a piece for a time [s].
    #[pyo3(signature = (food, for_s = None))]
    fn baste(&mut self, food: String, for_s: Option<f64>) -> PyResult<()> {
        self.apply(&Command::Baste { food, for_s: limited(for_s, "for_s", FOR_S)? })
    }

    /// Pushes or carries a piece to a place in the pan [mm].
    #[pyo3(name = "move")]
    fn move_food(&mut self, food: String, to_mm: &Bound<'_, PyAny>) -> PyResult<()> {
        self.apply(&Command::Move { food, to: place(Some(to_mm), "to_mm")? })
    }

    /// Moves the pan over the hob [mm], or lifts it [mm].
    #[pyo3(signature = (at_mm = None, *, lift_mm = None))]
    fn move_pan(&mut self, at_mm: Option<&Bound<'_, PyAny>>, lift_mm: Option<f64>) -> PyResult<()> {
        let lift = 1e-3 * limited(lift_mm, "lift_mm", LIFT_MM)?;
        self.apply(&Command::MovePan { at: place(at_mm, "at_mm")?, lift })
    }

    /// Sets the pan on the wet cloth for a time [s].
    #[pyo3(signature = (for_s = None))]
    fn cool(&mut self, for_s: Option<f64>) -> PyResult<()> {
        let limits = Limits { default: self.state.room().cloth.default_s, ..COOL_S };
        self.apply(&Command::Cool { for_s: limited(for_s, "for_s", limits)? })
    }

    /// Tosses the contents of the pan to a height [mm].
    #[pyo3(signature = (height_mm = None))]
    fn toss(&mut self, height_mm: Option<f64>) -> PyResult<()> {
        self.apply(&Command::Toss { height: 1e-3 * limited(height_mm, "height_mm", TOSS_HEIGHT_MM)? })
    }

    /// Shakes the pan left and right: amplitude [mm], frequency [Hz], duration [s].
    #[pyo3(signature = (*, amplitude_mm = None, hz = None, for_s = None))]
    fn shake(&mut self, amplitude_mm: Option<f64>, hz: Option<f64>, for_s: Option<f64>) -> PyResult<()> {
        let amplitude = 1e-3 * limited(amplitude_mm, "amplitude_mm", SHAKE_AMPLITUDE_MM)?;
        let (hz, for_s) = (limited(hz, "hz", SHAKE_HZ)?, limited(for_s, "for_s", FOR_S)?);
        self.apply(&Command::Shake { amplitude, hz, for_s })
    }

    /// Tilts the pan by an angle [°] towards a direction, from +x over +y [°]; it stays tilted.
    #[pyo3(signature = (deg, *, towards_deg = None))]
    fn tilt(&mut self, deg: f64, towards_deg: Option<f64>) -> PyResult<()> {
        let angle = ranged(deg, "deg", TILT_DEG)?.to_radians();
        let towards = limited(towards_deg, "towards_deg", TOWARDS_DEG)?.to_radians();
        self.apply(&Command::Tilt { angle, towards })
    }

    /// Pours oil into the pan [g], of a kind; the kitchen's own by default.
    #[pyo3(signature = (g, kind = None))]
    fn oil(&mut self, g: f64, kind: Option<String>) -> PyResult<()> {
        self.apply(&Command::Oil { kind, mass: 1e-3 * ranged(g, "g", FAT_G)? })
    }

    /// Puts butter into the pan [g].
    fn butter(&mut self, g: f64) -> PyResult<()> {
        self.apply(&Command::Butter(1e-3 * ranged(g, "g", FAT_G)?))
    }

    /// Pours water into the pan [g].
    fn water(&mut self, g: f64) -> PyResult<()> {
        self.apply(&Command::Water(1e-3 * ranged(g, "g", WATER_G)?))
    }

    /// Wipes the empty pan with a paper towel: only the film of a seasoned pan stays.
    fn wipe(&mut self) -> PyResult<()> {
        self.apply(&Command::Wipe)
    }

    /// Puts the lid on, or takes it off.
    #[pyo3(signature = (on = true))]
    fn lid(&mut self, on: bool) -> PyResult<()> {
        self.apply(&Command::Lid(on))
    }

    /// Holds the pan at a pose of the centre of its floor, [x, y, z, qx, qy, qz, qw] (m); it follows with bounded speed.
    #[pyo3(name = "hold_pan")]
    fn hold_pan_at(&mut self, pose_m: &Bound<'_, PyAny>) -> PyResult<()> {
        self.apply(&Command::HoldPan { pose: pose(pose_m)? })
    }

    /// Moves a tool, "turner" or "tongs", towards a pose of its tip; tongs grip a piece that is named once it is in reach.
    #[pyo3(signature = (tool, pose_m, *, grip = None))]
    fn lead(&mut self, tool: &str, pose_m: &Bound<'_, PyAny>, grip: Option<String>) -> PyResult<()> {
        self.apply(&Command::Lead { tool: tool_of(tool)?, to: pose(pose_m)?, grip })
    }

    /// Lowers a gripped piece until it lies, releases it and puts the tool away.
    fn let_go(&mut self) -> PyResult<()> {
        self.apply(&Command::LetGo)
    }
}
