//! What the motors of a gamepad let a hand feel: collisions, sliding and boiling in the pan.

use saute_haptics::{ContactModel, KitchenWatch, Rumble, RumbleRule, library};
use saute_kitchen::{FRAME_S, Kitchen};

/// A gamepad falls silent when nothing has happened for so long [s] (chosen: three frames).
const SILENT_S: f64 = 0.05;

/// The contact model, and what a gamepad makes of it.
#[derive(Default)]
pub struct Felt {
    watch: KitchenWatch,
    model: ContactModel,
    /// Time since the kitchen was looked at last [s].
    silent: f64,
    /// True if a gamepad renders what is felt.
    listened: bool,
    rule: Option<RumbleRule>,
}

impl Felt {
    /// Returns true if a gamepad renders what is felt.
    pub fn is_listened(&self) -> bool {
        self.listened
    }

    /// Looks at the kitchen after a frame at the pace of the clock.
    pub fn look(&mut self, kitchen: &Kitchen) -> &ContactModel {
        self.model = self.watch.look(kitchen, FRAME_S);
        self.silent = 0.0;
        &self.model
    }

    /// Another kitchen is shown.
    pub fn forget(&mut self) {
        self.watch.forget();
    }

    /// Returns the rumble of a gamepad now, `wall` after the last call [s]; none while time is stopped or runs
    /// faster.
    pub fn rumble(&mut self, wall: f64) -> Rumble {
        self.listened = true;
        self.silent += wall;
        if self.rule.is_none() {
            // The program's own file is whole, or nothing at all is felt.
            self.rule = library::feel().ok().map(|feel| RumbleRule::new(&feel));
        }
        let (silent, model) = (self.silent > SILENT_S + wall, &self.model);
        self.rule.as_mut().filter(|_| !silent).map_or_else(Rumble::default, |rule| rule.step(model, wall))
    }
}
