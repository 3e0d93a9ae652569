//! What hands do to the kitchen: keys, mouse, gamepad, tools and devices.

#[cfg(not(target_arch = "wasm32"))]
mod devices;
mod grab;
mod pad_input;
mod pan_keys;
mod picking;
mod pouring;
mod probe_hand;
mod put_in;
mod scale_choice;
#[cfg(not(target_arch = "wasm32"))]
mod strings;
mod tool_hand;
