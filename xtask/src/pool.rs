//! Programs side by side: a few at a time, each with its output in a file; the first that fails ends the others.

use std::collections::VecDeque;
use std::fs::File;
use std::path::{Path, PathBuf};
use std::process::{Child, Command, ExitStatus, Stdio};
use std::time::{Duration, Instant};

use crate::error::{TaskError, at};

/// How often the programs are looked at.
const LOOK: Duration = Duration::from_millis(50);

/// A program to run.
pub struct Job {
    /// What people call it.
    pub name: String,
    /// The program with its arguments.
    pub command: Command,
}

/// A program that has ended.
#[derive(Debug)]
pub struct Ended {
    /// What people call it.
    pub name: String,
    /// How it ended.
    pub status: ExitStatus,
    /// What it printed.
    pub output: String,
    /// How long it ran [s].
    pub wall_s: f64,
}

struct Running {
    name: String,
    child: Child,
    log: PathBuf,
    begun: Instant,
}

impl Running {
    fn start(job: Job, number: usize, logs: &Path) -> Result<Self, TaskError> {
        let Job { name, mut command } = job;
        let log = logs.join(format!("{number}.log"));
        let out = File::create(&log).map_err(at(&log))?;
        let error = out.try_clone().map_err(at(&log))?;
        let child = command.stdin(Stdio::null()).stdout(out).stderr(error).spawn();
        let child = child.map_err(|source| TaskError::Start { program: name.clone(), source })?;
        Ok(Self { name, child, log, begun: Instant::now() })
    }

    fn ended(&mut self) -> Result<Option<Ended>, TaskError> {
        let Some(status) = self.child.try_wait().map_err(at(&self.log))? else { return Ok(None) };
        let output = String::from_utf8_lossy(&std::fs::read(&self.log).map_err(at(&self.log))?).into_owned();
        Ok(Some(Ended { name: self.name.clone(), status, output, wall_s: self.begun.elapsed().as_secs_f64() }))
    }
}

impl Drop for Running {
    /// Ends a program that still runs when another has failed.
    fn drop(&mut self) {
        let _ = self.child.kill();
        let _ = self.child.wait();
    }
}

/// Runs jobs in their order, `at_once` at a time; `each` sees every one that has ended, and an error of it ends the rest.
///
/// # Errors
///
/// That of `each`, or if a program does not start.
pub fn run(
    jobs: Vec<Job>,
    at_once: usize,
    logs: &Path,
    mut each: impl FnMut(Ended) -> Result<(), TaskError>,
) -> Result<(), TaskError> {
    std::fs::create_dir_all(logs).map_err(at(logs))?;
    let mut waiting: VecDeque<(usize, Job)> = jobs.into_iter().enumerate().collect();
    let mut running: Vec<Running> = Vec::new();
    while !(waiting.is_empty() && running.is_empty()) {
        while running.len() < at_once.max(1)
            && let Some((number, job)) = waiting.pop_front()
        {
            running.push(Running::start(job, number, logs)?);
        }
        let mut place = 0;
        while place < running.len() {
            match running[place].ended()? {
                Some(ended) => {
                    drop(running.swap_remove(place));
                    each(ended)?;
                }
                None => place += 1,
            }
        }
        std::thread::sleep(LOOK);
    }
    Ok(())
}

#[cfg(all(test, unix))]
mod tests {
    use super::*;

    fn job(name: &str, script: &str) -> Job {
        let mut command = Command::new("sh");
        command.args(["-c", script]);
        Job { name: name.to_owned(), command }
    }

    #[test]
    fn every_job_runs_and_its_output_is_kept() {
        let logs = tempfile::tempdir().expect("a folder");
        let jobs = (0..5).map(|n| job(&format!("job {n}"), &format!("echo said {n}"))).collect();
        let mut seen = Vec::new();
        run(jobs, 2, logs.path(), |ended| {
            seen.push((ended.name, ended.output));
            Ok(())
        })
        .expect("all run");
        seen.sort();
        let expected = (0..5).map(|n| (format!("job {n}"), format!("said {n}\n")));
        assert!(seen.into_iter().eq(expected));
    }

    #[test]
    fn the_first_failure_ends_the_others_and_starts_no_more() {
        let logs = tempfile::tempdir().expect("a folder");
        let mark = logs.path().join("mark");
        let last = format!("touch {}", mark.display());
        let jobs = vec![job("waits", "exec sleep 600"), job("fails", "exit 3"), job("last", &last)];
        let done = run(jobs, 2, logs.path(), |ended| match ended.status.success() {
            true => Ok(()),
            false => Err(TaskError::Failed(format!("{} {}", ended.name, ended.status))),
        });
        assert!(matches!(&done, Err(TaskError::Failed(words)) if words.starts_with("fails ")), "{done:?}");
        assert!(!mark.exists(), "no other job is started");
    }
}
