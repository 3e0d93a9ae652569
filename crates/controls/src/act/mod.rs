//! Everything a person can do, by button, key or mouse.

mod app_act;
mod card;
mod cook_act;
#[cfg(not(target_arch = "wasm32"))]
mod desktop_act;
mod guided_act;
mod host_act;
mod learn_act;
mod one_act;
#[cfg(target_arch = "wasm32")]
mod page_act;
mod photo_choice;
#[cfg(not(target_arch = "wasm32"))]
pub mod samples;
mod setting;
mod time_act;
mod traits;
mod view_act;

pub use self::app_act::AppAct;
pub use self::card::Card;
pub use self::cook_act::CookAct;
#[cfg(not(target_arch = "wasm32"))]
pub use self::desktop_act::HostAct;
pub use self::guided_act::GuidedAct;
pub use self::learn_act::LearnAct;
pub use self::one_act::{Act, Acts};
#[cfg(target_arch = "wasm32")]
pub use self::page_act::HostAct;
pub use self::photo_choice::{PhotoChoice, SIZES};
pub use self::setting::Setting;
pub use self::time_act::TimeAct;
pub use self::traits::{Subject, Traits};
pub use self::view_act::ViewAct;
