//! Explains what is wrong with a food's file, and what a sound one makes.

mod report;

use saute_food::FoodDescription;
use saute_heat::Soup;

pub use report::{FoodReport, SurfaceReport};

use crate::data::library::{Library, with_body};
pub use saute_schema::Finding;
use saute_schema::{DataFile, FormatSchema};

/// Checks the text of a food's file; `surface` contains the triangles of the file that it names, where it names one.
///
/// Its kinetics are those of the library; the food itself need not be in it.
pub fn check_food(text: &str, surface: Option<&Soup>, library: &Library) -> Result<FoodReport, Vec<Finding>> {
    let format = FormatSchema::of::<FoodDescription>();
    let findings = format.findings(text);
    if !findings.is_empty() {
        return Err(findings);
    }
    let file = DataFile { name: "food", text };
    let food = format.read(&file).and_then(|food| with_body(food, surface, &file));
    let food = food.and_then(|food| library.check_kinetics(&food, &file).map(|()| food));
    let one = |finding: Finding| vec![finding];
    let food: FoodDescription = food.map_err(|e| one(e.into()))?;
    FoodReport::of(&food, library).map_err(|e| one(Finding::new(1, "", e.to_string(), "choose other sizes")))
}
