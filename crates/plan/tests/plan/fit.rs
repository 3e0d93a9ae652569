//! Promise: fitted to logs of a simulated cook with noise, "my kitchen" finds the true values within its 90 % intervals as often as it
//! states. Truths are drawn from the prior, noise from the stated standard deviations, both from one seed.

use saute_fixtures::draws::Draws;
use std::sync::Arc;

use saute_kitchen::Library;
use saute_plan::fit::observed::{CORE_SIGMA, Observed, PAN_SIGMA, Quantity, WEIGHT_SIGMA};
use saute_plan::fit::parameters::{Logs, Parameters};
use saute_plan::fit::predict::{FitError, Job};
use saute_plan::fit::search::Fit;
use saute_recipe::{Cook, Recipe};

/// A steak that was fried by the clock: pan heated for two minutes, a flip, rest. Small and coarse, so that many fit in a test.
const RECIPE: &str = r#"
[pan]
kind = "carbon-steel-26"
initial_c = 20
[[food]]
id = "steak"
kind = "beef-lean"
size_mm = [80, 60, 25]
initial_c = 6
[[step]]
at_s = 0
hob_w = 1500
[[step]]
at_s = 120
put = "steak"
[[step]]
at_s = 125
hob_w = 700
[[step]]
at_s = 300
flip = "steak"
[[step]]
at_s = 480
rest = "steak"
[[step]]
at_s = 700
end = true
"#;

/// Trials of `./test.sh`; the campaign makes as many as `SAUTE_FIT_TRIALS` states.
const TRIALS: usize = 3;

/// Of so many jobs one is run again, in the opposite order.
const AGAIN: usize = 4;

fn library() -> Arc<Library> {
    Arc::new(Library::embedded().expect("embedded data"))
}

fn recipe(library: &Library) -> Recipe {
    let mut recipe = Recipe::parse(RECIPE, "steak.toml", library).expect("a recipe");
    recipe.foods[0].coarseness = 3.0;
    recipe
}

/// What thermometers would have shown in a kitchen with the parameters: the pan until the food is in, the core every 10 s, the
/// weight at the end.
fn measured(truth: &Parameters, library: &Library, noise: &mut Draws) -> Observed {
    let (mut library, mut recipe) = (library.clone(), recipe(library));
    truth.set_in(&mut library);
    truth.set_in_recipe(&mut recipe);
    let mut cook = Cook::new(recipe, &library).expect("a kitchen");
    let (mut pan, mut core) = (Vec::new(), Vec::new());
    while cook.kitchen.time_s() < 690.0 {
        if cook.kitchen.tick().is_multiple_of(100) {
            let now = cook.kitchen.time_s();
            if now < 120.0 {
                pan.push((now, cook.kitchen.pan_temperature() + PAN_SIGMA * noise.normal()));
            } else {
                core.push((now, cook.kitchen.pieces()[0].core() + CORE_SIGMA * noise.normal()));
            }
        }
        cook.advance().expect("a step");
    }
    let mut observed = Observed::default();
    observed.add_curve(Quantity::Pan, &pan);
    observed.add_curve(Quantity::Core, &core);
    observed.add_weight(cook.kitchen.time_s(), cook.kitchen.pieces()[0].mass() + WEIGHT_SIGMA * noise.normal());
    observed
}

fn drawn(library: &Library, noise: &mut Draws) -> Parameters {
    let middle = Parameters::of(&recipe(library), library).logs();
    let away = Parameters::prior().component_mul(&Logs::from_fn(|_, _| noise.normal()));
    Parameters::from_logs(&(middle + away))
}

#[test]
fn true_values_lie_within_the_stated_intervals() {
    let library = library();
    let trials = std::env::var("SAUTE_FIT_TRIALS").ok().and_then(|n| n.parse().ok()).unwrap_or(TRIALS);
    let mut noise = Draws(20_131_120);
    let mut hits = [0usize; 3];
    for trial in 0..trials {
        let begun = std::time::Instant::now();
        let truth = drawn(&library, &mut noise);
        let observed = measured(&truth, &library, &mut noise);
        let mut fit = Fit::new(recipe(&library), Arc::clone(&library), &observed).expect("a fit");
        while fit.found().is_none() {
            let values: Vec<Vec<f64>> = fit.next_jobs().iter().map(|job| job.run().expect("a cook")).collect();
            fit.take(&values);
        }
        let found = fit.found().expect("has ended");
        let held = [
            found.hob_efficiency.holds(truth.hob_efficiency),
            found.contact.holds(truth.contact),
            found.thickness_mm.holds(1e3 * truth.thickness),
        ];
        println!("{trial}: {truth:?} {held:?} {found:?} {:?}", begun.elapsed());

        (0..3).for_each(|k| hits[k] += usize::from(held[k]));
    }
    println!("of {trials}: {hits:?}");
    let all: usize = hits.iter().sum();
    if trials >= 100 {
        assert!(hits.iter().all(|n| (85..=95).contains(&(100 * n / trials))), "{hits:?} of {trials}");
    } else {
        // Of 9 values, 6 or more are inside with a probability above 0.99 if each does with 0.9.
        assert!(3 * all >= 2 * 3 * trials, "{hits:?} of {trials}");
    }
}

/// A job is a function of its order alone, so what some jobs of two rounds show holds for all of them.
#[test]
fn the_answer_does_not_depend_on_the_order_of_the_jobs() {
    let library = library();
    let observed = measured(&drawn(&library, &mut Draws(7)), &library, &mut Draws(8));
    let mut fit = Fit::coarse(recipe(&library), Arc::clone(&library), &observed).expect("a fit");
    for _ in 0..2 {
        let jobs = fit.next_jobs();
        let run = |jobs: &[Job]| -> Vec<(usize, Vec<f64>)> {
            jobs.iter().map(|job| (job.number, job.run().expect("a cook"))).collect()
        };
        let there = run(&jobs);
        let back: Vec<Job> = jobs.iter().rev().step_by(AGAIN).cloned().collect();
        assert!(run(&back).iter().all(|job| there.contains(job)));
        fit.take(&there.into_iter().map(|(_, values)| values).collect::<Vec<_>>());
    }
}

#[test]
fn what_cannot_be_fitted_is_refused() {
    let library = library();
    let refused = |observed: &Observed| Fit::new(recipe(&library), Arc::clone(&library), observed).map(drop);
    assert_eq!(refused(&Observed::default()), Err(FitError::Nothing));
    let mut late = Observed::default();
    late.add_weight(900.0, 0.1);
    let fit = Fit::new(recipe(&library), Arc::clone(&library), &late).expect("a fit");
    let error = fit.next_jobs()[0].run().expect_err("too late").to_string();
    assert_eq!(
        error,
        "a value was measured at 900 s, but the recipe ends at 700 s; let the recipe last longer, or shift the log's time"
    );
}
