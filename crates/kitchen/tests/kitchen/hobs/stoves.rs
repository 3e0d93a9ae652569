//! Promise: gas, radiant glass-ceramic and an iron plate heat a pan as such stoves do: how much of their power arrives, how fast
//! they are, where they heat, and what limits them.

use saute_kitchen::{Command, Kitchen, Library, Refused, celsius, kelvin};

use crate::stove::{apply, library, run};

const STOVES: [&str; 4] = ["gas", "induction", "iron-plate", "radiant"];

fn on(stove: &str, pan: &str) -> Kitchen {
    in_library(&library().on_hob(stove).expect("a hob"), pan)
}

fn in_library(library: &Library, pan: &str) -> Kitchen {
    Kitchen::new(library, pan, kelvin(20.0)).expect("a pan")
}

/// Time in which a litre of water from 20 °C is at 90 °C [s], and the share of the power that pan and water took [-].
fn a_litre(mut kitchen: Kitchen, power: f64) -> (f64, f64) {
    apply(&mut kitchen, Command::Water(1.0));
    apply(&mut kitchen, Command::Hob(power));
    let before = kitchen.energy();
    let is_cold = |kitchen: &Kitchen| {
        let water = &kitchen.pan_state().liquids.water;
        water.stored() / water.total() < 90.0 * 4190.0
    };
    while is_cold(&kitchen) {
        assert!(kitchen.time_s() < 1800.0, "never hot");
        run(&mut kitchen, 1.0);
    }
    let energy = kitchen.energy();
    assert!(energy.imbalance.abs() < 1e-6 * energy.hob, "{energy:?}");
    (kitchen.time_s(), (energy.pan_stored - before.pan_stored + energy.evaporation) / energy.hob)
}

fn floor_c(kitchen: &Kitchen) -> f64 {
    celsius(kitchen.pan_temperature())
}

/// Mean of the wall [°C].
fn wall_c(kitchen: &Kitchen) -> f64 {
    let wall = &kitchen.pan_state().temperature[kitchen.pan_model().floor_nodes..];
    celsius(wall.iter().sum::<f64>() / wall.len() as f64)
}

/// Heats a pan until its floor has a mean temperature [°C].
fn heated_to(stove: &str, pan: &str, power: f64, c: f64) -> Kitchen {
    let mut kitchen = on(stove, pan);
    apply(&mut kitchen, Command::Hob(power));
    while floor_c(&kitchen) < c {
        assert!(kitchen.time_s() < 1800.0, "{stove}: {} °C", floor_c(&kitchen));
        run(&mut kitchen, 0.5);
    }
    kitchen
}

#[test]
fn as_much_of_the_power_arrives_as_tests_of_such_stoves_find() {
    // A DOE test finds 44 % of gas and 84 % of induction; EN 30 requires 52 % of burners. One litre is less than they heat, so that
    // a slow stove's own heat counts more here.
    let bands = [("gas", 0.40..0.53), ("induction", 0.77..0.86), ("radiant", 0.58..0.75), ("iron-plate", 0.42..0.62)];
    let mut times = Vec::new();
    for (stove, band) in bands {
        for pan in ["aluminium-26", "carbon-steel-26", "cast-iron-26", "stainless-clad-26"] {
            let kitchen = on(stove, pan);
            let power = kitchen.hob().largest_w().min(2000.0);
            let (time, share) = a_litre(kitchen, power);
            println!("{stove} {pan} {power} W: {time:.0} s, {share:.3}");
            assert!(band.contains(&share), "{stove} {pan}: {share}");
            times.push((stove, time));
        }
    }
    // A cook's test, powers unstated: 9:20 min on gas, 9:30 on a plate, 4:25 on induction.
    let mean = |of: &str| times.iter().filter(|(stove, _)| *stove == of).map(|(_, time)| time).sum::<f64>() / 4.0;
    let over_induction = |of: &str| mean(of) / mean("induction");
    assert!((1.6..2.4).contains(&over_induction("gas")), "{}", over_induction("gas"));
    assert!((1.4..2.4).contains(&over_induction("iron-plate")), "{}", over_induction("iron-plate"));
}

