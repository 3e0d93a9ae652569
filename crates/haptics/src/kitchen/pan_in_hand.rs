//! The kitchen's pan where a device's hand holds it, and on its ring when the hand is gone.

use saute_kitchen::{Command, Kitchen};

use crate::device::{HapticSample, Health};
use crate::kitchen::handover::Handover;
use crate::kitchen::lay_down::LayDown;

/// Leads the kitchen's pan by a device, frame by frame.
#[derive(Clone, Copy, Debug, Default)]
pub struct PanInHand {
    handover: Handover,
    holds: bool,
    laying: Option<LayDown>,
}

impl PanInHand {
    /// Before a frame of `dt` [s]: holds the pan where a running device is; a device that has stopped, is lost, was taken away (none) or
    /// tells nothing of the pan lays it down.
    pub fn step(&mut self, sample: Option<&HapticSample>, kitchen: &mut Kitchen, dt: f64) {
        if let Some(sample) = sample.filter(|s| s.health == Health::Running && s.leads_pan) {
            (self.holds, self.laying) = (true, None);
            let pose = self.handover.pose(&kitchen.held_pan(), &sample.pose, dt);
            // Refused only for poses that are no numbers, and drivers give none.
            let _ = kitchen.apply(&Command::HoldPan { pose });
            return;
        }
        if std::mem::take(&mut self.holds) {
            self.handover.let_go();
            self.laying = Some(LayDown::begin(kitchen));
        }
        if self.laying.as_mut().is_some_and(|way| way.step(kitchen, dt)) {
            self.laying = None;
        }
    }

    /// Whether a hand holds the pan.
    pub fn holds(&self) -> bool {
        self.holds
    }

    /// Whether the pan is being laid down.
    pub fn lays_down(&self) -> bool {
        self.laying.is_some()
    }
}
