//! The texts of the window: both languages contain every text, and no text is shown that no file contains.

use std::collections::{BTreeMap, BTreeSet};
use std::path::Path;

use saute_kitchen::{Library, Refused};
use saute_recipe::Recipe;
use saute_words::language::Language;

type Texts = BTreeMap<String, BTreeMap<String, String>>;

/// Sections of names that come from the core's data: found by the English text, not by a key in the code.
const NAMES: [&str; 17] = [
    "id",
    "pan",
    "stove",
    "recipe",
    "recipe_file",
    "range",
    "scale",
    "class",
    "change",
    "dimension",
    "amount",
    "oil",
    "event",
    "deed",
    "button",
    "goal",
    "rig",
];

fn texts(l: Language) -> Texts {
    toml::from_str(l.file()).unwrap_or_else(|e| panic!("{l:?}: {e}"))
}

fn keys(texts: &Texts) -> BTreeSet<String> {
    texts.iter().flat_map(|(section, keys)| keys.keys().map(move |key| format!("{section}.{key}"))).collect()
}

/// The placeholders of a text, in alphabetical order.
fn open(text: &str) -> Vec<&str> {
    let mut open: Vec<&str> = text.split('{').skip(1).filter_map(|rest| rest.split('}').next()).collect();
    open.sort_unstable();
    open.dedup();
    open
}

#[test]
fn no_key_is_missing_in_one_language() {
    let [english, japanese] = [Language::ENGLISH, crate::harness::japanese()].map(|l| keys(&texts(l)));
    let differ: Vec<_> = english.symmetric_difference(&japanese).collect();
    assert!(differ.is_empty() && english.len() > 250, "{differ:?}");
}

#[test]
fn both_languages_leave_the_same_things_open() {
    let [english, japanese] = [Language::ENGLISH, crate::harness::japanese()].map(texts);
    for (section, keys) in &english {
        for (key, text) in keys {
            // A language may repeat a placeholder; it may not omit or add one.
            assert_eq!(open(text), open(&japanese[section][key]), "{section}.{key}");
        }
    }
}

/// Every `"section.key"` in the sources.
fn used(sections: &BTreeSet<String>) -> BTreeSet<String> {
    fn sources(folder: &Path, all: &mut String) {
        for entry in std::fs::read_dir(folder).expect("reads").flatten() {
            if entry.path().is_dir() {
                sources(&entry.path(), all);
            } else if entry.path().extension().is_some_and(|e| e == "rs") {
                all.push_str(&std::fs::read_to_string(entry.path()).expect("reads"));
            }
        }
    }
    let mut all = String::new();
    for crate_of in ["picture", "session", "window", "controls", "words"] {
        sources(&Path::new(env!("CARGO_MANIFEST_DIR")).join("..").join(crate_of).join("src"), &mut all);
    }
    let is_key = |s: &&str| {
        let letters =
            |t: &str| !t.is_empty() && t.chars().all(|c| c.is_ascii_lowercase() || c.is_ascii_digit() || c == '_');
        s.split_once('.').is_some_and(|(a, b)| sections.contains(a) && letters(b) && !["toml", "wgsl"].contains(&b))
    };
    all.split('"').filter(is_key).map(str::to_owned).collect()
}

#[test]
fn every_key_in_the_code_has_a_text_and_every_text_is_used() {
    let english = texts(Language::ENGLISH);
    let (known, used) = (keys(&english), used(&english.keys().cloned().collect()));
    let missing: Vec<_> = used.difference(&known).collect();
    assert!(missing.is_empty(), "no text for {missing:?}");
    let idle: Vec<_> =
        known.difference(&used).filter(|key| !NAMES.contains(&key.split('.').next().unwrap_or(""))).collect();
    assert!(idle.is_empty(), "nothing uses {idle:?}");
}

