//! Promise: whatever is cooked, in whatever pan, however it is turned: nothing becomes non-finite, energy and water
//! balance, masses stay positive, and nothing un-cooks.

use proptest::prelude::*;
use saute_kitchen::food::Rules;
use saute_kitchen::{Command, Kitchen, Library, MeshSize, OutlineKind, Piece, PieceOrder, RestOn, TICK_S, kelvin};

/// A cook drawn at random.
#[derive(Clone, Debug)]
struct Draw {
    food: prop::sample::Index,
    pan: prop::sample::Index,
    size: [f64; 3],
    start_c: f64,
    pan_c: f64,
    seed: u64,
    schedule: Vec<(f64, Deed)>,
    rules: Rules,
}

#[derive(Clone, Copy, Debug)]
enum Deed {
    Hob(f64),
    Put,
    Flip,
    Rest(RestOn),
    Cloth,
    Lift(f64),
    Oil(f64),
    Butter(f64),
    Water(f64),
    Lid(bool),
    Tilt(f64, f64),
    Toss,
    Shake(f64),
}

fn deed() -> impl Strategy<Value = Deed> {
    prop_oneof![
        2 => (0.0..3500.0).prop_map(Deed::Hob),
        1 => Just(Deed::Put),
        3 => Just(Deed::Flip),
        2 => prop_oneof![Just(RestOn::Board), Just(RestOn::Rack), Just(RestOn::Foil)].prop_map(Deed::Rest),
        1 => Just(Deed::Cloth),
        1 => (0.0..0.05).prop_map(Deed::Lift),
        1 => (-0.01..0.05).prop_map(Deed::Oil),
        1 => (-0.01..0.05).prop_map(Deed::Butter),
        1 => (-0.01..0.1).prop_map(Deed::Water),
        2 => any::<bool>().prop_map(Deed::Lid),
        2 => (0.0..1.4, 0.0..6.3).prop_map(|(angle, towards)| Deed::Tilt(angle, towards)),
        2 => Just(Deed::Toss),
        2 => (0.5..6.0).prop_map(Deed::Shake),
    ]
}

fn draw() -> impl Strategy<Value = Draw> {
    let sizes = [0.0..1.0, 0.0..1.0, 0.0..1.0];
    let schedule = prop::collection::vec((0.0..60.0, deed()), 1..8);
    let rules = prop_oneof![4 => Just(Rules::Full), 1 => Just(Rules::Paper2013)];
    (
        any::<prop::sample::Index>(),
        any::<prop::sample::Index>(),
        sizes,
        0.0..40.0,
        20.0..320.0,
        0..1000u64,
        schedule,
        rules,
    )
        .prop_map(|(food, pan, size, start_c, pan_c, seed, schedule, rules)| Draw {
            food,
            pan,
            size,
            start_c,
            pan_c,
            seed,
            schedule,
            rules,
        })
}

/// The kitchen of a draw, with a piece whose sizes are at the drawn places of the allowed ranges.
fn kitchen(library: &Library, draw: &Draw) -> Kitchen {
    let pans: Vec<&String> = library.pans.keys().collect();
    let foods: Vec<&String> = library.foods.keys().collect();
    let (pan, kind) = (pans[draw.pan.index(pans.len())], foods[draw.food.index(foods.len())]);
    let food = &library.foods[kind];
    let within = |axis: usize| {
        let (low, high) = (food.size.min_mm[axis], food.size.max_mm[axis].min(130.0));
        1e-3 * (low + draw.size[axis] * (high - low))
    };
    let given: Vec<f64> = (0..food.form.dimensions().len()).map(within).collect();
    let mut kitchen = Kitchen::new(library, pan, kelvin(draw.pan_c)).expect("pan");
    let order = PieceOrder {
        id: "it".into(),
        kind: kind.clone(),
        size: food.form.extent(&given).expect("dimensions"),
        temperature: kelvin(draw.start_c),
        seed: draw.seed,
        coarseness: 2.5,
        rules: draw.rules,
        mesh: MeshSize::Default,
        outline: OutlineKind::Plain,
    };
    kitchen.add(library, &order).expect("builds");
    kitchen
}

fn command(deed: Deed) -> Command {
    let food = "it".to_owned();
    match deed {
        Deed::Hob(w) => Command::Hob(w),
        Deed::Put => Command::Put { food, at: [0.0, 0.0], heap: false },
        Deed::Flip => Command::Flip { food },
        Deed::Rest(on) => Command::Rest { food, on },
        Deed::Cloth => Command::Cool { for_s: 2.0 },
        Deed::Lift(lift) => Command::MovePan { at: [0.01, 0.0], lift },
        Deed::Oil(mass) => Command::Oil { kind: Some("olive".into()), mass },
        Deed::Butter(mass) => Command::Butter(mass),
        Deed::Water(mass) => Command::Water(mass),
        Deed::Lid(on) => Command::Lid(on),
        Deed::Tilt(angle, towards) => Command::Tilt { angle, towards },
        Deed::Toss => Command::Toss { height: 0.1 },
        Deed::Shake(hz) => Command::Shake { amplitude: 0.03, hz, for_s: 1.0 },
    }
}

