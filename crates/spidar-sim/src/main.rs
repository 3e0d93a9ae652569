//! The simulated SPIDAR as a program.

use std::io::Write;
use std::process::ExitCode;

use clap::Parser;
use saute_spidar_sim::{Args, run};

fn main() -> ExitCode {
    match run(&Args::parse()) {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            let _ = writeln!(std::io::stderr(), "error: {error}");
            ExitCode::from(2)
        }
    }
}
