//! Promise: one can cook in every kitchen within the documented ranges. At both ends of every range of the files of a kitchen at home,
//! a pan, an oil and a hob nothing panics, every temperature is a number, and no liquid is less than nothing.

// A test that fails at an unwrap names its line.
#![allow(clippy::unwrap_used)]

use std::panic::catch_unwind;

use saute_kitchen::Library;
use saute_kitchen::data::at_home::KitchenAtHome;
use saute_kitchen::liquids::oil::OilDescription;
use saute_kitchen::pan::hob::HobDescription;
use saute_kitchen::pan::pan_description::PanDescription;
use saute_recipe::{Cook, Recipe};
use saute_schema::FormatSchema;
use serde_json::Value;

use saute_fixtures::draws::Draws;

/// A thin steak on the coarse mesh, from a hot pan over a flip to water under a lid.
const SHORT: &str = r#"
[pan]
kind = "PAN"
initial_c = 200
[[food]]
id = "steak"
kind = "beef-lean"
size_mm = [60, 50, 12]
initial_c = 5
mesh = "2013"
[[step]]
hob_w = 1000
[[step]]
put = "steak"
[[step]]
after_s = 5
flip = "steak"
[[step]]
after_s = 4
water_g = 15
[[step]]
lid = true
[[step]]
after_s = 3
end = true
"#;

/// A number of a file: where it is, and the ends of its range.
#[derive(Clone, Debug)]
struct Ranged {
    key: Vec<String>,
    ends: [f64; 2],
    is_whole: bool,
}

/// A file whose numbers have ranges.
struct Ranging {
    path: String,
    text: toml::Table,
    numbers: Vec<Ranged>,
}

impl Ranging {
    fn of(path: &str, schema: &Value, text: &str) -> Self {
        let text: toml::Table = toml::from_str(text).unwrap();
        let mut numbers = Vec::new();
        walk(schema, schema, &toml::Value::Table(text.clone()), &mut Vec::new(), &mut numbers);
        Self { path: path.to_owned(), text, numbers }
    }

    /// The file with other numbers.
    fn with(&self, numbers: &[(&Ranged, usize)]) -> (String, String) {
        let mut text = self.text.clone();
        for (number, end) in numbers {
            set(&mut text, number, number.ends[*end]);
        }
        (self.path.clone(), toml::to_string(&text).unwrap())
    }
}

/// Finds the numbers of a file that have both ends of a range in its schema.
fn walk(root: &Value, at: &Value, value: &toml::Value, key: &mut Vec<String>, found: &mut Vec<Ranged>) {
    let at = resolved(root, at);
    match value {
        toml::Value::Table(table) => {
            for (name, inner) in table {
                key.push(name.clone());
                walk(root, &at["properties"][name], inner, key, found);
                key.pop();
            }
        }
        toml::Value::Float(_) | toml::Value::Integer(_) => {
            if let (Some(least), Some(most)) = (at["minimum"].as_f64(), at["maximum"].as_f64()) {
                found.push(Ranged { key: key.clone(), ends: [least, most], is_whole: value.is_integer() });
            }
        }
        _ => {}
    }
}

/// What a schema refers to, also as one of "something or nothing".
fn resolved<'a>(root: &'a Value, at: &'a Value) -> &'a Value {
    let one = at["anyOf"].as_array().and_then(|all| all.iter().find(|one| one["type"] != "null"));
    let at = one.unwrap_or(at);
    let name = at["$ref"].as_str().and_then(|name| name.strip_prefix('#'));
    name.map_or(at, |name| root.pointer(name).unwrap())
}

fn set(table: &mut toml::Table, number: &Ranged, to: f64) {
    let (last, before) = number.key.split_last().unwrap();
    let inner = before.iter().fold(table, |table, name| table[name].as_table_mut().unwrap());
    let value = if number.is_whole { toml::Value::Integer(to as i64) } else { toml::Value::Float(to) };
    inner.insert(last.clone(), value);
}

fn files() -> Vec<Ranging> {
    let shipped = Library::embedded_files();
    let text = |path: &str| shipped[path].as_str();
    let home = KitchenAtHome::default();
    let hob = |path: &str| Ranging::of(path, FormatSchema::of::<HobDescription>().json(), text(path));
    vec![
        Ranging::of("kitchen-at-home.toml", FormatSchema::of::<KitchenAtHome>().json(), &home.to_file()),
        Ranging::of(
            "pans/carbon-steel-26.toml",
            FormatSchema::of::<PanDescription>().json(),
            text("pans/carbon-steel-26.toml"),
        ),
        Ranging::of(
            "pans/cast-iron-grill-26.toml",
            FormatSchema::of::<PanDescription>().json(),
            text("pans/cast-iron-grill-26.toml"),
        ),
        Ranging::of("oils/canola.toml", FormatSchema::of::<OilDescription>().json(), text("oils/canola.toml")),
        hob("hobs/gas.toml"),
        hob("hobs/induction.toml"),
        hob("hobs/iron-plate.toml"),
        hob("hobs/radiant.toml"),
    ]
}

