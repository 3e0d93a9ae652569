//! What is requested of a plan by the settings: the food and the pan of the pantry, to the goal.

use saute_kitchen::Library;
use saute_kitchen::food::Scale;
use saute_plan::schedule::PLAIN_FLIPS;
use saute_plan::schedule::asked::{Asked, scale_for};

use super::Settings;
use super::plan_choice::{MOST_FLIPS, PlanChoice};

impl Settings {
    /// Returns the class that a plan is requested for on a scale: the chosen one, else that of the goal.
    pub fn class_of_plan<'a>(&self, plan: &PlanChoice, scale: &'a Scale) -> &'a str {
        let chosen = scale.class.iter().find(|class| class.name == plan.class);
        let of_goal = || scale.class.get(scale.class_of(scale.of_nodes(self.goal(scale))));
        chosen.or_else(of_goal).map_or("", |class| class.name.as_str())
    }

    /// Returns the request for a plan.
    pub fn wanted_plan(&self, library: &Library) -> Asked {
        let (plan, choice) = (&self.plan, &self.choice);
        let scale = scale_for(library, &choice.kind, &plan.scale);
        let class = scale.map_or(String::new(), |scale| self.class_of_plan(plan, scale).to_owned());
        Asked {
            food: choice.kind.clone(),
            size_mm: choice.size_mm.iter().map(|mm| mm.round()).collect(),
            initial_c: choice.initial_c.round(),
            count: None,
            hob: choice.hob.clone(),
            pan: choice.pan.clone(),
            hob_w: plan.powers_w(choice.hob(library)),
            most_flips: if plan.plain { PLAIN_FLIPS } else { plan.most_flips.min(MOST_FLIPS) },
            plain: plan.plain,
            target: if plan.by_core || scale.is_none() { format!("core={:.0}", plan.core_c) } else { class },
            scale: scale.map_or(String::new(), |scale| scale.id.clone()),
            crust_pct: plan.crust_of(library, &choice.kind),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use saute_session::FoodChoice;

    #[test]
    fn what_is_requested_fits_the_food_whatever_was_chosen_for_another() {
        let library = Library::embedded().expect("embedded data");
        let of = |kind: &str| {
            let size_mm = library.foods[kind].size.default_mm.clone();
            let choice = FoodChoice { kind: kind.into(), size_mm, ..FoodChoice::default() };
            Settings { choice, ..Settings::default() }.wanted_plan(&library)
        };
        let targets = ["beef-lean", "shrimp", "beef-patty", "carrot-coin"].map(|kind| of(kind).target);
        assert_eq!(targets, ["medium", "opaque", "safe", "tender"]);
        assert_eq!([of("beef-lean").crust_pct, of("shrimp").crust_pct], [60.0, 0.0]);
        for kind in library.foods.keys() {
            assert!(of(kind).order(&library).is_ok(), "{kind}");
        }
    }
}
