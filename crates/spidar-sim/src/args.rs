//! The command line.

use std::path::PathBuf;

use clap::Parser;

/// A simulated eight-string haptic device. Prints its address and pairing code, then serves until it is stopped.
///
/// Reads commands on stdin: "loss SHARE", "delay MS", "malformed SHARE", "silence S" (unplugged for that time), "units wrong",
/// "units right", "power-cycle" (encoders lose their count), "fault CODE" (1 to 4), "repair", "encoders stuck" (they
/// repeat their count), "encoders free", "buttons BITS", "clear", "quit".
#[derive(Debug, Parser)]
#[command(name = "saute-spidar-sim", version)]
pub struct Args {
    /// Name of a device, or a geometry file (.toml).
    #[arg(long, value_name = "NAME|FILE", default_value = "spidar-pan-crossed")]
    pub device: String,
    /// Address to serve on. Only this machine can reach the default; other addresses are reachable from the network.
    #[arg(long, value_name = "ADDRESS", default_value = "127.0.0.1:0")]
    pub bind: std::net::SocketAddr,
    /// Pairing code that a host must send; random unless given. 0 disables pairing.
    #[arg(long, value_name = "CODE")]
    pub pairing: Option<u32>,
    /// Seed of manufacturing errors, encoder zeros and the hand's motion.
    #[arg(long, default_value_t = 1)]
    pub seed: u64,
    /// Largest manufacturing error of each coordinate of motors and attachments [mm].
    #[arg(long, default_value_t = 0.5)]
    pub error_mm: f64,
    /// Multiple of the usual noise: friction, errors of string stiffness and jig, and jitter of the encoders above 1.
    #[arg(long, default_value_t = 1.0)]
    pub noise: f64,
    /// Amplitude of the hand's motion: 0 is still, 1 shakes and tilts.
    #[arg(long, default_value_t = 1.0)]
    pub hand: f64,
    /// Writes the true state at every sample to this file (CSV).
    #[arg(long, value_name = "FILE")]
    pub truth: Option<PathBuf>,
    /// Ends when stdin ends, and so with the program that started it.
    #[arg(long)]
    pub end_with_stdin: bool,
    /// Prints no state on stderr.
    #[arg(long)]
    pub quiet: bool,
}
