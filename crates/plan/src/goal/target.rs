//! The goal of a cook: a class of doneness, or a temperature of the core, with a crust.

use std::collections::BTreeMap;
use std::str::FromStr;

use saute_kitchen::data::goals::{Counted, GoalDescription};
use saute_kitchen::food::Scale;
use saute_kitchen::food::change::doneness::{Class, Measure};
use saute_kitchen::food::description::Confidence;

/// A target as a person states it: `medium`, or `core=54`.
#[derive(Clone, Debug, PartialEq)]
pub enum Wish {
    /// A class of a scale.
    Class(String),
    /// Highest temperature of the core [°C].
    Core(f64),
}

/// Why a target cannot be used.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum TargetError {
    /// The temperature is no number or out of range.
    #[error("core={0} is not a temperature from {low} to {high} °C", low = CORE_C[0], high = CORE_C[1])]
    Temperature(String),
    /// The scale has no such class.
    #[error("the scale \"{scale}\" has no class \"{class}\"; there are: {known}")]
    NoSuchClass {
        /// Id of the scale.
        scale: String,
        /// What was requested.
        class: String,
        /// Its classes.
        known: String,
    },
}

/// Temperatures that may be the target of a core [°C] (chosen: from warmer than the refrigerator to below boiling).
const CORE_C: [f64; 2] = [30.0, 98.0];
/// Half of the band that counts as on target around a target temperature [K] (chosen: half of the narrowest class of the
/// chefs' scale).
const HALF_BAND_K: f64 = 2.5;
/// Largest miss of a target temperature [K] (chosen: what a good probe resolves).
const CORE_MISS_K: f64 = 1.0;
/// Charred share of the faces above which a cook is burnt where its goal does not state it [%] (chosen: some black edges are part of a
/// crust).
const BURNT_PCT: f64 = 5.0;
/// Aim inside a class, as a share of its width above the lower end [-], and its largest distance from that end [K or
/// points of %] (chosen: most of a section is in a class when the core has just passed its lower end; the margin is for what a
/// kitchen does differently).
const AIM_SHARE: f64 = 0.25;
const MOST_AIM_K: f64 = 1.5;
const MOST_AIM_PCT: f64 = 10.0;
/// Aim above the lower end of a class without an upper end, over the largest distance inside of the others [-] (chosen: the whole
/// section gets there, its edges too).
const OPEN_AIM: f64 = 3.0;

impl FromStr for Wish {
    type Err = TargetError;

    fn from_str(text: &str) -> Result<Self, TargetError> {
        let Some(number) = text.strip_prefix("core=") else { return Ok(Self::Class(text.to_owned())) };
        let wrong = || TargetError::Temperature(number.to_owned());
        let core: f64 = number.trim().parse().map_err(|_| wrong())?;
        if (CORE_C[0]..=CORE_C[1]).contains(&core) { Ok(Self::Core(core)) } else { Err(wrong()) }
    }
}

/// Full share of a goal that states none [%] (chosen: verified plans of steaks reach about half of the section).
const USUAL_FULL_PCT: f64 = 50.0;

/// What a cook is to give. Values of the core are in the unit of the scale [°C or %].
#[derive(Clone, Debug, PartialEq)]
pub struct Goal {
    /// The target in words: `medium`, `core 54 °C`.
    pub name: String,
    /// The same in other languages by their code.
    pub names: BTreeMap<String, String>,
    /// The scale that the target is a class of; for a temperature a separate one.
    pub scale: Scale,
    /// Index of the class.
    pub class: usize,
    /// Value of the core that is aimed at.
    pub aim: f64,
    /// Lowest and highest value of the core that meets the goal.
    pub core: [f64; 2],
    /// Target browned share of the faces [%].
    pub crust_pct: f64,
    /// What the share that counts is a share of.
    pub counts: Counted,
    /// True if the core must be in the class; otherwise only the share counts.
    pub core_counts: bool,
    /// Least target share [%].
    pub least_share_pct: f64,
    /// Share that a cook can reach who does it best [%]: it has full marks.
    pub full_share_pct: f64,
    /// Charred share of the faces above which the food is burnt [%].
    pub most_charred_pct: f64,
}

