//! Messages between a phone's page and the server, as JSON.

use saute_kitchen::dynamics::Pose;
use serde::{Deserialize, Serialize};

use crate::control::rumble::Rumble;

/// Longest message [bytes] (chosen: a motion message with all digits has 300).
pub const LONGEST: usize = 1024;
/// Largest accepted acceleration [m/s²] (chosen: above the 16 g range of phone sensors).
pub const LARGEST_M_S2: f64 = 200.0;
/// Largest angle of the DeviceOrientation event [°].
pub const LARGEST_DEG: f64 = 360.0;

/// A message from the phone.
#[derive(Clone, Debug, PartialEq, Deserialize)]
#[serde(tag = "kind", rename_all = "kebab-case", deny_unknown_fields)]
pub enum FromPhone {
    /// The pairing code that the user typed.
    Hello {
        /// Six digits.
        code: String,
    },
    /// Orientation and acceleration.
    Motion(Measured),
    /// Sets the present orientation as level, with the phone's top pointing away from the cook.
    Flat {},
    /// A finger touches or leaves the page.
    Button {
        /// True if it touches.
        down: bool,
    },
}

/// Readings of the phone's sensors.
#[derive(Clone, Copy, Debug, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Measured {
    /// Angles alpha, beta, gamma of the DeviceOrientation event [°].
    pub turn: [f64; 3],
    /// Acceleration without gravity along the phone's axes, if known [m/s²].
    #[serde(default)]
    pub push: Option<[f64; 3]>,
    /// Acceleration with gravity along the phone's axes, if known [m/s²].
    #[serde(default)]
    pub felt: Option<[f64; 3]>,
}

/// A message to the phone.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[serde(tag = "kind", rename_all = "kebab-case")]
pub enum ToPhone {
    /// The code is correct.
    Welcome,
    /// The code is wrong; the next attempt must wait.
    Refused {
        /// Wait before the next attempt [s].
        wait_s: f64,
        /// True if no code is accepted any more.
        closed: bool,
    },
    /// Result of setting the level.
    Flat {
        /// True if the phone was flat enough.
        taken: bool,
    },
    /// Orientation of the pan in the kitchen, and rumble.
    Pan {
        /// Orientation as a quaternion x, y, z, w [-].
        turn: [f64; 4],
        /// Rumble of collisions, 0 to 1 [-].
        strong: f64,
        /// Rumble of boiling, sliding and scraping, 0 to 1 [-].
        weak: f64,
    },
    /// Another phone has taken over the pan.
    Replaced,
}

/// Why a message is invalid.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum BadMessage {
    /// The message is too long.
    #[error("a message of {0} bytes is too long")]
    Long(usize),
    /// The text is not JSON of a known kind.
    #[error("{0}")]
    Json(String),
    /// A number is outside a sensor's range.
    #[error("{key} may be {low} to {high}")]
    Range {
        /// Key of the number.
        key: &'static str,
        /// Smallest value, in the unit of the key.
        low: f64,
        /// Largest value, in the unit of the key.
        high: f64,
    },
}

impl FromPhone {
    /// Parses and checks a message.
    pub fn parse(text: &str) -> Result<Self, BadMessage> {
        if text.len() > LONGEST {
            return Err(BadMessage::Long(text.len()));
        }
        let message: Self = serde_json::from_str(text).map_err(|e| BadMessage::Json(e.to_string()))?;
        if let Self::Motion(measured) = &message {
            measured.check()?;
        }
        Ok(message)
    }
}

impl Measured {
    pub(super) fn check(&self) -> Result<(), BadMessage> {
        within("turn", Some(&self.turn), LARGEST_DEG)?;
        within("push", self.push.as_ref(), LARGEST_M_S2)?;
        within("felt", self.felt.as_ref(), LARGEST_M_S2)
    }
}

/// Refuses numbers beyond a largest one to either side.
fn within(key: &'static str, numbers: Option<&[f64; 3]>, most: f64) -> Result<(), BadMessage> {
    let fits = |numbers: &[f64; 3]| numbers.iter().all(|v| (-most..=most).contains(v));
    if numbers.is_none_or(fits) { Ok(()) } else { Err(BadMessage::Range { key, low: -most, high: most }) }
}

impl ToPhone {
    /// Creates the message about the pan, rounded to four decimals.
    pub fn pan(pose: &Pose, rumble: &Rumble) -> Self {
        let round = |v: f64| (v * 1e4).round() * 1e-4;
        Self::Pan { turn: pose.rotation.to_array().map(round), strong: round(rumble.strong), weak: round(rumble.weak) }
    }

    /// Returns the message as JSON.
    pub fn json(&self) -> String {
        // Serialising finite numbers and fixed names cannot fail.
        serde_json::to_string(self).unwrap_or_default()
    }
}
