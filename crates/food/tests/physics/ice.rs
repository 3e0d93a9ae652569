//! Promise: frozen food melts: its heat, conductivity and time to thaw are those of frozen meat, and no energy is lost.

use std::array::from_fn;

use saute_food::{FoodState, FreeAir, ZERO_C};

use crate::run::{Run, kitchen_air, lean, model};

/// Enthalpy of lean beef [kJ/kg] and its conductivity [W/(m·K)] at a temperature [°C].
fn of_beef(celsius: f64) -> (f64, f64) {
    let raw = &lean().description().lean;
    let masses = [raw.water, raw.lean_solids(), raw.fat];
    let (properties, t) = (lean().properties(), ZERO_C + celsius);
    (1e-3 * properties.enthalpy(&masses, t).0, properties.conductivity(&masses, t))
}

/// Enthalpies of lean, fresh beef (74.5 % water) above −40 °C [kJ/kg], after Riedel 1957 `[@riedel-1957]` as handbooks of
/// refrigeration quote him.
const RIEDEL: [[f64; 2]; 6] = [[-20.0, 42.0], [-10.0, 72.0], [-5.0, 105.0], [-3.0, 138.0], [-2.0, 180.0], [0.0, 304.0]];

#[test]
fn frozen_beef_holds_the_measured_heat() {
    for [celsius, above] in RIEDEL {
        let (measured, got) = (304.0 - above, of_beef(0.0).0 - of_beef(celsius).0);
        assert!((got - measured).abs() < 12.0, "{celsius} °C: {got:.0} of {measured} kJ/kg");
    }
}

/// About three times as well as raw.
#[test]
fn frozen_beef_conducts_three_times_as_well_as_raw() {
    let ratio = of_beef(-20.0).1 / of_beef(5.0).1;
    assert!((2.5..3.5).contains(&ratio), "{ratio}");
}

/// The temperature of an enthalpy is exact across the leap of the capacity at the beginning of freezing.
#[test]
fn temperature_and_enthalpy_agree_in_ice() {
    let masses = [0.73, 0.235, 0.035];
    let properties = lean().properties();
    for step in -320..100 {
        let t = ZERO_C + 0.1 * f64::from(step);
        let (enthalpy, _) = properties.enthalpy(&masses, t);
        for guess in [t - 15.0, t, t + 60.0] {
            let (found, capacity) = properties.temperature(&masses, enthalpy, guess);
            assert!((found - t).abs() < 1e-8 && capacity > 0.0, "{t} from {guess}: {found}");
        }
    }
}

/// Eight temperatures that are found together are those found alone, to the last bit: also where some are frozen, near the leap of
/// the capacity, far from the guess, or beyond the table.
#[test]
fn temperatures_found_together_are_those_found_alone() {
    let properties = lean().properties();
    for first in -60..500 {
        let masses: [_; 8] = from_fn(|k| [0.73 - 0.05 * k as f64, 0.235, 0.035 + 0.01 * k as f64]);
        let celsius: [f64; 8] = from_fn(|k| f64::from(first) + [0.0, 0.3, 41.0, 1e-9, -0.5, 7.7, 0.0, 90.0][k]);
        let enthalpy: [f64; 8] = from_fn(|k| properties.enthalpy(&masses[k], ZERO_C + celsius[k]).0);
        let guess: [f64; 8] = from_fn(|k| ZERO_C + celsius[k] + [0.0, 1e-6, -3.0, 20.0, 0.0, 1e-11, -60.0, 0.1][k]);
        let (together, capacities) = properties.temperatures(&masses, &enthalpy, &guess);
        for k in 0..8 {
            let (t, capacity) = properties.temperature(&masses[k], enthalpy[k], guess[k]);
            let bits = |t: f64, capacity: f64| (t.to_bits(), capacity.to_bits());
            assert_eq!(bits(together[k], capacities[k]), bits(t, capacity), "{} °C", celsius[k]);
        }
    }
}

/// Plank's equation for a slab: t = ρL/(T_a − T_f) (a/2h + a²/8k), which leaves out the sensible heat.
#[test]
fn a_slab_thaws_in_the_time_of_planks_equation() {
    let thickness = 0.012;
    let steak = model("beef-lean", 2.0, [0.12, 0.08, thickness]);
    let mut run = Run::new(&steak, -5.0);
    let [bath, h] = [20.0, 1000.0];
    let water = FreeAir {
        temperature: ZERO_C + bath,
        walls: ZERO_C + bath,
        convection: h,
        mass_transfer: 0.0,
        radiation: 0.0,
        ..kitchen_air()
    };
    let mut seconds = 0.0;
    while steak.core_temperature(&run.state) < ZERO_C - 0.5 {
        run.fry(1.0, bath, h, water);
        seconds += 1.0;
        assert!(seconds < 1500.0, "{} °C", steak.core_temperature(&run.state) - ZERO_C);
    }
    let raw = FoodState::raw(&steak, ZERO_C + 5.0).mass(&steak);
    let density = raw / steak.mesh().volumes().iter().sum::<f64>();
    let heat = 1e3 * (of_beef(0.0).0 - of_beef(-5.0).0) * density;
    // Flesh conducts along its fibres, through the thickness, by a separate factor.
    let along = steak.description().anisotropy.as_ref().map_or(1.0, |a| a.along);
    let conductivity = along * of_beef(5.0).1;
    let plank = heat / (bath + 1.0) * (thickness / (2.0 * h) + thickness * thickness / (8.0 * conductivity));
    assert!((0.85..1.15).contains(&(seconds / plank)), "{seconds} s, Plank {plank:.0} s");
}

/// What a frozen piece takes up is what it contains afterwards.
#[test]
fn thawing_keeps_energy() {
    let steak = model("beef-lean", 2.5, [0.06, 0.05, 0.015]);
    let mut run = Run::new(&steak, -18.0);
    let before = FoodState::raw(&steak, ZERO_C - 18.0).total_enthalpy();
    run.fry(240.0, 180.0, 400.0, kitchen_air());
    let passed = &run.passed;
    let gained = passed.contact - passed.air - passed.evaporation - passed.runoff_enthalpy;
    assert!((run.state.total_enthalpy() - before - gained).abs() < 1e-9 * passed.contact, "{gained} J");
    let mass = run.state.mass(&steak) + passed.evaporated + passed.drip + passed.rendered;
    let raw = FoodState::raw(&steak, ZERO_C - 18.0).mass(&steak);
    assert!((mass / raw - 1.0).abs() < 1e-12, "{mass} kg");
}
