//! A tool in a free hand: it is led to where a person points, takes hold of food, and lays it down again.

use glam::DVec3;

use crate::dynamics::{Pose, RIGID_S, Tool};
use crate::hands::command::Refused;
use crate::kitchen::Kitchen;
use crate::piece::piece_state::Place;

/// A tool that a person leads.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Led {
    tool: Tool,
    to: Pose,
    grip: Option<u32>,
    /// Since when it lays down what it grips, if it does [s].
    laying_s: Option<f64>,
}

/// A tool this near to where it is led has arrived [m] (chosen).
const ARRIVED: f64 = 0.008;
/// How quickly food is laid down [m/s] (chosen: gently).
const LAYING_SPEED: f64 = 0.25;
/// How far the tool is below where its food would hang free when the food lies [m] (chosen: above what the spring gives).
const LIES: f64 = 0.003;
/// Longest time that laying food down takes [s] (chosen: then it is dropped).
const LAYING_S: f64 = 2.0;

impl Kitchen {
    /// Leads a tool; a task of the other hand is given up.
    pub(crate) fn lead(&mut self, tool: Tool, to: &Pose, grip: Option<&str>) -> Result<(), Refused> {
        let key = match grip {
            Some(food) => {
                let piece = self.piece_mut(food)?;
                if piece.place == Place::Waiting {
                    return Err(Refused::Waiting(food.into()));
                }
                Some(piece.key)
            }
            None => None,
        };
        if self.led.is_none_or(|led| led.tool != tool) {
            self.hand.withdraw();
            self.tasks.clear();
            self.at_work = None;
            self.hand.pose = *to;
        }
        self.led = Some(Led { tool, to: *to, grip: key, laying_s: None });
        // The hand is active at once, so that even a world at rest is looked at.
        self.hand.lead(tool, to);
        Ok(())
    }

    /// The tool that a person leads; none once it is laid down.
    pub fn led_tool(&self) -> Option<Tool> {
        self.led.filter(|led| led.laying_s.is_none()).map(|led| led.tool)
    }

    /// Lays down what is gripped; a hand that grips nothing is put away at once.
    pub(crate) fn let_go(&mut self) {
        match &mut self.led {
            Some(led) if self.hand.gripped().is_some() => led.laying_s = Some(0.0),
            _ => self.end_lead(),
        }
    }

    fn end_lead(&mut self) {
        if self.led.take().is_some() {
            self.hand.withdraw();
        }
    }

    /// One rigid step of a led tool.
    pub(crate) fn follow_lead(&mut self) {
        let Some(mut led) = self.led else { return };
        if let Some(since) = &mut led.laying_s {
            *since += RIGID_S;
            let arrived = (led.to.position - self.hand.pose.position).truncate().length() < ARRIVED;
            let lies = self.hand.hanging_below(&self.world).is_none_or(|low| low < -LIES);
            if *since > LAYING_S || (arrived && lies) {
                return self.end_lead();
            }
            if arrived {
                led.to.position = self.hand.pose.position - DVec3::Z * (LAYING_SPEED * RIGID_S);
            }
        }
        self.hand.lead(led.tool, &led.to);
        if let (Some(key), None, None) = (led.grip, self.hand.gripped(), led.laying_s) {
            self.hand.grip(key, &self.world);
        }
        if (led.tool, led.grip, led.laying_s) == (Tool::Turner, None, None) {
            self.hand.scoop(&led.to, &self.world);
        }
        self.led = Some(led);
    }
}
