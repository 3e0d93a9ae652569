//! Promise: oil, butter and water in the pan keep their mass and their heat, run to the low side and come back, melt, boil,
//! foam, brown, smoke, burn and spatter as they should, and a lid keeps what rises.

use saute_kitchen::food::Rules;
use saute_kitchen::liquids::drop_flight::Landing;
use saute_kitchen::liquids::water_film::WATER_DENSITY;
use saute_kitchen::pan::LEVEL;
use saute_kitchen::{Command, EventKind, Kitchen, Library, PieceOrder, Refused, TICK_S, celsius, kelvin};

use crate::stove::{apply, imbalance, library, run};

fn pan_at(celsius: f64) -> Kitchen {
    Kitchen::new(&library(), "carbon-steel-26", kelvin(celsius)).expect("pan")
}

fn pour(kitchen: &mut Kitchen, kind: &str, grams: f64) {
    apply(kitchen, Command::Oil { kind: Some(kind.into()), mass: 1e-3 * grams });
}

/// Gravity in the frame of a pan that is tilted by so many degrees, down towards +x.
fn tilted(degrees: f64) -> [f64; 3] {
    let (sin, cos) = degrees.to_radians().sin_cos();
    [-LEVEL[2] * sin, 0.0, LEVEL[2] * cos]
}

/// Tilts the pan by so many degrees, down towards +x.
fn tilt(kitchen: &mut Kitchen, degrees: f64) {
    apply(kitchen, Command::Tilt { angle: degrees.to_radians(), towards: 0.0 });
}

fn steak() -> PieceOrder {
    PieceOrder {
        id: "steak".into(),
        kind: "beef-lean".into(),
        size: [0.10, 0.07, 0.02],
        temperature: kelvin(5.0),
        seed: 1,
        coarseness: 2.0,
        rules: Rules::Full,
        mesh: saute_kitchen::MeshSize::Default,
        outline: saute_kitchen::OutlineKind::Plain,
    }
}

fn frying(pan_c: f64) -> Kitchen {
    let mut kitchen = pan_at(pan_c);
    kitchen.add(&library(), &steak()).expect("food");
    apply(&mut kitchen, Command::Put { food: "steak".into(), at: [0.0, 0.0], heap: false });
    kitchen
}

#[test]
fn a_level_pan_keeps_the_even_film_that_the_contact_model_was_calibrated_with() {
    let mut kitchen = pan_at(20.0);
    apply(&mut kitchen, Command::Hob(1000.0));
    run(&mut kitchen, 120.0);
    let (pan, state, contact) = (kitchen.pan_model(), kitchen.pan_state(), &kitchen.room().contact);
    let even = 1e-3 * contact.oil_g / (contact.oil_density_kg_m3 * pan.floor_area);
    for i in 0..pan.floor_nodes {
        assert!((state.liquids.film[i] / even - 1.0).abs() < 1e-3, "{i}: {} of {even}", state.liquids.film[i]);
    }
    assert!(state.liquids.film[pan.floor_nodes..].iter().all(|h| *h == 0.0));
}

#[test]
fn oil_that_runs_keeps_its_mass_and_its_heat_and_is_nowhere_negative() {
    let mut kitchen = pan_at(150.0);
    pour(&mut kitchen, "sunflower", 20.0);
    let before = kitchen.pan_state().oil_mass();
    let shake = Command::Shake { amplitude: 0.05, hz: 4.0, for_s: 5.0 };
    let slanting = Command::Tilt { angle: 1.2, towards: 4.0 };
    let level = Command::Tilt { angle: 0.0, towards: 0.0 };
    for (step, motion) in [slanting, shake, Command::Tilt { angle: 2.6, towards: 1.0 }, level].iter().enumerate() {
        apply(&mut kitchen, motion.clone());
        run(&mut kitchen, 6.0);
        let liquids = &kitchen.pan_state().liquids;
        assert!(liquids.oil.mass.iter().all(|m| *m >= 0.0), "{step}");
        let gone = liquids.spilled + liquids.spatter.spattered + liquids.smoke.smoked;
        assert!(((liquids.oil.total() + gone) / before - 1.0).abs() < 1e-12, "{step}");
        let by_kind: f64 = liquids.oil.fats.iter().flat_map(|f| &f.mass).sum();
        assert!((by_kind / liquids.oil.total() - 1.0).abs() < 1e-12);
    }
    assert!(imbalance(&kitchen) < 1e-9, "{:?}", kitchen.energy());
    assert!(kitchen.pan_state().temperature.iter().all(|t| (kelvin(20.0)..kelvin(151.0)).contains(t)));
}