#[test]
fn every_name_in_the_data_has_a_japanese_one() {
    let library = Library::embedded().expect("embedded data");
    let same = ["AMSA / USDA"];
    let known = |section: &str, name: &str| {
        assert!(same.contains(&name) || crate::harness::japanese().called(section, name) != name, "{section}: {name}");
        assert_eq!(Language::ENGLISH.called(section, name), name);
    };
    for (id, food) in &library.foods {
        let words = food.words.get("ja").unwrap_or_else(|| panic!("{id}: no Japanese"));
        assert!(words.name.as_ref().is_some_and(|name| *name != food.name) && words.noun.is_some(), "{id}");
        assert!(food.words["en"].noun.is_some() && food.name_in("en") == food.name, "{id}");
        food.form.dimensions().iter().for_each(|name| known("dimension", name));
    }
    library.oils.keys().for_each(|id| known("oil", id));
    library.pans.values().for_each(|pan| known("pan", &pan.name));
    library.hobs.values().for_each(|hob| known("stove", &hob.name));
    for (id, _) in saute_mirror::rig_file::SHIPPED {
        known("rig", id);
        known("rig", &saute_mirror::rig_file::shipped(id).expect("is there").expect("is read").name);
    }
    for scale in &library.scales {
        if !scale.names.contains_key("ja") {
            known("scale", &scale.name);
        }
        scale
            .class
            .iter()
            .filter(|class| !class.names.contains_key("ja"))
            .for_each(|class| known("class", &class.name));
    }
    let goals = library.goals.iter().filter(|goal| !goal.names.contains_key("ja"));
    goals.for_each(|goal| known("goal", &goal.name));
    for (id, text) in &library.recipes {
        known("recipe_file", &id.replace('-', " "));
        known("recipe", &Recipe::parse(text, id, &library).expect("parses").title);
    }
}

/// One of each; a new kind of refusal does not compile until it is here.
fn refusals() -> Vec<Refused> {
    let (food, other) = (|| "steak".to_owned(), || "carrots-2".to_owned());
    let next = |refused: &Refused| match refused {
        Refused::NoSuchFood(_) => Some(Refused::NotInPan(food())),
        Refused::NotInPan(_) => Some(Refused::NotOnBoard(food())),
        Refused::NotOnBoard(_) => Some(Refused::AlreadyHalved(food())),
        Refused::AlreadyHalved(_) => Some(Refused::BesideFood { food: food(), most_mm: 30 }),
        Refused::BesideFood { .. } => Some(Refused::AlreadyInPan(other())),
        Refused::AlreadyInPan(_) => Some(Refused::DoesNotFit { food: food(), reach_mm: 140, floor_mm: 105 }),
        Refused::DoesNotFit { .. } => Some(Refused::Occupied { food: food(), other: other() }),
        Refused::Occupied { .. } => Some(Refused::Waiting(food())),
        Refused::Waiting(_) => Some(Refused::StillRuns(food())),
        Refused::StillRuns(_) => Some(Refused::TooLittleFat { least_g: 4 }),
        Refused::TooLittleFat { .. } => Some(Refused::EmptyPan),
        Refused::EmptyPan => Some(Refused::PanPlace { farthest_mm: 400 }),
        Refused::PanPlace { .. } => Some(Refused::Power { largest_w: 3500 }),
        Refused::Power { .. } => Some(Refused::NoSensor),
        Refused::NoSensor => Some(Refused::FoodToWipe(food())),
        Refused::FoodToWipe(_) => Some(Refused::HoldTemperature { lowest_c: 50, highest_c: 230 }),
        Refused::HoldTemperature { .. } => {
            Some(Refused::NoSuchOil { kind: "butter".into(), known: "olive, clarified-butter".into() })
        }
        Refused::NoSuchOil { .. } => Some(Refused::Amount { what: "oil", holds_g: 900 }),
        Refused::Amount { .. } => Some(Refused::LidIsOn),
        Refused::LidIsOn => Some(Refused::Range { key: "toss.height_mm", low: "50".into(), high: "500".into() }),
        Refused::Range { .. } => Some(Refused::NoPose),
        Refused::NoPose => None,
    };
    std::iter::successors(Some(Refused::NoSuchFood(food())), next).collect()
}

#[test]
fn refusals_in_japanese_hold_no_english_but_units() {
    let library = Library::embedded().expect("embedded data");
    for refused in refusals() {
        let words = saute_words::refusal::words(&refused, &library, crate::harness::japanese());
        let latin = words.split(|c: char| !c.is_ascii_alphabetic()).filter(|w| !w.is_empty());
        let english: Vec<&str> = latin.filter(|w| !["mm", "g", "W", "C"].contains(w)).collect();
        assert!(english.is_empty() && !words.contains(['{', '}']), "{english:?} in {words}");
        assert!(!saute_words::refusal::words(&refused, &library, Language::ENGLISH).contains('{'), "{refused:?}");
    }
}

#[test]
fn a_name_of_a_users_own_stays_as_it_is() {
    assert_eq!(crate::harness::japanese().called("pan", "Grandma's dumpling"), "Grandma's dumpling");
}

#[test]
fn the_systems_locale_chooses_the_language() {
    for (locale, language) in [
        ("ja_JP.UTF-8", crate::harness::japanese()),
        ("ja", crate::harness::japanese()),
        ("C.UTF-8", Language::ENGLISH),
        ("jam_JM", Language::ENGLISH),
        ("de_DE.UTF-8", Language::ENGLISH),
    ] {
        assert_eq!(Language::of_locale(locale), language, "{locale}");
    }
}
