//! Promises about every action of a recipe, checked for all members of `ActionKind::ALL`.

// A test that unwraps in vain states where.
#![allow(clippy::unwrap_used)]

use saute_kitchen::Library;
use saute_recipe::recipe_file::RecipeFile;
use saute_recipe::step_record::StepRecord;
use saute_recipe::{Action, ActionKind, Recipe};
use serde_json::Value;

/// Returns the action of a kind's example, in a recipe that brings the steak where the action needs it.
fn example(kind: ActionKind, library: &Library) -> Action {
    let before = match kind {
        ActionKind::Put => "hob_w = 0",
        ActionKind::Halve => "put = \"steak\"\n[[step]]\nrest = \"steak\"",
        _ => "put = \"steak\"",
    };
    let end = if kind == ActionKind::End { "" } else { "[[step]]\nend = true" };
    let text = format!(
        "[[food]]\nid = \"steak\"\nkind = \"beef-lean\"\n[[step]]\n{before}\n[[step]]\n{}\n{end}",
        kind.example()
    );
    let steps = Recipe::parse(&text, "example.toml", library).unwrap_or_else(|e| panic!("{kind}: {e}")).steps;
    steps[steps.len() - if kind == ActionKind::End { 1 } else { 2 }].action.clone()
}

/// Returns each kind with the action of its example.
fn examples() -> Vec<(ActionKind, Action)> {
    let library = Library::embedded().unwrap();
    ActionKind::ALL.into_iter().map(|kind| (kind, example(kind, &library))).collect()
}

#[test]
fn every_action_is_read_from_its_example_under_its_key() {
    for (kind, action) in examples() {
        assert_eq!((action.kind(), action.name()), (kind, kind.name()));
        assert_eq!(ActionKind::from_name(kind.name()), Some(kind));
    }
}

#[test]
fn every_action_has_words_and_an_action_on_a_food_names_it() {
    let mut on_foods = Vec::new();
    for (kind, action) in examples() {
        assert!(!action.words().is_empty(), "{kind}");
        assert!(kind.summary().ends_with('.'), "{kind}");
        if let Some(target) = action.target() {
            assert_eq!(target.name, "steak");
            assert!(action.words().starts_with(&format!("{kind} steak")), "{}", action.words());
            on_foods.push(kind.name());
        }
    }
    assert_eq!(on_foods, ["put", "flip", "rest", "halve", "press", "baste", "move"]);
}

#[test]
fn every_action_has_a_record_with_its_key_target_and_value() {
    for (kind, action) in examples() {
        let (target, value) = (action.target().map(|t| t.name.clone()), action.value());
        let foods: Vec<String> = target.iter().cloned().collect();
        let expected = format!(
            "{{\"time_s\":1.5,\"action\":\"{kind}\",\"target\":{},\"foods\":{},\"value\":{}}}",
            json(&target),
            json(&foods),
            json(&value)
        );
        assert_eq!(json(&StepRecord { time_s: 1.5, action, foods }), expected);
    }
}

fn json(value: &impl serde::Serialize) -> String {
    serde_json::to_string(value).unwrap()
}

#[test]
fn every_action_has_a_schema_with_its_description() {
    let schema = serde_json::to_value(schemars::schema_for!(RecipeFile)).unwrap();
    let properties = schema["$defs"]["StepEntry"]["properties"].as_object().unwrap();
    for kind in ActionKind::ALL {
        let property = &properties[kind.name()];
        assert_eq!(property["description"], format!("Action: {}", kind.summary()));
        assert!(property["anyOf"].is_array() || property["type"].is_array(), "{kind}: {property}");
    }
    let described = |of: &&Value| of["description"].as_str().is_some_and(|text| text.starts_with("Action: "));
    assert_eq!(properties.values().filter(described).count(), ActionKind::ALL.len());
}

#[test]
fn a_step_with_an_unknown_key_names_the_actions() {
    let text = "[[step]]\nfry = true\n[[step]]\nend = true";
    let error = Recipe::parse(text, "fry.toml", &Library::embedded().unwrap()).expect_err("is refused");
    assert_eq!(error.line, 2, "{error}");
    for kind in ActionKind::ALL {
        assert!(error.to_string().contains(kind.name()), "{kind}: {error}");
    }
}