/// Height of the liquid's surface against gravity at every node where it is deeper than `least` [m].
fn surfaces(kitchen: &Kitchen, thickness: &[f64], gravity: [f64; 3], least: f64) -> Vec<f64> {
    let bed = &kitchen.pan_model().liquids.bed;
    let g = gravity.iter().map(|v| v * v).sum::<f64>().sqrt();
    let wet = (0..thickness.len()).filter(|&i| thickness[i] > least);
    wet.map(|i| {
        let surface: Vec<f64> = (0..3).map(|k| bed.places[i][k] + thickness[i] * bed.normals[i][k]).collect();
        -surface.iter().zip(&gravity).map(|(x, g)| x * g).sum::<f64>() / g
    })
    .collect()
}

fn spread(values: &[f64]) -> f64 {
    values.iter().copied().fold(f64::NEG_INFINITY, f64::max) - values.iter().copied().fold(f64::INFINITY, f64::min)
}

#[test]
fn a_tilted_pan_has_a_level_pool_on_its_low_side_that_returns_when_it_is_set_down() {
    let mut kitchen = pan_at(120.0);
    pour(&mut kitchen, "canola", 60.0);
    let gravity = tilted(12.0);
    tilt(&mut kitchen, 12.0);
    run(&mut kitchen, 60.0);
    let low_share = |kitchen: &Kitchen| {
        let (bed, mass) = (&kitchen.pan_model().liquids.bed, &kitchen.pan_state().liquids.oil.mass);
        let low: f64 = (0..mass.len()).filter(|&i| bed.places[i][0] > 0.03).map(|i| mass[i]).sum();
        low / kitchen.pan_state().oil_mass()
    };
    assert!(low_share(&kitchen) > 0.9, "{}", low_share(&kitchen));
    let oil = &kitchen.pan_model().liquids.oils[kitchen.pan_state().liquids.oil.fats[0].kind];
    let mean = kitchen.pan_temperature();
    let bed = &kitchen.pan_model().liquids.bed;
    let mass = &kitchen.pan_state().liquids.oil.mass;
    let depth: Vec<f64> = mass.iter().zip(&bed.areas).map(|(m, a)| m / (oil.density(mean) * a)).collect();
    let heights = surfaces(&kitchen, &depth, gravity, 1.5e-3);
    assert!(heights.len() > 10 && spread(&heights) < 0.3e-3, "{} nodes, {} m", heights.len(), spread(&heights));
    tilt(&mut kitchen, 0.0);
    run(&mut kitchen, 60.0);
    assert!(low_share(&kitchen) < 0.45, "{}", low_share(&kitchen));
}

/// q = ρ g sin α h³/(3μ): while a film drains, its thickness at a distance x from the upper edge goes towards
/// √(μ x/(ρ g sin α t)) (Jeffreys 1930).
#[test]
fn a_draining_film_thins_by_jeffreys_law() {
    let mut kitchen = pan_at(100.0);
    pour(&mut kitchen, "canola", 5.0);
    tilt(&mut kitchen, 10.0);
    run(&mut kitchen, 30.0);
    let pan = kitchen.pan_model();
    let oil = &pan.liquids.oils[kitchen.pan_state().liquids.oil.fats[0].kind];
    let warm = 0.5 * (kelvin(100.0) + kitchen.pan_temperature());
    let density = oil.density(warm);
    let g = -LEVEL[2] * 10f64.to_radians().sin();
    for (x, y) in [(0.02, 0.0), (-0.02, 0.0), (0.0, 0.01)] {
        let at = pan.locator.locate(&pan.section, [x, y]).expect("on the floor");
        let mass: f64 = (0..3)
            .map(|k| {
                let i = at.nodes[k] as usize;
                at.weights[k] * kitchen.pan_state().liquids.oil.mass[i] / (density * pan.liquids.bed.areas[i])
            })
            .sum();
        let from_edge = x + (0.1f64 * 0.1 - y * y).sqrt();
        let exact = (from_edge / (density * g * oil.fluidity(warm) * 30.0)).sqrt();
        assert!((mass / exact - 1.0).abs() < 0.15, "{x}: {mass} against {exact}");
    }
}

