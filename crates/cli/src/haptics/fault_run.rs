//! Injected faults and their outcomes.

use std::time::Instant;

use saute_haptics::control::control_loop::LoopState;
use saute_haptics::{Health, Simulator};
use serde::Serialize;

use super::fry::Fry;
use crate::output::stderr;

/// Duration of each fault [s] (chosen: long enough for an unstable loop to diverge).
const LASTS_S: f64 = 3.0;
/// Time without the cable [s] (chosen).
const UNPLUGGED_S: f64 = 1.5;
/// Time in which forces are back at full strength [s] (chosen: twice the soft start).
const SOFT_START_S: f64 = 1.0;
/// Longest time until the device is back [s] (chosen: a refused device is tried again after 1 s).
const BACK_S: f64 = 5.0;

/// One fault and its outcome.
#[derive(Debug, Serialize)]
pub struct FaultOutcome {
    /// Name of the fault.
    pub kind: &'static str,
    /// Outcome in words.
    pub outcome: String,
    /// True if the outcome is correct.
    pub passed: bool,
}

/// Injects all faults, one after the other.
pub fn run(fry: &mut Fry, simulator: &mut Simulator, force_limit_n: f64) -> Vec<FaultOutcome> {
    stderr::say("injecting faults");
    let mut bench = Bench { fry, simulator, force_limit_n };
    vec![
        bench.noisy("packet loss 1 %", "loss 0.01"),
        bench.noisy("delay 5 ms", "delay 5"),
        bench.noisy("malformed packets 5 %", "malformed 0.05"),
        bench.unplugged(),
        bench.wrong_units(),
        bench.no_contact_model(),
    ]
}

struct Bench<'a> {
    fry: &'a mut Fry,
    simulator: &'a mut Simulator,
    force_limit_n: f64,
}

fn is_running(state: &LoopState) -> bool {
    state.sample.health == Health::Running && state.sample.fresh
}

impl Bench<'_> {
    /// Waits until `enough` returns true and returns the time that it took [s]; none after `seconds`.
    fn wait(&mut self, seconds: f64, enough: impl FnMut(&LoopState) -> bool) -> Option<f64> {
        let begun = Instant::now();
        self.fry.until(seconds, enough).then(|| begun.elapsed().as_secs_f64())
    }

    /// Injects a fault that the loop must survive.
    fn noisy(&mut self, kind: &'static str, order: &str) -> FaultOutcome {
        let before = self.fry.control.state();
        self.simulator.order(order);
        let mut farthest = 0.0f64;
        let mut lost = false;
        let home = before.sample.pose.position;
        self.fry.until(LASTS_S, |s| {
            farthest = farthest.max((s.sample.pose.position - home).length());
            lost |= s.sample.health != Health::Running;
            false
        });
        self.simulator.order("clear");
        let after = self.fry.control.state();
        let (dropouts, rejected) =
            (after.dropouts - before.dropouts, after.sample.rejected.wrapping_sub(before.sample.rejected));
        let passed = !lost && farthest < 0.5 && after.max_force_n <= self.force_limit_n && after.passivity_j >= 0.0;
        let ran = if lost { "lost for a while" } else { "ran on" };
        let outcome = format!(
            "{ran}; {dropouts} dropouts, {rejected} messages rejected, largest force {:.1} N",
            after.max_force_n
        );
        FaultOutcome { kind, outcome, passed }
    }

    fn unplugged(&mut self) -> FaultOutcome {
        let kind = "unplugged and plugged in";
        let steps = self.fry.control.state().steps;
        self.simulator.order(&format!("silence {UNPLUGGED_S}"));
        let out = Instant::now();
        let lost = self.wait(UNPLUGGED_S, |s| s.sample.health == Health::Lost);
        let Some(lost) = lost else {
            return FaultOutcome { kind, outcome: "was not noticed".into(), passed: false };
        };
        self.fry.until(UNPLUGGED_S - out.elapsed().as_secs_f64(), |_| false);
        let ticks = (self.fry.control.state().steps - steps) as f64 / out.elapsed().as_secs_f64();
        let back = self.wait(BACK_S, is_running);
        let outcome = match back {
            Some(back) => format!(
                "lost after {lost:.2} s, {ticks:.0} ticks a second meanwhile, running {back:.2} s after it was plugged in"
            ),
            None => format!("lost after {lost:.2} s and did not come back"),
        };
        FaultOutcome { kind, outcome, passed: back.is_some() && ticks > 950.0 }
    }

    fn wrong_units(&mut self) -> FaultOutcome {
        self.simulator.order("units wrong");
        let refused = self.wait(BACK_S, |s| s.sample.health == Health::WrongUnits);
        self.simulator.order("units right");
        let back = self.wait(BACK_S, is_running);
        let passed = refused.is_some() && back.is_some();
        let outcome = match (refused, back) {
            (Some(_), Some(back)) => format!(
                "refused: tension in gram-force, this program uses millinewtons; running {back:.2} s after it was corrected"
            ),
            (Some(_), None) => "refused, but it did not come back".into(),
            _ => "was not noticed".into(),
        };
        FaultOutcome { kind: "wrong units", outcome, passed }
    }

    fn no_contact_model(&mut self) -> FaultOutcome {
        self.fry.until(SOFT_START_S, |_| false);
        self.fry.pause_contact_model(true);
        let faded = self.wait(2.0, |s| !s.command.enabled);
        self.fry.pause_contact_model(false);
        let back = self.wait(2.0, |s| s.command.enabled);
        let outcome = match (faded, back) {
            (Some(faded), Some(_)) => {
                format!("faded to the minimum tension within {faded:.2} s, back with the next model")
            }
            (Some(_), None) => "faded, but forces did not come back".into(),
            _ => "forces did not fade".into(),
        };
        FaultOutcome { kind: "no contact model", outcome, passed: faded.is_some_and(|f| f < 0.4) && back.is_some() }
    }
}
