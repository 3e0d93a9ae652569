//! A pan led from afar: how long a silent sender still holds it, and how the pan follows or comes home.

/// Silence after which a sender counts as lost [s] (chosen: thirty messages at 60 Hz; a radio's hiccup is shorter).
pub const SILENCE_S: f64 = 0.5;
/// Time constant with which the pan follows [s] (chosen: two thirds of a message at 60 Hz, so that motion is smooth).
pub const FOLLOW_S: f64 = 0.011;
/// Time constant with which a pan that nobody holds comes home [s] (chosen: gentle enough for oil to stay in it).
pub const HOME_S: f64 = 0.4;
/// Longest step that is reckoned with [s] (chosen: a tenth of the silence, so that a loop that hung for seconds neither loses a sender
/// that speaks nor throws the pan in one step).
const LONGEST_STEP_S: f64 = 0.05;

/// The step that is reckoned with for a time between two exchanges, both [s].
pub fn reckoned(dt: f64) -> f64 {
    if dt.is_finite() { dt.clamp(0.0, LONGEST_STEP_S) } else { 0.0 }
}