/// Cooks with files in place of the shipped ones; false if they are refused, as rules of several keys do.
fn cooks(own: &[(String, String)]) -> bool {
    let Ok(library) = Library::with(own) else { return false };
    let hob = own.iter().find_map(|(path, _)| path.strip_prefix("hobs/")?.strip_suffix(".toml"));
    let Ok(library) = library.on_hob(hob.unwrap_or("induction")) else { return false };
    let pan = own.iter().find_map(|(path, _)| path.strip_prefix("pans/")?.strip_suffix(".toml"));
    let text = SHORT.replace("PAN", pan.unwrap_or("carbon-steel-26"));
    let Ok(recipe) = Recipe::parse(&text, "short.toml", &library) else { return false };
    let Ok(mut cook) = Cook::new(recipe, &library) else { return false };
    while cook.stopped().is_none() {
        if cook.advance().is_err() {
            return false;
        }
        let kitchen = &cook.kitchen;
        let [water, oil] = [kitchen.pan_state().water_mass(), kitchen.pan_state().oil_mass()];
        assert!(water >= 0.0 && oil >= 0.0, "{water} kg of water, {oil} kg of oil");
        assert!(kitchen.pan_temperature().is_finite() && kitchen.pieces()[0].core().is_finite());
    }
    true
}

/// As [`cooks`]; a panic names the files.
fn cooks_or_names(what: &str, own: &[(String, String)]) -> bool {
    catch_unwind(|| cooks(own)).unwrap_or_else(|_| panic!("{what}"))
}

#[test]
fn both_ends_of_every_range_of_a_kitchen_can_be_cooked_in() {
    let (mut cooked, mut refused) = (0, Vec::new());
    for file in files() {
        assert!(file.numbers.len() > 1, "{}", file.path);
        for number in &file.numbers {
            for end in 0..2 {
                let what = format!("{}: {} = {}", file.path, number.key.join("."), number.ends[end]);
                match cooks_or_names(&what, &[file.with(&[(number, end)])]) {
                    true => cooked += 1,
                    false => refused.push(what),
                }
            }
        }
    }
    println!("{cooked} cooked; refused: {refused:#?}");
    assert!(cooked > 4 * refused.len(), "{cooked} cooked, {} refused", refused.len());
}

#[test]
fn a_steak_on_the_usual_mesh_can_be_cooked_at_the_ends_of_the_contact() {
    for contact in [0.2, 5.0] {
        let home = KitchenAtHome { contact_factor: contact, ..KitchenAtHome::default() };
        let library = Library::with(&[("kitchen-at-home.toml".to_owned(), home.to_file())]).unwrap();
        let text = saute_kitchen::Library::embedded().unwrap().recipes["medium"].clone();
        let mut cook = Cook::new(Recipe::parse(&text, "medium.toml", &library).unwrap(), &library).unwrap();
        while cook.stopped().is_none() && cook.kitchen.time_s() < 200.0 {
            cook.advance().unwrap();
        }
        assert!(cook.kitchen.pan_state().water_mass() >= 0.0);
    }
}

#[test]
fn corners_of_the_ranges_drawn_at_random_can_be_cooked_in() {
    /// Corners that are cooked in, and draws at most (chosen: some seconds of computing; rules of several keys refuse most).
    const CORNERS: u64 = 25;
    const DRAWS: u64 = 400;
    let files = files();
    // A fixed seed: the corners are the same in each run (chosen: the day on which they were drawn first).
    let mut draws = Draws(20_261_126);
    let mut below = |most: usize| draws.below(most as u64) as usize;
    let mut cooked = 0;
    for _ in 0..DRAWS {
        if cooked == CORNERS {
            break;
        }
        // A pan of two, and two numbers of each file.
        let chosen: Vec<&Ranging> = [0, 1 + below(2), 3, 4 + below(4)].map(|at| &files[at]).into();
        let own: Vec<(String, String)> = chosen
            .into_iter()
            .map(|file| {
                let numbers: Vec<(&Ranged, usize)> =
                    (0..2).map(|_| (&file.numbers[below(file.numbers.len())], below(2))).collect();
                file.with(&numbers)
            })
            .collect();
        cooked += u64::from(cooks_or_names(&format!("{own:#?}"), &own));
    }
    assert_eq!(cooked, CORNERS);
}
