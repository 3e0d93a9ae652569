//! What a person requests of a plan, in plain words and numbers: it becomes an [`Order`] where a library is.

use std::sync::Arc;

use saute_kitchen::Library;
use saute_kitchen::doneness::made_for;
use saute_kitchen::food::Scale;
use serde::{Deserialize, Serialize};

use crate::goal::{Goal, TargetError, Wish};
use crate::schedule::{JobError, Order};

/// What a person requests of a plan.
#[derive(Clone, Debug, Deserialize, PartialEq, Serialize)]
pub struct Asked {
    /// Id of the food.
    pub food: String,
    /// Dimensions of its form; the last one is its thickness [mm].
    pub size_mm: Vec<f64>,
    /// Temperature at which it goes into the pan [°C].
    pub initial_c: f64,
    /// Number of pieces of a group; none for a single piece.
    pub count: Option<u32>,
    /// Id of the hob; none for that of the kitchen at home.
    pub hob: Option<String>,
    /// Id of the pan.
    pub pan: String,
    /// Powers of the hob that may be used; in any order [W].
    pub hob_w: Vec<f64>,
    /// Largest number of flips [-].
    pub most_flips: usize,
    /// True for a plan that is easily followed: one power to heat the pan and one to fry.
    pub plain: bool,
    /// The target: a class of the scale (`medium`), or a temperature of the core (`core=54`).
    pub target: String,
    /// Id of the scale of the target; the first one that fits the food where it does not.
    pub scale: String,
    /// Share of each face that is to be browned [%].
    pub crust_pct: f64,
}

/// Why nothing can be planned.
#[derive(Clone, Debug, thiserror::Error)]
pub enum AskedError {
    /// No food has this id.
    #[error("there is no food \"{0}\"")]
    Food(String),
    /// The target means nothing.
    #[error(transparent)]
    Target(#[from] TargetError),
    /// The order makes no recipe.
    #[error(transparent)]
    Job(#[from] JobError),
}

/// Returns the scales of doneness that apply to a food, in their order: those made for it, else the general ones.
pub fn scales_for<'a>(library: &'a Library, food: &str) -> Vec<&'a Arc<Scale>> {
    let Some(food) = library.foods.get(food) else { return Vec::new() };
    let Some(kinetics) = library.kinetics.get(&food.kinetics) else { return Vec::new() };
    let made = made_for(&library.scales, food);
    made.into_iter().filter(|scale| scale.applies_to(kinetics)).collect()
}

/// Returns the scale of a food by an id, or the first that fits the food.
pub fn scale_for<'a>(library: &'a Library, food: &str, id: &str) -> Option<&'a Arc<Scale>> {
    let fitting = scales_for(library, food);
    fitting.iter().find(|scale| scale.id == id).or(fitting.first()).copied()
}

impl Asked {
    /// Returns the order: its food is built to see that it can be cooked.
    ///
    /// # Errors
    ///
    /// If food, target or pan mean nothing, or a size is out of range.
    pub fn order(&self, library: &Library) -> Result<Order, AskedError> {
        let Self { food, size_mm, initial_c, count, hob, pan, most_flips, plain, target, crust_pct, .. } = self.clone();
        let Some(cooked) = library.foods.get(&food) else { return Err(AskedError::Food(food)) };
        let (most_flips, most_rest_s, pan_c) =
            (cooked.most_flips(most_flips), cooked.most_rest_s(), cooked.plan_pan_c());
        let wish: Wish = target.parse()?;
        let scale = scale_for(library, &food, &self.scale).or(library.scales.first());
        let scale = scale.ok_or_else(|| AskedError::Food(food.clone()))?;
        let goal = Goal::new(&wish, scale, crust_pct)?;
        let hob_w = self.powers(library.hob.largest_w());
        let order =
            Order { food, size_mm, initial_c, count, hob, pan, hob_w, most_flips, most_rest_s, pan_c, plain, goal };
        order.check(library, 1.0)?;
        Ok(order)
    }

    /// The powers, ascending, each once, that the hob can give [W].
    fn powers(&self, largest_w: f64) -> Vec<f64> {
        let mut powers: Vec<f64> = self.hob_w.iter().copied().filter(|w| *w > 0.0 && *w <= largest_w).collect();
        powers.sort_by(f64::total_cmp);
        powers.dedup();
        powers
    }
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use super::*;

    fn asked() -> Asked {
        Asked {
            food: "shrimp".into(),
            size_mm: vec![75.0, 16.0],
            initial_c: 5.0,
            count: None,
            hob: None,
            pan: "carbon-steel-26".into(),
            hob_w: vec![2000.0, 400.0, 400.0, 0.0],
            most_flips: 2,
            plain: false,
            target: "opaque".into(),
            scale: "chefs".into(),
            crust_pct: 0.0,
        }
    }

    #[test]
    fn a_food_is_asked_for_by_a_scale_that_fits_it() {
        let library = Library::embedded().unwrap();
        let order = asked().order(&library).unwrap();
        assert_eq!((order.goal.scale.id.as_str(), order.hob_w), ("shrimp", vec![400.0, 2000.0]));
        let chefs: Vec<&str> = scales_for(&library, "beef-lean").iter().map(|scale| scale.id.as_str()).collect();
        assert!(chefs.contains(&"chefs") && !chefs.contains(&"shrimp"), "{chefs:?}");
    }

    #[test]
    fn an_egg_is_turned_once_and_served_at_once() {
        let library = Library::embedded().unwrap();
        let egg = || Asked { food: "egg".into(), size_mm: vec![110.0, 5.1], target: "runny".into(), ..asked() };
        let order = egg().order(&library).unwrap();
        assert_eq!((order.most_flips, order.most_rest_s, order.pan_c), (1, Some(60), Some(140)));
        assert_eq!(Asked { most_flips: 0, ..egg() }.order(&library).unwrap().most_flips, 0, "the cook's own word");
        let other = asked().order(&library).unwrap();
        assert_eq!((other.most_flips, other.most_rest_s, other.pan_c), (2, None, None));
    }

    #[test]
    fn what_means_nothing_is_refused_with_the_reason() {
        let library = Library::embedded().unwrap();
        let refused = |asked: Asked| asked.order(&library).unwrap_err().to_string();
        assert!(refused(Asked { food: "beef".into(), ..asked() }).contains("no food"));
        assert!(refused(Asked { target: "medium".into(), ..asked() }).contains("opaque"));
        assert!(refused(Asked { size_mm: vec![750.0, 16.0], ..asked() }).contains("size_mm"));
    }
}
