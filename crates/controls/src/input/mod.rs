//! Keys, mouse and gamepad, and what they do to the kitchen.

pub mod felt;
pub mod gamepad;
pub mod grab;
pub mod pad_input;
pub mod pan_keys;
pub mod pouring;
pub mod tool_hand;
