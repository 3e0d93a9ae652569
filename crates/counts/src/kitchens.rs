//! Kitchens in the middle of a cook.

use std::error::Error;

use saute_kitchen::{Kitchen, Library};
use saute_recipe::{Cook, Recipe};

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

/// 35 shrimps of the default mesh that fall in five heaps.
const SHRIMPS: &str = r#"
title = "35 shrimps"
[pan]
initial_c = 190
[[food]]
id = "middle"
kind = "shrimp"
count = 7
seed = 1
[[food]]
id = "left"
kind = "shrimp"
count = 7
seed = 2
[[food]]
id = "right"
kind = "shrimp"
count = 7
seed = 3
[[food]]
id = "far"
kind = "shrimp"
count = 7
seed = 4
[[food]]
id = "near"
kind = "shrimp"
count = 7
seed = 5
[[step]]
hob_w = 1100
[[step]]
put = { food = "middle", at_mm = [0, 0], heap = true }
[[step]]
put = { food = "left", at_mm = [-50, 0], heap = true }
[[step]]
put = { food = "right", at_mm = [50, 0], heap = true }
[[step]]
put = { food = "far", at_mm = [0, 50], heap = true }
[[step]]
put = { food = "near", at_mm = [0, -50], heap = true }
[[step]]
after_s = 900
end = true
"#;

/// When the shrimps are counted [s] (chosen: they lie still).
const SHRIMPS_AT_S: f64 = 8.0;

/// The steak at its moment.
pub fn steak() -> Result<Kitchen, Box<dyn Error>> {
    cooked(STEAK, STEAK_AT_S)
}

/// The shrimps at their moment.
pub fn shrimps() -> Result<Kitchen, Box<dyn Error>> {
    cooked(SHRIMPS, SHRIMPS_AT_S)
}

fn cooked(recipe: &str, until_s: f64) -> Result<Kitchen, Box<dyn Error>> {
    let library = Library::embedded()?;
    let mut cook = Cook::new(Recipe::parse(recipe, "counts", &library)?, &library)?;
    while cook.kitchen.time_s() < until_s && cook.stopped().is_none() {
        cook.advance()?;
    }
    Ok(cook.kitchen)
}
