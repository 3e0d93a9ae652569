//! A simulated SPIDAR on UDP: eight motors and strings, a real pan on them, and a hand.
//!
//! It shares no code with its driver, only the protocol in docs/spidar-protocol.md.

mod arm;
mod codec;
mod faults;
mod pan_body;
mod random;
mod rig;
mod rig_file;
mod scene;
mod server;
mod string_drive;
mod truth_log;

use std::io::Write;
use std::path::PathBuf;
use std::process::ExitCode;

use clap::Parser;

/// A simulated eight-string haptic device. Prints its address and pairing code, then serves until it is stopped.
///
/// Reads commands on stdin: "loss SHARE", "delay MS", "malformed SHARE", "silence S" (unplugged for that time), "units wrong",
/// "units right", "power-cycle" (encoders lose their count), "clear", "quit".
#[derive(Debug, Parser)]
#[command(name = "saute-spidar-sim", version)]
struct Args {
    /// Name of a device, or a geometry file (.toml).
    #[arg(long, value_name = "NAME|FILE", default_value = "spidar-pan-crossed")]
    device: String,
    /// Address to serve on. Only this machine can reach the default; other addresses are reachable from the network.
    #[arg(long, value_name = "ADDRESS", default_value = "127.0.0.1:0")]
    bind: std::net::SocketAddr,
    /// Pairing code that a host must send; random unless given. 0 disables pairing.
    #[arg(long, value_name = "CODE")]
    pairing: Option<u32>,
    /// Seed of manufacturing errors, encoder zeros and the hand's motion.
    #[arg(long, default_value_t = 1)]
    seed: u64,
    /// Largest manufacturing error of each coordinate of motors and attachments [mm].
    #[arg(long, default_value_t = 0.5)]
    error_mm: f64,
    /// Amplitude of the hand's motion: 0 holds still, 1 shakes and tilts.
    #[arg(long, default_value_t = 1.0)]
    hand: f64,
    /// Writes the true state at every sample to this file (CSV).
    #[arg(long, value_name = "FILE")]
    truth: Option<PathBuf>,
    /// Ends when stdin ends, and so with the program that started it.
    #[arg(long)]
    end_with_stdin: bool,
    /// Prints no state on stderr.
    #[arg(long)]
    quiet: bool,
}

fn main() -> ExitCode {
    match run(&Args::parse()) {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            let _ = writeln!(std::io::stderr(), "error: {error}");
            ExitCode::from(2)
        }
    }
}

fn run(args: &Args) -> Result<(), server::ServeError> {
    let file = rig_file::load(&args.device)?;
    let scene = scene::Scene::new(&file, args.seed, args.error_mm * 1e-3, args.hand);
    let pairing = args.pairing.unwrap_or_else(random::code_from_clock);
    server::serve(args, scene, &file, pairing)
}
