//! What a fit found, as text, as JSON and as a data file.

use std::path::Path;
use std::time::Duration;

use saute_kitchen::Library;
use saute_kitchen::data::at_home::KitchenAtHome;
use saute_plan::fit::found::{Estimate, Found};
use saute_recipe::Recipe;
use serde::Serialize;

use crate::wording;

/// Name of the data file.
pub const FILE: &str = "kitchen-at-home.toml";

/// What a fit found, beside what the program assumes.
#[derive(Debug, Serialize)]
pub struct Answer {
    #[serde(flatten)]
    found: Found,
    /// Efficiency of the program's hob [-].
    program_hob_efficiency: f64,
    /// Thickness that the recipe states [mm].
    recipe_thickness_mm: f64,
    /// Factor on the efficiency of the shipped hob [-].
    hob_factor: f64,
    /// Factor on the contact conductance of the shipped data [-].
    contact_factor: f64,
    /// The kitchen that was found.
    #[serde(skip)]
    at_home: KitchenAtHome,
    /// Wall time [s].
    wall_s: f64,
}

impl Answer {
    pub fn new(found: &Found, recipe: &Recipe, library: &Library, wall: Duration) -> Self {
        let at_home = found.at_home(library, "");
        Self {
            found: *found,
            program_hob_efficiency: library.hob.efficiency(),
            recipe_thickness_mm: recipe.foods.first().map_or(0.0, |food| 1e3 * food.size[2]),
            hob_factor: at_home.hob_factor,
            contact_factor: at_home.contact_factor,
            at_home,
            wall_s: wall.as_secs_f64(),
        }
    }

    pub fn text(&self) -> String {
        let Found { samples, rounds, misfit, .. } = self.found;
        let wall = wording::duration(self.wall_s);
        let head = format!(
            "Fitted {samples} values in {rounds} rounds ({wall}); misfit {misfit:.2} (1: as the thermometers err)\n\n{:16} {:>13} {:>14}   90 % interval\n",
            "", "your kitchen", "the program's"
        );
        let row = |name: &str, estimate: &Estimate, assumed: f64, unit: &str, decimals: usize| {
            let Estimate { value, low, high } = estimate;
            let unit = if unit.is_empty() { String::new() } else { format!(" {unit}") };
            let own = format!("{value:.decimals$}{unit}");
            let assumed = format!("{assumed:.decimals$}{unit}");
            format!("{name:16} {own:>13} {assumed:>14}   {low:.decimals$}–{high:.decimals$}{unit}\n")
        };
        let rows = [
            row("hob efficiency", &self.found.hob_efficiency, self.program_hob_efficiency, "", 3),
            row("contact", &self.found.contact, 1.0, "×", 2),
            row("thickness", &self.found.thickness_mm, self.recipe_thickness_mm, "mm", 1),
        ];
        head + &rows.concat()
    }

    /// Returns the file for a `--data` folder.
    pub fn data_file(&self, log: Option<&Path>) -> String {
        let Found { hob_efficiency: hob, contact, thickness_mm, misfit, samples, .. } = self.found;
        let log = log.and_then(Path::file_name).map_or("weight or class".into(), |name| name.to_string_lossy());
        let source = format!("fitted to {samples} values of {log}; misfit {misfit:.2}");
        let at_home = KitchenAtHome { source, ..self.at_home.clone() };
        format!(
            "# Found by saute fit. 90 % intervals: efficiency of the hob {:.3}–{:.3}, contact {:.2}–{:.2}, thickness of that food {:.1}–{:.1} mm.\n{}",
            hob.low,
            hob.high,
            contact.low,
            contact.high,
            thickness_mm.low,
            thickness_mm.high,
            at_home.to_file()
        )
    }
}
