//! Explains what is wrong with a food's file, and what a sound one makes.

mod keys;
mod layout;
mod report;

use saute_food::FoodDescription;
use saute_heat::Soup;
use serde::Serialize;

pub use report::{FoodReport, SurfaceReport};

use crate::data::data_check;
use crate::data::library::{Library, LibraryError, line_of, with_body};

/// One thing that is wrong with a file.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct Finding {
    /// Line, from 1.
    pub line: usize,
    /// The key; empty where it is none.
    pub key: String,
    /// What is wrong.
    pub message: String,
    /// What to write instead.
    pub remedy: String,
}

impl Finding {
    fn new(line: usize, key: &str, message: String, remedy: impl Into<String>) -> Self {
        Self { line, key: key.to_owned(), message, remedy: remedy.into() }
    }
}

impl From<LibraryError> for Finding {
    fn from(error: LibraryError) -> Self {
        Self::new(error.line, "", error.message, "mend this line")
    }
}

/// Checks the text of a food's file; `surface` holds the triangles of the file that it names, where it names one.
///
/// The library tells the kinetics that there are; the food itself need not be in it.
pub fn check_food(text: &str, surface: Option<&Soup>, library: &Library) -> Result<FoodReport, Vec<Finding>> {
    let layout = layout::findings(text);
    if !layout.is_empty() {
        return Err(layout);
    }
    let one = |finding: Finding| vec![finding];
    let food: FoodDescription = toml::from_str(text).map_err(|e| {
        let line = line_of(text, e.span().map_or(0, |s| s.start));
        one(Finding::new(line, "", e.message().trim().to_owned(), "write one of the values that there are"))
    })?;
    let file = "food";
    data_check::food(&food, file, text).map_err(|e| one(e.into()))?;
    let food = with_body(food, surface, file, text).map_err(|e| one(e.into()))?;
    library.check_kinetics(&food, file, text).map_err(|e| one(e.into()))?;
    FoodReport::of(&food, library).map_err(|e| one(Finding::new(1, "", e.to_string(), "choose other sizes")))
}
