//! Contact of a piece with the pan over time: patches near the pan, duration, force and flips.

use crate::pan::near_pan::NearPan;
use crate::tick::low_pass::low_pass;
use serde::{Deserialize, Serialize};

/// Longest loss of contact that does not restart the contact [s] (chosen: a hop of a few millimetres).
const HOP_S: f64 = 0.15;
/// Time constant of the contact force's low-pass filter [s] (chosen: longer than the impact of a landing).
const PRESSURE_S: f64 = 0.3;

/// Contact of a piece with the pan.
#[derive(Clone, Debug, Deserialize, Serialize)]
pub(crate) struct PanContact {
    /// Patches near the pan.
    pub(crate) near: NearPan,
    /// Time since the start of the contact of its lower face [s].
    pub(crate) since: f64,
    /// Low-pass filtered normal force on the pan [N].
    pub(crate) force: f64,
    /// Time of the last flip [s].
    pub(crate) flipped_at: Option<f64>,
    /// Upward direction in the body's frame when the contact started [-].
    pub(crate) lay_up: [f64; 3],
    /// Duration of the present loss of contact [s].
    lost_s: f64,
}

impl PanContact {
    /// Returns the record of a piece that was never in the pan.
    pub(crate) fn none() -> Self {
        let (near, lay_up) = (NearPan::default(), [0.0, 0.0, 1.0]);
        Self { near, since: 0.0, force: 0.0, flipped_at: None, lay_up, lost_s: 0.0 }
    }

    /// Returns the record of the piece on another mesh, whose patches are to be found again.
    pub(crate) fn on_other_mesh(&self) -> Self {
        Self { near: NearPan::default(), ..*self }
    }

    /// Updates duration, flips and filtered force after an update of the near patches; `up` is the upward direction in
    /// the body's frame.
    pub(crate) fn follow(&mut self, up: [f64; 3], force: f64, now: f64, dt: f64) {
        self.lost_s = if self.near.patches.is_empty() { self.lost_s + dt } else { 0.0 };
        let level: f64 = up.iter().zip(&self.lay_up).map(|(a, b)| a * b).sum();
        if level < 0.0 && !self.near.patches.is_empty() {
            self.flipped_at = Some(now);
        }
        if self.lost_s > HOP_S || (level < 0.5 && !self.near.patches.is_empty()) {
            self.since = 0.0;
            self.force = force;
        }
        if !self.near.patches.is_empty() && level < 0.5 {
            self.lay_up = up;
        }
        low_pass(&mut self.force, force, PRESSURE_S, dt);
    }

    /// Restarts the record for a piece laid flat into the pan.
    pub(crate) fn lie(&mut self) {
        self.lay_up = [0.0, 0.0, 1.0];
        self.near.forget();
    }

    /// Ends the contact.
    pub(crate) fn leave(&mut self) {
        self.near.forget();
        self.since = 0.0;
        self.force = 0.0;
    }
}