#[test]
fn cold_oil_cools_the_pan_by_what_it_takes_to_warm_it() {
    let mut kitchen = pan_at(180.0);
    let before = kitchen.pan_model().stored(kitchen.pan_state());
    pour(&mut kitchen, "olive", 30.0);
    let oil = &library().oils["olive"].fluid;
    let brought = 0.030 * oil.specific_heat_j_kgk * 23.0;
    let after = kitchen.pan_model().stored(kitchen.pan_state());
    assert!((after - before - brought).abs() < 1e-6 * after, "{}", after - before - brought);
    assert!(celsius(kitchen.pan_temperature()) < 165.0);
}

#[test]
fn water_in_a_hot_pan_boils_away_and_takes_its_latent_heat_from_the_pan() {
    let mut kitchen = pan_at(210.0);
    apply(&mut kitchen, Command::Water(0.005));
    let before = kitchen.pan_model().stored(kitchen.pan_state());
    let air = kitchen.energy().air;
    let mut vapour = 0.0;
    for _ in 0..1200 {
        kitchen.step();
        vapour += kitchen.other_vapour().0 * TICK_S;
    }
    let left = kitchen.pan_state().water_mass();
    assert!(left < 1e-4, "{left}");
    assert!(((vapour + left) / 0.005 - 1.0).abs() < 1e-12, "{vapour}");
    let after = kitchen.pan_model().stored(kitchen.pan_state());
    let e = kitchen.energy();
    assert!((0.005 * 2.6e6..0.005 * 2.75e6).contains(&e.evaporation), "{}", e.evaporation);
    assert!(before - after > e.evaporation && e.air > air);
    assert!(imbalance(&kitchen) < 1e-9, "{e:?}");
}

/// Leidenfrost: a pan at 280 °C boils a splash of water away more slowly than one at 180 °C.
#[test]
fn a_very_hot_pan_boils_water_more_slowly_than_a_hot_one() {
    let rate = |celsius: f64| {
        let mut kitchen = pan_at(celsius);
        apply(&mut kitchen, Command::Water(0.004));
        run(&mut kitchen, 0.5);
        0.004 - kitchen.pan_state().water_mass()
    };
    assert!(rate(280.0) < 0.5 * rate(180.0), "{} {}", rate(280.0), rate(180.0));
}

#[test]
fn water_runs_to_the_low_side_and_over_the_rim_of_a_pan_on_edge() {
    let mut kitchen = pan_at(40.0);
    apply(&mut kitchen, Command::Water(0.2));
    let gravity = tilted(20.0);
    tilt(&mut kitchen, 20.0);
    run(&mut kitchen, 20.0);
    let (state, bed) = (kitchen.pan_state(), &kitchen.pan_model().liquids.bed);
    let depth: Vec<f64> =
        state.liquids.water.mass.iter().zip(&bed.areas).map(|(m, a)| m / (WATER_DENSITY * a)).collect();
    let heights = surfaces(&kitchen, &depth, gravity, 3e-3);
    assert!(heights.len() > 10 && spread(&heights) < 0.5e-3, "{} nodes, {} m", heights.len(), spread(&heights));
    assert!(state.liquids.spilled == 0.0);
    tilt(&mut kitchen, 100.0);
    run(&mut kitchen, 20.0);
    let liquids = &kitchen.pan_state().liquids;
    assert!(liquids.spilled > 0.15 && liquids.water.total() < 0.05, "{}", liquids.spilled);
    assert!(imbalance(&kitchen) < 1e-9);
}

#[test]
fn juice_stays_where_it_drips_until_it_boils() {
    let mut kitchen = frying(160.0);
    apply(&mut kitchen, Command::Hob(500.0));
    let mut seen = 0.0_f64;
    for _ in 0..4000 {
        kitchen.step();
        seen = seen.max(kitchen.pan_state().water_mass());
    }
    assert!(seen > 1e-6 && seen < 5e-3, "{seen}");
    assert!(imbalance(&kitchen) < 1e-9, "{:?}", kitchen.energy());
}

