//! A tool that a person moves freely: it follows a target pose, grips food and lays it down.

use glam::DVec3;
use serde::{Deserialize, Serialize};

use crate::dynamics::{Pose, RIGID_S, Tool};
use crate::hands::command::Refused;
use crate::hands::ranges::usable;
use crate::kitchen::Kitchen;
use crate::piece::piece_state::Place;

/// Tool that a person moves freely, with its target.
#[derive(Clone, Copy, Debug, Deserialize, PartialEq, Serialize)]
pub(crate) struct Led {
    tool: Tool,
    to: Pose,
    grip: Option<u32>,
    /// Time since the start of laying down; `None` before [s].
    laying_s: Option<f64>,
}

/// Horizontal distance from its target at which a tool has arrived [m] (chosen: small against the tool).
const ARRIVED: f64 = 0.008;
/// Speed of laying food down [m/s] (chosen: gently).
const LAYING_SPEED: f64 = 0.25;
/// Slack of the grip's spring at which the gripped food is supported from below [m] (chosen: above the spring's
/// deflection by weight).
const LIES: f64 = 0.003;
/// Farthest that a tool is led from the ring's centre along each axis [m] (chosen: an arm beyond the hob and the board).
const REACH: f64 = 1.5;
/// Longest duration of laying down; the food is dropped after it [s] (chosen).
const LAYING_S: f64 = 2.0;

/// The pose at the edge of the hand's reach where it is beyond.
fn within_reach(to: &Pose) -> Pose {
    Pose { position: to.position.clamp(DVec3::splat(-REACH), DVec3::splat(REACH)), ..*to }
}

impl Kitchen {
    /// Moves a tool towards a pose; the tasks of the second hand are cancelled.
    pub(crate) fn lead(&mut self, tool: Tool, to: &Pose, grip: Option<&str>) -> Result<(), Refused> {
        let to = &within_reach(&usable(to)?);
        let key = match grip {
            Some(food) => {
                self.check_set(food)?;
                let piece = self.piece_mut(food)?;
                if piece.place == Place::Waiting {
                    return Err(Refused::Waiting(food.into()));
                }
                Some(piece.key)
            }
            None => None,
        };
        if self.second_hand.free.is_none_or(|led| led.tool != tool) {
            self.second_hand.hand.withdraw();
            self.second_hand.tasks.clear();
            self.second_hand.current = None;
            self.second_hand.hand.pose = *to;
        }
        self.second_hand.free = Some(Led { tool, to: *to, grip: key, laying_s: None });
        // The hand becomes active at once: rigid steps are skipped while all bodies rest and no hand is active.
        self.second_hand.hand.lead(tool, to);
        Ok(())
    }

    /// Returns the tool that a person moves, or `None` once it is being laid down.
    pub fn led_tool(&self) -> Option<Tool> {
        self.second_hand.free.filter(|led| led.laying_s.is_none()).map(|led| led.tool)
    }

    /// Starts to lay the gripped piece down; a tool without grip is put away at once.
    pub(crate) fn let_go(&mut self) {
        match &mut self.second_hand.free {
            Some(led) if self.second_hand.hand.gripped().is_some() => led.laying_s = Some(0.0),
            _ => self.end_lead(),
        }
    }

    fn end_lead(&mut self) {
        if self.second_hand.free.take().is_some() {
            self.second_hand.hand.withdraw();
        }
    }

    /// One rigid step of the free tool.
    pub(crate) fn follow_lead(&mut self) {
        let Some(mut led) = self.second_hand.free else { return };
        if let Some(since) = &mut led.laying_s {
            *since += RIGID_S;
            let arrived = (led.to.position - self.second_hand.hand.pose.position).truncate().length() < ARRIVED;
            let lies = self.second_hand.hand.hanging_below(&self.world).is_none_or(|low| low < -LIES);
            if *since > LAYING_S || (arrived && lies) {
                return self.end_lead();
            }
            if arrived {
                led.to.position = self.second_hand.hand.pose.position - DVec3::Z * (LAYING_SPEED * RIGID_S);
            }
        }
        self.second_hand.hand.lead(led.tool, &led.to);
        if let (Some(key), None, None) = (led.grip, self.second_hand.hand.gripped(), led.laying_s) {
            self.second_hand.hand.grip(key, &self.world);
        }
        if (led.tool, led.grip, led.laying_s) == (Tool::Turner, None, None) {
            self.second_hand.hand.scoop(&led.to, &self.world);
        }
        self.second_hand.free = Some(led);
    }
}
