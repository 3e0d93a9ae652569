//! `saute schema`.

use serde_json::Value;

use crate::cook::cooked::{DISHES, PANTRY, SHIPPED};
use crate::library::lists::ACTIONS;
use crate::running::run;

fn schema() -> Value {
    let ran = run(&["schema", "recipe"]);
    assert_eq!(ran.code, Some(0));
    serde_json::from_str(&ran.out).unwrap()
}

/// Returns the schema behind references and `null` alternatives.
fn resolved<'a>(root: &'a Value, part: &'a Value) -> &'a Value {
    if let Some(path) = part["$ref"].as_str() {
        return resolved(root, root.pointer(path.trim_start_matches('#')).unwrap());
    }
    let real = part["anyOf"].as_array().and_then(|all| all.iter().find(|s| s["type"] != "null"));
    real.map_or(part, |s| resolved(root, s))
}

/// Returns the alternative of a schema that accepts tables.
fn table<'a>(root: &'a Value, part: &'a Value) -> Option<&'a Value> {
    let part = part["$ref"].as_str().map_or(part, |path| root.pointer(path.trim_start_matches('#')).unwrap());
    if part["properties"].is_object() {
        return Some(part);
    }
    part["anyOf"].as_array()?.iter().find_map(|alternative| table(root, alternative))
}

fn check(root: &Value, part: &Value, value: &Value, at: &str) {
    let part = if value.is_object() { table(root, part).unwrap_or(part) } else { resolved(root, part) };
    match value {
        Value::Object(map) => {
            assert_eq!(part["additionalProperties"], false, "{at} takes any key");
            for (key, inner) in map {
                let known =
                    part["properties"].get(key).unwrap_or_else(|| panic!("the schema does not know {at}.{key}"));
                check(root, known, inner, &format!("{at}.{key}"));
            }
        }
        Value::Array(items) => items.iter().for_each(|i| check(root, part.get("items").unwrap_or(&Value::Null), i, at)),
        _ => {}
    }
}

#[test]
fn the_schema_knows_every_key_of_the_shipped_recipes() {
    let schema = schema();
    for id in SHIPPED.into_iter().chain(DISHES).chain(PANTRY) {
        let path = format!("{}/../../recipes/{id}.toml", env!("CARGO_MANIFEST_DIR"));
        let recipe: Value = toml::from_str(&std::fs::read_to_string(path).unwrap()).unwrap();
        check(&schema, &schema, &recipe, id);
    }
}

#[test]
fn the_schema_describes_every_key_of_a_step() {
    let schema = schema();
    let step = resolved(&schema, &schema["properties"]["step"]["items"]);
    let companions = ["at_s", "after_s", "when", "at_mm", "on", "for_s"];
    for key in companions.into_iter().chain(ACTIONS) {
        assert!(step["properties"][key]["description"].is_string(), "{key}: {step}");
    }
}

#[test]
fn every_data_format_has_a_schema_that_describes_its_keys_and_their_ranges() {
    for format in ["food", "pan", "coating", "oil", "kinetics", "hob", "rig"] {
        let ran = run(&["schema", format]);
        assert_eq!(ran.code, Some(0), "{format}: {}", ran.err);
        let root: Value = serde_json::from_str(&ran.out).unwrap();
        assert_eq!(root["title"], format!("saute {format}"));
        assert_eq!(root["additionalProperties"], false, "{format}");
        for (key, part) in root["properties"].as_object().unwrap() {
            assert!(part["description"].is_string(), "{format}.{key}: {part}");
        }
        assert!(["\"minimum\"", "\"maximum\"", "\"examples\""].iter().all(|word| ran.out.contains(word)), "{format}");
    }
}
