//! What a kitchen at home may have otherwise than the program's data.

use saute_kitchen::Library;
use saute_kitchen::data::at_home::{CONTACT_FACTOR, HOB_FACTOR, KitchenAtHome};
use saute_recipe::Recipe;
use serde::Serialize;

/// Number of parameters [-].
pub const COUNT: usize = 3;

/// Transformed parameters [-]: ln(η/(1 − η)) of the hob's efficiency η, which is less than 1, and the logarithms of the others.
pub type Logs = nalgebra::SVector<f64, COUNT>;

/// Standard deviation of each transformed parameter before anything was measured [-] (chosen: 79–92 % of the power of household
/// induction hobs reaches the pan; contact conductances of steaks differ by a third, see `[contact]` in kitchen.toml; a cook
/// measures a thickness of 25 mm with a ruler to 2 mm).
const PRIOR: [f64; COUNT] = [0.6, 0.30, 0.08];

/// Standard deviations of its prior within which a thickness is searched [-] (chosen: a third of the stated thickness).
const FAR: f64 = 4.0;

/// Largest efficiency of a fit [-] (chosen: a little always is lost).
const MOST_EFFICIENCY: f64 = 0.99;

/// What a kitchen at home may have otherwise than the program's data.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Parameters {
    /// Electrical power that reaches the pan's metal [-].
    pub hob_efficiency: f64,
    /// Factor on the contact conductance between food and pan [-].
    pub contact: f64,
    /// Thickness of the food [m].
    pub thickness: f64,
}

impl Parameters {
    /// Returns those of a recipe in the program's kitchen; of several foods the first one counts.
    pub fn of(recipe: &Recipe, library: &Library) -> Self {
        let thickness = recipe.foods.first().map_or(0.0, |food| food.size[2]);
        // A file may state that all power arrives, which no measurement can move.
        Self { hob_efficiency: library.hob.efficiency().min(MOST_EFFICIENCY), contact: 1.0, thickness }
    }

    /// Returns the transformed parameters [-].
    pub fn logs(&self) -> Logs {
        let odds = self.hob_efficiency / (1.0 - self.hob_efficiency);
        [odds, self.contact, self.thickness].map(libm::log).into()
    }

    /// Returns the parameters of transformed ones [-].
    pub fn from_logs(logs: &Logs) -> Self {
        let [odds, contact, thickness] = (*logs).into();
        let hob_efficiency = 1.0 / (1.0 + libm::exp(-odds));
        Self { hob_efficiency, contact: libm::exp(contact), thickness: libm::exp(thickness) }
    }

    /// Returns the least and the largest transformed parameters of a fit [-]: factors of hob and contact that a kitchen at home can state,
    /// and a thickness within four standard deviations of the stated one.
    pub fn bounds(recipe: &Recipe, library: &Library) -> [Logs; 2] {
        let (start, earlier) = (Self::of(recipe, library), &library.at_home);
        let shipped = library.hob.efficiency() / earlier.hob_factor;
        let of = |end: usize| {
            let [hob, contact] = [HOB_FACTOR[end], CONTACT_FACTOR[end] / earlier.contact_factor];
            let away = if end == 0 { -FAR } else { FAR };
            let thickness = start.thickness * libm::exp(away * PRIOR[2]);
            Self { hob_efficiency: (shipped * hob).min(MOST_EFFICIENCY), contact, thickness }.logs()
        };
        [of(0), of(1)]
    }

    /// Returns the standard deviations of the transformed parameters before anything was measured [-].
    pub fn prior() -> Logs {
        PRIOR.into()
    }

    /// Sets them in a kitchen's data.
    pub fn set_in(&self, library: &mut Library) {
        self.factors(library).set_in(&mut library.hob, &mut library.room);
    }

    /// Returns the factors on a kitchen's data.
    fn factors(&self, library: &Library) -> KitchenAtHome {
        KitchenAtHome {
            hob_factor: self.hob_efficiency / library.hob.efficiency(),
            contact_factor: self.contact,
            ..KitchenAtHome::default()
        }
    }

    /// Sets the thickness of the foods of a recipe.
    pub fn set_in_recipe(&self, recipe: &mut Recipe) {
        for food in &mut recipe.foods {
            food.size[2] = self.thickness;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn logarithms_come_back() {
        let there = Parameters { hob_efficiency: 0.8, contact: 1.3, thickness: 0.027 };
        let back = Parameters::from_logs(&there.logs());
        assert!((back.thickness - there.thickness).abs() < 1e-15 && (back.contact - there.contact).abs() < 1e-14);
    }
}
