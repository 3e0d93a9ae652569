//! Moves the kitchen's pan with a device, and lays it down without one.

use saute_kitchen::dynamics::Pose;
use saute_kitchen::hands::ranges::usable;
use saute_kitchen::{Command, Kitchen};

#[cfg(not(target_arch = "wasm32"))]
use crate::device::{HapticSample, Health};
use crate::kitchen::handover::Handover;
use crate::kitchen::lay_down::LayDown;

/// State of the pan that a device moves, frame by frame.
#[derive(Clone, Copy, Debug, Default)]
pub struct PanInHand {
    handover: Handover,
    holds: bool,
    laying: Option<LayDown>,
}

impl PanInHand {
    /// Moves the pan before a frame of `dt` [s].
    ///
    /// A running device that moves the pan holds it at its pose. Otherwise (stopped, lost, `None`, or a device for the turner only) a
    /// held pan is laid down.
    #[cfg(not(target_arch = "wasm32"))]
    pub fn step(&mut self, sample: Option<&HapticSample>, kitchen: &mut Kitchen, dt: f64) {
        let sample = sample.filter(|s| s.health == Health::Running && s.leads_pan);
        self.hold(sample.map(|s| &s.pose), kitchen, dt);
    }

    /// As [`Self::step`], by the pose alone at which a hand holds the pan; without one a held pan is laid down. A pose that is none
    /// leaves the pan where it is.
    pub fn hold(&mut self, hand: Option<&Pose>, kitchen: &mut Kitchen, dt: f64) {
        if let Some(hand) = hand {
            // The handover remembers where the hand began, so that no number that is none may get there.
            let Ok(hand) = usable(hand) else { return };
            (self.holds, self.laying) = (true, None);
            let pose = self.handover.pose(&kitchen.held_pan(), &hand, dt);
            // A pose of usable ones is refused only where their difference is beyond all numbers.
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

    /// Returns true while a device holds the pan.
    pub fn holds(&self) -> bool {
        self.holds
    }

    /// Returns true while the pan is being laid down.
    pub fn lays_down(&self) -> bool {
        self.laying.is_some()
    }
}
