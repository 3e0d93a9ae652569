//! The tool in the cook's hand: tongs that grip what is dragged, or a turner that stays where it was put.

use glam::{DQuat, DVec2, DVec3};
use saute_kitchen::dynamics::{Pose, Tool};
use std::f64::consts::{FRAC_PI_2, PI, TAU};

/// Which tool mouse and right stick lead, and where.
#[derive(Clone, Debug, PartialEq)]
pub struct ToolHand {
    /// Which tool.
    pub tool: Tool,
    /// Where the turner is to be; none while it lies aside.
    pub turner: Option<TurnerPose>,
    /// What the right stick's tongs hold, and where they are to be [m].
    pub tongs: Option<(String, DVec3)>,
}

impl Default for ToolHand {
    fn default() -> Self {
        Self { tool: Tool::Tongs, turner: None, tongs: None }
    }
}

/// Where a turner is to be.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TurnerPose {
    /// Middle of the blade, in the kitchen [m].
    pub at: DVec2,
    /// Its height above the pan's floor [m].
    pub height: f64,
    /// Direction in which the blade points, from +x over +y [rad].
    pub facing: f64,
    /// Turn about that direction [rad].
    pub roll: f64,
    /// Turn of its front edge downwards [rad].
    pub pitch: f64,
}

/// Farthest place of a tool from the ring [m] (chosen: within reach).
pub const REACH: f64 = 0.55;
/// Greatest height of a tool above the pan [m] (chosen: within reach).
pub const HIGHEST: f64 = 0.25;

/// Steepest pitch [rad] (chosen: the blade stands on its edge).
const STEEPEST: f64 = FRAC_PI_2;

/// Rolls nearer to level or upside down than this settle there, and pitches nearer to level [rad] (chosen: forgiving).
const SETTLES: f64 = 0.35;

impl TurnerPose {
    /// Moves it.
    pub fn shift(&mut self, by: DVec3) {
        self.at = (self.at + by.truncate()).clamp_length_max(REACH);
        self.height = (self.height + by.z).clamp(0.0, HIGHEST);
    }

    /// Rolls it to the right and lowers its front edge [rad].
    pub fn tilt(&mut self, roll: f64, pitch: f64) {
        self.roll = (self.roll + roll + PI).rem_euclid(TAU) - PI;
        self.pitch = (self.pitch + pitch).clamp(-STEEPEST, STEEPEST);
    }

    /// Nearly level becomes level, nearly upside down upside down.
    pub fn settle(&mut self) {
        for whole in [-PI, 0.0, PI] {
            if (self.roll - whole).abs() < SETTLES {
                self.roll = whole;
            }
        }
        if self.pitch.abs() < SETTLES {
            self.pitch = 0.0;
        }
    }

    /// Makes it level.
    pub fn level(&mut self) {
        (self.roll, self.pitch) = (0.0, 0.0);
    }

    /// Returns where the blade is above a floor at a height [m].
    pub fn pose(&self, floor: f64) -> Pose {
        let turned = DQuat::from_rotation_z(self.facing) * DQuat::from_rotation_y(self.pitch);
        let rotation = turned * DQuat::from_rotation_x(self.roll);
        Pose { position: self.at.extend(floor + self.height), rotation }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn level() -> TurnerPose {
        TurnerPose { at: DVec2::ZERO, height: 0.0, facing: FRAC_PI_2, roll: 0.0, pitch: 0.0 }
    }

    #[test]
    fn a_roll_to_the_right_turns_the_blade_over_and_settles_there() {
        let mut turner = level();
        turner.tilt(0.5, 0.0);
        let up = turner.pose(0.0).rotation * DVec3::Z;
        assert!(up.x > 0.4 && up.y.abs() < 1e-9, "{up}");
        turner.tilt(2.5, 0.2);
        turner.settle();
        assert!((turner.roll.abs() - PI).abs() < 1e-12 && turner.pitch == 0.0);
        turner.tilt(PI, 0.0);
        turner.settle();
        assert!(turner.roll.abs() < 1e-9);
    }

    #[test]
    fn a_turner_stays_within_reach() {
        let mut turner = level();
        turner.shift(DVec3::new(3.0, 0.0, 3.0));
        assert!((turner.at.length() - REACH).abs() < 1e-12 && turner.height == HIGHEST);
        turner.shift(DVec3::new(0.0, 0.0, -3.0));
        turner.tilt(0.0, 9.0);
        assert_eq!((turner.height, turner.pitch), (0.0, STEEPEST));
    }
}