#[test]
fn a_small_pan_takes_less_of_a_flame() {
    let share = |radius_mm: f64| {
        let mut library = library().on_hob("gas").expect("gas").into_owned();
        let pan = library.pans.get_mut("carbon-steel-26").expect("a pan");
        pan.wall.rim_radius_mm += radius_mm - pan.floor.radius_mm;
        pan.floor.radius_mm = radius_mm;
        a_litre(in_library(&library, "carbon-steel-26"), 2000.0).1
    };
    let [small, usual, wide] = [70.0, 100.0, 140.0].map(share);
    assert!(small < 0.85 * usual && usual < wide, "{small} {usual} {wide}");
}

#[test]
fn gas_warms_the_wall_and_the_grate_and_induction_does_not() {
    let [gas, induction] =
        [("gas", 2000.0), ("induction", 1100.0)].map(|(stove, w)| heated_to(stove, "carbon-steel-26", w, 200.0));
    println!(
        "gas {:.0} °C, induction {:.0} °C, grate {:.0} °C",
        wall_c(&gas),
        wall_c(&induction),
        celsius(gas.pan_state().heater)
    );
    assert!(wall_c(&gas) > wall_c(&induction) + 25.0, "{} {}", wall_c(&gas), wall_c(&induction));
    assert!(gas.pan_state().heater > kelvin(40.0) && induction.pan_state().heater < kelvin(25.0));
}

#[test]
fn a_flame_and_a_coil_act_at_once_and_glass_and_iron_late() {
    // Time until the floor is 10 K warmer.
    let lag = |stove: &str| heated_to(stove, "carbon-steel-26", 1800.0, 30.0).time_s();
    let [gas, induction, plate, radiant] = STOVES.map(lag);
    println!("lag: gas {gas} s, induction {induction} s, plate {plate} s, radiant {radiant} s");
    assert!(gas < 10.0 && induction < 5.0 && (12.0..60.0).contains(&radiant) && (12.0..90.0).contains(&plate));
    // Half a minute after the power is off.
    let after = |stove: &str| {
        let mut kitchen = heated_to(stove, "carbon-steel-26", 1150.0, 200.0);
        apply(&mut kitchen, Command::Hob(0.0));
        run(&mut kitchen, 30.0);
        floor_c(&kitchen) - 200.0
    };
    let [gas, induction, plate, radiant] = STOVES.map(after);
    println!("after 30 s without power: gas {gas} K, induction {induction} K, plate {plate} K, radiant {radiant} K");
    assert!(gas < -5.0 && induction < -5.0 && plate > 0.0 && radiant > 0.0, "{gas} {induction} {plate} {radiant}");
}

#[test]
fn the_limiter_keeps_glass_and_plate_below_what_they_stand() {
    // The element that was switched off still warms the glass.
    for (stove, over) in [("radiant", 30.0), ("iron-plate", 5.0)] {
        let mut kitchen = on(stove, "carbon-steel-26");
        let hob = kitchen.hob();
        let largest = hob.largest_w();
        let limit = hob.element.as_ref().map(|e| e.limit_c).or(hob.plate.as_ref().map(|p| p.limit_c)).expect("a limit");
        apply(&mut kitchen, Command::MovePan { at: [0.0; 2], lift: 0.03 });
        apply(&mut kitchen, Command::Hob(largest));
        let (mut hottest, mut was_off) = (0.0f64, false);
        for _ in 0..1800 {
            run(&mut kitchen, 0.5);
            let state = kitchen.pan_state();
            let shares = &state.ring_shares;
            let glass: f64 =
                state.glass.iter().zip(shares).map(|(t, s)| t * s).sum::<f64>() / shares.iter().sum::<f64>();
            hottest = hottest.max(celsius(if stove == "radiant" { glass } else { state.heater }));
            was_off |= state.limited;
            assert_eq!(kitchen.hob_drawn_w(), if state.limited { 0.0 } else { largest });
        }
        println!("{stove}: {hottest:.0} °C of {limit} °C");
        assert!(was_off && hottest > limit && hottest < limit + over, "{stove}: {hottest} °C");
    }
}

