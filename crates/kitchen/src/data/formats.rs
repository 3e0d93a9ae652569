//! Promise: every shipped data file satisfies the schema of its format, every number has a range, and a mistake is one finding with its
//! line and a remedy.

use saute_food::components::Components;
use saute_food::{FoodDescription, Kinetics};
use saute_schema::{Finding, FormatSchema};
use schemars::JsonSchema;
use serde_json::Value;

use crate::data::at_home::KitchenAtHome;
use crate::data::goals::GoalsFile;
use crate::data::library::{DonenessFile, Library};
use crate::data::room::Room;
use crate::liquids::fond::FondData;
use crate::liquids::oil::OilDescription;
use crate::pan::hob::HobDescription;
use crate::pan::pan_description::{CoatingDescription, PanDescription};
use saute_schema::schema_text::{Kind, bounds, kind, resolved};

/// Every format with the beginning of the paths of its shipped files.
fn formats() -> Vec<(&'static str, FormatSchema)> {
    vec![
        ("foods/", FormatSchema::of::<FoodDescription>()),
        ("kinetics/", FormatSchema::of::<Kinetics>()),
        ("pans/", FormatSchema::of::<PanDescription>()),
        ("coatings/", FormatSchema::of::<CoatingDescription>()),
        ("oils/", FormatSchema::of::<OilDescription>()),
        ("hobs/", FormatSchema::of::<HobDescription>()),
        ("doneness.toml", FormatSchema::of::<DonenessFile>()),
        ("goals.toml", FormatSchema::of::<GoalsFile>()),
        ("components.toml", FormatSchema::of::<Components>()),
        ("kitchen.toml", FormatSchema::of::<Room>()),
        ("kitchen-at-home.toml", FormatSchema::of::<KitchenAtHome>()),
        ("fond.toml", FormatSchema::of::<FondData>()),
    ]
}

/// Returns the findings of a shipped file after a replacement, and the changed text.
fn changed<T: JsonSchema>(path: &str, from: &str, to: &str) -> (Vec<Finding>, String) {
    let text = &Library::embedded_files()[path];
    assert!(text.contains(from), "{path}: {from}");
    let text = text.replacen(from, to, 1);
    (FormatSchema::of::<T>().findings(&text), text)
}

/// Checks that a replacement in a shipped file gives one finding with its line, message and remedy.
fn refused<T: JsonSchema>(path: &str, [from, to]: [&str; 2], [message, remedy]: [&str; 2]) {
    let (findings, text) = changed::<T>(path, from, to);
    assert_eq!(findings.len(), 1, "{to}: {findings:?}");
    let line = 1 + text.lines().position(|l| l.contains(to)).expect("the line");
    assert_eq!(
        (findings[0].line, findings[0].message.as_str(), findings[0].remedy.as_str()),
        (line, message, remedy),
        "{to}"
    );
}

#[test]
fn every_shipped_file_satisfies_its_schema() {
    let files = Library::embedded_files();
    for (start, schema) in formats() {
        let own: Vec<_> = files.iter().filter(|(path, _)| path.starts_with(start)).collect();
        assert!(!own.is_empty(), "{start}");
        for (path, text) in own {
            assert_eq!(schema.findings(text), Vec::new(), "{path}");
        }
    }
}

/// Walks over a schema: every number has a range, those of maps too.
fn numbers_have_ranges(schema: &Value, at: &str) -> usize {
    let schema = resolved(schema);
    let inner = |key: &str| numbers_have_ranges(&schema[key], at);
    match kind(schema) {
        Kind::Number | Kind::Integer => {
            let (low, high) = bounds(schema);
            assert!(low.is_finite() && high.is_finite() && low < high, "{at} has no range");
            1
        }
        Kind::List if schema["prefixItems"].is_array() => {
            schema["prefixItems"].as_array().into_iter().flatten().map(|s| numbers_have_ranges(s, at)).sum()
        }
        Kind::List => inner("items"),
        Kind::Table if schema["additionalProperties"].is_object() => inner("additionalProperties"),
        Kind::Table => {
            assert_eq!(schema["additionalProperties"], false, "{at} takes any key");
            let keys = schema["properties"].as_object().into_iter().flatten();
            keys.map(|(key, s)| numbers_have_ranges(s, &format!("{at}.{key}"))).sum()
        }
        Kind::Text | Kind::Flag => 0,
        other => panic!("{at} is {other:?}"),
    }
}

#[test]
fn the_page_of_a_format_states_meaning_range_and_example_of_its_keys() {
    let page = FormatSchema::of::<OilDescription>().page();
    assert!(page.starts_with("# The oil format\n"), "{page}");
    let row = "| `smoke_c` | Smoke point [°C]. | 80 to 400 | **required** | `smoke_c = 220.0` |\n";
    assert!(page.contains(row), "{page}");
}