#[test]
fn butter_melts_foams_and_its_milk_solids_brown_and_burn() {
    let mut kitchen = pan_at(140.0);
    apply(&mut kitchen, Command::Hob(400.0));
    apply(&mut kitchen, Command::Butter(0.020));
    let mut most_foam = 0.0_f64;
    let mut molten_at = None;
    for _ in 0..600 {
        kitchen.step();
        let state = kitchen.pan_state();
        most_foam = most_foam.max(state.foam());
        if state.liquids.butter.lump.is_none() {
            molten_at.get_or_insert(kitchen.time_s());
        }
    }
    let molten = molten_at.expect("has molten");
    assert!((10.0..60.0).contains(&molten), "{molten} s");
    assert!(most_foam > 0.3, "{most_foam}");
    let kind = kitchen.pan_model().liquids.butter_kind().expect("butter");
    assert!((kitchen.pan_state().liquids.oil.total_of(kind) / (0.020 * 0.84) - 1.0).abs() < 0.02);
    let early = kitchen.pan_state().milk_solids_browning();
    run(&mut kitchen, 240.0);
    let state = kitchen.pan_state();
    assert!(state.water_mass() < 1e-6 && state.foam() < 0.05);
    assert!(state.milk_solids_browning() > early && state.milk_solids_browning() > 0.5);
    assert!(state.liquids.butter.charring > 0.0);
    assert!(imbalance(&kitchen) < 1e-9, "{:?}", kitchen.energy());
}

/// What melts has taken its latent heat: before, after and in between the sum of all stores changes by what left alone.
#[test]
fn melting_butter_keeps_mass_and_energy() {
    let mut kitchen = pan_at(90.0);
    apply(&mut kitchen, Command::Hob(300.0));
    let before = kitchen.pan_state().liquids.total();
    apply(&mut kitchen, Command::Butter(0.015));
    let mut evaporated = 0.0;
    for _ in 0..1500 {
        kitchen.step();
        evaporated += kitchen.other_vapour().0 * TICK_S;
        let liquids = &kitchen.pan_state().liquids;
        let total = liquids.total() + liquids.smoke.smoked + liquids.spatter.spattered + evaporated;
        assert!((total / (before + 0.015) - 1.0).abs() < 1e-12);
        assert!(imbalance(&kitchen) < 1e-9);
    }
    assert!(kitchen.pan_state().liquids.butter.lump.is_none());
}

#[test]
fn oil_smokes_above_its_smoke_point_more_the_hotter_it_is_and_tells_once() {
    let smoke = |celsius: f64| {
        let mut kitchen = pan_at(celsius);
        run(&mut kitchen, 2.0);
        (kitchen.pan_state().smoke_mg_s(), kitchen.events().tally(EventKind::SmokeBegins).count)
    };
    assert_eq!(smoke(210.0), (0.0, 0));
    let (at_240, told) = smoke(240.0);
    let (at_264, _) = smoke(264.0);
    assert_eq!(told, 1);
    assert!((3.0..5.0).contains(&(at_264 / at_240)), "{at_240} {at_264}");
    let mut kitchen = pan_at(250.0);
    let before = kitchen.pan_state().oil_mass();
    apply(&mut kitchen, Command::Hob(800.0));
    run(&mut kitchen, 60.0);
    let liquids = &kitchen.pan_state().liquids;
    let gone = liquids.smoke.smoked + liquids.smoke.burnt;
    assert!(gone > 0.0 && ((before - gone) / liquids.oil.total() - 1.0).abs() < 1e-12);
    assert!(imbalance(&kitchen) < 1e-9, "{:?}", kitchen.energy());
}

#[test]
fn oil_passes_its_flash_point_catches_fire_and_the_lid_puts_it_out() {
    let mut kitchen = pan_at(330.0);
    run(&mut kitchen, 1.0);
    assert_eq!(kitchen.events().tally(EventKind::FlashPoint).count, 1);
    assert_eq!(kitchen.events().tally(EventKind::Fire).count, 0);
    let mut kitchen = pan_at(360.0);
    run(&mut kitchen, 1.0);
    assert!(kitchen.pan_state().liquids.smoke.burning && kitchen.pan_state().liquids.smoke.burnt > 0.0);
    let fire = kitchen.events().tally(EventKind::Fire);
    assert!(fire.count == 1 && fire.kind.advice().is_some_and(|a| a.contains("lid")));
    apply(&mut kitchen, Command::Lid(true));
    run(&mut kitchen, 1.0);
    assert!(!kitchen.pan_state().liquids.smoke.burning);
}

