//! Reading remembered settings: a value that cannot be read costs no other.

use std::ops::RangeInclusive;

use serde_json::{Map, Value};

use super::Settings;
use saute_kitchen::PieceOrder;
use saute_mirror::rig::MARKS;
use saute_mirror::settings::WIDEST_MM;
use saute_words::language::Language;

impl Settings {
    /// Settings from JSON, and true if some of it could not be read. Where none was ever chosen the language is that of the system.
    pub fn remembered(text: &str, of_system: Language) -> (Self, bool) {
        let Ok(stored) = serde_json::from_str::<Value>(text) else { return (Self::default(), true) };
        let parse = |value: &Value| serde_json::from_value::<Self>(value.clone()).ok();
        let read = |value: &Value| parse(value).filter(Self::is_within_ranges);
        let kept = fitting(stored.clone(), &|value| read(value).is_some());
        let refused = kept != stored;
        let language = |chosen: Language| if kept.get("language").is_some() { chosen } else { of_system };
        let known = |settings: Self| Self { language: language(settings.language), ..settings.up_to_date() };
        read(&kept).map_or_else(|| (Self::default(), true), |settings| (known(settings), refused))
    }
}

impl Settings {
    /// Returns true of what is stored before a window has kept its settings: at most the language that a page was opened in.
    pub fn were_never_kept(text: &str) -> bool {
        serde_json::from_str::<Value>(text).is_ok_and(|stored| stored.get("version").is_none())
    }
}

/// Speeds of the clock [-] (chosen: the window offers 1 to 20).
const SPEED: RangeInclusive<f64> = 0.01..=1000.0;
/// Goals for the core [°C or %], and temperatures of the pan and of the food [°C] (chosen: as in recipes).
const GOAL: RangeInclusive<f64> = 0.0..=300.0;
/// Dimensions of a food [mm], as in its files.
const SIZE_MM: RangeInclusive<f64> = 2.0..=300.0;
/// Longest text of a kitchen at home [bytes] (chosen: ten times that of a fit).
const LONGEST_KITCHEN: usize = 4096;
/// Places of calibrated marks, in shares of the projector's picture [-] (chosen: far outside it).
const SHARE: RangeInclusive<f64> = -10.0..=10.0;

impl Settings {
    /// Returns true if every number is finite and within its range.
    fn is_within_ranges(&self) -> bool {
        let (choice, mirror) = (&self.choice, &self.mirror);
        let moved = mirror.calibrations.values().flat_map(|c| c.moved.iter());
        SPEED.contains(&self.speed)
            && self.marks.values().flatten().all(|mark| (0.0..=100.0).contains(mark))
            && (0.0..=1.0).contains(&self.volume)
            && self.held_speed.is_none_or(|held| SPEED.contains(&held))
            && self.goals.values().chain([&self.goal_c]).all(|goal| GOAL.contains(goal))
            && GOAL.contains(&self.plan.core_c)
            && self.kitchen.as_ref().is_none_or(|kitchen| kitchen.text.len() < LONGEST_KITCHEN)
            && self.plan.crust_pct.is_none_or(|pct| (0.0..=100.0).contains(&pct))
            && self.plan.most_flips <= crate::settings::plan_choice::MOST_FLIPS
            && GOAL.contains(&choice.preheat_c)
            && (PieceOrder::INITIAL_C[0]..=PieceOrder::INITIAL_C[1]).contains(&choice.initial_c)
            && choice.size_mm.iter().all(|mm| SIZE_MM.contains(mm))
            && mirror.eye_distance_mm.is_none_or(|mm| (0.0..=WIDEST_MM).contains(&mm))
            && { moved }.all(|(mark, at)| *mark < MARKS && at.iter().all(|share| SHARE.contains(share)))
    }
}

