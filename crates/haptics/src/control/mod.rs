//! The control loop: force rendering, passivity, limits, and the thread that exchanges with the device.

pub mod control_loop;
pub mod coupled_payload;
pub mod degrade;
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
pub mod scheduling;
pub mod vibration;
