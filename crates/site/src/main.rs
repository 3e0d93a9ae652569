//! Makes the web page of the simulator as a folder of static files, and serves such a folder on this machine.
//!
//! `scripts/web.sh` compiles `saute-web` and calls this program: it binds the module to JavaScript, lets `wasm-opt` shrink
//! it, adds the page and the guides as HTML, and writes every file a second and a third time, compressed. wasm-bindgen is a
//! library here, so that Cargo.lock fixes its two halves to one version.

mod bind;
mod build;
mod bytes_sent;
mod compress;
mod docs;
mod error;
mod page;
mod serve;
mod sound;
mod stamp;

use std::path::PathBuf;
use std::process::ExitCode;

use clap::{Parser, Subcommand};

use crate::error::SiteError;

/// Makes or serves the web page of saute. Called in the root of the repository.
#[derive(Parser)]
struct Arguments {
    #[command(subcommand)]
    command: Command,
}

#[derive(Subcommand)]
enum Command {
    /// Makes the site from the module that cargo compiled.
    Build(build::Build),
    /// Serves a folder at 127.0.0.1.
    Serve {
        /// The folder.
        folder: PathBuf,
        /// The port; 0 takes any that is free.
        #[arg(long, default_value_t = 8080)]
        port: u16,
        /// Sends every file as it is, as a host does that compresses nothing.
        #[arg(long)]
        plain: bool,
    },
}

fn run(command: Command) -> Result<(), SiteError> {
    match command {
        Command::Build(build) => build.run(),
        Command::Serve { folder, port, plain } => serve::serve(&folder, port, plain),
    }
}

fn main() -> ExitCode {
    match run(Arguments::parse().command) {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("{error}");
            ExitCode::FAILURE
        }
    }
}