/// Fields that must never fall: sums over the nodes, which a piece keeps for life; of a poured one, whose nodes are others in each shape,
/// sums over its volume, which shapes keep to rounding.
fn progress(kitchen: &Kitchen) -> Vec<f64> {
    let Piece { model, state, .. } = &kitchen.pieces()[0];
    let volumes = model.pool().map(|_| model.mesh().volumes());
    let sum = |v: &Vec<f64>| match volumes {
        None => v.iter().sum::<f64>(),
        Some(volumes) => v.iter().zip(volumes).map(|(v, volume)| v * volume).sum(),
    };
    let mut sums = vec![sum(&state.peak), sum(&state.browning), sum(&state.charring), sum(&state.lethality)];
    sums.extend(state.changed.iter().map(sum));
    // Vapour also condenses, on a face below the dew point: the evaporated water may fall.
    sums.extend([state.dripped, state.rendered]);
    sums
}

/// Number of random cooks: SAUTE_RANDOM_COOKS, or as many as `./test.sh` takes (scripts/campaign_share.sh).
fn random_cooks() -> u32 {
    std::env::var("SAUTE_RANDOM_COOKS").map_or(24, |count| count.parse().expect("a number"))
}

proptest! {
    #![proptest_config(ProptestConfig { cases: random_cooks(), ..ProptestConfig::default() })]

    #[test]
    fn any_cook_keeps_the_laws(draw in draw()) {
        let library = Library::embedded().expect("embedded data");
        let mut kitchen = kitchen(&library, &draw);
        let raw = kitchen.pieces()[0].mass();
        let water: f64 = kitchen.pieces()[0].state.water.iter().sum();
        // A deed may be refused, as flipping a piece that is not in the pan; then nothing changes.
        kitchen.apply(&command(Deed::Put)).expect("fits");
        let mut before = progress(&kitchen);
        for (wait, deed) in &draw.schedule {
            let _ = kitchen.apply(&command(*deed));
            (0..(wait / TICK_S) as usize).for_each(|_| kitchen.step());
            let now = progress(&kitchen);
            let rounding = if kitchen.pieces()[0].model.pool().is_some() { 1e-12 } else { 0.0 };
            let kept = |(n, b): (&f64, &f64)| *n >= b - rounding * b.abs();
            prop_assert!(now.iter().zip(&before).all(kept), "{now:?} after {before:?}");
            before = now;
        }
        let piece = &kitchen.pieces()[0];
        let (model, state) = (&piece.model, &piece.state);
        prop_assert!(state.healthy);
        for field in [&state.temperature, &state.water, &state.juice, &state.fat, &state.enthalpy, &state.browning] {
            prop_assert!(field.iter().all(|v| v.is_finite()));
        }
        for (name, mass) in [("water", &state.water), ("juice", &state.juice), ("fat", &state.fat)] {
            let least = mass.iter().copied().fold(f64::INFINITY, f64::min);
            prop_assert!(least >= 0.0, "{name} of {least} kg in a node of {}", kitchen.pieces()[0].kind);
        }
        prop_assert!(state.evaporated > -0.02 * raw, "{} condensed", -state.evaporated);
        let lost = state.evaporated + state.dripped;
        let left: f64 = state.water.iter().sum();
        prop_assert!((water - lost - left).abs() <= 1e-3 * water, "water {water} lost {lost} left {left}");
        prop_assert!((raw - lost - state.rendered - state.mass(model)).abs() <= 1e-9 * raw.max(1e-3));
        let pan = kitchen.pan_state();
        prop_assert!(pan.temperature.iter().all(|t| (kelvin(-1.0)..kelvin(1200.0)).contains(t)));
        prop_assert!(pan.liquids.oil.mass.iter().chain(&pan.liquids.water.mass).all(|m| *m >= 0.0));
        prop_assert!(pan.lid.is_none_or(|lid| lid.vapour >= 0.0 && lid.air_temperature() < kelvin(600.0)));
        let energy = kitchen.energy();
        let gross = energy.hob + energy.air.abs() + energy.evaporation + energy.other.abs() + energy.pan_stored.abs();
        prop_assert!(energy.imbalance.abs() <= 1e-3 * gross.max(1.0), "{energy:?}");
        prop_assert!(state.changed.iter().flatten().all(|x| (0.0..=1.0).contains(x)));
        prop_assert!((0.1..=1.0 + 1e-9).contains(&model.relative_volume(state)));
        let (low, high) = state.range();
        prop_assert!(low > kelvin(-1.0) && high < kelvin(1200.0), "{low} {high}");
    }
}