impl Goal {
    /// Returns the goal of a wish on a scale, with a crust [%].
    ///
    /// # Errors
    ///
    /// If the scale has no class of that name.
    pub fn new(wish: &Wish, scale: &Scale, crust_pct: f64) -> Result<Self, TargetError> {
        match wish {
            Wish::Core(core_c) => Ok(Self::of_core(*core_c, crust_pct)),
            Wish::Class(name) => Self::of_class(name, scale, crust_pct),
        }
    }

    /// Returns the goal of a description on a scale; the core of one that judges no core may be anything.
    ///
    /// # Errors
    ///
    /// If the scale has no class of the description's name.
    pub fn described(goal: &GoalDescription, scale: &Scale) -> Result<Self, TargetError> {
        let most_done = scale.class.last().map_or("", |class| class.name.as_str());
        let of_class = Self::of_class(goal.class.as_deref().unwrap_or(most_done), scale, goal.crust_pct)?;
        let anything = [f64::NEG_INFINITY, f64::INFINITY];
        Ok(Self {
            name: goal.name.clone(),
            names: goal.names.clone(),
            core: if goal.core_counts { of_class.core } else { anything },
            counts: goal.counts,
            core_counts: goal.core_counts,
            least_share_pct: goal.least_share_pct,
            full_share_pct: goal.full_share_pct.unwrap_or(USUAL_FULL_PCT),
            most_charred_pct: goal.most_charred_pct,
            ..of_class
        })
    }

    fn of_class(name: &str, scale: &Scale, crust_pct: f64) -> Result<Self, TargetError> {
        let Some(class) = scale.class.iter().position(|c| c.name == name) else {
            let known: Vec<&str> = scale.class.iter().map(|c| c.name.as_str()).collect();
            let (scale, class) = (scale.id.clone(), name.to_owned());
            return Err(TargetError::NoSuchClass { scale, class, known: known.join(", ") });
        };
        let core = [scale.from(class), scale.end(class).unwrap_or(f64::INFINITY)];
        let core = if class == 0 { [f64::NEG_INFINITY, core[1]] } else { core };
        let (name, scale, aim) = (name.to_owned(), scale.clone(), aim(scale, class));
        Ok(Self { core, ..Self::plain(name, scale, class, aim, crust_pct) })
    }

    fn of_core(core_c: f64, crust_pct: f64) -> Self {
        let class = |name: &str, from: f64| Class { name: name.to_owned(), from_c: Some(from), ..Class::default() };
        let (low, high) = (core_c - HALF_BAND_K, core_c + HALF_BAND_K);
        let scale = Scale {
            id: "core".to_owned(),
            name: format!("within {HALF_BAND_K} K of {core_c} °C"),
            names: BTreeMap::new(),
            class: vec![class("colder", 0.0), class("on target", low), class("hotter", high)],
            for_change: String::new(),
            for_kinetics: Vec::new(),
            of_second: false,
            is_of_one_food: false,
            goal: None,
            source: "the cook's".to_owned(),
            confidence: Confidence::High,
        };
        let core = [core_c - CORE_MISS_K, core_c + CORE_MISS_K];
        Self { core, ..Self::plain(format!("core {core_c} °C"), scale, 1, core_c, crust_pct) }
    }

    /// A goal whose core may be anything yet, and whose share any.
    fn plain(name: String, scale: Scale, class: usize, aim: f64, crust_pct: f64) -> Self {
        Self {
            name,
            names: BTreeMap::new(),
            scale,
            class,
            aim,
            core: [f64::NEG_INFINITY, f64::INFINITY],
            crust_pct,
            counts: Counted::Section,
            core_counts: true,
            least_share_pct: 0.0,
            full_share_pct: USUAL_FULL_PCT,
            most_charred_pct: BURNT_PCT,
        }
    }

    /// Returns true if a food can be done beyond the class.
    pub fn class_has_end(&self) -> bool {
        self.scale.end(self.class).is_some()
    }

