//! Promise: where a recipe wants individual pieces, the seed changes what the food's file states, by as much as it states; else it does not.

use saute_kitchen::food::Rules;
use saute_kitchen::{Kitchen, Library, MeshSize, OutlineKind, PieceOrder, kelvin};
use saute_recipe::{Cook, Recipe};

/// Lost water and melted fat [%], and when the cook ended [s], of a small steak of a seed that is turned twice and ends at 50 °C.
fn loss_and_time(outline: &str, seed: u64) -> [f64; 2] {
    let text = format!(
        "max_s = 3600\n[pan]\nkind = \"carbon-steel-26\"\ninitial_c = 180\n[[food]]\nid = \"steak\"\nkind = \"beef-lean\"\n\
         size_mm = [60, 50, 20]\ncoarseness = 2\nseed = {seed}\noutline = \"{outline}\"\n[[step]]\nhob_w = 600\n[[step]]\n\
         put = \"steak\"\n[[step]]\nafter_s = 120\nflip = \"steak\"\n[[step]]\nafter_s = 120\nflip = \"steak\"\n[[step]]\n\
         when = {{ food = \"steak\", core_c = 50 }}\nend = true\n"
    );
    let library = Library::embedded().expect("embedded data");
    let recipe = Recipe::parse(&text, "individual.toml", &library).expect("parses");
    let mut cook = Cook::new(recipe, &library).expect("begins");
    while cook.stopped().is_none() {
        cook.advance().expect("runs");
    }
    let summary = cook.summary(0.0);
    [summary.foods[0].lost_pct, summary.simulated_s]
}

/// Standard deviations relative to their means [-].
fn spread(outline: &str) -> [f64; 2] {
    let cooks: Vec<[f64; 2]> = (1..=12).map(|seed| loss_and_time(outline, seed)).collect();
    [0, 1].map(|k| {
        let mean = cooks.iter().map(|cook| cook[k]).sum::<f64>() / 12.0;
        let squares: f64 = cooks.iter().map(|cook| (cook[k] - mean).powi(2)).sum();
        (squares / 11.0).sqrt() / mean
    })
}

/// Real steaks of one size differ by 5–10 % (the band is that of the sources, widened by the error of a deviation of twelve: a fifth).
#[test]
fn individual_steaks_differ_as_real_ones_do_and_mean_ones_hardly() {
    let [loss, time] = spread("individual");
    assert!((0.04..0.12).contains(&loss) && (0.04..0.12).contains(&time), "{loss} {time}");
    let [loss, time] = spread("natural");
    assert!(loss < 0.02 && time < 0.02, "{loss} {time}");
}

fn order(outline: OutlineKind, seed: u64, kind: &str, size: [f64; 3]) -> PieceOrder {
    let (id, rules, mesh) = ("piece".to_owned(), Rules::Full, MeshSize::Default);
    PieceOrder { id, kind: kind.into(), size, temperature: kelvin(5.0), seed, coarseness: 2.0, rules, mesh, outline }
}

#[test]
fn a_seed_is_one_piece_also_after_it_was_stored() {
    let library = Library::embedded().expect("embedded data");
    let cooked = |seed: u64| {
        let mut kitchen = Kitchen::new(&library, "carbon-steel-26", kelvin(180.0)).expect("pan");
        kitchen.add(&library, &order(OutlineKind::Individual, seed, "beef-lean", [0.06, 0.05, 0.02])).expect("builds");
        kitchen
    };
    let (mut one, two) = (cooked(1), cooked(2));
    assert_eq!(one.state_hash(), cooked(1).state_hash());
    let thickness = |kitchen: &Kitchen| kitchen.pieces()[0].model.size()[2];
    assert!((thickness(&one) - thickness(&two)).abs() > 1e-5);
    let mut again = Kitchen::from_bytes(&one.to_bytes(), &library).expect("is read");
    (0..20).for_each(|_| one.step());
    (0..20).for_each(|_| again.step());
    assert_eq!(one.state_hash(), again.state_hash());
}

#[test]
fn every_shipped_food_has_individual_pieces_at_both_ends_of_its_sizes() {
    let library = Library::embedded().expect("embedded data");
    for (id, food) in &library.foods {
        assert!(food.spread.is_some(), "{id}");
        for ends in [&food.size.min_mm, &food.size.max_mm] {
            let size =
                food.form.extent(&ends.iter().map(|mm| 1e-3 * mm).collect::<Vec<_>>()).expect("has all dimensions");
            for seed in 1..=3 {
                let mut kitchen = Kitchen::new(&library, "carbon-steel-26", kelvin(180.0)).expect("pan");
                let built = kitchen.add(&library, &order(OutlineKind::Individual, seed, id, size));
                built.unwrap_or_else(|error| panic!("{id} {seed}: {error}"));
            }
        }
    }
}
