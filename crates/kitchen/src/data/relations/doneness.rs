//! Relations in the file of the scales of doneness.

use saute_food::Scale;
use saute_food::change::doneness::{Class, Measure};

use crate::data::library::{DEFAULT_SCALE, DonenessFile};
use saute_schema::{DataFile, Format, LibraryError};

/// Classes of [`DEFAULT_SCALE`]: the summary's `section_pct` has these keys.
const DEFAULT_CLASSES: [&str; 4] = ["raw", "rare", "medium", "well-done"];

impl Format for DonenessFile {
    fn relations(&self, file: &DataFile) -> Result<(), LibraryError> {
        for (at, scale) in self.scale.iter().enumerate() {
            if let Err((key, message)) = scale_fault(scale) {
                return Err(file.error(&format!("scale.{at}.{key}"), message));
            }
            if self.scale[..at].iter().any(|s| s.id == scale.id) {
                let message = format!("there is another scale \"{}\": use another id", scale.id);
                return Err(file.error(&format!("scale.{at}.id"), message));
            }
        }
        if self.scale.iter().any(|s| s.id == DEFAULT_SCALE) {
            return Ok(());
        }
        let message =
            format!("there is no scale \"{DEFAULT_SCALE}\", which every summary reports: keep it and add your own");
        Err(file.error("", message))
    }
}

/// Returns an error with the key that is wrong and what to write instead if a scale cannot be used.
pub(crate) fn scale_fault(scale: &Scale) -> Result<(), (&'static str, String)> {
    let plain = |c: char| c.is_ascii_alphanumeric() || c == '-' || c == '_';
    if scale.id.is_empty() || !scale.id.chars().all(plain) {
        return Err(("id", format!("id = \"{}\" cannot be used: write letters, digits, - and _", scale.id)));
    }
    if scale.name.trim().is_empty() {
        return Err(("name", "name is empty: write the label that people read".into()));
    }
    class_fault(scale).map_err(|message| ("class", message))?;
    goal_fault(scale).map_err(|message| ("goal", message))
}

/// Returns an error with what to write instead if the classes of a scale cannot be used.
fn class_fault(scale: &Scale) -> Result<(), String> {
    let classes = &scale.class;
    let repeated = |i: usize| classes[..i].iter().any(|c| c.name == classes[i].name);
    let key = if scale.measure() == Measure::Share { "from_pct" } else { "from_c" };
    let one_key = |c: &Class| c.from_c.is_some() != c.from_pct.is_some() && c.from_pct.is_some() == (key == "from_pct");
    if let Some(class) = classes.iter().find(|c| !one_key(c)) {
        return Err(format!(
            "class \"{}\" needs one lower bound, in the same key as the other classes: write from_c, the highest \
             temperature, or from_pct, the share of for_change, in all of them",
            class.name
        ));
    }
    if !classes.windows(2).all(|w| w[0].from() < w[1].from()) {
        return Err(format!("{key} does not ascend: list the classes from the least done to the most done"));
    }
    if let Some(i) = (0..classes.len()).find(|&i| classes[i].name.trim().is_empty() || repeated(i)) {
        return Err(format!("class name \"{}\" is empty or repeated: name each class", classes[i].name));
    }
    let of_2013 = scale.measure() == Measure::Peak && scale.is_general();
    if scale.id == DEFAULT_SCALE && !(of_2013 && classes.iter().map(|c| c.name.as_str()).eq(DEFAULT_CLASSES)) {
        let names = DEFAULT_CLASSES.join(", ");
        return Err(format!(
            "\"{DEFAULT_SCALE}\" has the classes {names} by from_c and no for_kinetics: give other ones an id of their own"
        ));
    }
    Ok(())
}

/// Returns an error with what to write instead if the goal of a scale of shares is no share.
fn goal_fault(scale: &Scale) -> Result<(), String> {
    match scale.goal {
        Some(goal) if scale.measure() == Measure::Share && goal > 100.0 => {
            Err(format!("goal = {goal} is a share in percent here: write 0 to 100"))
        }
        _ => Ok(()),
    }
}
