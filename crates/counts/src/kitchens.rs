//! Kitchens in the middle of a cook. They are cooked natively and kept as files, since under Callgrind a minute of a cook takes fifty times as
//! long.

use std::error::Error;
use std::fs;
use std::path::Path;

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

/// Ticks that are counted together (chosen: a piece's shape follows every twentieth).
pub const TICKS: u32 = 20;

/// Names of the kitchens' files.
const STEAK_FILE: &str = "steak.kitchen";
const SHRIMPS_FILE: &str = "shrimps.kitchen";

/// When the steak is counted [s] (chosen: it boils underneath and browns).
const STEAK_AT_S: f64 = 60.0;

/// Writes the kitchens to a folder.
pub fn write(folder: &Path) -> Result<(), Box<dyn Error>> {
    for (file, recipe, at_s) in
        [(STEAK_FILE, STEAK, STEAK_AT_S), (SHRIMPS_FILE, full_pan::SHRIMPS, full_pan::SHRIMPS_LIE_S)]
    {
        fs::write(folder.join(file), sound_asleep(cooked(recipe, at_s)?).to_bytes())?;
    }
    Ok(())
}

/// The steak of a folder.
pub fn steak(folder: &Path) -> Result<Kitchen, Box<dyn Error>> {
    read(&folder.join(STEAK_FILE))
}

/// The shrimps of a folder.
pub fn shrimps(folder: &Path) -> Result<Kitchen, Box<dyn Error>> {
    read(&folder.join(SHRIMPS_FILE))
}

fn read(file: &Path) -> Result<Kitchen, Box<dyn Error>> {
    let bytes = fs::read(file).map_err(|e| format!("{}: {e}; \"saute-counts FOLDER\" writes it", file.display()))?;
    Ok(Kitchen::from_bytes(&bytes, &Library::embedded()?)?)
}

/// A kitchen from when on all its bodies sleep for as long as is counted: as food shrinks they wake for half a second every few seconds,
/// which is left to the counts of rigid steps.
fn sound_asleep(mut kitchen: Kitchen) -> Kitchen {
    let (mut from, mut slept) = (kitchen.clone(), 0);
    while slept <= TICKS {
        if slept == 0 {
            from = kitchen.clone();
        }
        slept = if kitchen.bodies_sleep() { slept + 1 } else { 0 };
        kitchen.step();
    }
    from
}

fn cooked(recipe: &str, until_s: f64) -> Result<Kitchen, Box<dyn Error>> {
    let library = Library::embedded()?;
    let mut cook = Cook::new(Recipe::parse(recipe, "counts", &library)?, &library)?;
    while cook.kitchen.time_s() < until_s && cook.stopped().is_none() {
        cook.advance()?;
    }
    Ok(cook.kitchen)
}
