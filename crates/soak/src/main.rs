//! `saute-soak [--minutes N] [--record] [--log FILE]`: cooks a dish for N simulated minutes, a day by default, disturbs it
//! every ten, and ends with exit code 1 if memory grows, or energy or mass do not balance. See scripts/soak.sh.

mod dish;
mod figures;
mod kept_kitchen;
mod log;
mod memory;

use std::error::Error;
use std::path::PathBuf;
use std::process::ExitCode;
use std::sync::Arc;
use std::time::Instant;

use saute_kitchen::{Kitchen, Library};
use saute_recipe::{Cook, Recipe, Runner, Trigger};

use figures::Figures;
use kept_kitchen::KeptKitchen;
use log::Log;

/// Largest growth of memory after the first hour, without a recorder [bytes].
const GROWTH: u64 = 1_000_000;
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
    let kept = args.log.as_deref().map(KeptKitchen::of);
    let mut cook = begin(args, &library, kept.as_ref())?;
    println!("{} pieces, {} simulated minutes", cook.kitchen.pieces().len(), args.minutes);
    let mut log = Log::open(args.log.as_deref())?;
    let mut watch = Watch { begun: Instant::now(), first: None, held: true };
    while cook.stopped().is_none() {
        advance(&mut cook, args.records)?;
        let is_hour = cook.kitchen.tick().is_multiple_of(HOUR);
        if let Some(kept) = kept.as_ref().filter(|_| is_hour && !args.records) {
            kept.keep(&cook.kitchen)?;
        }
        if is_hour || cook.stopped().is_some() {
            let words = watch.hour(&cook, is_hour, args);
            log.note(&words)?;
        }
    }
    kept.map_or(Ok(()), |kept| kept.clear())?;
    Ok(watch.held)
}

/// Returns the cook at its beginning, or after the last hour that an earlier run finished. A series is not kept.
fn begin(args: &Args, library: &Library, kept: Option<&KeptKitchen>) -> Result<Cook, Box<dyn Error>> {
    let mut cook = Cook::new(Recipe::parse(&dish::recipe(args.minutes), "soak", library)?, library)?;
    if let Some(kitchen) = kept.filter(|_| !args.records).map_or(Ok(None), |kept| kept.load(library))? {
        println!("goes on after {:.0} h", kitchen.time_s() / 3600.0);
        go_on(&mut cook, kitchen);
    }
    Ok(cook)
}

/// Goes on with a kitchen from its instant: the steps until then are done.
fn go_on(cook: &mut Cook, kitchen: Kitchen) {
    let mut rest = Recipe::clone(cook.runner.recipe());
    rest.steps.retain(|step| matches!(step.trigger, Trigger::At(at_s) if at_s > kitchen.time_s()));
    cook.runner = Runner::new(Arc::new(rest));
    cook.kitchen = kitchen;
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
    /// Prints the figures of now, judges them and returns them as a line.
    fn hour(&mut self, cook: &Cook, is_hour: bool, args: &Args) -> String {
        let figures = Figures::of(&cook.kitchen);
        let now = memory::resident().unwrap_or(0);
        let first = if is_hour { *self.first.get_or_insert(now) } else { self.first.unwrap_or(now) };
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
        words
    }

    fn require(&mut self, holds: bool, otherwise: &str) {
        if !holds {
            println!("  FAILED: {otherwise}");
            self.held = false;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Cut off at four minutes, the dish goes on bit by bit, through the toss at five.
    #[test]
    fn a_day_that_was_cut_off_goes_on() -> Result<(), Box<dyn Error>> {
        let library = Library::embedded()?;
        let args = Args { minutes: 6, records: false, log: None };
        let mut whole = begin(&args, &library, None)?;
        let advance_to = |cook: &mut Cook, minute: f64| -> Result<(), Box<dyn Error>> {
            while cook.kitchen.time_s() < 60.0 * minute && cook.stopped().is_none() {
                advance(cook, false)?;
            }
            Ok(())
        };
        advance_to(&mut whole, 4.0)?;
        let kept = Kitchen::from_bytes(&whole.kitchen.to_bytes(), &library)?;
        let mut rest = begin(&args, &library, None)?;
        go_on(&mut rest, kept);
        for cook in [&mut whole, &mut rest] {
            advance_to(cook, 7.0)?;
        }
        assert_eq!(rest.kitchen.state_hash(), whole.kitchen.state_hash());
        assert!(rest.kitchen.time_s() > 359.0);
        Ok(())
    }
}
