//! The control loop: force rendering, passivity, limits, and the thread that exchanges with the device.
//!
//! The kitchen's thread turns the kitchen into a contact model after each frame and hands it over by triple buffer;
//! the loop does not wait, lock or allocate. The contents hang on the pan by a virtual coupling, so that inertia is
//! rendered without measuring acceleration. The rendered wrench passes an energy limit, a passivity controller, and
//! limits of force and slew rate; weights are exempt from the passivity account. That account integrates force ×
//! displacement with the commanded and with the reported force and uses the lower value; forces fade out before it is
//! empty.

#[cfg(not(target_arch = "wasm32"))]
pub mod control_loop;
#[cfg(not(target_arch = "wasm32"))]
pub mod coupled_payload;
#[cfg(not(target_arch = "wasm32"))]
pub mod degrade;
pub mod double_pulse;
#[cfg(not(target_arch = "wasm32"))]
mod end_signals;
pub mod feel;
#[cfg(not(target_arch = "wasm32"))]
pub mod guard_planes;
#[cfg(not(target_arch = "wasm32"))]
pub mod impulse_train;
#[cfg(not(target_arch = "wasm32"))]
pub mod jitter;
#[cfg(not(target_arch = "wasm32"))]
mod loop_state;
#[cfg(not(target_arch = "wasm32"))]
pub mod loop_step;
#[cfg(not(target_arch = "wasm32"))]
mod pacer;
#[cfg(not(target_arch = "wasm32"))]
pub mod passivity;
#[cfg(not(target_arch = "wasm32"))]
pub mod renderer;
pub mod rumble;
#[cfg(not(target_arch = "wasm32"))]
pub mod safety_limits;
#[cfg(not(target_arch = "wasm32"))]
pub mod safety_watch;
#[cfg(not(target_arch = "wasm32"))]
pub mod scheduling;
pub mod vibration;