#[test]
fn a_pan_is_heated_less_the_higher_it_is_lifted_and_the_stove_burns_on() {
    for stove in ["gas", "radiant", "iron-plate"] {
        let risen = |lift: f64| {
            let mut kitchen = on(stove, "carbon-steel-26");
            apply(&mut kitchen, Command::MovePan { at: [0.0; 2], lift });
            apply(&mut kitchen, Command::Hob(1150.0));
            run(&mut kitchen, 120.0);
            let energy = kitchen.energy();
            assert!((energy.hob - 120.0 * 1150.0).abs() < 0.2 * energy.hob, "{stove}: {} J", energy.hob);
            assert!(energy.imbalance.abs() < 1e-6 * energy.hob, "{energy:?}");
            floor_c(&kitchen) - 20.0
        };
        let [on, low, high] = [0.0, 0.03, 0.15].map(risen);
        println!("{stove}: {on:.0} K, {low:.0} K at 30 mm, {high:.0} K at 150 mm");
        assert!(on > 1.1 * low && low > 1.3 * high, "{stove}: {on} {low} {high}");
    }
}

#[test]
fn a_stove_goes_on_while_the_pan_stands_on_the_cloth() {
    for stove in ["gas", "radiant", "iron-plate"] {
        let mut kitchen = heated_to(stove, "carbon-steel-26", 1150.0, 180.0);
        // An element glows in turns; its glass does not.
        let hot = |kitchen: &Kitchen| {
            let state = kitchen.pan_state();
            if stove == "radiant" { state.glass[0] } else { state.heater }
        };
        let (burnt, before) = (kitchen.energy().hob, hot(&kitchen));
        apply(&mut kitchen, Command::Cool { for_s: 20.0 });
        run(&mut kitchen, 20.0);
        assert!(floor_c(&kitchen) < 130.0, "{stove}: the cloth cools the pan");
        let energy = kitchen.energy();
        assert!(energy.hob > burnt + 0.5 * 20.0 * 1150.0, "{stove}: {} J", energy.hob - burnt);
        assert!(energy.imbalance.abs() < 1e-6 * energy.hob, "{energy:?}");
        assert!(hot(&kitchen) > before - 20.0, "{stove} stays hot");
    }
}

#[test]
fn a_stove_without_a_sensor_holds_no_temperature_and_a_switch_has_steps() {
    for stove in STOVES {
        let mut kitchen = on(stove, "carbon-steel-26");
        let held = kitchen.apply(&Command::HobHold { temperature: kelvin(180.0), power: 1000.0 });
        assert_eq!(held.is_ok(), stove == "induction", "{stove}");
        if let Err(refused) = held {
            assert_eq!(refused, Refused::NoSensor);
            assert!(refused.to_string().contains("set a power"), "{refused}");
            assert_eq!((kitchen.hob_w(), kitchen.hob_holds()), (0.0, None), "nothing was set");
        }
        assert!(matches!(kitchen.apply(&Command::Hob(99_000.0)), Err(Refused::Power { .. })));
    }
    let given = |stove: &str, w: f64| {
        let mut kitchen = on(stove, "carbon-steel-26");
        apply(&mut kitchen, Command::Hob(w));
        kitchen.hob_w()
    };
    assert_eq!([given("iron-plate", 1000.0), given("iron-plate", 1020.0)], [850.0, 1150.0]);
    assert_eq!([given("gas", 100.0), given("gas", 250.0), given("gas", 777.0)], [0.0, 400.0, 777.0]);
}

