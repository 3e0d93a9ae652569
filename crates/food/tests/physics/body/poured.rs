//! Promise: a poured piece has the volume and the masses that were ordered in whatever shape it lies; it takes on another shape without
//! losing any water, fat or heat, and no place becomes hotter or colder than any was.

use saute_food::body::pool::{Dome, Pool};
use saute_food::{FoodModel, FoodState, MeshSize, OutlineKind, PieceSpec, Rules, ZERO_C};

use crate::run::piece;

fn spec(seed: u64) -> PieceSpec {
    PieceSpec {
        size: [0.110, 0.110, 0.0051],
        seed,
        coarseness: 1.0,
        mesh: MeshSize::Default,
        rules: Rules::Full,
        outline: OutlineKind::Natural,
        pool: None,
    }
}

/// The same egg, run to one side, with its yolk out of the middle.
fn run_aside(egg: &FoodModel) -> PieceSpec {
    let lies = *egg.pool().expect("is poured");
    let reach =
        core::array::from_fn(|k| lies.reach[k] * (1.0 + 0.2 * libm::cos(core::f64::consts::TAU * k as f64 / 32.0)));
    let pool = Pool { reach, dome: Dome { at: [0.009, -0.004], ..lies.dome }, ..lies };
    PieceSpec { pool: Some(pool), ..spec(3) }
}

fn near(a: f64, b: f64) -> bool {
    (a / b - 1.0).abs() < 1e-12
}

#[test]
fn a_poured_piece_has_its_volume_and_the_masses_of_white_and_yolk_in_every_shape() {
    let level = piece("egg", &spec(3));
    let volume: f64 = level.mesh().volumes().iter().sum();
    assert!(near(volume, 0.25 * core::f64::consts::PI * 0.110 * 0.110 * 0.0051), "{volume}");
    let aside = level.poured_as(&run_aside(&level)).expect("is meshed");
    let sum = |field: &[f64]| field.iter().sum::<f64>();
    for (one, other) in [
        (level.mesh().volumes(), aside.mesh().volumes()),
        (level.initial_water(), aside.initial_water()),
        (level.initial_fat(), aside.initial_fat()),
        (level.lean_solids(), aside.lean_solids()),
    ] {
        assert!(near(sum(one), sum(other)), "{} {}", sum(one), sum(other));
    }
    // A third of an egg is yolk, which has nearly all of its fat.
    let yolk = level.description().yolk.as_ref().expect("has a yolk");
    let fat = yolk.tissue.as_ref().expect("is stated").fat * yolk.share * 1028.0 * volume;
    assert!((sum(level.initial_fat()) / fat - 1.0).abs() < 0.05, "{} {fat}", sum(level.initial_fat()));
}

#[test]
fn a_shape_that_was_stored_is_built_as_it_was_poured() {
    let level = piece("egg", &spec(3));
    let poured = level.poured_as(&run_aside(&level)).expect("is meshed");
    let built = piece("egg", &run_aside(&level));
    let bits = |model: &FoodModel| -> Vec<u64> {
        let fields = model.mesh().volumes().iter().chain(model.initial_water()).chain(model.second_tissue());
        fields.map(|v| v.to_bits()).collect()
    };
    assert!(bits(&poured) == bits(&built));
}

#[test]
fn a_piece_that_runs_keeps_water_fat_and_heat_to_rounding_and_its_range_of_temperatures() {
    let level = piece("egg", &spec(3));
    let mut state = FoodState::raw(&level, ZERO_C + 8.0);
    for node in 0..state.temperature.len() {
        let [x, _, z] = level.mesh().position(node);
        state.temperature[node] = ZERO_C + 20.0 + 60.0 * x + 10.0 * libm::exp(-z / 1e-3);
        state.water[node] *= 0.95;
        state.changed.iter_mut().for_each(|change| change[node] = libm::exp(-z / 1e-3) * (0.7 + 4.0 * x));
        state.enthalpy[node] = level.properties().enthalpy(&level.masses(&state, node), state.temperature[node]).0;
    }
    let (low, high) = state.range();
    let over_volume = |model: &FoodModel, field: &[f64]| -> f64 {
        field.iter().zip(model.mesh().volumes()).map(|(v, volume)| v * volume).sum()
    };
    let aside = level.poured_as(&run_aside(&level)).expect("is meshed");
    let ran = aside.repoured(&level, &state);
    let sum = |field: &[f64]| field.iter().sum::<f64>();
    assert!(near(ran.total_enthalpy(), state.total_enthalpy()));
    assert!(near(sum(&ran.water), sum(&state.water)) && near(sum(&ran.fat), sum(&state.fat)));
    assert!(near(ran.mass(&aside), state.mass(&level)));
    for (ran, was) in ran.changed.iter().zip(&state.changed) {
        assert!(near(over_volume(&aside, ran), over_volume(&level, was)), "nothing un-cooks");
        assert!(ran.iter().all(|x| (0.0..=1.0).contains(x)));
    }
    // What was above has gone aside: the heat that is handed out to all makes less than a kelvin.
    let (lowest, highest) = ran.range();
    assert!(lowest > low - 1.0 && highest < high + 1.0, "{low}–{high} K became {lowest}–{highest}");
}

/// The dome of a yolk has its share of the volume: two thirds of its base times its height.
#[test]
fn a_yolk_has_its_share_of_the_volume() {
    let egg = piece("egg", &spec(1));
    let (yolk, dome) = (egg.description().yolk.as_ref().expect("has a yolk"), egg.pool().expect("is poured").dome);
    let volume: f64 = egg.mesh().volumes().iter().sum();
    let (steps, mut inside) = (80, 0.0);
    let cell = 2.0 * dome.radius / f64::from(steps);
    for i in 0..steps * steps * steps {
        let at = [i % steps, i / steps % steps, i / steps / steps].map(|k| (f64::from(k) + 0.5) * cell);
        let p = [at[0] - dome.radius, at[1] - dome.radius, at[2]];
        inside += if dome.depth(p) > 0.0 { cell * cell * cell } else { 0.0 };
    }
    assert!((inside / (yolk.share * volume) - 1.0).abs() < 0.02, "{inside} of {volume}");
}
