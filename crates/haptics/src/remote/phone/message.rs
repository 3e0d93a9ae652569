//! What a phone's page and this program say to each other, as JSON.

use saute_kitchen::dynamics::Pose;
use serde::{Deserialize, Serialize};

use crate::control::rumble::Rumble;

/// Longest message [bytes] (chosen: motion with all its digits has 300).
pub const LONGEST: usize = 1024;
/// Largest acceleration that a phone measures [m/s²] (chosen: sensors end at 16 g).
const LARGEST_M_S2: f64 = 200.0;
/// Largest angle that browsers tell [°].
const LARGEST_DEG: f64 = 360.0;

/// From the phone.
#[derive(Clone, Debug, PartialEq, Deserialize)]
#[serde(tag = "kind", rename_all = "kebab-case", deny_unknown_fields)]
pub enum FromPhone {
    /// The code that its user has typed.
    Hello {
        /// Six digits.
        code: String,
    },
    /// How it is turned and pushed.
    Motion(Measured),
    /// It lies flat in the hand now: this is level, and its top points away from the cook.
    Flat {},
    /// A finger on the page, or none.
    Button {
        /// Whether it is down.
        down: bool,
    },
}

/// What its sensors say.
#[derive(Clone, Copy, Debug, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Measured {
    /// alpha, beta, gamma of the DeviceOrientation event [°].
    pub turn: [f64; 3],
    /// Acceleration without gravity along the phone's axes, where it is known [m/s²].
    #[serde(default)]
    pub push: Option<[f64; 3]>,
    /// Acceleration with gravity, where it is known [m/s²].
    #[serde(default)]
    pub felt: Option<[f64; 3]>,
}

/// To the phone.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[serde(tag = "kind", rename_all = "kebab-case")]
pub enum ToPhone {
    /// The code was right.
    Welcome,
    /// The code was wrong; another one is looked at after a while.
    Refused {
        /// How long to wait [s].
        wait_s: f64,
        /// Whether no code is taken any more.
        closed: bool,
    },
    /// Whether the phone lay flat enough to be told that this is level.
    Flat {
        /// Whether it did.
        taken: bool,
    },
    /// How the pan in the kitchen is turned, and how hard to shake.
    Pan {
        /// Quaternion x, y, z, w [-].
        turn: [f64; 4],
        /// Collisions, 0 to 1.
        strong: f64,
        /// Boiling, sliding, scraping, 0 to 1.
        weak: f64,
    },
    /// Another phone holds the pan now.
    Replaced,
}

/// A message that means nothing.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum BadMessage {
    /// Too long.
    #[error("a message of {0} bytes is too long")]
    Long(usize),
    /// No JSON of a known kind.
    #[error("{0}")]
    Json(String),
    /// A number that no sensor tells.
    #[error("{0} is out of range")]
    Range(&'static str),
}

impl FromPhone {
    /// Reads and checks a message.
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
    fn check(&self) -> Result<(), BadMessage> {
        let within = |list: &[f64], most: f64| list.iter().all(|v| v.is_finite() && v.abs() <= most);
        if !within(&self.turn, LARGEST_DEG) {
            return Err(BadMessage::Range("turn"));
        }
        if !self.push.iter().chain(&self.felt).all(|a| within(a, LARGEST_M_S2)) {
            return Err(BadMessage::Range("push or felt"));
        }
        Ok(())
    }
}

impl ToPhone {
    /// The pan as it is held.
    pub fn pan(pose: &Pose, rumble: &Rumble) -> Self {
        let round = |v: f64| (v * 1e4).round() * 1e-4;
        Self::Pan { turn: pose.rotation.to_array().map(round), strong: round(rumble.strong), weak: round(rumble.weak) }
    }

    /// As JSON.
    pub fn json(&self) -> String {
        // Numbers and fixed names always can be written.
        serde_json::to_string(self).unwrap_or_default()
    }
}
