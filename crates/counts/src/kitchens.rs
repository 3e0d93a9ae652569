//! Kitchens in the middle of a cook.

use std::error::Error;

use saute_kitchen::{Kitchen, Library};
use saute_recipe::{Cook, Recipe, full_pan};

/// A steak of the default size in a hot pan.
const STEAK: &str = r#"
title = "Steak"
[pan]
initial_c = 200
[[food]]
id = "steak"
kind = "beef-lean"
[[step]]
hob_w = 600
[[step]]
put = "steak"
[[step]]
after_s = 900
end = true
"#;

/// When the steak is counted [s] (chosen: it boils underneath and browns).
const STEAK_AT_S: f64 = 60.0;

/// The steak at its moment, once its body has been awake and sleeps again: as it shrinks it wakes for half a second every six to
/// ten, which is left to the counts of rigid steps.
pub fn steak() -> Result<Kitchen, Box<dyn Error>> {
    let mut kitchen = cooked(STEAK, STEAK_AT_S)?;
    for asleep in [true, false] {
        while kitchen.bodies_sleep() == asleep {
            kitchen.step();
        }
    }
    Ok(kitchen)
}

/// The shrimps at their moment.
pub fn shrimps() -> Result<Kitchen, Box<dyn Error>> {
    cooked(full_pan::SHRIMPS, full_pan::SHRIMPS_LIE_S)
}

fn cooked(recipe: &str, until_s: f64) -> Result<Kitchen, Box<dyn Error>> {
    let library = Library::embedded()?;
    let mut cook = Cook::new(Recipe::parse(recipe, "counts", &library)?, &library)?;
    while cook.kitchen.time_s() < until_s && cook.stopped().is_none() {
        cook.advance()?;
    }
    Ok(cook.kitchen)
}
