//! Relations in the file of the goals.

use crate::data::goals::{Counted, GoalDescription, GoalsFile};
use saute_schema::{DataFile, Format, LibraryError};

/// Scales, classes and kinetics are checked against the library, once all files are read.
impl Format for GoalsFile {
    fn relations(&self, file: &DataFile) -> Result<(), LibraryError> {
        for (at, goal) in self.goal.iter().enumerate() {
            if let Err((key, message)) = goal_fault(goal) {
                return Err(file.error(&format!("goal.{at}.{key}"), message));
            }
            if self.goal[..at].iter().any(|other| other.id == goal.id) {
                let message = format!("there is another goal \"{}\": use another id", goal.id);
                return Err(file.error(&format!("goal.{at}.id"), message));
            }
        }
        Ok(())
    }
}

/// Returns an error with the key that is wrong and what to write instead if a goal cannot be used.
fn goal_fault(goal: &GoalDescription) -> Result<(), (&'static str, String)> {
    let plain = |c: char| c.is_ascii_alphanumeric() || c == '-' || c == '_';
    if goal.id.is_empty() || !goal.id.chars().all(plain) {
        return Err(("id", format!("id = \"{}\" cannot be used: write letters, digits, - and _", goal.id)));
    }
    if goal.name.trim().is_empty() {
        return Err(("name", "name is empty: write the label that people read".into()));
    }
    match (goal.counts, &goal.class) {
        (Counted::Section, None) => Err(("counts", "a share of the section needs a class: write class".into())),
        (Counted::Faces, Some(_)) => {
            Err(("class", "the faces have no class: remove class, or count the section".into()))
        }
        (Counted::Faces, None) if goal.core_counts || goal.scale.is_some() => {
            Err(("counts", "a goal of the faces judges no core: write core_counts = false and no scale".into()))
        }
        _ => Ok(()),
    }
}
