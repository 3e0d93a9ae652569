//! The table of a run: each step's time, its work next to its budget, and what was counted.

use std::collections::BTreeMap;
use std::fmt::Write;
use std::path::PathBuf;
use std::process::ExitCode;

use crate::durations::Budget;
use crate::error::{TaskError, at};
use crate::measured::{self, StepTime};

/// `durations`.
#[derive(clap::Args)]
pub struct Report {
    /// Folder with the times of the steps.
    #[arg(long)]
    steps: PathBuf,
    /// The file of budgets.
    #[arg(long)]
    budget: PathBuf,
    /// The program whose brick measures the machine.
    #[arg(long)]
    saute: PathBuf,
    /// Time of the whole run on the clock [s].
    #[arg(long)]
    wall_s: f64,
    /// Writes the work of this run as the new budgets; ceilings come down to what was counted.
    #[arg(long)]
    bless: bool,
}

impl Report {
    /// Prints the table, and fails where more was counted than is allowed.
    pub fn run(&self) -> Result<ExitCode, TaskError> {
        let steps = measured::steps(&self.steps)?;
        let counted = measured::counted(&self.steps)?;
        let loop_s = measured::loop_s(&self.saute)?;
        let budget = Budget::read(&self.budget)?;
        print!("{}", table(&steps, loop_s, self.wall_s, &budget));
        if self.bless {
            return self.bless(budget, &steps, &counted, loop_s);
        }
        println!("{}", counts(&counted, &budget));
        match budget.above(&counted) {
            above if above.is_empty() => Ok(ExitCode::SUCCESS),
            above => {
                Err(TaskError::Failed(format!("above the ceilings of {}: {}", self.budget.display(), above.join("; "))))
            }
        }
    }

    fn bless(
        &self,
        mut budget: Budget,
        steps: &BTreeMap<String, StepTime>,
        counted: &BTreeMap<String, u64>,
        loop_s: f64,
    ) -> Result<ExitCode, TaskError> {
        budget.loops.extend(steps.iter().map(|(name, time)| (name.clone(), (time.cpu_s / loop_s).ceil())));
        for (name, most) in &mut budget.ceilings {
            *most = counted.get(name).map_or(*most, |count| (*count).min(*most));
        }
        let old = std::fs::read_to_string(&self.budget).map_err(at(&self.budget))?;
        std::fs::write(&self.budget, budget.blessed(&old)).map_err(at(&self.budget))?;
        println!("wrote {}", self.budget.display());
        Ok(ExitCode::SUCCESS)
    }
}

/// One line a step, the sum, and the steps that are beyond their budgets.
fn table(steps: &BTreeMap<String, StepTime>, loop_s: f64, wall_s: f64, budget: &Budget) -> String {
    let mut text = format!("\n   {:<16}{:>9}{:>11}{:>9}{:>9}\n", "step", "clock", "processor", "loops", "budget");
    let mut beyond = Vec::new();
    for (name, time) in steps {
        let loops = time.cpu_s / loop_s;
        let allowed = budget.loops.get(name).map_or("none".to_owned(), |loops| format!("{loops:.0}"));
        let _ =
            writeln!(text, "   {name:<16}{:>9}{:>11}{loops:>9.0}{allowed:>9}", clock(time.wall_s), clock(time.cpu_s));
        if budget.exceeds(name, loops) {
            beyond.push(format!("{name} took {loops:.0} loops of {allowed}"));
        }
    }
    let cpu_s: f64 = steps.values().map(|time| time.cpu_s).sum();
    let allowed: f64 = budget.loops.values().sum();
    let _ = writeln!(
        text,
        "   {:<16}{:>9}{:>11}{:>9.0}{allowed:>9.0}",
        "together",
        clock(wall_s),
        clock(cpu_s),
        cpu_s / loop_s
    );
    let _ = writeln!(text, "   a loop of the brick took {:.1} ms here", 1000.0 * loop_s);
    for line in beyond {
        let _ = writeln!(text, "   beyond its budget by more than a quarter: {line}");
    }
    text
}

/// Counts next to their ceilings.
fn counts(counted: &BTreeMap<String, u64>, budget: &Budget) -> String {
    let one = |(name, count): (&String, &u64)| match budget.ceilings.get(name) {
        Some(most) => format!("{name} {count} of {most}"),
        None => format!("{name} {count}"),
    };
    let all: Vec<_> = counted.iter().map(one).collect();
    format!("   counted: {}", all.join(", "))
}

/// Minutes and seconds.
fn clock(seconds: f64) -> String {
    let whole = seconds.round() as u64;
    format!("{}:{:02}", whole / 60, whole % 60)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_step_beyond_its_budget_is_named_at_the_end_with_both_figures() {
        let steps = [("lints", 7.0), ("tests", 20.0)];
        let steps = steps.map(|(name, cpu_s)| (name.to_owned(), StepTime { wall_s: 65.0, cpu_s })).into();
        let loops = [("lints".to_owned(), 500.0), ("tests".to_owned(), 1000.0)].into();
        let text = table(&steps, 0.014, 65.0, &Budget { loops, ..Budget::default() });
        assert!(text.contains("   lints                1:05       0:07      500      500\n"), "{text}");
        assert!(text.ends_with("beyond its budget by more than a quarter: tests took 1429 loops of 1000\n"), "{text}");
        assert!(text.contains("a loop of the brick took 14.0 ms here"), "{text}");
    }

    #[test]
    fn counts_stand_beside_their_ceilings() {
        let counted = [("pages_opened".to_owned(), 44), ("windows_opened".to_owned(), 9)].into();
        let ceilings = [("pages_opened".to_owned(), 50)].into();
        let text = counts(&counted, &Budget { ceilings, ..Budget::default() });
        assert_eq!(text, "   counted: pages_opened 44 of 50, windows_opened 9");
    }
}