/// As much of a value as fits: all of it, else those of its entries that do, and of them as much as fits.
fn fitting(value: Value, fits: &dyn Fn(&Value) -> bool) -> Value {
    match value {
        Value::Object(entries) if !fits(&Value::Object(entries.clone())) => {
            let mut kept = Map::new();
            for (key, entry) in entries {
                let with = |entry: &Value| {
                    let mut all = kept.clone();
                    all.insert(key.clone(), entry.clone());
                    fits(&Value::Object(all))
                };
                let entry = fitting(entry, &with);
                if with(&entry) {
                    kept.insert(key, entry);
                }
            }
            Value::Object(kept)
        }
        all => all,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_value_that_cannot_be_read_costs_no_other() {
        let text = r#"{"fahrenheit":true,"theme":"plaid","mirror":{"projector":"ceiling","stereo":"holo",
            "calibrations":{"ceiling":{"moved":{"0":[0.1,0.2]}},"wall":{"moved":7}}}}"#;
        let (settings, refused) = Settings::remembered(text, Language::ENGLISH);
        assert!(refused && settings.fahrenheit && settings.theme == Default::default());
        assert_eq!(settings.mirror.projector, "ceiling");
        assert_eq!(settings.mirror.calibration().moved[&0], [0.1, 0.2]);
        assert!(!settings.mirror.calibrations.contains_key("wall"));
    }

    #[test]
    fn a_number_out_of_its_range_costs_no_other_value() {
        let wild = r#"{"fahrenheit":true,"speed":1e308,"volume":7,"goal_c":-1e9,"goals":{"chefs":1e300,"shrimp":63.0},
            "choice":{"kind":"shrimp","size_mm":[75.0,1e99],"initial_c":1e9},
            "mirror":{"eye_distance_mm":1e9,"calibrations":{"ceiling":{"moved":{"0":[1e99,0.2],"1":[0.1,0.2],"99":[0.0,0.0]}}}}}"#;
        let (settings, refused) = Settings::remembered(wild, Language::ENGLISH);
        assert!(refused && settings.fahrenheit && settings.is_within_ranges());
        assert_eq!((settings.speed, settings.volume), (1.0, 0.5));
        assert_eq!((settings.goals.len(), settings.goals["shrimp"]), (1, 63.0));
        assert_eq!((settings.choice.kind.as_str(), settings.choice.initial_c), ("shrimp", 5.0));
        assert_eq!(settings.mirror.calibrations["ceiling"].moved.len(), 1);
    }

    #[test]
    fn a_goal_that_was_never_chosen_is_the_present_first_one() {
        let goal = |text: &str| Settings::remembered(text, Language::ENGLISH).0.goal_c;
        assert_eq!(goal(r#"{"goal_c":60.0}"#), 62.0);
        assert_eq!(goal(r#"{"goal_c":58.0}"#), 58.0);
        assert_eq!(goal(r#"{"goal_c":60.0,"version":1}"#), 60.0, "it was chosen");
        assert_eq!(Settings::remembered("{}", Language::ENGLISH).0, Settings::default());
    }

    #[test]
    fn what_can_be_read_is_read_as_it_is() {
        let settings = Settings { fahrenheit: true, speed: 5.0, ..Settings::default() };
        let text = serde_json::to_string(&settings).expect("is written");
        assert_eq!(Settings::remembered(&text, Language::ENGLISH), (settings, false));
        assert!(!Settings::remembered("{}", Language::ENGLISH).1);
        assert_eq!(Settings::remembered("not JSON", Language::ENGLISH), (Settings::default(), true));
    }

    #[test]
    fn the_language_is_that_of_the_system_until_one_is_chosen() {
        let japanese = Language::of_code("ja").expect("is shipped");
        let language = |text: &str| Settings::remembered(text, japanese).0.language;
        assert_eq!(language("{}"), japanese);
        assert_eq!(language(r#"{"language":"en"}"#), Language::ENGLISH);
        assert_eq!(language(r#"{"language":"none"}"#), japanese, "what cannot be read was not chosen");
    }
}
