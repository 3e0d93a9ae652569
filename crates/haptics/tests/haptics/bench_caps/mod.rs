//! Capabilities of a device that the driver accepts, for every test program.

use saute_haptics::strings::wire::{Caps, Units};

/// A device like the shipped ones.
pub const CAPS: Caps = Caps {
    strings: 8,
    units: Units::SPOKEN,
    pitch_nm: 20_000,
    min_mn: 300,
    max_mn: 12_000,
    rate_hz: 1000,
    watchdog_ms: 100,
    boot: 1,
    name: *b"bench\0\0\0\0\0\0\0\0\0\0\0",
};
