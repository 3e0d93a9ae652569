//! Promise: whatever number comes through a door, it is refused with its key and its range, or held at a hand's reach, or cooked with;
//! nothing panics, the balances close, and no food freezes.

mod other_version;
mod page;
mod page_messages;
mod recipes;
mod sessions;
mod streams;

use saute_attack::doors::Range;
use saute_kitchen::Kitchen;
use saute_schema::number_text::number_text;

/// How far beyond an end is tried, over the width of the range [-] (chosen: far above rounding).
const BEYOND: f64 = 1e-3;

/// What is handed to every door: numbers that are none or huge, usual slips, both ends and what is just beyond them.
fn hostile(range: Range) -> Vec<f64> {
    let mut all = vec![f64::NAN, f64::INFINITY, f64::NEG_INFINITY, 1e308, -1e308, 0.0, -1.0];
    if let Range::Within(low, high) = range {
        let more = BEYOND * (high - low);
        all.extend([low, high, low - more, high + more]);
    }
    if range == Range::Plain { vec![0.0] } else { all }
}

/// Returns true for a number that a door takes for certain, false for one that it refuses for certain; none where it depends.
fn is_taken(range: Range, v: f64) -> Option<bool> {
    match range {
        Range::Plain => Some(true),
        Range::Within(low, high) => Some((low..=high).contains(&v)),
        Range::Fitting if v.is_finite() && v.abs() < 1e300 => None,
        Range::Fitting => Some(false),
        Range::Reach => Some(v.is_finite()),
    }
}

/// Panics unless a refusal names what it refuses, and its range where it has a fixed one.
fn names(said: &str, named: &[&str], range: Range, case: &str) {
    assert!(named.iter().any(|word| said.contains(word)), "{case}: {said}");
    if let Range::Within(low, high) = range {
        let (least, most) = (number_text(low), number_text(high));
        let both = said.contains(&format!("{least} to {most}"));
        // A number to either side may be named by its distance from the middle.
        let either_side = [format!("± {most}"), format!("0 to {most}")].iter().any(|words| said.contains(words));
        assert!(both || (low == -high && either_side), "{case} without {least} to {most}: {said}");
    }
}

/// Panics if a kitchen contains a number that is not finite, its energy does not balance, or food freezes or burns away.
fn sound(kitchen: &Kitchen, case: &str) {
    let energy = kitchen.energy();
    let gross = energy.hob.abs() + energy.pan_stored.abs() + energy.food_stored.abs() + energy.evaporation.abs();
    assert!(energy.imbalance.abs() <= 1e-6 * gross.max(1.0), "{case}: {energy:?}");
    for piece in kitchen.pieces() {
        assert!(piece.pose.is_finite() && piece.mass().is_finite(), "{case}: {}", piece.id);
        assert!(piece.state.temperature.iter().all(|t| (200.0..900.0).contains(t)), "{case}: {}", piece.id);
    }
    assert!(kitchen.pan_state().temperature.iter().all(|t| (200.0..900.0).contains(t)), "{case}");
}
