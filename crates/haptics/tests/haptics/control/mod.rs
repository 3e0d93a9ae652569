//! What the control loop promises: force rendering, passivity and degraded rendering.

mod control_loop;
mod degrade;
mod feel;
mod passivity;