    /// Returns the unit of the core's values.
    pub fn unit(&self) -> &'static str {
        match self.scale.measure() {
            Measure::Peak => "°C",
            Measure::Share => "%",
        }
    }

    /// Returns the distance of a value of the core from the band that meets the goal [K or points of %].
    pub fn miss(&self, at_core: f64) -> f64 {
        (self.core[0] - at_core).max(at_core - self.core[1]).max(0.0)
    }
}

/// Returns the value of the core to aim at: the scale's own goal if it is in the class, else a little inside of the end that is
/// reached first.
fn aim(scale: &Scale, class: usize) -> f64 {
    let (from, end) = (scale.from(class), scale.end(class));
    let most = if scale.measure() == Measure::Peak { MOST_AIM_K } else { MOST_AIM_PCT };
    if let Some(goal) = scale.goal.filter(|g| *g >= from && end.is_none_or(|end| *g < end)) {
        return goal;
    }
    match end {
        Some(end) if class == 0 => end - most,
        Some(end) => from + (AIM_SHARE * (end - from)).min(most),
        None => from + OPEN_AIM * most,
    }
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use saute_kitchen::Library;

    use super::*;

    fn goal(scale: &str, target: &str) -> Goal {
        let library = Library::embedded().unwrap();
        Goal::new(&target.parse().unwrap(), library.scale(scale).unwrap(), 60.0).unwrap()
    }

    #[test]
    fn the_aim_is_a_little_inside_of_the_class_or_the_goal_of_its_scale() {
        let aim = |scale, target| goal(scale, target).aim;
        assert_eq!([aim("chefs", "rare"), aim("chefs", "medium"), aim("chefs", "well-done")], [51.25, 61.5, 74.5]);
        assert_eq!(
            [aim("shrimp", "opaque"), aim("ground-beef", "safe"), aim("vegetables", "tender")],
            [63.0, 73.0, 50.0]
        );
        assert_eq!([aim("chefs", "raw"), aim("chefs", "core=54")], [48.5, 54.0]);
    }

    #[test]
    fn a_core_meets_its_class_between_its_ends_and_a_temperature_within_a_kelvin() {
        let medium = goal("chefs", "medium");
        assert_eq!([59.0, 60.0, 69.0, 73.5].map(|c| medium.miss(c)), [1.0, 0.0, 0.0, 3.5]);
        assert_eq!(goal("chefs", "well-done").miss(90.0), 0.0);
        let core = goal("chefs", "core=54");
        assert_eq!([52.0, 54.9, 56.0].map(|c| (10.0 * core.miss(c)).round()), [10.0, 0.0, 10.0]);
    }

    #[test]
    fn every_goal_of_the_data_is_a_goal_on_each_scale_that_has_its_class() {
        let library = Library::embedded().unwrap();
        for described in &library.goals {
            let scales: Vec<_> = library.scales.iter().filter(|scale| described.is_on(scale)).collect();
            assert!(!scales.is_empty(), "{}", described.id);
            for scale in scales {
                let goal = Goal::described(described, scale).unwrap();
                assert_eq!((goal.crust_pct, goal.counts), (described.crust_pct, described.counts));
                assert_eq!(goal.core[0].is_finite() || goal.core[1].is_finite(), described.core_counts);
            }
        }
        let of_2013 =
            Goal::described(library.goal("study-2013").unwrap(), library.scale("paper-2013").unwrap()).unwrap();
        assert_eq!((of_2013.scale.class[of_2013.class].name.as_str(), of_2013.least_share_pct), ("medium", 40.0));
        assert!(Goal::described(library.goal("medium-rare").unwrap(), library.scale("paper-2013").unwrap()).is_err());
    }

    #[test]
    fn targets_that_mean_nothing_are_refused_with_what_there_is() {
        assert!("core=hot".parse::<Wish>().is_err() && "core=120".parse::<Wish>().is_err());
        let library = Library::embedded().unwrap();
        let wrong = Goal::new(&"pink".parse().unwrap(), library.scale("chefs").unwrap(), 0.0).unwrap_err();
        assert!(wrong.to_string().contains("raw, rare, medium-rare, medium, well-done"), "{wrong}");
    }
}
