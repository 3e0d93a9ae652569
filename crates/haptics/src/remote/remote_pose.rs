//! Constants of a pan that a remote sender moves: timeout, smoothing, and the return home.

/// Timeout after which a silent sender counts as lost [s] (chosen: thirty messages at 60 Hz; radio dropouts are shorter).
pub const SILENCE_S: f64 = 0.5;
/// Time constant of following a sender [s] (chosen: two thirds of a message interval at 60 Hz, which smooths the motion).
pub const FOLLOW_S: f64 = 0.011;
/// Time constant of the return home without a sender [s] (chosen: gentle enough to keep oil in the pan).
pub const HOME_S: f64 = 0.4;
/// Longest step [s] (chosen: a tenth of the timeout, so that a loop that hung for seconds neither loses an active sender nor throws the
/// pan in one step).
const LONGEST_STEP_S: f64 = 0.05;

/// Returns the time between two exchanges, limited to the longest step [s].
pub fn limited_step(dt: f64) -> f64 {
    if dt.is_finite() { dt.clamp(0.0, LONGEST_STEP_S) } else { 0.0 }
}
