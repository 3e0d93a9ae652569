//! Promise: masses and thermal properties follow from the composition and the volume of the mesh.

use saute_food::{FoodState, ZERO_C};

use crate::run::{lean, model, swept_mesh};

#[test]
fn the_default_steak_has_at_least_8000_nodes() {
    let steak = model("beef-lean", 1.0, [0.12, 0.08, 0.025]);
    assert!(steak.mesh().node_count() >= 8000, "{}", steak.mesh().node_count());
    assert_eq!(swept_mesh(&steak).section.clamped_edges, 0);
}

/// Density of lean beef 1058 kg/m³ (Choi & Okos); the mass follows from the volume of the mesh.
#[test]
fn the_raw_mass_is_that_of_its_volume() {
    let steak = lean();
    let volume: f64 = steak.mesh().volumes().iter().sum();
    let mass = FoodState::raw(steak, ZERO_C + 5.0).mass(steak);
    assert!((mass / volume / 1058.0 - 1.0).abs() < 0.005, "{}", mass / volume);
}

/// Conductivity and specific heat of lean beef at 20 and 60 °C from composition: 0.494, 0.538 W/(m·K); 3.59, 3.61 kJ/(kg·K).
#[test]
fn properties_match_the_composition_models() {
    let steak = lean();
    let masses = [0.730, 0.235, 0.035];
    for (c, k, cp) in [(20.0, 0.494, 3590.0), (60.0, 0.538, 3610.0)] {
        assert!((steak.properties().conductivity(&masses, ZERO_C + c) / k - 1.0).abs() < 0.01, "k at {c}");
        // The melting of the 3.5 % fat adds up to 0.09 kJ/(kg·K) near 38 °C and 0.01 at 60.
        assert!((steak.properties().enthalpy(&masses, ZERO_C + c).1 / cp - 1.0).abs() < 0.02, "cp at {c}");
    }
}

#[test]
fn marbling_keeps_its_mean_and_conducts_less() {
    let steak = model("beef-marbled", 1.6, [0.12, 0.08, 0.025]);
    let fat: f64 = steak.initial_fat().iter().sum();
    let mass = FoodState::raw(&steak, ZERO_C + 5.0).mass(&steak);
    assert!((fat / mass - 0.20).abs() < 0.04, "{}", fat / mass);
    assert!(steak.adipose().iter().any(|&s| s > 0.6) && steak.adipose().iter().any(|&s| s < 0.05));
    let k = |fractions: [f64; 3]| steak.properties().conductivity(&fractions, ZERO_C + 20.0);
    assert!(k([0.10, 0.025, 0.875]) < 0.25 && k([0.73, 0.235, 0.035]) > 0.45);
}
