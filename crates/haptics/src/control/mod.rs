//! The control loop: force rendering, passivity, limits, and the thread that exchanges with the device.
//!
//! The kitchen's thread turns the kitchen into a contact model after each frame and hands it over by triple buffer;
//! the loop does not wait, lock or allocate. The contents hang on the pan by a virtual coupling, so that inertia is
//! rendered without measuring acceleration. The rendered wrench passes an energy limit, a passivity controller, and
//! limits of force and slew rate; weights are exempt from the passivity account. That account integrates force ×
//! displacement with the commanded and with the reported force and uses the lower value; forces fade out before it is
//! empty.

pub mod control_loop;
pub mod coupled_payload;
pub mod degrade;
mod end_signals;
pub mod feel;
pub mod guard_planes;
pub mod impulse_train;
pub mod jitter;
mod loop_state;
pub mod loop_step;
mod pacer;
pub mod passivity;
pub mod renderer;
pub mod rumble;
pub mod safety_limits;
pub mod safety_watch;
pub mod scheduling;
pub mod vibration;
