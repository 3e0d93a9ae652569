//! Everything a person can do, by button, key or mouse.

mod app_act;
mod bindings;
mod card;
mod cook_act;
mod guided_act;
mod host_act;
mod learn_act;
mod one_act;
#[cfg(test)]
pub(crate) mod samples;
mod setting;
mod time_act;
mod traits;
mod view_act;

pub use self::app_act::AppAct;
pub use self::bindings::{BINDINGS, Binding, CHORDS, ROLL_STEP, TOOL_STEP, hint, key_of};
pub use self::card::Card;
pub use self::cook_act::CookAct;
pub use self::guided_act::GuidedAct;
pub use self::host_act::HostAct;
pub use self::learn_act::LearnAct;
pub use self::one_act::{Act, Acts};
pub use self::setting::Setting;
pub use self::time_act::TimeAct;
pub use self::traits::{Subject, Traits};
pub use self::view_act::ViewAct;