#[test]
fn steam_under_oil_spatters_in_proportion_the_same_way_every_time() {
    let fry = |oil_g: f64| {
        let mut kitchen = frying(180.0);
        pour(&mut kitchen, "canola", oil_g);
        apply(&mut kitchen, Command::Hob(800.0));
        run(&mut kitchen, 60.0);
        let count = [EventKind::Spatter, EventKind::Pop].map(|k| kitchen.events().tally(k).count);
        (count[0] + count[1], kitchen.pan_state().liquids.spatter.spattered, kitchen)
    };
    let (few, _, _) = fry(1.0);
    let (many, lost, kitchen) = fry(25.0);
    assert!(few > 3 && many > 2 * few, "{few} {many}");
    assert!((1e-6..1e-3).contains(&lost), "{lost}");
    assert!(kitchen.events().latest().any(|e| e.kind == EventKind::Spatter && e.amount > 0.0));
    let (again, lost_again, _) = fry(25.0);
    assert_eq!((many, lost.to_bits()), (again, lost_again.to_bits()));
    assert!(imbalance(&kitchen) < 1e-9);
}

#[test]
fn water_in_hot_oil_is_told_and_spatters() {
    let mut kitchen = pan_at(180.0);
    pour(&mut kitchen, "canola", 50.0);
    run(&mut kitchen, 1.0);
    assert_eq!(kitchen.events().tally(EventKind::Spatter).count, 0);
    apply(&mut kitchen, Command::Water(0.010));
    run(&mut kitchen, 10.0);
    let told = kitchen.events().tally(EventKind::WaterInHotOil);
    assert!(told.count == 1 && told.amount == 0.010);
    assert!(kitchen.events().tally(EventKind::Spatter).count > 20);
}

#[test]
fn under_a_lid_water_stays_in_the_pan_and_everything_balances() {
    let boil = |lid: bool| {
        let mut kitchen = pan_at(60.0);
        apply(&mut kitchen, Command::Water(0.15));
        let before = kitchen.pan_state().water_mass();
        let mut vapour = 0.0;
        apply(&mut kitchen, Command::Lid(lid));
        apply(&mut kitchen, Command::Hob(500.0));
        let under = kitchen.pan_state().lid.map_or(0.0, |l| l.vapour);
        for _ in 0..3000 {
            kitchen.step();
            vapour += kitchen.other_vapour().0 * TICK_S;
            let state = kitchen.pan_state();
            let total = state.water_mass() + state.lid.map_or(0.0, |l| l.vapour) + vapour;
            assert!((total / (before + under) - 1.0).abs() < 1e-10);
        }
        assert!(imbalance(&kitchen) < 1e-9, "{:?}", kitchen.energy());
        (kitchen.pan_state().water_mass(), kitchen)
    };
    let (open, _) = boil(false);
    let (covered, mut kitchen) = boil(true);
    assert!(covered > open + 0.01, "{covered} {open}");
    let lid = kitchen.pan_state().lid.expect("on");
    assert!((85.0..101.0).contains(&celsius(lid.air_temperature())), "{}", celsius(lid.air_temperature()));
    assert!((60.0..100.0).contains(&celsius(lid.temperature)), "{}", celsius(lid.temperature));
    apply(&mut kitchen, Command::Lid(false));
    assert!(kitchen.events().tally(EventKind::SteamReleased).amount > 5e-4);
    assert!(kitchen.pan_state().lid.is_none() && imbalance(&kitchen) < 1e-9);
    run(&mut kitchen, 10.0);
    assert!(imbalance(&kitchen) < 1e-9);
}

#[test]
fn food_under_a_lid_heats_from_above_and_loses_less_weight() {
    let cook = |lid: bool| {
        let mut kitchen = frying(150.0);
        apply(&mut kitchen, Command::Water(0.005));
        apply(&mut kitchen, Command::Lid(lid));
        apply(&mut kitchen, Command::Hob(500.0));
        // Little water: the steam of more condenses on the cold food of an open pan as well.
        run(&mut kitchen, 400.0);
        assert!(kitchen.pieces()[0].state.healthy && imbalance(&kitchen) < 1e-9, "{:?}", kitchen.energy());
        let piece = &kitchen.pieces()[0];
        (celsius(piece.face(false)), celsius(piece.core()), piece.state.evaporated)
    };
    let ((open, open_core, open_lost), (covered, core, lost)) = (cook(false), cook(true));
    assert!(covered > open + 10.0, "{covered} {open}");
    assert!(core > open_core, "{core} {open_core}");
    assert!(lost < open_lost, "{lost} {open_lost}");
}

