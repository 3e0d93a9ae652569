//! How well a cook went, as it is shown to a person: 0 to 100. (The [score](crate::goal::score) is what plans are searched by; it has no
//! lower end and is shown to nobody.)
//!
//! mark = 30·core + 40·even + 20·crust + 10·care, each part between 0 and 1:
//!
//! | part | is |
//! |---|---|
//! | core | 1 − miss / 8 K, the distance of the core from the band that meets the goal; of a change, 5 points of % are 1 K |
//! | even | the share that counts over the full share of the goal, which verified plans reach |
//! | crust | browned share of the paler face over the goal, times 1 − (charred beyond what may be) / 20 % |
//! | care | (310 °C − hottest place of the pan) / 40 K: oils flash at 310–320 °C |
//!
//! What a goal does not judge gives its weight to *even*. A goal that is met has at least 80, one that is missed at most 79, a
//! fire at most 39. The weights are chosen: they order cooks as the goals are missed, the core before the crust.

use saute_kitchen::food::change::doneness::Measure;

use crate::goal::score::PCT_PER_K;
use crate::goal::{Goal, Outcome, Shortfall};

/// Weights of the parts [points] (chosen, see above).
const CORE: f64 = 30.0;
const EVEN: f64 = 40.0;
const CRUST: f64 = 20.0;
const CARE: f64 = 10.0;
/// Miss of the core at which nothing is left of its part [K] (chosen: most of a class).
const MISS_K: f64 = 8.0;
/// Char beyond what may be at which nothing is left of the crust [points of %] (chosen).
const CHAR_PCT: f64 = 20.0;
/// Temperature of the pan at which no care was taken, and how far below it all was [°C, K] (chosen: the flash points of oils).
const CARELESS_C: f64 = 310.0;
const CARE_K: f64 = 40.0;
/// Least mark of a goal that is met, and most of one that is missed and of a cook with a fire [points] (chosen).
const MET: f64 = 80.0;
const MISSED: f64 = 79.0;
const BURNT_DOWN: f64 = 39.0;
/// Mark from which a cook is nearly right [points] (chosen).
const NEARLY: f64 = 60.0;

/// What a part of a mark is for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Part {
    /// The core.
    Core,
    /// The share that counts.
    Even,
    /// Crust, and no char.
    Crust,
    /// The pan stays below the flash points of oils.
    Care,
}

/// What limits a mark, whatever its parts.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Bound {
    /// The goal is met.
    Met,
    /// It is missed.
    Missed,
    /// The oil could burn.
    Fire,
}

/// A mark in one of three grades.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Grade {
    /// From 80 points.
    JustRight,
    /// From 60 points.
    Nearly,
    /// Below.
    NotYet,
}

/// The mark of a cook.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Mark {
    /// The parts: what for, how much of it is reached [-], and its weight [points].
    pub parts: [(Part, f64, f64); 4],
    /// What limits the sum.
    pub bound: Bound,
}

impl Mark {
    /// Marks an outcome by a goal.
    pub fn of(outcome: &Outcome, goal: &Goal) -> Self {
        let in_k = if goal.scale.measure() == Measure::Peak { 1.0 } else { 1.0 / PCT_PER_K };
        let core = 1.0 - in_k * goal.miss(outcome.at_core) / MISS_K;
        let even = outcome.target_share_pct / goal.full_share_pct;
        let browned = (outcome.least_crust_pct / goal.crust_pct).clamp(0.0, 1.0);
        let crust = browned * (1.0 - ((outcome.charred_pct - goal.most_charred_pct).max(0.0) / CHAR_PCT).min(1.0));
        let care = (CARELESS_C - outcome.hottest_c) / CARE_K;
        let core_weight = if goal.core_counts { CORE } else { 0.0 };
        let crust_weight = if goal.crust_pct > 0.0 { CRUST } else { 0.0 };
        let even_weight = EVEN + (CORE - core_weight) + (CRUST - crust_weight);
        let part =
            |part, reached: f64, weight| (part, if weight > 0.0 { reached.clamp(0.0, 1.0) } else { 0.0 }, weight);
        let bound = match outcome.fire_hazard {
            true => Bound::Fire,
            false if Shortfall::of(outcome, goal).is_empty() => Bound::Met,
            false => Bound::Missed,
        };
        Self {
            parts: [
                part(Part::Core, core, core_weight),
                part(Part::Even, even, even_weight),
                part(Part::Crust, crust, crust_weight),
                part(Part::Care, care, CARE),
            ],
            bound,
        }
    }

