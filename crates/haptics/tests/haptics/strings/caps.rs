//! Promise: a device is judged by the capabilities that it states, and refused with the reason.

use saute_haptics::device::{HapticCommand, HapticDevice, Health};
use saute_haptics::strings::wire::Caps;
use saute_haptics::{Spidar, Wrench};

use crate::bench_device::Bench;
use crate::random::device;

/// The health after half a second with a device that states other capabilities.
fn met(change: impl FnOnce(&mut Caps)) -> Health {
    let bench = Bench::new(&device("spidar-pan-crossed"));
    bench.state_caps(change);
    let mut spidar = Spidar::new(bench.link(), device("spidar-pan-crossed"), 42);
    let wrench = Wrench { force: glam::DVec3::NEG_Z, ..Wrench::ZERO };
    let command = HapticCommand { wrench, enabled: true, ..HapticCommand::default() };
    let health = (0..500).map(|_| spidar.exchange(&command, 1e-3).health).last().unwrap();
    let armed = health == Health::Uncalibrated;
    assert_eq!(bench.tensions(), if armed { [0.3; 8] } else { [0.0; 8] }, "armed only if accepted: {health:?}");
    health
}

#[test]
fn a_watchdog_outside_the_lawful_range_is_refused() {
    for watchdog_ms in [0, 1, 4, 101, 1000, u16::MAX] {
        assert_eq!(met(|caps| caps.watchdog_ms = watchdog_ms), Health::WatchdogUnlawful, "{watchdog_ms} ms");
    }
    for watchdog_ms in [5, 20, 100] {
        assert_eq!(met(|caps| caps.watchdog_ms = watchdog_ms), Health::Uncalibrated, "{watchdog_ms} ms");
    }
}

#[test]
fn a_least_tension_above_the_geometry_s_is_refused() {
    for min_mn in [301, 5000, 11_999] {
        assert_eq!(met(|caps| caps.min_mn = min_mn), Health::LeastTensionTooHigh, "{min_mn} mN");
    }
    assert_eq!(met(|caps| caps.min_mn = 200), Health::Uncalibrated);
}

#[test]
fn a_largest_tension_below_the_geometry_s_is_refused() {
    for max_mn in [0, 300, 11_999] {
        assert_eq!(met(|caps| caps.max_mn = max_mn), Health::LargestTensionTooLow, "{max_mn} mN");
    }
    assert_eq!(met(|caps| caps.max_mn = u16::MAX), Health::Uncalibrated);
}

#[test]
fn a_largest_rate_below_the_geometry_s_is_refused() {
    for rate_hz in [0, 1, 500, 999] {
        assert_eq!(met(|caps| caps.rate_hz = rate_hz), Health::RateTooLow, "{rate_hz} Hz");
    }
    assert_eq!(met(|caps| caps.rate_hz = 4000), Health::Uncalibrated);
}

#[test]
fn strings_units_and_pitch_that_are_not_supported_are_refused() {
    assert_eq!(met(|caps| caps.strings = 4), Health::WrongUnits);
    assert_eq!(met(|caps| caps.pitch_nm = 0), Health::WrongUnits);
    assert_eq!(met(|caps| caps.units.time = 2), Health::WrongUnits);
}
