//! Cooks a steak in thirty lines and prints its core temperature and doneness.
//!
//! `cargo run --release -p saute-kitchen --example cook_a_steak`

use std::error::Error;

use saute_kitchen::data::library::DEFAULT_SCALE;
use saute_kitchen::food::Rules;
use saute_kitchen::{Command, Kitchen, Library, MeshSize, OutlineKind, PieceOrder, RestOn, TICK_S, celsius, kelvin};

fn main() -> Result<(), Box<dyn Error>> {
    let library = Library::embedded()?;
    let mut kitchen = Kitchen::new(&library, "carbon-steel-26", kelvin(200.0))?;
    let steak = PieceOrder {
        id: "steak".into(),
        kind: "beef-lean".into(),
        size: [0.120, 0.080, 0.020],
        temperature: kelvin(20.0),
        seed: 1,
        coarseness: 1.0,
        rules: Rules::Full,
        mesh: MeshSize::Paper2013,
        outline: OutlineKind::Plain,
    };
    kitchen.add(&library, &steak)?;
    let food = || String::from("steak");
    kitchen.apply(&Command::Hob(700.0))?;
    kitchen.apply(&Command::Put { food: food(), at: [0.0, 0.0], heap: false })?;
    run(&mut kitchen, 180.0);
    kitchen.apply(&Command::Flip { food: food() })?;
    run(&mut kitchen, 180.0);
    kitchen.apply(&Command::Rest { food: food(), on: RestOn::Board })?;
    run(&mut kitchen, 240.0);
    let (peak, when) = kitchen.pieces()[0].core_peak;
    let scale = library.scales.iter().find(|s| s.id == DEFAULT_SCALE).ok_or("the default scale is missing")?;
    println!("core: {:.1} °C after {when:.0} s, {} ({})", celsius(peak), scale.name_of(peak), scale.name);
    Ok(())
}

/// Advances the kitchen by a time [s].
fn run(kitchen: &mut Kitchen, seconds: f64) {
    let until = kitchen.time_s() + seconds - 0.5 * TICK_S;
    while kitchen.time_s() < until {
        kitchen.step();
    }
}
