//! What is done as soon as its foods are built.

use egui::Context;
use saute_controls::act::Act;
use web_time::Duration;

use crate::app::SauteApp;

/// Longest that a frame builds foods before it is drawn, unless one takes longer [ms] (chosen: the picture goes on at ten frames a second).
const BUILD_BUDGET_MS: u64 = 60;

/// What waits for its foods.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Later {
    /// An act.
    Act(Act),
    /// A recipe's name and its text.
    Recipe(String, String),
    /// A session's name and its bytes.
    Session(String, Vec<u8>),
    /// The fragment of an address.
    Link(String),
}

impl SauteApp {
    /// Keeps something for when its foods are built, if they are not built yet; returns true if it waits now.
    pub(crate) fn waits_for_food(&mut self, is_to_build: bool, later: impl FnOnce() -> Later) -> bool {
        if is_to_build {
            self.pace.later = Some(later());
        }
        is_to_build
    }

    /// Builds foods, and does what waited for them.
    pub(crate) fn build_foods(&mut self, ctx: &Context) {
        if self.pace.later.is_none() {
            return;
        }
        ctx.request_repaint();
        match self.session.build_more(Duration::from_millis(BUILD_BUDGET_MS)) {
            Some(false) => {}
            // Another cook began meanwhile.
            None => self.pace.later = None,
            Some(true) => {
                if let Some(later) = self.pace.later.take() {
                    self.do_later(later, ctx);
                }
            }
        }
    }

    fn do_later(&mut self, later: Later, ctx: &Context) {
        match later {
            Later::Act(act) => self.act(act, ctx),
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
}
