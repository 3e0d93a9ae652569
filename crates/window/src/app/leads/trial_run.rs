//! The trial run of a study's machine, and the share of a locked speed that the machine sustains.

use std::sync::Arc;

use crate::app::SauteApp;
use saute_kitchen::Command;
use saute_session::guided::{Guided, Readiness};
use saute_session::hands::Hands as _;

/// Power of the hob while the machine is tried [W] (chosen: a pan that sears, as in a trial).
const HOB_W: f64 = 1800.0;

impl SauteApp {
    /// Begins to try the machine, if that is still to be done: the food of the trials goes into the pan.
    pub(crate) fn try_machine(&mut self) {
        let Some(Guided::Study(desk)) = &mut self.leads.guided else { return };
        if !matches!(desk.readiness(), Readiness::Untried) {
            return;
        }
        let trials = desk.to_try().map(|simulate| (Arc::clone(&simulate.recipe), simulate.speed));
        desk.try_machine(trials.as_ref().map(|(_, speed)| *speed));
        let Some((recipe, speed)) = trials else { return };
        if let Err(error) = self.session.set_out_led(recipe) {
            return self.say_trouble(&error);
        }
        self.session.set_speed(speed);
        self.session.permits = self.permits();
        self.give(&Command::Hob(HOB_W));
        self.lay_in(&self.session.its_group());
    }

    /// Notes what has passed of a locked speed; after a trial run the food is there raw again.
    pub(crate) fn note_pace(&mut self, wall_s: f64, simulated_s: f64) {
        let Some(Guided::Study(desk)) = &mut self.leads.guided else { return };
        desk.note_devices(self.session.hands.names());
        if !desk.pass(wall_s, simulated_s) {
            return;
        }
        let recipe = desk.study().fastest_to_come().map(|simulate| Arc::clone(&simulate.recipe));
        self.sights.motions.clear();
        if let Some(Err(error)) = recipe.map(|recipe| self.session.set_out_led(recipe)) {
            self.say_trouble(&error);
        }
    }
}
