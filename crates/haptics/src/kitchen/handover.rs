//! From where the kitchen's pan stands to where the hand holds the real one, without a jerk that would toss the food.

use glam::DVec3;
use saute_kitchen::dynamics::Pose;
use saute_kitchen::dynamics::pose::{about, rotation_between};

/// How long the kitchen's pan takes to come into the hand [s] (chosen: a lift of 10 cm at 0.3 m/s at most).
const GLIDE_S: f64 = 0.6;

/// Leads the kitchen's pan into the hand: what parts the two poses at first shrinks to nothing, x = x_hand + s(t) Δx.
#[derive(Clone, Copy, Debug, Default)]
pub struct Handover {
    off: Option<(DVec3, DVec3)>,
    since: f64,
}

impl Handover {
    /// Where the kitchen shall hold its pan, which is at `kitchen` now, while the hand is at `hand`; `dt` after the last time [s].
    pub fn pose(&mut self, kitchen: &Pose, hand: &Pose, dt: f64) -> Pose {
        let apart = || (kitchen.position - hand.position, rotation_between(hand.rotation, kitchen.rotation));
        let (place, turn) = *self.off.get_or_insert_with(apart);
        let left = 1.0 - (self.since / GLIDE_S).min(1.0);
        // Starts and ends gently: 3s² − 2s³.
        let share = left * left * (3.0 - 2.0 * left);
        self.since += dt;
        Pose { position: hand.position + place * share, rotation: (about(turn * share) * hand.rotation).normalize() }
    }

    /// The hand has let go, or the device is away: the next pose begins a new glide.
    pub fn let_go(&mut self) {
        *self = Self::default();
    }
}
