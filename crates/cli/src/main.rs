//! The command `saute`: a frying pan with a steak in it, in a window or from a recipe file.

mod action_list;
mod args;
mod bench_heat;
mod bench_paper;
mod cook_command;
mod error;
mod food_check;
mod gallery;
mod haptics;
mod lab;
mod list;
mod out_dir;
mod out_file;
mod picture;
mod progress;
mod recipe_source;
mod report;
mod schema;
mod section_files;
mod shelf;
mod stderr;
mod stdout;
mod surface_file;
mod text_file;
mod text_summary;
mod validate;
mod window;
mod wording;

use std::process::ExitCode;
use std::time::Instant;

use clap::Parser;

use crate::args::{Args, Bench, Command, Food, Haptics};
use crate::error::CliError;
use crate::shelf::Shelf;

/// Exit code for wrong usage, wrong input and failed runs.
const FAILED: u8 = 2;

fn main() -> ExitCode {
    let process_start = Instant::now();
    let args = match Args::try_parse() {
        Ok(args) => args,
        Err(usage) => {
            // Help and version come this way too and go to stdout; a closed pipe there is not an error.
            let _ = usage.print();
            return if usage.use_stderr() { ExitCode::from(FAILED) } else { ExitCode::SUCCESS };
        }
    };
    run(args, process_start).unwrap_or_else(|error| {
        stderr::say(format!("error: {error}"));
        ExitCode::from(FAILED)
    })
}

fn run(args: Args, process_start: Instant) -> Result<ExitCode, CliError> {
    match args.command {
        Some(Command::Schema(which)) => return schema::run(which),
        // The file under examination may lie in the --data folder, which as a whole could not be read then.
        Some(Command::Food(Food::Check(check))) => return food_check::run(&check, args.data.as_deref()),
        Some(Command::Haptics(Haptics::List(list))) => return haptics::list(&list),
        _ => {}
    }
    let shelf = Shelf::open(args.data.as_deref())?;
    match args.command {
        None => window::open(&shelf, None, args.hands),
        Some(Command::Open { recipe }) => {
            let recipe = recipe_source::load(&recipe, &shelf)?;
            window::open(&shelf, Some(recipe), args.hands)
        }
        Some(Command::Cook(args)) => cook_command::run(&args, &shelf),
        Some(Command::Shot(args)) => picture::shot(&args, &shelf),
        Some(Command::Gallery(args)) => gallery::run(&args, &shelf),
        Some(Command::Bench(Bench::Frame(args))) => picture::bench_frame(&args, &shelf, process_start),
        Some(Command::Bench(Bench::Heat(args))) => bench_heat::run(&args, &shelf),
        Some(Command::Bench(Bench::Paper(args))) => bench_paper::run(&args, &shelf),
        Some(Command::Lab(args)) => lab::lab(&args, &shelf),
        Some(Command::Validate(args)) => validate::validate(&args, &shelf),
        Some(Command::List(args)) => list::run(&args, &shelf),
        Some(Command::Schema(which)) => schema::run(which),
        Some(Command::Food(Food::Check(check))) => food_check::run(&check, args.data.as_deref()),
        Some(Command::Haptics(Haptics::List(list))) => haptics::list(&list),
        Some(Command::Haptics(Haptics::Check(check))) => haptics::check(&check, &shelf),
    }
}
