//! Promise: every food is spoken of in its own words of doneness, and files of a user's from before foods had their own
//! words keep working.

use std::sync::Arc;

use saute_kitchen::doneness::{ScaleChoice, core_class, fitting};
use saute_kitchen::food::{FoodModel, Rules, Scale};
use saute_kitchen::{Kitchen, Library, MeshSize, OutlineKind, Piece, PieceOrder, kelvin};

use crate::stove::library;

const OF_MEAT: [&str; 3] = ["paper-2013", "chefs", "academic"];

/// A kitchen with one raw piece.
fn with_piece(library: &Library, kind: &str, rules: Rules) -> Kitchen {
    let mut kitchen = Kitchen::new(library, "carbon-steel-26", kelvin(20.0)).expect("pan");
    let food = &library.foods[kind];
    let size = food.form.extent(&food.size.default_mm).expect("a default size");
    let order = PieceOrder {
        id: kind.into(),
        kind: kind.into(),
        size: size.map(|mm| 1e-3 * mm),
        temperature: kelvin(20.0),
        seed: 1,
        coarseness: 3.0,
        rules,
        mesh: MeshSize::Default,
        outline: OutlineKind::Plain,
    };
    kitchen.add(library, &order).expect("food");
    kitchen
}

fn ids(scales: &[Arc<Scale>], food: &FoodModel) -> Vec<String> {
    fitting(scales, food).iter().map(|s| s.id.clone()).collect()
}

fn piece(kitchen: &Kitchen) -> &Piece {
    &kitchen.pieces()[0]
}

#[test]
fn every_food_has_the_scales_that_were_made_for_it_and_a_steak_those_of_meat() {
    let library = library();
    for (kind, expected) in [
        ("beef-lean", OF_MEAT.as_slice()),
        ("beef-marbled", OF_MEAT.as_slice()),
        ("shrimp", &["shrimp"]),
        ("beef-patty", &["ground-beef"]),
        ("carrot-coin", &["vegetables"]),
        ("carrot-stick", &["vegetables"]),
        ("leek-ring", &["vegetables"]),
    ] {
        assert_eq!(ids(&library.scales, &piece(&with_piece(&library, kind, Rules::Full)).model), expected, "{kind}");
    }
}

#[test]
fn by_the_rules_of_2013_meat_also_has_the_scale_of_2013() {
    let library = library();
    let of = |kind| ids(&library.scales, &piece(&with_piece(&library, kind, Rules::Paper2013)).model);
    assert_eq!(of("shrimp"), ["paper-2013", "shrimp"]);
    assert_eq!(of("beef-patty"), ["paper-2013", "ground-beef"]);
    assert_eq!(of("carrot-coin"), ["vegetables"]);
    assert_eq!(of("beef-lean"), OF_MEAT);
}

#[test]
fn the_choice_among_scales_holds_where_it_fits_and_gives_way_to_a_foods_own_words() {
    let library = library();
    let [steak, shrimp, carrot] =
        ["beef-lean", "shrimp", "carrot-coin"].map(|kind| with_piece(&library, kind, Rules::Full));
    let words = |chosen: &str, kitchen: &Kitchen| {
        let choice = ScaleChoice::new(&library.scales, chosen);
        choice.of(&piece(kitchen).model).map(|s| s.id.clone()).unwrap_or_default()
    };
    for chosen in OF_MEAT {
        assert_eq!([&steak, &shrimp, &carrot].map(|k| words(chosen, k)), [chosen, "shrimp", "vegetables"]);
    }
    assert_eq!(words("of-old", &steak), "paper-2013");
}

#[test]
fn a_raw_food_is_in_the_first_class_of_its_own_words() {
    let library = library();
    let choice = ScaleChoice::new(&library.scales, "chefs");
    for (kind, word) in [("beef-lean", "raw"), ("shrimp", "glassy"), ("beef-patty", "raw"), ("leek-ring", "crisp")] {
        let kitchen = with_piece(&library, kind, Rules::Full);
        let scale = choice.of(&piece(&kitchen).model).expect("a scale");
        assert_eq!(core_class(piece(&kitchen), scale), word, "{kind}");
        let model = &piece(&kitchen).model;
        let volume = model.volume_shares(&piece(&kitchen).state, scale).0;
        assert!((volume[0] - 100.0).abs() < 1e-9, "{kind}: {volume:?}");
    }
}

