//! Doneness of a piece in the words of its food: which scales fit it, and the class of its core.

use std::sync::Arc;

use saute_food::change::doneness::Measure;
use saute_food::{FoodDescription, FoodModel, Rules, Scale};

use crate::Piece;
use crate::data::library::DEFAULT_SCALE;

/// Returns the scales that are made for a food, in their order: its own, else those for its kinetics, else the general ones.
pub fn made_for<'a>(scales: &'a [Arc<Scale>], food: &FoodDescription) -> Vec<&'a Arc<Scale>> {
    if let Some(own) = &food.doneness {
        return scales.iter().filter(|s| s.id == own.id).collect();
    }
    let of_kinetics: Vec<_> = scales.iter().filter(|s| s.is_made_for(&food.kinetics)).collect();
    if of_kinetics.is_empty() { scales.iter().filter(|s| s.is_general()).collect() } else { of_kinetics }
}

/// Returns the scales that apply to a food, in their order: those made for it whose change its kinetics contain.
///
/// By the rules of 2013 the scale of 2013 is always among them where its change is: that system knew no other.
pub fn fitting<'a>(scales: &'a [Arc<Scale>], food: &FoodModel) -> Vec<&'a Arc<Scale>> {
    let made = made_for(scales, food.description());
    let of_2013 = |s: &Scale| food.rules() == Rules::Paper2013 && s.id == DEFAULT_SCALE;
    let wanted = |s: &Scale| of_2013(s) || made.iter().any(|one| one.id == s.id);
    scales.iter().filter(|s| wanted(s) && s.applies_to(food.kinetics())).collect()
}

/// Scales of doneness with the one that the cook prefers.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct ScaleChoice {
    scales: Vec<Arc<Scale>>,
    chosen: String,
}

impl ScaleChoice {
    /// Returns the choice of a scale by its id.
    pub fn new(scales: &[Arc<Scale>], chosen: &str) -> Self {
        Self { scales: scales.to_vec(), chosen: chosen.to_owned() }
    }

    /// Returns the scale in whose words a food is spoken of: the chosen one if it fits the food, else the first that
    /// does; none if no scale fits.
    pub fn of(&self, food: &FoodModel) -> Option<&Arc<Scale>> {
        let fitting = fitting(&self.scales, food);
        fitting.iter().find(|s| s.id == self.chosen).or(fitting.first()).copied()
    }

    /// Returns the chosen scale where there is no food; where the data do not have it, the first.
    pub fn alone(&self) -> Option<&Arc<Scale>> {
        self.scales.iter().find(|s| s.id == self.chosen).or(self.scales.first())
    }

    /// Returns the id of the chosen scale.
    pub fn chosen(&self) -> &str {
        &self.chosen
    }

    /// Returns the scale with an id.
    pub fn by_id(&self, id: &str) -> Option<&Arc<Scale>> {
        self.scales.iter().find(|s| s.id == id)
    }
}

/// Returns what a scale measures at the core of a piece [K or -]: the highest temperature so far, or the share of a
/// change, which a scale of the second tissue takes as the mean over it; 0 for a change that the food's kinetics do not contain.
pub fn at_core(piece: &Piece, scale: &Scale) -> f64 {
    let field = piece.model.measured(&piece.state, scale);
    match scale.measure() {
        Measure::Peak => piece.core_peak.0,
        Measure::Share if field.is_empty() => 0.0,
        Measure::Share => piece.model.core_share(field, scale),
    }
}

/// Word for a core that is still ice, whatever the scale.
pub const FROZEN: &str = "frozen";

/// Returns the class of the core of a piece; [`FROZEN`] while it is colder than the beginning of freezing.
pub fn core_class<'a>(piece: &Piece, scale: &'a Scale) -> &'a str {
    if piece.model.core_is_ice(&piece.state) { FROZEN } else { scale.name_of(at_core(piece, scale)) }
}
