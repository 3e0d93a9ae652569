//! Promise: food may begin frozen, and on a finer mesh than the default; what cannot freeze is refused at its line.

use saute_kitchen::{Library, celsius};
use saute_recipe::{Cook, Recipe, Summary};
use saute_schema::InputError;

fn text(kind: &str, head: &str, food: &str) -> String {
    format!(
        "{head}max_s = 3600\n[pan]\nkind = \"cast-iron-26\"\ninitial_c = 170\n[[food]]\nid = \"food\"\nkind = \"{kind}\"\n\
         outline = \"plain\"\n{food}\n[[step]]\nhob_w = 700\n[[step]]\nput = \"food\"\n[[step]]\nafter_s = 120\n\
         flip = \"food\"\n[[step]]\nafter_s = 120\nflip = \"food\"\n[[step]]\nwhen = {{ food = \"food\", core_c = 45 }}\n\
         end = true\n"
    )
}

fn cooked(text: &str) -> Summary {
    let library = Library::embedded().expect("embedded data");
    let mut cook = Cook::new(Recipe::parse(text, "frozen.toml", &library).expect("parses"), &library).expect("begins");
    while cook.stopped().is_none() {
        cook.advance().expect("runs");
    }
    let moved = cook.kitchen.energy();
    assert!(moved.imbalance.abs() < 1e-9 * moved.food_stored.abs().max(moved.pan_stored.abs()), "{moved:?}");
    cook.summary(0.0)
}

#[test]
fn a_frozen_steak_thaws_and_cooks_in_the_pan() {
    let steak = |c: f64| text("beef-lean", "", &format!("size_mm = [60, 50, 15]\ninitial_c = {c}\ncoarseness = 2"));
    let [frozen, chilled] = [-18.0, 5.0].map(|c| cooked(&steak(c)).simulated_s);
    assert!((1.4..3.0).contains(&(frozen / chilled)), "{frozen} {chilled}");
    // It is called frozen as long as its core is ice.
    let library = Library::embedded().expect("embedded data");
    let recipe = Recipe::parse(&steak(-18.0), "frozen.toml", &library).expect("parses");
    let mut cook = Cook::new(recipe, &library).expect("begins");
    let class = |cook: &Cook| cook.summary(0.0).foods[0].doneness.0[0].1.class.clone();
    assert_eq!(class(&cook), "frozen");
    while celsius(cook.kitchen.pieces()[0].core()) < 0.0 {
        cook.advance().expect("runs");
    }
    assert_ne!(class(&cook), "frozen");
}

/// Half the spacing changes little: what is cooked on the default mesh has nearly settled.
#[test]
fn a_finer_mesh_tells_the_same() {
    let steak = |coarseness: f64| {
        let food = format!("size_mm = [40, 36, 15]\ninitial_c = 5\ncoarseness = {coarseness}");
        let summary = cooked(&text("beef-lean", "", &food));
        (summary.simulated_s, summary.foods[0].lost_pct, summary.foods[0].nodes)
    };
    let [default, fine] = [1.0, 0.6].map(steak);
    assert!(fine.2 > 2 * default.2, "{fine:?} {default:?}");
    assert!((fine.0 / default.0 - 1.0).abs() < 0.03 && (fine.1 - default.1).abs() < 0.5, "{fine:?} {default:?}");
}

fn refused(text: &str, library: &Library) -> InputError {
    Recipe::parse(text, "frozen.toml", library).expect_err("refused")
}

#[test]
fn what_cannot_freeze_is_refused_with_a_remedy() {
    let library = Library::embedded().expect("embedded data");
    let cold = "size_mm = [60, 50, 15]\ninitial_c = -18";
    let of_2013 = refused(&text("beef-lean", "preset = \"2013\"\n", cold), &library);
    assert!(of_2013.to_string().contains("know no ice"), "{of_2013}");
    let far = refused(&text("beef-lean", "", "initial_c = -40"), &library);
    assert!(far.to_string().contains("food.initial_c"), "{far}");
    let mesh = refused(&text("beef-lean", "", "coarseness = 0.1"), &library);
    assert!(mesh.to_string().contains("food.coarseness"), "{mesh}");
    // A user's food that states nothing about freezing.
    let shipped = include_str!("../../../../data/foods/beef-lean.toml");
    let (head, rest) = shipped.split_once("[freezing]").expect("a table");
    let own = format!("{head}{}", &rest[rest.find("[sorption]").expect("the next table")..]);
    let library = Library::with(&[("foods/own.toml".into(), own)]).expect("sound");
    let unknown = refused(&text("own", "", cold), &library);
    assert!(unknown.to_string().contains("[freezing]"), "{unknown}");
}
