//! How good a cook is: one number for comparing, and what is missing to the goal.
//!
//! score = share − 1 · missing crust − 1 · charred − 5 · miss of the core − 0.5 · |core − aim| − 0.1 · mass loss − 0.5 · heat above 295 °C
//! − 0.1 · flips
//!
//! | term | unit | meaning |
//! |---|---|---|
//! | share | % | of the section in the class of the goal; for a goal of the faces, of them that is browned |
//! | missing crust | points of % | how much less than the goal of the faces is browned, on the face with less of it |
//! | charred | % | of the faces |
//! | miss of the core | K (points of %: a fifth of the weight) | distance from the band that meets the goal |
//! | core − aim | the same | distance from the value that is aimed at |
//! | mass loss | % | |
//! | heat above 295 °C | K | of the hottest place of the pan; oils flash at 310–320 °C, and a hob may give 10 % more than it states |
//! | flips | number | work of the hand |
//!
//! A goal that judges no core has no miss of it and no aim.
//!
//! A cook that passes the flash point of its oil scores 100 points less. The weights are chosen: the share counts first, a core
//! that misses its class by 2 K outweighs ten points of it, and juice and work decide between cooks that are otherwise equal.

use core::fmt;

use saute_kitchen::food::change::doneness::Measure;
use serde::{Deserialize, Serialize};

use crate::goal::{Goal, Outcome};

/// Weights of the formula, in points per unit (chosen, see above).
const CRUST: f64 = 1.0;
const CHARRED: f64 = 1.0;
const MISS: f64 = 5.0;
const OFF_AIM: f64 = 0.5;
const LOST: f64 = 0.1;
const HOT: f64 = 0.5;
/// Temperature of the hottest place of a pan that no cook should pass [°C]: oils flash at 310–320 °C, and a hob may give 10 % more than it
/// states. Above it the window warns of danger, whatever a plan states.
pub const HOT_C: f64 = 295.0;
const FLIP: f64 = 0.1;
const FIRE: f64 = 100.0;
/// Points of a share that weigh as much as a kelvin [-] (chosen: 5 °C and 25 % are each half of a class).
pub(crate) const PCT_PER_K: f64 = 5.0;

/// How good a cook is [points]; the highest possible value is 100.
#[derive(Clone, Copy, Debug, Deserialize, PartialEq, PartialOrd, Serialize)]
pub struct Score(pub f64);

/// What is missing to a goal.
#[derive(Clone, Copy, Debug, Deserialize, PartialEq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Shortfall {
    /// The core stays below the class.
    Undercooked,
    /// The core passes the class.
    Overcooked,
    /// Too little of the section is in the class, or of the faces browned.
    Share,
    /// Too little of a face is browned.
    Crust,
    /// Too much of the faces is charred.
    Burnt,
    /// The oil passes its flash point.
    Fire,
}

impl Score {
    /// Scores an outcome of a cook with a number of flips against a goal.
    pub fn of(outcome: &Outcome, flips: usize, goal: &Goal) -> Self {
        Self::sum(&Term::all(outcome, flips, goal))
    }

    /// Adds up the terms of the formula.
    pub fn sum(terms: &[Term]) -> Self {
        Self(terms.iter().map(Term::points).sum())
    }
}

/// What a term of the formula counts.
#[derive(Clone, Copy, Debug, Deserialize, Eq, PartialEq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum TermKind {
    /// Share of the section in the class of the goal, or of the faces that is browned [%].
    Share,
    /// Missing crust of the paler face [points of %].
    MissingCrust,
    /// Charred share of the faces [%].
    Charred,
    /// Distance of the core from the band that meets the goal [K].
    CoreMiss,
    /// Distance of the core from the value that is aimed at [K].
    OffAim,
    /// Mass loss [%].
    Lost,
    /// Heat of the pan above the bound of the formula [K].
    Hot,
    /// Flips [-].
    Flips,
    /// Oil past its flash point [-].
    Fire,
}

/// A term of the formula: value × weight = points.
#[derive(Clone, Copy, Debug, Deserialize, PartialEq, Serialize)]
pub struct Term {
    /// What it counts.
    pub kind: TermKind,
    /// The value, in the unit of the kind; a change counts in fifths of a point of %, as kelvins.
    pub value: f64,
    /// Points per unit.
    pub weight: f64,
}

impl Term {
    /// Returns all terms of the formula, in its order.
    pub fn all(outcome: &Outcome, flips: usize, goal: &Goal) -> [Self; 9] {
        let in_k = if goal.scale.measure() == Measure::Peak { 1.0 } else { 1.0 / PCT_PER_K };
        let missing = (goal.crust_pct - outcome.least_crust_pct).max(0.0);
        let off_aim = if goal.core_counts { (outcome.at_core - goal.aim).abs() } else { 0.0 };
        let term = |kind, value, weight| Self { kind, value, weight };
        [
            term(TermKind::Share, outcome.target_share_pct, 1.0),
            term(TermKind::MissingCrust, missing, -CRUST),
            term(TermKind::Charred, outcome.charred_pct, -CHARRED),
            term(TermKind::CoreMiss, in_k * goal.miss(outcome.at_core), -MISS),
            term(TermKind::OffAim, in_k * off_aim, -OFF_AIM),
            term(TermKind::Lost, outcome.lost_pct, -LOST),
            term(TermKind::Hot, (outcome.hottest_c - HOT_C).max(0.0), -HOT),
            term(TermKind::Flips, flips as f64, -FLIP),
            term(TermKind::Fire, f64::from(u8::from(outcome.fire_hazard)), -FIRE),
        ]
    }

