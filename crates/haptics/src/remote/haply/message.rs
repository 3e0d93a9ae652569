//! The JSON of the Inverse service, as much of it as a pan needs; axes x right, y away, z up as in the kitchen, metres and newtons.

use glam::{DQuat, DVec3};
use serde::Deserialize;
use serde_json::json;

/// Name under which the service shows this program.
const PROFILE: &str = "saute";
/// Farthest place [m] and fastest speed [m/s] of a device of this size (chosen: five times its reach; a thrown hand).
const FARTHEST_M: f64 = 1.0;
const FASTEST_M_S: f64 = 20.0;
/// Largest force that an answer may tell [N] (chosen: more than any such device can do).
const STRONGEST_N: f64 = 100.0;

/// What the service says about all devices.
#[derive(Clone, Debug, Default, Deserialize)]
pub struct State {
    /// Devices that sense place and make force.
    #[serde(default)]
    pub inverse3: Vec<Inverse3>,
    /// Grips by cable.
    #[serde(default)]
    pub verse_grip: Vec<Grip>,
    /// Grips by radio.
    #[serde(default)]
    pub wireless_verse_grip: Vec<Grip>,
}

/// One device.
#[derive(Clone, Debug, Deserialize)]
pub struct Inverse3 {
    /// Its id.
    pub device_id: String,
    /// Where it is.
    #[serde(default)]
    pub state: Option<Cursor>,
    /// Whether it is ready.
    #[serde(default)]
    pub status: Status,
}

/// Where a device's cursor is.
#[derive(Clone, Copy, Debug, Deserialize)]
pub struct Cursor {
    /// Place [m].
    pub cursor_position: Vector,
    /// Velocity [m/s].
    #[serde(default)]
    pub cursor_velocity: Vector,
    /// Force that is made [N].
    #[serde(default)]
    pub current_cursor_force: Vector,
}

/// Whether a device is ready.
#[derive(Clone, Copy, Debug, Default, Deserialize)]
pub struct Status {
    /// Whether it knows where it is; as good as yes where nothing is said.
    pub calibrated: Option<bool>,
}

/// Three numbers.
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
    /// How it is held.
    #[serde(default)]
    pub state: Option<Held>,
}

/// How a grip is held.
#[derive(Clone, Copy, Debug, Deserialize)]
pub struct Held {
    /// How it is turned.
    pub orientation: Quaternion,
    /// Its buttons.
    #[serde(default)]
    pub buttons: Buttons,
}

/// A turn.
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

/// An answer that means nothing.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum BadAnswer {
    /// No JSON of this kind.
    #[error("{0}")]
    Json(String),
    /// A number that no device tells.
    #[error("{0} is out of range")]
    Range(&'static str),
}

impl State {
    /// Reads and checks an answer.
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

    /// How the first grip is held.
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
    /// As a vector.
    pub fn vector(&self) -> DVec3 {
        DVec3::new(self.x, self.y, self.z)
    }
}

impl Quaternion {
    /// As a turn; none where it is no such.
    pub fn turn(&self) -> Option<DQuat> {
        let q = DQuat::from_xyzw(self.x, self.y, self.z, self.w);
        let length = q.length();
        (length.is_finite() && (0.5..2.0).contains(&length)).then(|| q.normalize())
    }
}

impl Buttons {
    /// One bit each: a, b, c.
    pub fn bits(&self) -> u32 {
        u32::from(self.a) | u32::from(self.b) << 1 | u32::from(self.c) << 2
    }
}

/// A force [N], which also asks for an answer; the first message says who asks, and puts the origin into the middle of the workspace.
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
