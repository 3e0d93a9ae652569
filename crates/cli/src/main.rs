//! The command `saute`: a frying pan with a steak in it, in a window or from a recipe file.

mod args;
mod bench_heat;
mod bench_paper;
mod chart;
mod class;
mod commands;
mod error;
mod exit_code;
mod fit;
mod gallery;
mod haptics;
mod input;
mod output;
mod page;
mod picture;
mod plan;
mod report;
mod simulated_people;
mod study;
mod sweep;
mod validate;
mod wording;
mod workers;

use std::process::ExitCode;
use std::time::Instant;

use clap::Parser;

use crate::args::{Args, Bench, Command, Food, Haptics};
use crate::commands::{cook, food_check, lab, list, manual, open, replay, schema};
use crate::error::CliError;
use crate::input::data_library::DataLibrary;
use crate::output::stderr;

fn main() -> ExitCode {
    let process_start = Instant::now();
    let args = match Args::try_parse() {
        Ok(args) => args,
        Err(usage) => {
            // Help and version arrive here too and go to stdout; a closed pipe there is not an error.
            let _ = usage.print();
            return if usage.use_stderr() { exit_code::failed() } else { ExitCode::SUCCESS };
        }
    };
    run(args, process_start).unwrap_or_else(|error| {
        stderr::say(format!("error: {error}"));
        exit_code::of_error(&error)
    })
}

fn run(args: Args, process_start: Instant) -> Result<ExitCode, CliError> {
    let library = || DataLibrary::open(args.data.as_deref());
    match args.command {
        None => open::run(library()?, None, args.hands),
        Some(Command::Open(open)) => open::run_named(&open, library()?, args.hands),
        Some(Command::Study(study)) => study::run(study, library()?, args.hands),
        Some(Command::Class(command)) => class::run(&command, library),
        Some(Command::Cook(args)) => cook::run(&args, &library()?),
        Some(Command::Replay(args)) => replay::run(&args, &library()?),
        Some(Command::Fit(args)) => fit::run(&args, &library()?),
        Some(Command::Lab(args)) => lab::run(&args, &library()?),
        Some(Command::Validate(args)) => validate::run(&args, &library()?),
        Some(Command::Shot(args)) => picture::shot::run(&args, &library()?),
        Some(Command::Plan(args)) => plan::run(&args, &library()?),
        Some(Command::Sweep(args)) => sweep::run(&args, &library()?),
        Some(Command::Gallery(args)) => gallery::run(&args, &library()?),
        Some(Command::Bench(Bench::Frame(args))) => picture::bench_frame::run(&args, &library()?, process_start),
        Some(Command::Bench(Bench::Heat(args))) => bench_heat::run(&args, &library()?.library),
        Some(Command::Bench(Bench::Paper(args))) => bench_paper::run(&args, &library()?.library),
        Some(Command::List(args)) => list::run(&args, &library()?),
        // The file under check may be in the --data folder, which as a whole could not be read then.
        Some(Command::Food(Food::Check(check))) => food_check::run(&check, args.data.as_deref()),
        Some(Command::Schema(args)) => schema::run(&args),
        Some(Command::Completions { shell }) => manual::completions(shell),
        Some(Command::Man { command }) => manual::page(&command),
        Some(Command::Haptics(Haptics::List(args))) => haptics::list(&args),
        Some(Command::Haptics(Haptics::Check(args))) => haptics::check(&args, &library()?.library),
    }
}
