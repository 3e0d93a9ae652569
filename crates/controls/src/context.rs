//! What every panel may read: the world, the settings, and who leads the cook.

use std::sync::Arc;

use saute_kitchen::Piece;
use saute_kitchen::food::Scale;
use saute_kitchen::food::change::doneness::Measure;

use crate::act::Act;
use crate::session::Session;
use crate::settings::Settings;
use saute_session::guided::Guided;
use saute_session::permits::{Permit, Permits};

/// What every panel may read. A panel that reads more takes its own state, which derefs to this; the changes that it requests it returns as
/// an [`Act`].
#[derive(Clone, Copy)]
pub struct PanelContext<'a> {
    /// The world behind the window.
    pub session: &'a Session,
    /// The settings that are remembered.
    pub settings: &'a Settings,
    /// The study or the lesson that leads the cook.
    pub guided: Option<&'a Guided>,
}

/// Lets what every panel reads be read from a state that has it as its `context`.
#[macro_export]
macro_rules! reads_context {
    ($state:ident) => {
        impl<'a> std::ops::Deref for $state<'a> {
            type Target = $crate::context::PanelContext<'a>;

            fn deref(&self) -> &$crate::context::PanelContext<'a> {
                &self.context
            }
        }
    };
}

impl PanelContext<'_> {
    /// Returns true if panels may show readings: temperatures, doneness, curves, forecasts and advice. In skill mode, and where a
    /// study or a lesson hides them, they do not.
    pub fn reads_out(&self) -> bool {
        !self.settings.skill_mode && !self.is_blind()
    }

    /// Returns true if words may state what the core will reach: not before a lesson has asked the student for it.
    pub fn foretells(&self) -> bool {
        self.session.lesson.as_ref().is_none_or(|lesson| !lesson.asks_ahead())
    }

    /// The scale of doneness in whose words the food that the panels show is described.
    pub fn scale(&self) -> Option<Arc<Scale>> {
        self.session.scale(&self.settings.scale)
    }

    /// The scale in whose words a piece is described.
    pub fn scale_of(&self, piece: &Piece) -> Option<Arc<Scale>> {
        self.session.scales(&self.settings.scale).of(&piece.model).cloned()
    }

    /// About how long the whole cook of the shown food takes to its goal [s]; none of food whose doneness is determined by something other than
    /// the temperature of its core.
    pub fn whole_time_s(&self) -> Option<f64> {
        let scale = self.scale().filter(|scale| scale.measure() == Measure::Peak)?;
        self.session.whole_time_s(self.settings.goal(&scale))
    }

    /// Returns true if a study or a lesson hides what cannot be seen in a kitchen.
    pub fn is_blind(&self) -> bool {
        !self.permits().allow(&[Permit::ReadOuts])
    }

    /// Returns true if a control is not shown at all: what a study does not let anybody do, and what reads out where read-outs are
    /// hidden. What else a lesson locks is shown as locked: its card names it.
    pub fn hides(&self, act: &Act) -> bool {
        let is_study = matches!(self.guided, Some(Guided::Study(_)));
        self.forbids(act) && (is_study || (self.is_blind() && act.traits().reads))
    }

    /// What a study or a lesson lets a person do.
    pub fn permits(&self) -> Permits {
        self.guided.map(Guided::permits).unwrap_or_default()
    }

    /// Returns true if a study or a lesson does not let a person do something.
    pub fn forbids(&self, act: &Act) -> bool {
        !self.permits().allow(act.traits().needs)
    }
}
