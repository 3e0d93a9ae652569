//! What a run of `./test.sh` left behind: the times of its steps, and what was counted.

use std::collections::BTreeMap;
use std::path::Path;
use std::process::Command;

use crate::error::{TaskError, at};

/// Times of a step.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct StepTime {
    /// On the clock [s].
    pub wall_s: f64,
    /// On the processors, its programs included [s].
    pub cpu_s: f64,
}

/// Reads the times of all steps in a folder: `NAME.times` contains the time on the clock [s] and what the shell prints of its own
/// and its programs' time on the processors.
///
/// # Errors
///
/// If the folder or a file cannot be read.
pub fn steps(folder: &Path) -> Result<BTreeMap<String, StepTime>, TaskError> {
    let mut found = BTreeMap::new();
    for entry in std::fs::read_dir(folder).map_err(at(folder))?.flatten() {
        let path = entry.path();
        let (Some(name), true) = (path.file_stem(), path.extension().is_some_and(|ending| ending == "times")) else {
            continue;
        };
        let text = std::fs::read_to_string(&path).map_err(at(&path))?;
        let time = step_time(&text).ok_or_else(|| TaskError::Content {
            path: path.clone(),
            reason: "it does not hold the times of a step; run the step again".to_owned(),
        })?;
        found.insert(name.to_string_lossy().into_owned(), time);
    }
    Ok(found)
}

/// Reads seconds, and then minutes and seconds as in `1m2.500s`.
fn step_time(text: &str) -> Option<StepTime> {
    let mut words = text.split_whitespace();
    let wall_s = words.next()?.parse().ok()?;
    let parts: Option<Vec<f64>> = words.map(shell_time).collect();
    let parts = parts.filter(|parts| parts.len() == 4)?;
    Some(StepTime { wall_s, cpu_s: parts.iter().sum() })
}

fn shell_time(word: &str) -> Option<f64> {
    let (minutes, seconds) = word.strip_suffix('s')?.split_once('m')?;
    Some(60.0 * minutes.parse::<f64>().ok()? + seconds.replace(',', ".").parse::<f64>().ok()?)
}

/// Reads what was counted while the steps ran: a file `NAME.count` has a line for each.
///
/// # Errors
///
/// If the folder or a file cannot be read.
pub fn counted(folder: &Path) -> Result<BTreeMap<String, u64>, TaskError> {
    let mut found = BTreeMap::new();
    for entry in std::fs::read_dir(folder).map_err(at(folder))?.flatten() {
        let path = entry.path();
        if let (Some(name), true) = (path.file_stem(), path.extension().is_some_and(|ending| ending == "count")) {
            let text = std::fs::read_to_string(&path).map_err(at(&path))?;
            found.insert(name.to_string_lossy().into_owned(), text.lines().count() as u64);
        }
    }
    Ok(found)
}

/// The time of the brick's loop on this machine, now [s].
///
/// # Errors
///
/// If the program does not start or prints something else.
pub fn loop_s(saute: &Path) -> Result<f64, TaskError> {
    let program = || saute.display().to_string();
    let output = Command::new(saute).args(["bench", "heat", "--brick", "--json"]).output();
    let output = output.map_err(|source| TaskError::Start { program: program(), source })?;
    let value: Option<serde_json::Value> = serde_json::from_slice(&output.stdout).ok();
    let loop_s = value.and_then(|value| value.pointer("/brick/loop_s")?.as_f64()).filter(|loop_s| *loop_s > 0.0);
    loop_s.ok_or_else(|| TaskError::Failed(format!("{} bench heat prints no time of the brick's loop", program())))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn times_of_a_shell_are_summed() {
        let text = "65.5\n0m0.500s 0m0.250s\n1m2.000s 0m3.250s\n";
        assert_eq!(step_time(text), Some(StepTime { wall_s: 65.5, cpu_s: 66.0 }));
        assert_eq!(step_time("65.5\n"), None);
        assert_eq!(step_time("1 0m1s 0m1s 0m1s x"), None);
    }

    #[test]
    fn steps_and_counts_are_read_from_a_folder_and_other_files_are_passed_over() {
        let folder = tempfile::tempdir().expect("a folder");
        let write = |name: &str, text: &str| std::fs::write(folder.path().join(name), text).expect("is written");
        write("tests.times", "2\n0m0.0s 0m0.0s\n0m3.0s 0m0.5s\n");
        write("pages_opened.count", "a\nb\n");
        write("notes.txt", "nothing");
        let steps = steps(folder.path()).expect("reads");
        assert_eq!(steps, [("tests".to_owned(), StepTime { wall_s: 2.0, cpu_s: 3.5 })].into());
        assert_eq!(counted(folder.path()).expect("reads"), [("pages_opened".to_owned(), 2)].into());
        write("broken.times", "soon");
        let error = super::steps(folder.path()).expect_err("it is refused");
        assert!(error.to_string().contains("broken.times"), "{error}");
    }
}
