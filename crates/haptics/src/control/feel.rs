//! Haptic parameters of the kitchen, as `data/haptics/feel.toml` states them.

use saute_kitchen::food::sourced_table;
use saute_schema::InputError;
use serde::Deserialize;

use crate::library::{error_at, parse_table};

sourced_table! {
    /// Virtual coupling of the contents to the pan.
    PayloadFeel {
        /// Natural frequency [Hz].
        frequency_hz: f64,
        /// Damping over critical [-].
        damping: f64,
    }
}

sourced_table! {
    /// Collisions.
    ImpulseFeel {
        /// Duration of a pulse [s].
        duration_s: f64,
        /// Weaker impulses are not rendered [N·s].
        least_n_s: f64,
    }
}

sourced_table! {
    /// Boiling.
    SizzleFeel {
        /// Amplitude at the reference flow [N].
        force_n: f64,
        /// Reference vapour flow [g/s].
        at_vapour_g_s: f64,
        /// Lower edge of the noise band [Hz].
        low_hz: f64,
        /// Upper edge of the noise band [Hz].
        high_hz: f64,
    }
}

sourced_table! {
    /// Sliding food and the scraping turner.
    SlideFeel {
        /// Amplitude per normal force [-].
        force_n: f64,
        /// Pitch of the texture [mm].
        pitch_mm: f64,
        /// Largest amplitude [N].
        largest_n: f64,
        /// Slowest perceptible speed [m/s].
        least_m_s: f64,
    }
}

sourced_table! {
    /// Guard planes.
    GuardFeel {
        /// Damping [N·s/m].
        damping_n_s_m: f64,
    }
}

sourced_table! {
    /// The control loop.
    LoopFeel {
        /// Time in which forces rise from zero to full [s].
        soft_start_s: f64,
        /// Watchdog: age at which a contact model counts as lost [s].
        model_timeout_s: f64,
        /// Time in which forces fade to zero [s].
        fade_s: f64,
        /// Initial energy of the passivity observer [mJ].
        reserve_mj: f64,
    }
}

/// All haptic parameters.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Feel {
    /// Virtual coupling of the contents.
    pub payload: PayloadFeel,
    /// Collisions.
    pub impulse: ImpulseFeel,
    /// Boiling.
    pub sizzle: SizzleFeel,
    /// Sliding and scraping.
    pub slide: SlideFeel,
    /// Guard planes.
    pub guard: GuardFeel,
    /// The control loop.
    #[serde(rename = "loop")]
    pub timing: LoopFeel,
}

impl Feel {
    /// Parses and checks the file.
    pub fn parse(text: &str, file: &str) -> Result<Self, InputError> {
        let feel: Self = parse_table(text, file, "see data/haptics/feel.toml for the keys")?;
        let ranged = [
            ("frequency_hz", feel.payload.frequency_hz, 0.5, 40.0),
            ("damping", feel.payload.damping, 0.05, 2.0),
            ("duration_s", feel.impulse.duration_s, 0.002, 0.1),
            ("least_n_s", feel.impulse.least_n_s, 0.0, 1.0),
            ("at_vapour_g_s", feel.sizzle.at_vapour_g_s, 1e-3, 100.0),
            ("low_hz", feel.sizzle.low_hz, 1.0, 400.0),
            ("high_hz", feel.sizzle.high_hz, 1.0, 400.0),
            ("pitch_mm", feel.slide.pitch_mm, 0.01, 100.0),
            ("soft_start_s", feel.timing.soft_start_s, 0.0, 10.0),
            ("model_timeout_s", feel.timing.model_timeout_s, 0.005, 1.0),
            ("fade_s", feel.timing.fade_s, 0.01, 10.0),
            ("reserve_mj", feel.timing.reserve_mj, 0.0, 1000.0),
        ];
        for (key, value, low, high) in ranged {
            if !(low..=high).contains(&value) {
                let message = format!("{key} = {value} is out of range");
                return Err(error_at(text, file, key, message, &format!("give {low} to {high}")));
            }
        }
        Ok(feel)
    }
}
