//! Oil, butter, water and the lid: what a cook adds at once, and what is in the pan.

use crate::app::SauteApp;
use saute_controls::input::pouring::Pourable;
use saute_kitchen::Command;

impl SauteApp {
    /// Adds a portion to the pan.
    pub(crate) fn pour(&mut self, what: Pourable) {
        let mass = 1e-3 * self.inputs.portion.grams(what);
        self.command(&match what {
            Pourable::Oil => Command::Oil { kind: None, mass },
            Pourable::Butter => Command::Butter(mass),
            Pourable::Water => Command::Water(mass),
        });
    }

    /// The next larger portion, or the smallest again.
    pub(crate) fn next_portion(&mut self) {
        self.inputs.portion = self.inputs.portion.next();
    }

    /// Lays the lid on, or takes it off; a tool in the pan is put away first.
    pub(crate) fn turn_lid(&mut self) {
        let on = self.session.kitchen.pan_state().lid.is_some();
        if !on {
            self.put_tool_away();
        }
        self.command(&Command::Lid(!on));
    }
}
