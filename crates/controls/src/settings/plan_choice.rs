//! What a person requests of a plan, in addition to the food and the pan of the pantry: it is remembered.

use saute_kitchen::Library;
use saute_kitchen::advice::usual_powers_w;
use saute_kitchen::pan::hob::HobDescription;
use serde::{Deserialize, Serialize};

/// Scale in whose classes a target is stated at first: the one that cooks use.
const FIRST_SCALE: &str = "chefs";
/// Flips at first [-] (chosen: one in a minute of a steak of 25 mm).
const FIRST_FLIPS: usize = 8;
/// Most flips [-] (chosen: one every 20 s of a thick steak).
pub const MOST_FLIPS: usize = 30;
/// Most powers of a hob [-] (chosen: as many as a hob has levels).
const MOST_POWERS: usize = 20;

/// The request for a plan.
#[derive(Clone, Debug, Deserialize, PartialEq, Serialize)]
#[serde(default)]
pub struct PlanChoice {
    /// Id of the scale of the target.
    pub scale: String,
    /// The class of the scale.
    pub class: String,
    /// True if the target is a temperature of the core.
    pub by_core: bool,
    /// That temperature [°C].
    pub core_c: f64,
    /// Share of each face that is to be browned; what is usual for the food unless it was chosen [%].
    pub crust_pct: Option<f64>,
    /// Largest number of flips [-].
    pub most_flips: usize,
    /// True for a plan that is easily followed: one power to heat the pan, one to fry, few flips.
    pub plain: bool,
    /// Powers of the hob as they were typed [W]; those of its dial if there are none.
    pub powers: String,
}

impl Default for PlanChoice {
    fn default() -> Self {
        Self {
            scale: FIRST_SCALE.to_owned(),
            class: "medium".to_owned(),
            by_core: false,
            core_c: 57.0,
            crust_pct: None,
            most_flips: FIRST_FLIPS,
            plain: false,
            powers: String::new(),
        }
    }
}

impl PlanChoice {
    /// Returns the share of each face that is to be browned of a food [%].
    pub fn crust_of(&self, library: &Library, food: &str) -> f64 {
        let usual = || library.foods.get(food).map_or(0.0, |food| food.crust_pct());
        self.crust_pct.unwrap_or_else(usual)
    }

    /// Returns the powers of the hob that may be used, ascending [W].
    pub fn powers_w(&self, hob: &HobDescription) -> Vec<f64> {
        let typed = self.powers.split(|c: char| !c.is_ascii_digit()).filter_map(|number| number.parse().ok());
        let usable = |w: &f64| *w > 0.0 && *w <= hob.largest_w();
        let mut powers: Vec<f64> = typed.filter(usable).take(MOST_POWERS).collect();
        if powers.is_empty() {
            powers = usual_powers_w(hob);
        }
        powers.sort_by(f64::total_cmp);
        powers.dedup();
        powers
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn powers_are_read_as_people_write_them_and_are_those_of_the_dial_where_there_are_none() {
        let library = Library::embedded().expect("embedded data");
        let of = |powers: &str| PlanChoice { powers: powers.into(), ..PlanChoice::default() }.powers_w(&library.hob);
        assert_eq!(of("2000; 500 W,650"), [500.0, 650.0, 2000.0]);
        assert_eq!(of("a lot"), of(""));
        assert!(of("").len() >= 3 && !of("").contains(&0.0));
    }
}
