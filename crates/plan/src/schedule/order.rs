//! What is to be cooked, in which pan, with which powers, to which goal.

use std::fmt::Write;
use std::sync::Arc;

use saute_kitchen::Library;
use saute_kitchen::food::FoodModel;
use saute_recipe::Cook;

use crate::goal::Goal;
use crate::schedule::{JobError, Schedule, Setting};

/// What is to be cooked, in which pan, with which powers, to which goal.
#[derive(Clone, Debug, PartialEq)]
pub struct Order {
    /// Id of the food; its name in the recipe too.
    pub food: String,
    /// Dimensions of its form; the last one is its thickness [mm].
    pub size_mm: Vec<f64>,
    /// Temperature at which it goes into the pan [°C].
    pub initial_c: f64,
    /// Number of pieces of a group; none for a single piece.
    pub count: Option<u32>,
    /// Id of the hob, for the recipe; none for that of the kitchen at home.
    pub hob: Option<String>,
    /// Id of the pan.
    pub pan: String,
    /// Powers of the hob that may be used, ascending, without 0 [W].
    pub hob_w: Vec<f64>,
    /// Largest number of flips [-].
    pub most_flips: usize,
    /// Longest rest [s]; none for one until the core has peaked.
    pub most_rest_s: Option<u32>,
    /// Temperature of the pan about which the food is put in [°C]; none where the search chooses.
    pub pan_c: Option<u32>,
    /// True for a plan that is easily followed: one power to heat the pan and one to fry.
    pub plain: bool,
    /// The goal.
    pub goal: Goal,
}

/// Flips of a plain plan at most [-] (chosen: a turn every three minutes, as the coach advises, warms evenly and is not missed).
pub const PLAIN_FLIPS: usize = 3;

impl Order {
    /// Thickness of a piece [mm].
    pub fn thickness_mm(&self) -> f64 {
        self.size_mm.last().copied().unwrap_or_default()
    }

    /// Returns the order with another thickness [mm], within the range of its food.
    pub(crate) fn with_thickness(&self, mm: f64, library: &Library) -> Self {
        let mut order = self.clone();
        let range = library.foods.get(&self.food).map(|food| &food.size);
        let ends = range.and_then(|size| Some([*size.min_mm.last()?, *size.max_mm.last()?]));
        if let (Some(last), Some([low, high])) = (order.size_mm.last_mut(), ends) {
            *last = mm.clamp(low, high);
        }
        order
    }

    /// Returns the model of a piece, with a mesh spacing relative to the default [-].
    ///
    /// # Errors
    ///
    /// If the order makes no recipe.
    pub fn check(&self, library: &Library, coarseness: f64) -> Result<Arc<FoodModel>, JobError> {
        let powers = self.hob_w.iter().map(|hob_w| Setting { at_s: 0, hob_w: *hob_w }).collect();
        let schedule = Schedule { powers, put_s: 0, flips_s: Vec::new(), pull_s: 60, rest_s: 60 };
        let mut recipe = schedule.recipe(self, library)?;
        recipe.foods.iter_mut().for_each(|food| food.coarseness = coarseness);
        let kitchen = recipe.kitchen(library)?;
        // The runner checks that all pieces find room in the pan.
        let mut cook = Cook::new(recipe, library)?;
        cook.fire()?;
        Ok(Arc::clone(&kitchen.pieces()[0].model))
    }

    /// Returns the title of its recipe.
    pub fn title(&self) -> String {
        format!("{} to {}, planned", self.food.replace('-', " "), self.goal.name)
    }

    /// Writes title, pan and foods as a recipe states them.
    pub(crate) fn write_head(&self, text: &mut String, max_s: u32) {
        let Self { food, size_mm, initial_c, pan, hob, .. } = self;
        let hob = hob.as_ref().map_or_else(String::new, |kind| format!("[hob]\nkind = {kind:?}\n"));
        // Writing to a string cannot fail.
        let _ = write!(
            text,
            "title = {:?}\nmax_s = {max_s}\n{hob}[pan]\nkind = {pan:?}\n[[food]]\nid = {food:?}\nkind = {food:?}\n\
             size_mm = {size_mm:?}\ninitial_c = {initial_c}\n",
            self.title()
        );
        if let Some(count) = self.count {
            let _ = writeln!(text, "count = {count}");
        }
    }
}
