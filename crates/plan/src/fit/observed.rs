//! What was measured at a real stove.

use std::sync::Arc;

use saute_kitchen::food::Scale;
use serde::{Deserialize, Serialize};

/// Standard deviation of a probe in the core [K] (chosen: ±1 K of a household thermometer and its place).
pub const CORE_SIGMA: f64 = 1.0;
/// Standard deviation of a pan's temperature [K] (chosen: an infrared thermometer on oiled steel).
pub const PAN_SIGMA: f64 = 5.0;
/// Standard deviation of a weight [kg] (chosen: a kitchen scale and the juice that clings).
pub const WEIGHT_SIGMA: f64 = 1.5e-3;
/// Width of a class's bounds as the eye sees them [K] (chosen: the colour between two classes is read by eye).
const CLASS_SIGMA: f64 = 2.0;
/// Most samples of a quantity that are compared [-] (chosen: more add no information, as neighbours share their errors).
const MOST_SAMPLES: usize = 60;

/// A quantity that was measured.
#[derive(Clone, Copy, Debug, Deserialize, PartialEq, Eq, Serialize)]
pub enum Quantity {
    /// Mean temperature of the pan's floor [K].
    Pan,
    /// Temperature of the core of the first food [K].
    Core,
    /// Highest temperature that the core has reached [K].
    CorePeak,
    /// Mass of the first food [kg].
    Mass,
}

/// Time of what was measured when all was done [s].
pub const END: f64 = f64::INFINITY;

/// One measured value.
#[derive(Clone, Copy, Debug, Deserialize, PartialEq, Serialize)]
pub struct Sample {
    /// What was measured.
    pub quantity: Quantity,
    /// Time since the beginning of the recipe [s]; [`END`] for its end.
    pub at_s: f64,
    /// Value [K, kg].
    pub value: f64,
    /// Standard deviation of its error [K, kg].
    pub sigma: f64,
}

/// Everything that was measured in one cook.
#[derive(Clone, Debug, Default, Deserialize, PartialEq, Serialize)]
pub struct Observed {
    samples: Vec<Sample>,
}

impl Observed {
    /// Adds a curve of a quantity: times [s] and values [K]; of a long one, samples at even distances.
    pub fn add_curve(&mut self, quantity: Quantity, curve: &[(f64, f64)]) {
        let sigma = if quantity == Quantity::Pan { PAN_SIGMA } else { CORE_SIGMA };
        let every = curve.len().div_ceil(MOST_SAMPLES).max(1);
        let kept = curve.iter().step_by(every);
        self.samples.extend(kept.map(|&(at_s, value)| Sample { quantity, at_s, value, sigma }));
    }

    /// Adds a weight [kg] at a time [s].
    pub fn add_weight(&mut self, at_s: f64, value: f64) {
        self.samples.push(Sample { quantity: Quantity::Mass, at_s, value, sigma: WEIGHT_SIGMA });
    }

    /// Adds the class of the core that was seen on the cut at a time [s]; false if the scale has no such class or does not
    /// measure temperatures.
    ///
    /// A class between the temperatures a and b counts as a peak of (a + b)/2 ± √((b − a)²/12 + (2 K)²).
    pub fn add_class(&mut self, at_s: f64, scale: &Arc<Scale>, class: &str) -> bool {
        let Some((from, to)) = class_bounds(scale, class) else { return false };
        let sigma = libm::sqrt((to - from) * (to - from) / 12.0 + CLASS_SIGMA * CLASS_SIGMA);
        self.samples.push(Sample { quantity: Quantity::CorePeak, at_s, value: 0.5 * (from + to), sigma });
        true
    }

    /// Returns the samples by time.
    pub fn samples(&self) -> Vec<Sample> {
        let mut samples = self.samples.clone();
        samples.sort_by(|a, b| a.at_s.total_cmp(&b.at_s));
        samples
    }
}

/// Bounds of a class [K]; the first and the last class are as wide as their neighbour. None where the scale measures no
/// temperature or has no such class.
fn class_bounds(scale: &Scale, class: &str) -> Option<(f64, f64)> {
    if scale.measure() != saute_kitchen::food::change::doneness::Measure::Peak {
        return None;
    }
    let place = scale.class.iter().position(|c| c.name == class)?;
    let second = scale.from(1);
    let width = |of: usize| scale.end(of).unwrap_or(0.0) - scale.from(of);
    let (from, to) = match (place, scale.end(place)) {
        (0, _) => (second - width(1), second),
        (_, Some(end)) => (scale.from(place), end),
        (_, None) => (scale.from(place), scale.from(place) + if place > 1 { width(place - 1) } else { 10.0 }),
    };
    Some((scale.of_nodes(from), scale.of_nodes(to)))
}

#[cfg(test)]
mod tests {
    use super::*;
    use saute_kitchen::{Library, kelvin};

    #[test]
    fn a_class_is_a_peak_temperature_with_the_width_of_its_bounds() {
        let library = Library::embedded().expect("embedded data");
        let scale = library.scale("chefs").expect("is there");
        let mut observed = Observed::default();
        assert!(observed.add_class(900.0, scale, "medium-rare"));
        assert!(!observed.add_class(900.0, scale, "blue"));
        let sample = observed.samples()[0];
        assert!((sample.value - kelvin(57.5)).abs() < 1e-9 && (sample.sigma - 2.466).abs() < 1e-3, "{sample:?}");
    }

    #[test]
    fn a_long_curve_is_thinned_evenly() {
        let curve: Vec<(f64, f64)> = (0..1000).map(|s| (f64::from(s), 300.0)).collect();
        let mut observed = Observed::default();
        observed.add_curve(Quantity::Core, &curve);
        let samples = observed.samples();
        assert!((50..=60).contains(&samples.len()), "{}", samples.len());
        assert_eq!((samples[0].at_s, samples[1].at_s - samples[0].at_s), (0.0, 17.0));
    }
}