#[test]
fn a_vegetable_is_as_tender_as_its_pectin_has_changed_however_hot_it_was() {
    let library = library();
    let kitchen = with_piece(&library, "carrot-coin", Rules::Full);
    let piece = piece(&kitchen);
    let scale = library.scale("vegetables").expect("the scale");
    let place = piece.model.kinetics().names().iter().position(|n| *n == "pectin").expect("pectin");
    let mut state = piece.state.clone();
    state.peak.iter_mut().for_each(|t| *t = kelvin(99.0));
    let volume = |state: &_| piece.model.volume_shares(state, scale).0;
    let cut = |state: &_| piece.model.cut_shares(state, &piece.model.cut_across(0.0), scale).0;
    for (share, class) in [(0.0, 0), (0.39, 0), (0.41, 1), (0.84, 1), (0.86, 2)] {
        state.changed[place].iter_mut().for_each(|x| *x = share);
        for shares in [volume(&state), cut(&state)] {
            assert!((shares[class] - 100.0).abs() < 1e-9, "{share}: {shares:?}");
        }
    }
}

/// The shipped file as it was before foods had their own words: the scales of meat alone.
fn of_old() -> String {
    let text = &Library::embedded_files()["doneness.toml"];
    let end = text.find("[[scale]]\nid = \"shrimp\"").expect("the shrimp's scale");
    text[..end].to_owned()
}

#[test]
fn scales_of_a_users_own_from_before_read_all_meat_as_they_did() {
    let library = Library::with(&[("doneness.toml".into(), of_old())]).expect("the file of old");
    for (kind, expected) in [("shrimp", OF_MEAT.as_slice()), ("beef-patty", &OF_MEAT), ("carrot-coin", &[])] {
        assert_eq!(ids(&library.scales, &piece(&with_piece(&library, kind, Rules::Full)).model), expected, "{kind}");
    }
}

#[test]
fn a_food_of_a_users_own_kinetics_has_the_scales_of_the_changes_in_them() {
    let files = Library::embedded_files();
    let own = |path: &str, text: String| (path.to_owned(), text);
    let lamb = files["foods/beef-lean.toml"].replace("kinetics = \"beef\"", "kinetics = \"lamb\"");
    let beetroot = files["foods/carrot-coin.toml"].replace("kinetics = \"carrot\"", "kinetics = \"beetroot\"");
    let library = Library::with(&[
        own("foods/lamb.toml", lamb),
        own("kinetics/lamb.toml", files["kinetics/beef.toml"].clone()),
        own("foods/beetroot.toml", beetroot),
        own("kinetics/beetroot.toml", files["kinetics/carrot.toml"].clone()),
    ])
    .expect("own files");
    let of = |kind| ids(&library.scales, &piece(&with_piece(&library, kind, Rules::Full)).model);
    assert_eq!((of("lamb"), of("beetroot")), (OF_MEAT.map(str::to_owned).to_vec(), vec!["vegetables".to_owned()]));
}

#[test]
fn a_mistake_in_a_foods_own_scale_is_named_with_file_line_and_remedy() {
    let shipped = &Library::embedded_files()["doneness.toml"];
    for (from, to, parts) in [
        ("for_kinetics = [\"shrimp\"]", "for_kinetics = [\"prawn\"]", ["prawn", "there are: bacon, beef"]),
        ("for_kinetics = [\"shrimp\"]", "for_kinetics = [\"carrot\"]", ["no change \"myosin\"", "turgor, pectin"]),
        ("\"tender\", from_pct = 40.0", "\"tender\", from_c = 40.0", ["tender", "in all of them"]),
        ("\"opaque\", from_c = 55.0", "\"opaque\"", ["opaque", "write from_c"]),
        ("\"tender\", from_pct = 40.0", "\"tender\", from_pct = 90.0", ["from_pct does not ascend", "least done"]),
        ("goal = 50.0", "goal = 105.0", ["share in percent", "0 to 100"]),
        ("id = \"shrimp\"", "id = \"shrimp\"\nmeasure = \"peak\"", ["measure", "for_kinetics"]),
    ] {
        assert!(shipped.contains(from), "{from}");
        let text = shipped.replacen(from, to, 1);
        let error = Library::with(&[("doneness.toml".into(), text)]).expect_err(to);
        let message = error.message.as_str();
        assert!(error.file == "doneness.toml" && error.line > 30, "{to}: {error}");
        assert!(parts.iter().all(|part| message.contains(part)), "{to}: {message}");
    }
}
