//! The dish of the 2013 paper, never taken off the hob: a steak, eleven carrot coins and eleven leek rings.

use std::fmt::Write;

/// Interval between two disturbances [s].
const EVERY_S: usize = 600;

/// What disturbs the dish, in turn.
const DISTURBANCES: [&str; 6] = [
    "toss = { height_mm = 60 }",
    "oil_g = 5",
    "lid = true",
    "lid = false",
    "water_g = 40",
    "shake = { amplitude_mm = 20, hz = 3, for_s = 3 }",
];

/// Pan, foods and first steps.
const BEGIN: &str = r#"
title = "A day at the stove"
max_s = 86400
[pan]
kind = "carbon-steel-26"
initial_c = 20
[[food]]
id = "steak"
kind = "beef-marbled"
size_mm = [120, 80, 20]
mesh = "2013"
[[food]]
id = "carrots"
kind = "carrot-coin"
count = 11
size_mm = [26, 6]
mesh = "2013"
[[food]]
id = "leeks"
kind = "leek-ring"
count = 11
size_mm = [24, 10]
mesh = "2013"
[[step]]
oil_g = 12
[[step]]
hob_w = { hold_c = 120, w = 1500 }
[[step]]
at_s = 60
put = { food = "carrots", at_mm = [-45, 0], heap = true }
[[step]]
put = { food = "leeks", at_mm = [45, 0], heap = true }
[[step]]
put = { food = "steak", heap = true }
"#;

/// Returns the recipe of a number of minutes: every ten of them a toss, oil, a lid, no lid, water or shaking.
pub fn recipe(minutes: usize) -> String {
    let end_s = 60 * minutes;
    let mut text = BEGIN.to_owned();
    for (turn, at_s) in (EVERY_S / 2..end_s).step_by(EVERY_S).enumerate() {
        let disturbance = DISTURBANCES[turn % DISTURBANCES.len()];
        write!(text, "[[step]]\nat_s = {at_s}\n{disturbance}\n").expect("a string takes every text");
    }
    text + &format!("[[step]]\nat_s = {end_s}\nend = true\n")
}
