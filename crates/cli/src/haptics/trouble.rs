//! What a device does that does not work, and the remedy.

use saute_haptics::Health;

use crate::error::CliError;

/// Returns what a device does in a state in which it does not work, and the remedy.
pub fn trouble(health: Health) -> (&'static str, &'static str) {
    match health {
        Health::WrongCode => ("refuses the pairing code", "give the code that the device shows: --pairing CODE"),
        Health::Busy => ("is driven by another program", "end that program, and wait a second"),
        Health::WrongUnits => (
            "uses units or strings that this program does not support",
            "see docs/spidar-protocol.md: the units are nanometres, millinewtons and microseconds",
        ),
        Health::DeviceOutdated => {
            ("speaks an older version of the protocol", "update its firmware to version 2 of docs/spidar-protocol.md")
        }
        Health::ProgramOutdated => ("speaks a newer version of the protocol", "update saute"),
        Health::WatchdogUnlawful => {
            ("states a watchdog time that is not within 5 to 100 ms", "correct the watchdog in its firmware")
        }
        Health::LeastTensionTooHigh => (
            "states a least tension above that of its geometry file",
            "correct its firmware, or min_tension_n in the geometry file",
        ),
        Health::LargestTensionTooLow => (
            "states a largest tension below that of its geometry file",
            "correct its firmware, or max_tension_n in the geometry file",
        ),
        Health::RateTooLow => (
            "states a largest rate of commands below that of its geometry file",
            "correct its firmware, or rate_hz in the geometry file",
        ),
        Health::ImpossibleLengths => (
            "was stopped for safety: the lengths of its strings contradict each other",
            "check strings and encoders, and put the pan on its jig again",
        ),
        Health::ForceAboveLimit => {
            ("was stopped for safety: it reported a force above its limit", "check motors and current measurement")
        }
        Health::EnergyOverdrawn => (
            "was stopped for safety: it gave the hand too much energy",
            "check the delay of the link, and the encoders",
        ),
        Health::Fault => ("reports a fault", "look at the device"),
        Health::Uncalibrated => ("is not calibrated", "calibrate it as its manual says"),
        Health::Lost => ("went silent", "check its supply, its cable and its network"),
        Health::Stopped => ("was stopped by hand", "start the check again"),
        _ => ("does not answer", "switch it on, and check its address, network and pairing code"),
    }
}

/// Returns the error of a device that has not been found.
pub fn not_there(health: Health) -> CliError {
    // A device that reports a fault has been found.
    if health == Health::Fault {
        return broke_off(health);
    }
    let health = if health == Health::Lost { Health::Connecting } else { health };
    let (message, remedy) = trouble(health);
    CliError::place("the device", message, remedy)
}

/// Returns the error of a device that was found and then did not work.
pub fn broke_off(health: Health) -> CliError {
    let (message, remedy) = trouble(health);
    CliError::Trouble { message, remedy }
}
