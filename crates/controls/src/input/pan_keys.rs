//! Keys that are held, and the gamepad's left hand: they move and tilt the pan and shake it.

use glam::DVec2;

/// Held keys, as the help lists them, with the keys of the words for them.
pub const HELD: [(&str, &str); 5] = [
    ("Shift+WASD", "held.move_pan"),
    ("Shift+E/Q", "held.lift_pan"),
    ("Shift+R/F", "held.tilt_away"),
    ("Shift+Z/C", "held.tilt_side"),
    ("K", "held.shake"),
];

/// What the keys do to the pan between frames.
#[derive(Clone, Copy, Debug, Default)]
pub struct PanKeys {
    /// Slope of the floor, about its two axes [rad].
    pub tilt: DVec2,
    /// True while the pan is shaken.
    pub shaking: bool,
}