    /// Returns what it adds to the score [points].
    pub fn points(&self) -> f64 {
        self.value * self.weight
    }
}

impl Shortfall {
    /// Returns everything that is missing in an outcome; nothing if it meets the goal.
    pub fn of(outcome: &Outcome, goal: &Goal) -> Vec<Self> {
        let cases = [
            (Self::Undercooked, outcome.at_core < goal.core[0]),
            (Self::Overcooked, outcome.at_core > goal.core[1]),
            (Self::Share, outcome.target_share_pct < goal.least_share_pct),
            (Self::Crust, outcome.least_crust_pct < goal.crust_pct),
            (Self::Burnt, outcome.charred_pct > goal.most_charred_pct),
            (Self::Fire, outcome.fire_hazard),
        ];
        cases.into_iter().filter(|(_, is_missing)| *is_missing).map(|(shortfall, _)| shortfall).collect()
    }

    /// Returns the shortfall of an outcome in English.
    pub fn words(self, outcome: &Outcome, goal: &Goal) -> String {
        let (core, unit, [low, high]) = (outcome.at_core, goal.unit(), goal.core);
        match self {
            Self::Undercooked => format!("the core reaches {core:.1} {unit} of at least {low} {unit}"),
            Self::Overcooked => format!("the core reaches {core:.1} {unit} of at most {high} {unit}"),
            Self::Share => {
                let (share, wanted) = (outcome.target_share_pct, goal.least_share_pct);
                format!("{share:.0} % is as wanted of at least {wanted} %")
            }
            Self::Crust => {
                let (least, wanted) = (outcome.least_crust_pct, goal.crust_pct);
                format!("{least:.0} % of the paler face is browned of {wanted:.0} % wanted")
            }
            Self::Burnt => format!("{:.0} % of the faces is charred", outcome.charred_pct),
            Self::Fire => "the oil passes its flash point".to_owned(),
        }
    }
}

impl fmt::Display for Score {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        write!(f, "{:.1}", self.0)
    }
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use saute_kitchen::Library;

    use super::*;

    fn medium() -> Goal {
        Goal::new(&"medium".parse().unwrap(), Library::embedded().unwrap().scale("chefs").unwrap(), 60.0).unwrap()
    }

    fn on_target() -> Outcome {
        let (core_peak_c, at_core) = (61.5, 61.5);
        Outcome {
            core_peak_c,
            at_core,
            target_share_pct: 70.0,
            least_crust_pct: 90.0,
            lost_pct: 15.0,
            ..Outcome::default()
        }
    }

    #[test]
    fn the_score_is_the_formula_on_its_page() {
        let of = |outcome: Outcome| Score::of(&outcome, 5, &medium()).0;
        assert!((of(on_target()) - (70.0 - 1.5 - 0.5)).abs() < 1e-9);
        assert!((of(Outcome { at_core: 57.5, ..on_target() }) - (68.0 - 12.5 - 2.0)).abs() < 1e-9);
        assert!(
            (of(Outcome { least_crust_pct: 40.0, charred_pct: 3.0, ..on_target() }) - (68.0 - 20.0 - 3.0)).abs() < 1e-9
        );
        assert!((of(Outcome { fire_hazard: true, hottest_c: 311.0, ..on_target() }) + 32.0 + 8.0).abs() < 1e-9);
    }

    #[test]
    fn the_terms_of_the_formula_add_up_to_the_score_and_a_goal_without_a_core_has_none_of_it() {
        let outcome = Outcome { at_core: 57.5, charred_pct: 3.0, least_crust_pct: 40.0, ..on_target() };
        let terms = Term::all(&outcome, 5, &medium());
        assert_eq!(Score::sum(&terms), Score::of(&outcome, 5, &medium()));
        let points = |kind| terms.iter().find(|term| term.kind == kind).unwrap().points();
        assert_eq!([points(TermKind::MissingCrust), points(TermKind::CoreMiss)], [-20.0, -12.5]);
        let anything = Goal { core: [f64::NEG_INFINITY, f64::INFINITY], core_counts: false, ..medium() };
        assert!((Score::of(&outcome, 5, &anything).0 - Score::sum(&terms).0 - 14.5).abs() < 1e-9);
    }

    #[test]
    fn a_shortfall_is_named_and_a_cook_on_target_has_none() {
        assert_eq!(Shortfall::of(&on_target(), &medium()), []);
        let pale_and_rare = Outcome { at_core: 55.0, least_crust_pct: 10.0, ..on_target() };
        let missing = Shortfall::of(&pale_and_rare, &medium());
        assert_eq!(missing, [Shortfall::Undercooked, Shortfall::Crust]);
        assert!(missing[1].words(&pale_and_rare, &medium()).contains("10 % of the paler face"));
    }
}