#[test]
fn every_number_of_every_format_has_a_range() {
    for (start, schema) in formats() {
        assert!(numbers_have_ranges(schema.json(), start) > 0, "{start}");
    }
}

#[test]
fn a_misspelt_key_is_one_finding_with_the_nearest_key() {
    let message = "outline.rippel is no key of the food format";
    refused::<FoodDescription>("foods/beef-lean.toml", ["ripple =", "rippel ="], [message, "write ripple"]);
    let message = "crusts is no key of the food format";
    refused::<FoodDescription>("foods/beef-lean.toml", ["[crust]", "[crusts]"], [message, "write crust"]);
}

#[test]
fn a_missing_key_is_refused_with_its_meaning_and_an_example() {
    let (found, text) = changed::<FoodDescription>("foods/beef-lean.toml", "ripple =", "# ripple =");
    let table = 1 + text.lines().position(|l| l == "[outline]").expect("is there");
    assert_eq!((found.len(), found[0].line, found[0].key.as_str()), (1, table, "ripple"), "{found:?}");
    assert!(found[0].message.starts_with("outline.ripple is missing: amplitude of the natural"), "{found:?}");
    assert_eq!(found[0].remedy, "write ripple = 0.02");
}

#[test]
fn a_missing_table_is_refused_with_the_keys_that_it_needs() {
    let (found, _) = changed::<FoodDescription>("foods/beef-lean.toml", "[crust]", "[unheard-of]");
    let of = |part: &str| found.iter().find(|f| f.message.contains(part)).unwrap_or_else(|| panic!("{found:?}"));
    assert!(of("unheard-of is no key").remedy.starts_with("leave it out; there are: "), "{found:?}");
    let missing = of("[crust] is missing: the dry crust");
    assert!(missing.remedy.starts_with("write [crust] with conductivity_w_mk = 0.12"), "{missing:?}");
}

#[test]
fn a_value_of_the_wrong_type_is_refused_with_an_example() {
    refused::<PanDescription>(
        "pans/cast-iron-grill-26.toml",
        ["radius_mm = 100.0", "radius_mm = \"wide\""],
        ["floor.radius_mm is a text and must be a number: radius [mm]", "write, for instance, radius_mm = 100.0"],
    );
    refused::<HobDescription>(
        "hobs/induction.toml",
        ["settings_w = [0.0, 400.0, 1100.0, 2000.0]", "settings_w = 5"],
        [
            "coil.settings_w is a number and must be a list: settings on the dial [W]",
            "write, for instance, settings_w = [0.0, 400.0, 1100.0, 2000.0]",
        ],
    );
}

#[test]
fn a_number_out_of_range_or_not_finite_is_refused_with_the_range() {
    let pan = "pans/cast-iron-grill-26.toml";
    refused::<PanDescription>(
        pan,
        ["pitch_mm = 12.0", "pitch_mm = 0"],
        ["ridges.pitch_mm = 0 is out of range", "use 2 to 50"],
    );
    refused::<PanDescription>(
        pan,
        ["metalness = 0.35", "metalness = nan"],
        ["look.metalness = NaN is no finite number", "use 0 to 1"],
    );
    refused::<OilDescription>(
        "oils/olive.toml",
        ["[190, 172, 40]", "[190, 372, 40]"],
        ["look.colour_srgb = 372 is out of range", "use numbers from 0 to 255"],
    );
    refused::<Kinetics>(
        "kinetics/beef.toml",
        ["across = { myosin = 0.050", "across = { myosin = inf"],
        ["shrinkage.across.myosin = inf is no finite number", "use -0.5 to 0.5"],
    );
}

#[test]
fn a_list_of_the_wrong_length_is_refused() {
    refused::<OilDescription>(
        "oils/olive.toml",
        ["[190, 172, 40]", "[190, 172]"],
        ["look.colour_srgb has 2 entries", "write 3"],
    );
    refused::<FoodDescription>(
        "foods/beef-lean.toml",
        ["char = [14.0, 1.0, 1.0]", "char = [14.0, 1.0]"],
        ["colour.char = [14.0, 1.0] is no colour", "use L* 0 to 100, a* and b* -128 to 127"],
    );
}

#[test]
fn a_word_that_is_no_choice_is_refused_with_the_choices() {
    let (found, _) = changed::<FoodDescription>("foods/beef-lean.toml", "form = \"steak\"", "form = \"stake\"");
    assert_eq!(found.len(), 1);
    assert_eq!(found[0].message, "form = \"stake\" is unknown");
    assert!(found[0].remedy.starts_with("write \"steak\"; there are: steak, patty"), "{found:?}");
}

#[test]
fn every_mistake_of_writing_is_refused_with_its_line() {
    let found = FormatSchema::of::<FoodDescription>().findings("name = \nform = steak\n[lean\n");
    assert!(found.len() >= 2 && found[0].line == 1, "{found:?}");
}
