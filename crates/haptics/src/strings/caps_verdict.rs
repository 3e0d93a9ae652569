//! Judges the capabilities that a device states: only a device that keeps a hand safe is armed.

use std::ops::RangeInclusive;

use crate::device::Health;
use crate::strings::STRINGS;
use crate::strings::geometry::Geometry;
use crate::strings::wire::{Caps, Units};

/// Lawful watchdog times [ms] (chosen: five commands may be late on a network; a host that hangs must not hold a force for longer
/// than a tenth of a second).
pub const LAWFUL_WATCHDOG_MS: RangeInclusive<u16> = 5..=100;
/// Rounding of tensions that are stated in whole millinewtons [mN].
const ROUNDING_MN: f64 = 0.5;

/// Returns why a device with these capabilities must not be armed.
pub fn judge(caps: &Caps, geometry: &Geometry) -> Result<(), Health> {
    let (least_mn, largest_mn) = (geometry.drive.min_tension_n * 1e3, geometry.drive.max_tension_n * 1e3);
    if caps.units != Units::SPOKEN || usize::from(caps.strings) != STRINGS || caps.pitch_nm == 0 {
        return Err(Health::WrongUnits);
    }
    if !LAWFUL_WATCHDOG_MS.contains(&caps.watchdog_ms) {
        return Err(Health::WatchdogUnlawful);
    }
    if f64::from(caps.min_mn) > least_mn + ROUNDING_MN {
        return Err(Health::LeastTensionTooHigh);
    }
    if f64::from(caps.max_mn) < largest_mn - ROUNDING_MN {
        return Err(Health::LargestTensionTooLow);
    }
    // The geometry's stiffness and slew rate are stable at its own rate only.
    if f64::from(caps.rate_hz) < geometry.drive.rate_hz.trunc() {
        return Err(Health::RateTooLow);
    }
    Ok(())
}