    /// Returns the sum of the parts [points].
    pub fn sum(&self) -> f64 {
        self.parts.iter().map(|(_, reached, weight)| reached * weight).sum()
    }

    /// Returns the mark [points]: the sum within its bound.
    pub fn points(&self) -> f64 {
        match self.bound {
            Bound::Met => self.sum().max(MET),
            Bound::Missed => self.sum().min(MISSED),
            Bound::Fire => self.sum().min(BURNT_DOWN),
        }
    }

    /// Returns the grade of the mark.
    pub fn grade(&self) -> Grade {
        match self.points() {
            points if points >= MET => Grade::JustRight,
            points if points >= NEARLY => Grade::Nearly,
            _ => Grade::NotYet,
        }
    }
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use saute_kitchen::Library;
    use saute_kitchen::food::tissue::noise::uniform;

    use super::*;

    fn medium() -> Goal {
        let library = Library::embedded().unwrap();
        Goal::described(library.goal("medium").unwrap(), library.scale("chefs").unwrap()).unwrap()
    }

    fn good() -> Outcome {
        Outcome { at_core: 62.0, target_share_pct: 50.0, least_crust_pct: 80.0, hottest_c: 250.0, ..Outcome::default() }
    }

    fn random(draw: u64) -> Outcome {
        let between = |index: u64, low: f64, high: f64| low + (high - low) * uniform(draw, index);
        Outcome {
            at_core: between(0, 0.0, 100.0),
            target_share_pct: between(1, 0.0, 100.0),
            least_crust_pct: between(2, 0.0, 100.0),
            charred_pct: between(3, 0.0, 100.0),
            hottest_c: between(4, 20.0, 420.0),
            fire_hazard: uniform(draw, 5) < 0.1,
            ..Outcome::default()
        }
    }

    #[test]
    fn a_perfect_cook_has_all_points_and_one_that_is_only_hot_or_raw_few() {
        assert!((Mark::of(&good(), &medium()).points() - 100.0).abs() < 1e-9);
        let raw = Outcome { at_core: 25.0, target_share_pct: 2.0, ..good() };
        assert!(Mark::of(&raw, &medium()).points() <= 35.0);
        let fire = Outcome { fire_hazard: true, ..good() };
        assert_eq!((Mark::of(&fire, &medium()).points(), Mark::of(&fire, &medium()).grade()), (39.0, Grade::NotYet));
        let nearly = Outcome { at_core: 59.0, ..good() };
        assert_eq!(
            (Mark::of(&nearly, &medium()).points(), Mark::of(&nearly, &medium()).grade()),
            (79.0, Grade::Nearly)
        );
        // What just meets the goal is just right.
        let just = Outcome { target_share_pct: 30.0, least_crust_pct: 60.0, hottest_c: 300.0, ..good() };
        assert_eq!((Mark::of(&just, &medium()).points(), Mark::of(&just, &medium()).grade()), (80.0, Grade::JustRight));
    }

    #[test]
    fn what_a_goal_does_not_judge_gives_its_weight_to_the_share() {
        let goal = Goal { core_counts: false, crust_pct: 0.0, ..medium() };
        let mark = Mark::of(&Outcome { at_core: 20.0, least_crust_pct: 0.0, ..good() }, &goal);
        assert_eq!(mark.parts.map(|(_, _, weight)| weight), [0.0, 90.0, 0.0, 10.0]);
        assert!((mark.sum() - 100.0).abs() < 1e-9);
    }

    #[test]
    fn ten_thousand_marks_lie_between_0_and_100_and_nothing_worse_raises_one() {
        let goal = medium();
        for draw in 0..10_000 {
            let outcome = random(draw);
            let points = Mark::of(&outcome, &goal).points();
            assert!((0.0..=100.0).contains(&points), "{outcome:?}");
            let further = if outcome.at_core < goal.core[0] { -3.0 } else { 3.0 };
            let worse = [
                Outcome { at_core: outcome.at_core + further, ..outcome },
                Outcome { target_share_pct: 0.7 * outcome.target_share_pct, ..outcome },
                Outcome { least_crust_pct: 0.7 * outcome.least_crust_pct, ..outcome },
                Outcome { charred_pct: outcome.charred_pct + 4.0, ..outcome },
                Outcome { hottest_c: outcome.hottest_c + 9.0, ..outcome },
                Outcome { fire_hazard: true, ..outcome },
            ];
            for one in worse {
                assert!(Mark::of(&one, &goal).points() <= points + 1e-9, "{one:?} after {outcome:?}");
            }
        }
    }
}
