//! Temperatures that a core or a pan can have: by them a unit is believed or doubted.

use saute_kitchen::food::ZERO_C;
use saute_kitchen::heat::sorted::{Quantile, Sorted};

use crate::fit::observed::Quantity;

/// Highest temperature of a core that a unit is believed with [°C] (chosen: water boils).
const MOST_CORE_C: f64 = 105.0;
/// Highest temperature of a pan that a unit is believed with [°C] (chosen: on a household hob).
const MOST_PAN_C: f64 = 420.0;
/// Lowest temperature that a unit is believed with [°C] (chosen: a freezer).
const LEAST_C: f64 = -30.0;
/// How far a core is from where it began before its unit is doubted [K] (chosen: a raw piece and a thermometer differ less).
const BEGIN_OFF: f64 = 10.0;

/// True if nearly all of a core's or a pan's temperatures are such as one has.
pub(super) fn is_believed(points: &[(f64, f64)], quantity: Quantity) -> bool {
    let celsius = sorted_c(points);
    let at = |share: f64| celsius.quantile(share, Quantile::Nearest);
    at(0.05).is_some_and(|low| low >= LEAST_C) && at(0.95).is_some_and(|high| high <= most_c(quantity))
}

/// True if a core is what it must be at the time at which its food is put in.
pub(super) fn begins_as(points: &[(f64, f64)], begin: Option<(f64, f64)>) -> bool {
    let Some((at_s, kelvin)) = begin else { return true };
    let first = points.iter().find(|(at, _)| *at >= at_s).or(points.last());
    first.is_none_or(|(_, read)| (read - kelvin).abs() <= BEGIN_OFF)
}

fn most_c(quantity: Quantity) -> f64 {
    if quantity == Quantity::Pan { MOST_PAN_C } else { MOST_CORE_C }
}

fn sorted_c(points: &[(f64, f64)]) -> Sorted {
    Sorted::new(points.iter().map(|(_, kelvin)| kelvin - ZERO_C).collect())
}

/// From the lowest to the highest temperature, in words.
pub(super) fn range(points: &[(f64, f64)]) -> String {
    let celsius = sorted_c(points);
    let [low, high] = [0.0, 1.0].map(|share| celsius.quantile(share, Quantile::Nearest).unwrap_or(0.0));
    format!("from {low:.0} to {high:.0} °C")
}
