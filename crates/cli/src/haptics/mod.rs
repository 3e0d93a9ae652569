//! `saute haptics`: lists and checks haptic devices.

mod check;
mod fault_run;
mod fry;
mod list;
mod network_check;
mod observation;
mod report;
mod stop_key;
mod trouble;
mod truth;

pub use check::{CheckArgs, check};
pub use list::{DevicesArgs, list};
