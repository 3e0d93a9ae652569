//! Measurement, not a test: rows of a sweep against bare cooks of the same recipe, in alternating runs. `scripts/sweeps.sh` runs it.

use std::sync::Arc;
use std::sync::atomic::{AtomicU64, Ordering};
use std::thread;
use std::time::Instant;

use saute_kitchen::Library;
use saute_kitchen::heat::sorted::Sorted;
use saute_recipe::{Cook, Recipe};
use saute_sweep::{Base, Sweep};
use saute_sweep_folder::SweepFolder;
use saute_sweep_folder::cooking::{cook_all, cores};

/// Runs of each [-].
const RUNS: usize = 5;
/// Simulated time of a row [s].
const FOR_S: f64 = 30.0;
/// Spacing of the mesh [-].
const COARSENESS: f64 = 3.0;

/// Cooks a recipe so many times on every core, with nothing around it; returns rows a second.
fn bare(recipe: &Recipe, library: &Library, rows: u64) -> f64 {
    let (next, begun) = (AtomicU64::new(0), Instant::now());
    let work = || {
        while next.fetch_add(1, Ordering::Relaxed) < rows {
            let mut cook = Cook::new(recipe.clone(), library).unwrap();
            while cook.stopped().is_none() && cook.kitchen.time_s() < FOR_S {
                cook.advance().unwrap();
            }
            assert!(cook.summary(0.0).simulated_s > 0.0);
        }
    };
    thread::scope(|scope| (0..cores()).for_each(|_| drop(scope.spawn(work))));
    rows as f64 / begun.elapsed().as_secs_f64()
}

/// Sweeps so many rows of the same cook; returns rows a second.
fn swept(recipe: &str, rows: u64) -> f64 {
    let spec = format!(
        "recipe = \"medium\"\nfor_s = {FOR_S}\ncoarseness = {COARSENESS}\n[vary]\n\"food.steak.initial_c\" = {{ from = 5, to = 5.001 }}\n\
         [design]\nkind = \"latin-hypercube\"\nn = {rows}\n"
    );
    let base = Base { recipe: recipe.to_owned(), file: "medium".to_owned(), ..Base::default() };
    let sweep = Arc::new(Sweep::new(&spec, "spec.toml", base).unwrap());
    let dir = tempfile::tempdir().unwrap();
    let begun = Instant::now();
    let tally = cook_all(SweepFolder::open(dir.path(), sweep).unwrap(), cores(), &|_| (), &|| true).unwrap();
    assert_eq!((tally.done, tally.failed), (rows, 0));
    rows as f64 / begun.elapsed().as_secs_f64()
}

#[test]
#[ignore = "a measurement of a minute"]
fn throughput() {
    let rows = std::env::var("SAUTE_SWEEP_ROWS").map_or(64, |rows| rows.parse().unwrap());
    let library = Library::embedded().unwrap();
    // A hot pan, so that the steak is in it from the first second on.
    let text = library.recipes.get("medium").unwrap().replace("initial_c = 20", "initial_c = 230");
    let mut recipe = Recipe::parse(&text, "medium", &library).unwrap();
    recipe.foods.iter_mut().for_each(|food| food.coarseness = COARSENESS);
    let ratios = (0..RUNS)
        .map(|_| {
            let (bare, swept) = (bare(&recipe, &library, rows), swept(&text, rows));
            println!("bare {bare:.2} rows/s, sweep {swept:.2} rows/s: {:+.1} %", 100.0 * (swept / bare - 1.0));
            swept / bare
        })
        .collect();
    let median = Sorted::new(ratios).median().unwrap();
    println!("median of {RUNS}: {:+.1} % on {} threads", 100.0 * (median - 1.0), cores());
}
