//! `saute-soak [--minutes N] [--record] [--log FILE]`: cooks a dish for N simulated minutes, a day by default, disturbs it
//! every ten, and ends with exit code 1 if memory grows, or energy or mass do not balance. See scripts/soak.sh.

mod dish;
mod figures;
mod log;
mod memory;

use std::error::Error;
use std::path::PathBuf;
use std::process::ExitCode;
use std::time::Instant;

use saute_kitchen::Library;
use saute_recipe::{Cook, Recipe};

use figures::Figures;
use log::Log;

/// Largest growth of memory after the first hour, without a recorder [bytes].
const GROWTH: u64 = 1 << 20;
/// Largest memory of a recorder [bytes].
const RECORDED: u64 = 64 << 20;
/// Ticks of an hour [-].
const HOUR: u64 = 36_000;

/// Arguments of the command line.
struct Args {
    minutes: usize,
    records: bool,
    log: Option<PathBuf>,
}

impl Args {
    fn read() -> Result<Self, String> {
        let mut read = Self { minutes: 24 * 60, records: false, log: None };
        let mut rest = std::env::args().skip(1);
        while let Some(word) = rest.next() {
            let mut value = || rest.next().ok_or(format!("{word} needs a value"));
            match word.as_str() {
                "--minutes" => read.minutes = value()?.parse().map_err(|e| format!("--minutes: {e}"))?,
                "--log" => read.log = Some(value()?.into()),
                "--record" => read.records = true,
                _ => return Err(format!("there is no {word}; there are --minutes N, --record, --log FILE")),
            }
        }
        Ok(read)
    }
}

fn main() -> ExitCode {
    match Args::read().map_err(Into::into).and_then(|args| soak(&args)) {
        Ok(true) => ExitCode::SUCCESS,
        Ok(false) => ExitCode::FAILURE,
        Err(error) => {
            eprintln!("{error}");
            ExitCode::from(2)
        }
    }
}

/// Cooks, prints a line for every hour and the end, and returns true if all held.
fn soak(args: &Args) -> Result<bool, Box<dyn Error>> {
    let library = Library::embedded()?;
    let mut cook = Cook::new(Recipe::parse(&dish::recipe(args.minutes), "soak", &library)?, &library)?;
    println!("{} pieces, {} simulated minutes", cook.kitchen.pieces().len(), args.minutes);
    let mut log = Log::open(args.log.as_deref())?;
    if log.hours() > 0 {
        println!("{} hours of an earlier run are repeated and compared", log.hours());
    }
    let mut watch = Watch { begun: Instant::now(), first: None, held: true };
    while cook.stopped().is_none() {
        advance(&mut cook, args.records)?;
        let is_hour = cook.kitchen.tick().is_multiple_of(HOUR);
        if is_hour || cook.stopped().is_some() {
            let hour = is_hour.then(|| (cook.kitchen.tick() / HOUR) as usize);
            watch.hour(&cook, hour, args, &mut log)?;
        }
    }
    Ok(watch.held)
}

/// Advances by one tick, with or without the series of the recorder.
fn advance(cook: &mut Cook, records: bool) -> Result<(), Box<dyn Error>> {
    if records {
        cook.advance()?;
    } else {
        cook.runner.poll(&mut cook.kitchen)?;
        if cook.stopped().is_none() {
            cook.kitchen.step();
        }
    }
    Ok(())
}

/// What is compared from hour to hour.
struct Watch {
    begun: Instant,
    /// Memory at the end of the first hour [bytes].
    first: Option<u64>,
    held: bool,
}

impl Watch {
    /// Prints the figures of now, and judges them.
    fn hour(&mut self, cook: &Cook, hour: Option<usize>, args: &Args, log: &mut Log) -> Result<(), Box<dyn Error>> {
        let figures = Figures::of(&cook.kitchen);
        let now = memory::resident().unwrap_or(0);
        let first = if hour.is_some() { *self.first.get_or_insert(now) } else { self.first.unwrap_or(now) };
        let growth = now.saturating_sub(first);
        let most = if args.records { RECORDED } else { GROWTH };
        let words = format!(
            "{:6.2} h  {:6.0} s of wall time  {:6.2} MB  {:+5} kB since the first hour  energy {:.1e}  mass {:.1e}",
            cook.kitchen.time_s() / 3600.0,
            self.begun.elapsed().as_secs_f64(),
            now as f64 / 1e6,
            (now as i64 - first as i64) / 1000,
            figures.energy,
            figures.mass,
        );
        println!("{words}");
        self.require(growth <= most, "memory has grown too much");
        self.require(figures.balance(), "energy or mass do not balance");
        if let Some(hour) = hour {
            let same = log.note(hour, figures.fingerprint, &words)?;
            self.require(same, "this hour came out otherwise in an earlier run");
        }
        Ok(())
    }

    fn require(&mut self, holds: bool, otherwise: &str) {
        if !holds {
            println!("  FAILED: {otherwise}");
            self.held = false;
        }
    }
}
