//! Foods that are built before a cook begins with them or they are added, some in each frame: many pieces take longer than a person waits
//! before a picture that stands.

use std::sync::Arc;

use saute_kitchen::bytes::Models;
use saute_kitchen::kitchen::SetupError;
use saute_kitchen::piece::building_time::building_s;
use saute_kitchen::{Kitchen, Library, PieceOrder};
use saute_recipe::session::Deed;
use saute_recipe::{Recipe, Recording};
use web_time::{Duration, Instant};

use crate::Session;
use crate::choice::{FoodChoice, as_recipe, orders};
use crate::hands::Hands;

/// What takes no longer is built at once [s] (chosen: what a person takes for an answer at once is 0.1 s, and a page that stands for
/// half a second is not yet thought to be stuck).
const AT_ONCE_S: f64 = 0.5;

/// Calls in which nothing is built yet [-] (chosen: a message is laid out in one frame and seen in the next).
const TOLD_IN: u32 = 2;

/// Foods that are being built.
pub(crate) struct Building {
    /// The kitchen without food.
    bare: Kitchen,
    library: Arc<Library>,
    orders: Vec<PieceOrder>,
    built: usize,
    models: Models,
    /// Calls until the first is built.
    told_in: u32,
}

impl<H: Hands> Session<H> {
    /// Returns true if the foods of a choice must be built before they are set out: [`Self::build_more`] then does it.
    pub fn builds_choice_first(&mut self, choice: &FoodChoice, count: usize) -> bool {
        as_recipe(&self.library, choice, count).is_ok_and(|recipe| self.builds_recipe_first(&recipe))
    }

    /// Returns true if foods must be built before they are added.
    pub fn builds_added_first(&mut self, choice: &FoodChoice, count: usize) -> bool {
        let (recipe, library) = (Arc::clone(&self.recipe), Arc::clone(&self.library));
        let orders = orders(&library, choice, "", count);
        self.builds_first(&recipe, &library, orders)
    }

    /// Returns true if the foods of a recipe must be built before it is played or set out.
    pub fn builds_recipe_first(&mut self, recipe: &Recipe) -> bool {
        let home = Arc::clone(&self.home);
        self.builds_first(recipe, &home, recipe.foods.clone())
    }

    /// Returns true if foods must be built before this cook is begun again.
    pub fn builds_again_first(&mut self) -> bool {
        let (recipe, home) = (Arc::clone(&self.recipe), Arc::clone(&self.home));
        // A recipe that plays begins again without what was added.
        let orders = if self.plays { recipe.foods.clone() } else { with_added(&recipe, &self.recording) };
        self.builds_first(&recipe, &home, orders)
    }

    /// Returns true if foods must be built before a recorded cook is resumed. What the library lacks of it is told by the cook that cannot
    /// begin.
    pub fn builds_recorded_first(&mut self, recording: &Recording) -> bool {
        let Ok(library) = self.library_of(recording) else { return false };
        let Ok(recipe) = recording.beginning().recipe(&library) else { return false };
        let orders = with_added(&recipe, recording);
        self.builds_first(&recipe, &library, orders)
    }

    fn builds_first(&mut self, recipe: &Recipe, library: &Arc<Library>, orders: Vec<PieceOrder>) -> bool {
        if let Some(building) = self.building.as_ref().filter(|building| building.orders == orders) {
            return !building.is_ended();
        }
        let models = self.timeline.models().needed_by(&orders, library);
        let unknown: Vec<PieceOrder> = orders.iter().filter(|order| !models.knows(order, library)).cloned().collect();
        if building_s(library, &unknown).is_ok_and(|s| s < AT_ONCE_S) {
            return false;
        }
        let begun = recipe.empty_kitchen(library);
        // What is wrong, and what does not fit, is told by the cook that cannot begin.
        let bare = begun.ok().filter(|bare| bare.check_all_fit(library, &orders).is_ok());
        self.building = bare.map(|bare| Building {
            bare,
            library: Arc::clone(library),
            orders,
            built: 0,
            models,
            told_in: TOLD_IN,
        });
        self.building.is_some()
    }

    /// Number of foods that are built, and of all, while they are being built [-].
    pub fn building(&self) -> Option<[usize; 2]> {
        let building = self.building.as_ref().filter(|building| !building.is_ended())?;
        Some([building.built, building.orders.len()])
    }