#[test]
fn absurd_amounts_unknown_oils_and_a_lid_in_the_way_are_refused_and_change_nothing() {
    let mut kitchen = frying(180.0);
    let before = kitchen.pan_state().clone();
    for grams in [-5.0, 0.0, f64::NAN, f64::INFINITY, 5e3] {
        for command in [
            Command::Oil { kind: Some("canola".into()), mass: 1e-3 * grams },
            Command::Butter(1e-3 * grams),
            Command::Water(1e-3 * grams),
        ] {
            let refused = kitchen.apply(&command).expect_err("refused");
            assert!(matches!(refused, Refused::Amount { holds_g, .. } if holds_g > 1500), "{command:?}: {refused}");
        }
    }
    let refused = kitchen.apply(&Command::Oil { kind: Some("motor".into()), mass: 0.01 }).expect_err("refused");
    let text = refused.to_string();
    assert!(text.contains("motor") && text.contains("sunflower") && text.contains("clarified-butter"), "{text}");
    assert!(*kitchen.pan_state() == before);
    apply(&mut kitchen, Command::Lid(true));
    apply(&mut kitchen, Command::Lid(true));
    assert_eq!(kitchen.apply(&Command::Water(0.01)), Err(Refused::LidIsOn));
    assert_eq!(kitchen.apply(&Command::Flip { food: "steak".into() }), Err(Refused::LidIsOn));
}

#[test]
fn every_oil_has_its_points_in_order_and_impossible_oils_are_refused_where_they_stand() {
    for (id, oil) in &library().oils {
        assert!(oil.heat.smoke_c < oil.heat.flash_c && oil.heat.flash_c < oil.heat.fire_c, "{id}");
        assert!(oil.fluid.viscosity_mpa_s.windows(2).all(|w| w[1] < w[0]), "{id}");
    }
    for id in ["canola", "olive", "sunflower", "clarified-butter", "butter", "beef-fat"] {
        assert!(library().oils.contains_key(id), "{id}");
    }
    let text = Library::embedded_files()["oils/canola.toml"].clone();
    for (from, to, key) in [
        ("smoke_c = 220.0", "smoke_c = 600.0", "smoke_c"),
        ("density_kg_m3 = 920.0", "density_kg_m3 = 92.0", "density_kg_m3"),
        ("[65.0, 32.0,", "[65.0,", "viscosity_c"),
    ] {
        assert!(text.contains(from), "{from}");
        let error = Library::with(&[("oils/own.toml".into(), text.replace(from, to))]).expect_err("refused");
        assert!(error.file == "oils/own.toml" && error.line > 1 && error.message.contains(key), "{error}");
    }
    let room = Library::embedded_files()["kitchen.toml"].replace("rendered = \"beef-fat\"", "rendered = \"whale\"");
    let error = Library::with(&[("kitchen.toml".into(), room)]).expect_err("refused");
    assert!(error.message.contains("whale") && error.message.contains("canola"), "{error}");
}

/// Drops ejected, in flight and landed always equal the number of events.
#[test]
fn as_many_drops_fly_and_land_as_spatter_and_pops_are_told() {
    let mut kitchen = frying(190.0);
    pour(&mut kitchen, "canola", 15.0);
    apply(&mut kitchen, Command::Hob(1200.0));
    let mut flew = 0;
    for _ in 0..600 {
        kitchen.step();
        let told = [EventKind::Spatter, EventKind::Pop].map(|k| kitchen.events().tally(k).count);
        let spatter = &kitchen.pan_state().liquids.spatter;
        assert_eq!(spatter.landed + spatter.flights.len() as u64, told[0] + told[1]);
        flew = flew.max(spatter.flights.len());
    }
    let spots = &kitchen.pan_state().liquids.spatter.spots;
    assert!(flew > 2 && spots.len() > 20, "{flew} {}", spots.len());
    for landing in [Landing::Wall, Landing::Outside] {
        assert!(spots.iter().any(|spot| spot.landing == landing), "{landing:?}");
    }
    assert!(spots.iter().all(|spot| spot.radius > 0.0 && spot.radius < 2e-3));
}
