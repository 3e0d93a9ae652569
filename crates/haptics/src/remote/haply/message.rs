//! JSON messages of the Inverse service, the subset for a pan; axes as in the kitchen (x right, y away, z up), metres and newtons.

use glam::{DQuat, DVec3};
use serde::Deserialize;
use serde_json::json;

/// Name of this program at the service.
const PROFILE: &str = "saute";
/// Largest accepted distance of the cursor [m] (chosen: five times the device's reach).
const FARTHEST_M: f64 = 1.0;
/// Largest accepted speed of the cursor [m/s] (chosen: faster than any arm).
const FASTEST_M_S: f64 = 20.0;
/// Largest accepted force in an answer [N] (chosen: more than any such device makes).
const STRONGEST_N: f64 = 100.0;

/// State of all devices at the service.
#[derive(Clone, Debug, Default, Deserialize)]
pub struct State {
    /// Devices that measure position and make force.
    #[serde(default)]
    pub inverse3: Vec<Inverse3>,
    /// Wired grips.
    #[serde(default)]
    pub verse_grip: Vec<Grip>,
    /// Wireless grips.
    #[serde(default)]
    pub wireless_verse_grip: Vec<Grip>,
}

/// One device.
#[derive(Clone, Debug, Deserialize)]
pub struct Inverse3 {
    /// Device id.
    pub device_id: String,
    /// State of the cursor.
    #[serde(default)]
    pub state: Option<Cursor>,
    /// Status of the device.
    #[serde(default)]
    pub status: Status,
}

/// Cursor of a device.
#[derive(Clone, Copy, Debug, Deserialize)]
pub struct Cursor {
    /// Position [m].
    pub cursor_position: Vector,
    /// Velocity [m/s].
    #[serde(default)]
    pub cursor_velocity: Vector,
    /// Present force [N].
    #[serde(default)]
    pub current_cursor_force: Vector,
}

/// Status of a device.
#[derive(Clone, Copy, Debug, Default, Deserialize)]
pub struct Status {
    /// True if the device is calibrated; an absent value counts as true.
    pub calibrated: Option<bool>,
}

/// A vector.
#[derive(Clone, Copy, Debug, Default, Deserialize)]
#[serde(default)]
pub struct Vector {
    x: f64,
    y: f64,
    z: f64,
}

/// A grip.
#[derive(Clone, Debug, Deserialize)]
pub struct Grip {
    /// State of the grip.
    #[serde(default)]
    pub state: Option<Held>,
}

/// State of a grip.
#[derive(Clone, Copy, Debug, Deserialize)]
pub struct Held {
    /// Orientation.
    pub orientation: Quaternion,
    /// Buttons.
    #[serde(default)]
    pub buttons: Buttons,
}

/// A quaternion.
#[derive(Clone, Copy, Debug, Deserialize)]
pub struct Quaternion {
    w: f64,
    x: f64,
    y: f64,
    z: f64,
}

/// Buttons of a grip.
#[derive(Clone, Copy, Debug, Default, Deserialize)]
#[serde(default)]
pub struct Buttons {
    a: bool,
    b: bool,
    c: bool,
}

/// Why an answer is invalid.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum BadAnswer {
    /// The text is not JSON of this kind.
    #[error("{0}")]
    Json(String),
    /// A number is out of range.
    #[error("{0} is out of range")]
    Range(&'static str),
}

impl State {
    /// Parses and checks an answer.
    pub fn parse(text: &str) -> Result<Self, BadAnswer> {
        let state: Self = serde_json::from_str(text).map_err(|e| BadAnswer::Json(e.to_string()))?;
        for cursor in state.inverse3.iter().filter_map(|d| d.state) {
            cursor.check()?;
        }
        if state.grips().any(|held| held.orientation.turn().is_none()) {
            return Err(BadAnswer::Range("orientation"));
        }
        Ok(state)
    }

    fn grips(&self) -> impl Iterator<Item = Held> {
        self.wireless_verse_grip.iter().chain(&self.verse_grip).filter_map(|g| g.state)
    }

    /// Returns the state of the first grip.
    pub fn grip(&self) -> Option<Held> {
        self.grips().next()
    }
}

impl Cursor {
    fn check(&self) -> Result<(), BadAnswer> {
        let within = |v: Vector, most: f64| v.vector().is_finite() && v.vector().length() <= most;
        match () {
            () if !within(self.cursor_position, FARTHEST_M) => Err(BadAnswer::Range("cursor_position")),
            () if !within(self.cursor_velocity, FASTEST_M_S) => Err(BadAnswer::Range("cursor_velocity")),
            () if !within(self.current_cursor_force, STRONGEST_N) => Err(BadAnswer::Range("current_cursor_force")),
            () => Ok(()),
        }
    }
}

impl Vector {
    /// Returns the vector.
    pub fn vector(&self) -> DVec3 {
        DVec3::new(self.x, self.y, self.z)
    }
}

impl Quaternion {
    /// Returns the normalised rotation, or `None` if the length is far from 1.
    pub fn turn(&self) -> Option<DQuat> {
        let q = DQuat::from_xyzw(self.x, self.y, self.z, self.w);
        let length = q.length();
        (length.is_finite() && (0.5..2.0).contains(&length)).then(|| q.normalize())
    }
}

impl Buttons {
    /// Returns one bit each for a, b, c.
    pub fn bits(&self) -> u32 {
        u32::from(self.a) | u32::from(self.b) << 1 | u32::from(self.c) << 2
    }
}

/// Returns the message that sets a force [N] and requests an answer.
///
/// The first message also names this program and puts the origin into the centre of the workspace.
pub fn force(device_id: &str, force: DVec3, is_first: bool) -> String {
    let vector = json!({ "x": force.x, "y": force.y, "z": force.z });
    let mut device = json!({ "device_id": device_id, "commands": { "set_cursor_force": { "vector": vector } } });
    let mut message = json!({});
    if is_first {
        message["session"] = json!({ "configure": { "profile": { "name": PROFILE } } });
        device["configure"] = json!({ "preset": { "preset": "arm_front_centered" } });
    }
    message["inverse3"] = json!([device]);
    message.to_string()
}
