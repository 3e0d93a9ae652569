//! Keys, mouse and gamepad, and what they do to the kitchen.

pub(crate) mod felt;
pub mod gamepad;
pub(crate) mod grab;
pub(crate) mod pad_input;
pub(crate) mod pan_keys;
pub(crate) mod picking;
pub mod pouring;
pub(crate) mod tool_hand;
