//! Foods that are built over frames, and what waits for them.

use egui::Context;
use saute_controls::act::{Act, TimeAct};
use web_time::Duration;

use super::later::Later;
use crate::app::SauteApp;

/// Longest that a frame builds foods before it is drawn, unless one takes longer [ms] (chosen: the picture goes on at ten frames a second).
const BUILD_BUDGET_MS: u64 = 60;

impl SauteApp {
    /// Keeps something for when its foods are built, if they are not built yet; returns true if it waits now.
    pub(crate) fn waits_for_food(&mut self, is_to_build: bool, later: impl FnOnce() -> Later) -> bool {
        if is_to_build {
            self.pace.later = Some((later(), self.session.generation));
        }
        is_to_build
    }

    /// Builds foods, and does what waited for them, unless another cook began meanwhile.
    pub(crate) fn build_foods(&mut self, ctx: &Context) {
        let Some((_, generation)) = self.pace.later else { return };
        if generation != self.session.generation {
            self.stops_building();
            return;
        }
        ctx.request_repaint();
        let is_built = self.session.build_more(Duration::from_millis(BUILD_BUDGET_MS));
        if is_built == Some(false) {
            return;
        }
        if let Some((later, _)) = self.pace.later.take().filter(|_| is_built.is_some()) {
            self.do_later(later);
        }
        // What was refused leaves nothing behind.
        if self.pace.later.is_none() {
            self.session.stop_building();
        }
    }

    fn do_later(&mut self, later: Later) {
        match later {
            Later::SetOut(choice, count) => self.set_out_chosen(choice, count),
            Later::Add(choice, count) => self.add_chosen(&choice, count),
            Later::Restart => self.restart(),
            Later::Offer => self.decide_on_offer(true),
            Later::Recipe(name, text) => self.open_recipe(&text, &name),
            Later::Session(name, bytes) => self.open_session(&name, &bytes),
            Later::Link(fragment) => self.open_link(&fragment),
        }
    }

    /// Lets go of what waits for its foods; returns true if something did.
    pub(crate) fn stops_building(&mut self) -> bool {
        self.session.stop_building();
        self.pace.later.take().is_some()
    }

    /// Time that is turned lets go of what waits for its foods: it was meant for the cook as it was. Returns true if that is all that the act
    /// does.
    pub(crate) fn takes_back_later(&mut self, act: &Act) -> bool {
        let Act::Time(act) = act else { return false };
        let turns = matches!(act, TimeAct::Redo | TimeAct::Scrub(_) | TimeAct::TryFrom(_) | TimeAct::Branch(_));
        if !(turns || *act == TimeAct::Undo) || !self.stops_building() {
            return false;
        }
        self.say("waiting.not_set_out");
        *act == TimeAct::Undo
    }
}
