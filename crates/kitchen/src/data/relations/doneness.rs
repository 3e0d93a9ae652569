//! Relations in the file of the scales of doneness.

use saute_food::Scale;

use crate::data::data_file::DataFile;
use crate::data::format::Format;
use crate::data::library::{DEFAULT_SCALE, DonenessFile, LibraryError};

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
fn scale_fault(scale: &Scale) -> Result<(), (&'static str, String)> {
    let plain = |c: char| c.is_ascii_alphanumeric() || c == '-' || c == '_';
    if scale.id.is_empty() || !scale.id.chars().all(plain) {
        return Err(("id", format!("id = \"{}\" cannot be used: write letters, digits, - and _", scale.id)));
    }
    if scale.name.trim().is_empty() {
        return Err(("name", "name is empty: write the label that people read".into()));
    }
    class_fault(scale).map_err(|message| ("class", message))
}

/// Returns an error with what to write instead if the classes of a scale cannot be used.
fn class_fault(scale: &Scale) -> Result<(), String> {
    let classes = &scale.class;
    let repeated = |i: usize| classes[..i].iter().any(|c| c.name == classes[i].name);
    if !classes.windows(2).all(|w| w[0].from_c < w[1].from_c) {
        return Err("from_c does not ascend: list the classes from the coldest to the hottest".into());
    }
    if let Some(i) = (0..classes.len()).find(|&i| classes[i].name.trim().is_empty() || repeated(i)) {
        return Err(format!("class name \"{}\" is empty or repeated: name each class", classes[i].name));
    }
    if scale.id == DEFAULT_SCALE && !classes.iter().map(|c| c.name.as_str()).eq(DEFAULT_CLASSES) {
        let names = DEFAULT_CLASSES.join(", ");
        return Err(format!("\"{DEFAULT_SCALE}\" has the classes {names}: give other ones an id of their own"));
    }
    Ok(())
}
