//! What a person requests of a plan, in addition to the food and the pan of the pantry: it is remembered.

use saute_kitchen::Library;
use saute_kitchen::food::Scale;
use saute_kitchen::pan::hob::HobDescription;
use saute_plan::schedule::asked::{Asked, scale_for};
use saute_plan::schedule::{Order, PLAIN_FLIPS};
use serde::{Deserialize, Serialize};

use crate::settings::Settings;
use saute_session::SteakChoice;

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
        let usual = || library.foods.get(food).map_or(0.0, |food| Order::usual_crust_pct(food.form));
        self.crust_pct.unwrap_or_else(usual)
    }

    /// Returns the class that is requested on a scale: the chosen one, else that of the goal.
    pub fn class_on<'a>(&self, scale: &'a Scale, settings: &Settings) -> &'a str {
        let chosen = scale.class.iter().find(|class| class.name == self.class);
        let of_goal = || scale.class.get(scale.class_of(scale.of_nodes(settings.goal(scale))));
        chosen.or_else(of_goal).map_or("", |class| class.name.as_str())
    }

    /// Returns the powers of the hob that may be used, ascending [W].
    pub fn powers_w(&self, hob: &HobDescription) -> Vec<f64> {
        let typed = self.powers.split(|c: char| !c.is_ascii_digit()).filter_map(|number| number.parse().ok());
        let usable = |w: &f64| *w > 0.0 && *w <= hob.largest_w();
        let mut powers: Vec<f64> = typed.filter(usable).take(MOST_POWERS).collect();
        if powers.is_empty() {
            powers = hob.settings_w().iter().copied().filter(usable).collect();
        }
        powers.sort_by(f64::total_cmp);
        powers.dedup();
        powers
    }

    /// Returns the request for a choice of food and pan.
    pub fn asked(&self, choice: &SteakChoice, library: &Library, settings: &Settings) -> Asked {
        let scale = scale_for(library, &choice.kind, &self.scale);
        let class = scale.map_or(String::new(), |scale| self.class_on(scale, settings).to_owned());
        Asked {
            food: choice.kind.clone(),
            size_mm: choice.size_mm.iter().map(|mm| mm.round()).collect(),
            initial_c: choice.initial_c.round(),
            count: None,
            hob: choice.hob.clone(),
            pan: choice.pan.clone(),
            hob_w: self.powers_w(choice.hob(library)),
            most_flips: if self.plain { PLAIN_FLIPS } else { self.most_flips.min(MOST_FLIPS) },
            plain: self.plain,
            target: if self.by_core || scale.is_none() { format!("core={:.0}", self.core_c) } else { class },
            scale: scale.map_or(String::new(), |scale| scale.id.clone()),
            crust_pct: self.crust_of(library, &choice.kind),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_asked_fits_the_food_whatever_was_chosen_for_another() {
        let library = Library::embedded().expect("embedded data");
        let (settings, choice) = (Settings::default(), PlanChoice::default());
        let of = |kind: &str| {
            let size_mm = library.foods[kind].size.default_mm.clone();
            choice.asked(&SteakChoice { kind: kind.into(), size_mm, ..SteakChoice::default() }, &library, &settings)
        };
        let targets = ["beef-lean", "shrimp", "beef-patty", "carrot-coin"].map(|kind| of(kind).target);
        assert_eq!(targets, ["medium", "opaque", "safe", "tender"]);
        assert_eq!([of("beef-lean").crust_pct, of("shrimp").crust_pct], [60.0, 0.0]);
        for kind in library.foods.keys() {
            assert!(of(kind).order(&library).is_ok(), "{kind}");
        }
    }

    #[test]
    fn powers_are_read_as_people_write_them_and_are_those_of_the_dial_where_there_are_none() {
        let library = Library::embedded().expect("embedded data");
        let of = |powers: &str| PlanChoice { powers: powers.into(), ..PlanChoice::default() }.powers_w(&library.hob);
        assert_eq!(of("2000; 500 W,650"), [500.0, 650.0, 2000.0]);
        assert_eq!(of("a lot"), of(""));
        assert!(of("").len() >= 3 && !of("").contains(&0.0));
    }
}