#[test]
fn on_every_stove_a_saved_kitchen_goes_on_as_if_it_had_not_been_saved() {
    for stove in STOVES {
        let library = library();
        let mut kitchen = heated_to(stove, "stainless-clad-26", 1150.0, 120.0);
        let bytes = kitchen.to_bytes();
        let mut again = Kitchen::from_bytes(&bytes, &library).expect("a kitchen");
        run(&mut kitchen, 30.0);
        run(&mut again, 30.0);
        assert_eq!(kitchen.state_hash(), again.state_hash(), "{stove}");
        assert_eq!(again.hob().name, kitchen.hob().name);
    }
}

/// The file that the documentation shows is sound, and a hob of one's own is cooked on.
#[test]
fn the_documented_hob_can_be_used() {
    let page = concat!(env!("CARGO_MANIFEST_DIR"), "/../../docs/your-own-hob.md");
    let page = std::fs::read_to_string(page).expect("the page");
    let file = page.split("```toml").nth(1).and_then(|rest| rest.split("```").next()).expect("a file");
    let own = Library::with(&[("hobs/own.toml".into(), file.into())]).expect("sound");
    let (_, share) = a_litre(in_library(&own.on_hob("own").expect("a hob"), "carbon-steel-26"), 1700.0);
    assert!((0.25..0.45).contains(&share), "{share}");
}

/// Tables that do not belong together are refused with what to do.
#[test]
fn hobs_that_cannot_be_are_refused_where_they_stand() {
    let shipped = Library::embedded_files();
    let refused = |path: &str, change: &dyn Fn(&str) -> String| {
        let text = change(&shipped[path]);
        assert_ne!(text, shipped[path], "{path} was changed");
        Library::with(&[(path.to_owned(), text)]).expect_err("refused").to_string()
    };
    let grate = shipped["hobs/gas.toml"]
        .split("[grate]")
        .nth(1)
        .and_then(|rest| rest.split("[under]").next())
        .expect("a grate");
    let element = shipped["hobs/radiant.toml"]
        .split("[under]")
        .next()
        .and_then(|rest| rest.split("\n\n").nth(1))
        .expect("an element");
    let without_grate = refused("hobs/gas.toml", &|text| text.replace(&format!("[grate]{grate}"), ""));
    assert!(without_grate.contains("[flame] needs [grate]"), "{without_grate}");
    let with_grate = refused("hobs/iron-plate.toml", &|text| format!("{text}\n[grate]{grate}"));
    assert!(with_grate.contains("[grate] belongs to [flame]"), "{with_grate}");
    let two = refused("hobs/iron-plate.toml", &|text| format!("{text}\n{element}"));
    assert!(two.contains("[element] and [plate] both make heat"), "{two}");
    let none = refused("hobs/radiant.toml", &|text| text.replace(element, ""));
    assert!(none.contains("nothing makes heat") && none.contains("[flame]"), "{none}");
    let steps = refused("hobs/gas.toml", &|text| text.replace("500.0, 1200.0", "100.0, 1200.0"));
    assert!(steps.contains("no flame burns with 100 W"), "{steps}");
    let descending = refused("hobs/iron-plate.toml", &|text| text.replace("220.0, 300.0", "300.0, 220.0"));
    assert!(descending.contains("begins with 0 and rises"), "{descending}");
    let beyond = refused("hobs/radiant.toml", &|text| text.replace("1200.0, 1800.0]", "1200.0, 2500.0]"));
    assert!(beyond.contains("beyond largest_w"), "{beyond}");
    let at_home =
        Library::with(&[("kitchen-at-home.toml".into(), shipped["kitchen-at-home.toml"].clone() + "\nhob = \"fire\"")]);
    let at_home = at_home.expect_err("refused").to_string();
    assert!(at_home.contains("there are: gas, induction, iron-plate, radiant"), "{at_home}");
}
