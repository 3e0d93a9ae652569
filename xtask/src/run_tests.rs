//! Runs the test programs of the workspace.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::process::{Command, ExitCode};

use crate::error::{TaskError, at};
use crate::pool::{self, Ended, Job};
use crate::programs::{self, TestProgram};

/// `tests`.
#[derive(clap::Args)]
pub struct Tests {
    /// Programs at a time; as many as there are cores unless given.
    #[arg(long)]
    at_once: Option<usize>,
    /// Folder for outputs and for the times by which the longest is begun first.
    #[arg(long)]
    kept: PathBuf,
    /// Leaves out the programs whose names contain this text.
    #[arg(long)]
    without: Option<String>,
    /// Runs only the programs whose names contain one of these texts, as in `saute-heat exact`.
    names: Vec<String>,
}

impl Tests {
    /// Runs the programs, each with one thread, the longest with two.
    pub fn run(&self) -> Result<ExitCode, TaskError> {
        let chosen = |program: &TestProgram| {
            let is_named = self.names.is_empty() || self.names.iter().any(|name| program.name.contains(name.as_str()));
            is_named && !self.without.as_ref().is_some_and(|without| program.name.contains(without.as_str()))
        };
        let mut programs: Vec<_> = programs::built()?.into_iter().filter(chosen).collect();
        let mut times = Times::read(&self.kept)?;
        programs.sort_by(|a, b| times.of(&b.name).total_cmp(&times.of(&a.name)));
        let at_once = self.at_once.unwrap_or_else(|| std::thread::available_parallelism().map_or(1, Into::into));
        let jobs = programs.iter().map(job).collect();
        let mut passed = 0;
        pool::run(jobs, at_once, &self.kept.join("logs"), |ended| {
            let program = programs.iter().find(|program| program.name == ended.name);
            passed += judged(&ended, program)?;
            times.note(&ended);
            Ok(())
        })?;
        times.write(&self.kept)?;
        println!("passed: {passed} tests of {} programs", programs.len());
        Ok(ExitCode::SUCCESS)
    }
}

fn job(program: &TestProgram) -> Job {
    let mut command = Command::new(&program.executable);
    command.current_dir(&program.folder).args(["--test-threads", threads_of(&program.name)]);
    // As cargo sets them for a test that it runs itself.
    command.env("CARGO_MANIFEST_DIR", &program.folder).env("CARGO_PKG_NAME", &program.package);
    Job { name: program.name.clone(), command }
}

/// The command's tests start other programs and wait for them; with one thread they would be the last to end.
fn threads_of(program: &str) -> &'static str {
    if program == "saute cli" { "2" } else { "1" }
}

/// Prints how a program ended; returns the number of tests that passed.
fn judged(ended: &Ended, program: Option<&TestProgram>) -> Result<usize, TaskError> {
    if !ended.status.success() {
        println!("{}", ended.output);
        let again = program.map(|program| program.executable.display().to_string()).unwrap_or_default();
        let failed = format!(
            "{} failed ({}); again: ./test.sh step tests \"{}\", or {again} TEST",
            ended.name, ended.status, ended.name
        );
        return Err(TaskError::Failed(failed));
    }
    let passed = passed(&ended.output);
    println!("{:<28} {passed:>4} passed {:>7.1} s", ended.name, ended.wall_s);
    Ok(passed)
}

/// Sum of the tests that passed by the closing lines of an output.
fn passed(output: &str) -> usize {
    let results = output.lines().filter_map(|line| line.strip_prefix("test result: ok. "));
    results.filter_map(|rest| rest.split(' ').next()?.parse::<usize>().ok()).sum()
}

/// How long each program ran the last time [s].
struct Times(BTreeMap<String, f64>);

impl Times {
    fn file(kept: &Path) -> PathBuf {
        kept.join("times.json")
    }

    fn read(kept: &Path) -> Result<Self, TaskError> {
        let file = Self::file(kept);
        match std::fs::read(&file) {
            // Only the order depends on them.
            Ok(bytes) => Ok(Self(serde_json::from_slice(&bytes).unwrap_or_default())),
            Err(error) if error.kind() == std::io::ErrorKind::NotFound => Ok(Self(BTreeMap::new())),
            Err(error) => Err(at(file)(error)),
        }
    }

    /// An unknown program may be the longest.
    fn of(&self, name: &str) -> f64 {
        self.0.get(name).copied().unwrap_or_else(|| first_time(name))
    }

    fn note(&mut self, ended: &Ended) {
        self.0.insert(ended.name.clone(), ended.wall_s);
    }

    fn write(&self, kept: &Path) -> Result<(), TaskError> {
        let file = Self::file(kept);
        let text = serde_json::to_string_pretty(&self.0).unwrap_or_default();
        std::fs::write(&file, text).map_err(at(&file))
    }
}

/// The programs that are longest on a clean clone, where none has been timed: they are begun first [s].
fn first_time(name: &str) -> f64 {
    match name {
        "saute cli" => 3.0,
        "saute-window window" | "saute validation" | "saute-plan plan" => 2.0,
        _ if name.ends_with(" lib") => 0.0,
        _ => 1.0,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn passed_tests_are_summed_over_all_closing_lines() {
        let output = "test a ... ok\n\ntest result: ok. 12 passed; 0 failed; 1 ignored; 0 measured\n\
            test result: ok. 3 passed; 0 failed; 0 ignored\n";
        assert_eq!(passed(output), 15);
        assert_eq!(passed("test result: FAILED. 3 passed; 1 failed"), 0);
    }

    #[test]
    fn what_ran_longest_is_begun_first_and_what_is_unknown_before_short_ones() {
        let times = Times([("saute-heat lib".to_owned(), 0.2), ("saute cli".to_owned(), 300.0)].into());
        assert!(times.of("saute cli") > times.of("saute-plan verified"));
        assert!(times.of("saute-plan verified") > times.of("saute-heat lib"));
    }
}