    /// Builds foods for no longer than `budget`, but one at least; none in the first two calls, so that it can be told before
    /// the first is built. Returns true once all are built; none where nothing is to be built.
    pub fn build_more(&mut self, budget: Duration) -> Option<bool> {
        let building = self.building.as_mut()?;
        if building.told_in == 0 {
            building.more(budget);
        }
        building.told_in = building.told_in.saturating_sub(1);
        Some(building.is_ended())
    }

    /// Lets go of foods that are being built.
    pub fn stop_building(&mut self) {
        self.building = None;
    }

    /// The models of foods that are set out or added, as far as they are known: those that were built for them, and those of this cook.
    pub(crate) fn take_built(&mut self, orders: &[PieceOrder]) -> Models {
        let mut models = self.timeline.models().needed_by(orders, &self.library);
        if let Some(building) = self.building.take_if(|building| building.is_ended()) {
            models.adopt(building.models);
        }
        models
    }
}

impl Building {
    fn is_ended(&self) -> bool {
        self.built == self.orders.len()
    }

    fn more(&mut self, budget: Duration) {
        let begun = Instant::now();
        while !self.is_ended() {
            // What is wrong with one is told when it is set out.
            if self.next().is_err() {
                self.built = self.orders.len();
            }
            if begun.elapsed() >= budget {
                break;
            }
        }
    }

    fn next(&mut self) -> Result<(), SetupError> {
        self.bare.prepare(&self.library, &self.orders[self.built], &mut self.models)?;
        self.built += 1;
        Ok(())
    }
}

/// The foods of a recipe, and those that were added to its cook.
fn with_added(recipe: &Recipe, recording: &Recording) -> Vec<PieceOrder> {
    recipe.foods.iter().chain(added_to(recording)).cloned().collect()
}

/// The foods that were added to a cook.
pub(crate) fn added_to(recording: &Recording) -> impl Iterator<Item = &PieceOrder> {
    recording.entries().iter().filter_map(|entry| match &entry.deed {
        Deed::Add(order) => Some(order),
        _ => None,
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    const MANY: usize = 60;

    fn session() -> (Session, FoodChoice) {
        let library = Arc::new(Library::embedded().expect("embedded data"));
        let session = Session::new(library, &FoodChoice::default()).expect("sets out");
        let size_mm = session.library.foods["shrimp"].size.default_mm.clone();
        (session, FoodChoice { kind: "shrimp".into(), size_mm, ..FoodChoice::default() })
    }

    /// Builds all; returns the number of slices.
    fn build(session: &mut Session) -> usize {
        for _ in 0..TOLD_IN {
            assert_eq!(session.build_more(Duration::ZERO), Some(false));
        }
        assert_eq!(session.building(), Some([0, MANY]), "it is told first");
        let mut slices = 1;
        while session.build_more(Duration::ZERO) == Some(false) {
            slices += 1;
        }
        slices
    }

    #[test]
    fn one_piece_is_built_at_once_and_many_one_after_another() {
        let (mut session, choice) = session();
        assert!(!session.builds_choice_first(&choice, 1) && session.building().is_none());
        assert!(session.builds_choice_first(&choice, MANY));
        assert_eq!(build(&mut session), MANY, "a slice builds one piece at least");
        assert!(session.building().is_none() && session.kitchen.pieces().len() == 1, "the cook goes on meanwhile");
        assert!(!session.builds_choice_first(&choice, MANY), "they are built");
        session.set_out(&choice, MANY).expect("sets out");
        assert_eq!(session.kitchen.pieces().len(), MANY);
        assert!(session.building.is_none(), "nothing is left behind");
        assert!(!session.builds_choice_first(&choice, MANY), "this cook knows them");
    }

    #[test]
    fn added_food_and_that_of_a_recording_are_built_first() {
        let (mut session, choice) = session();
        assert!(session.builds_added_first(&choice, MANY));
        build(&mut session);
        assert!(!session.builds_added_first(&choice, MANY));
        session.add(&choice, MANY).expect("adds");
        let recording = session.recording().clone();
        assert!(!session.builds_again_first(), "this cook knows them");
        let (mut other, _) = self::session();
        assert!(other.builds_recorded_first(&recording));
        other.stop_building();
        assert_eq!(other.build_more(Duration::ZERO), None);
    }
}
