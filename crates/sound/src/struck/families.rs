//! Bodies other than the pan that ring by a family of ratios: bell, tool, board and flesh.

use crate::struck::modes::Mode;

/// A family of modes: frequencies over the lowest [-].
#[derive(Clone, Copy, Debug)]
pub(crate) struct Family {
    lowest_hz: f32,
    ratios: &'static [f32],
    quality: f32,
    /// Exponent with which the weight falls with frequency [-].
    fall: f32,
}

/// A free bar: ratios of Euler and Bernoulli.
const BAR: &[f32] = &[1.0, 2.757, 5.404, 8.933, 13.34];

/// The bell of a kitchen timer: a small hemisphere (chosen: 2.1 kHz, partials as of a small tuned bell, two seconds to −60 dB).
pub(crate) const BELL: Family =
    Family { lowest_hz: 2100.0, ratios: &[1.0, 2.0, 2.4, 3.0, 4.2, 5.4], quality: 1900.0, fall: 0.8 };
/// A turner's blade of steel, 110 mm long and 1.2 mm thick: f₁ = 1.028·h/L²·√(E/ρ) = 530 Hz (Euler–Bernoulli); a hand holds it
/// (chosen: Q 60).
pub(crate) const TOOL: Family = Family { lowest_hz: 530.0, ratios: BAR, quality: 60.0, fall: 0.0 };
/// A board of beech, 350 mm long and 20 mm thick: f₁ = 690 Hz (E 11 GPa, ρ 650 kg/m³); it lies on a table (chosen: Q 18).
pub(crate) const BOARD: Family = Family { lowest_hz: 690.0, ratios: BAR, quality: 18.0, fall: 0.5 };
/// Wet flesh that falls flat: a thud and the slap of the air that it drives out, all but aperiodic (chosen).
pub(crate) const FLESH: Family =
    Family { lowest_hz: 90.0, ratios: &[1.0, 1.9, 3.4, 6.0, 11.0, 20.0], quality: 2.5, fall: 0.4 };

impl Family {
    /// The modes.
    pub(crate) fn modes(self) -> impl Iterator<Item = Mode> + Clone {
        self.ratios.iter().map(move |ratio| Mode {
            hz: self.lowest_hz * ratio,
            quality: self.quality,
            weight: libm::powf(*ratio, -self.fall),
        })
    }
}
