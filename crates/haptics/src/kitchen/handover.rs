//! Handover: the kitchen's pan glides to the hand's pose without a jerk that would toss the food.

use glam::DVec3;
use saute_kitchen::dynamics::Pose;
use saute_kitchen::dynamics::pose::{about, rotation_between};

/// Duration of the glide [s] (chosen: lifts the pan by 10 cm with at most 0.3 m/s).
const GLIDE_S: f64 = 0.6;

/// Blends from the kitchen's pose to the hand's: x = x_hand + s(t) Δx, where s falls from 1 to 0 and Δx is the initial offset.
#[derive(Clone, Copy, Debug, Default)]
pub struct Handover {
    off: Option<(DVec3, DVec3)>,
    since: f64,
}

impl Handover {
    /// Returns the blended pose; `kitchen` is the pan's present pose, `hand` the device's, `dt` the time since the last call [s].
    pub fn pose(&mut self, kitchen: &Pose, hand: &Pose, dt: f64) -> Pose {
        let apart = || (kitchen.position - hand.position, rotation_between(hand.rotation, kitchen.rotation));
        let (place, turn) = *self.off.get_or_insert_with(apart);
        let left = 1.0 - (self.since / GLIDE_S).min(1.0);
        // Smoothstep 3s² − 2s³: zero speed at both ends.
        let share = left * left * (3.0 - 2.0 * left);
        self.since += dt;
        Pose { position: hand.position + place * share, rotation: (about(turn * share) * hand.rotation).normalize() }
    }

    /// Ends the glide; the next call to `pose` starts a new one.
    pub fn let_go(&mut self) {
        *self = Self::default();
    }
}
