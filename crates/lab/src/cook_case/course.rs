//! The expected course of a colour over time in pictures of a cook: monotonically falling.

use saute_food::Lab;
use schemars::JsonSchema;
use serde::Deserialize;

use crate::cook_case::file::SeenAt;

/// A colour coordinate that is expected to fall monotonically.
#[derive(Clone, Debug, Deserialize, JsonSchema, PartialEq)]
#[serde(deny_unknown_fields)]
pub struct Course {
    /// Name of the quantity.
    pub quantity: String,
    /// Place on the food.
    pub place: SeenAt,
    /// Colour coordinate.
    pub of: Coordinate,
    /// Time of the first reading [s].
    pub from_s: f64,
    /// Time of the last reading [s]; the end of the cook by default.
    pub until_s: Option<f64>,
    /// Interval between readings [s].
    pub every_s: f64,
    /// Largest rise of a reading above the lowest one before it [-].
    pub slack: f64,
    /// Least and largest fall from the first reading to the last [-].
    pub falls: [f64; 2],
}

/// A coordinate of a colour.
#[derive(Clone, Copy, Debug, Deserialize, JsonSchema, PartialEq, Eq)]
pub enum Coordinate {
    /// Lightness L*.
    #[serde(rename = "L*")]
    Lightness,
    /// Redness a*.
    #[serde(rename = "a*")]
    Redness,
}

impl Coordinate {
    /// Returns the coordinate of a colour [-].
    pub fn read(self, Lab(lab): Lab) -> f64 {
        match self {
            Self::Lightness => lab[0],
            Self::Redness => lab[1],
        }
    }

    /// Returns the name of the coordinate, used in place of a unit.
    pub fn unit(self) -> &'static str {
        match self {
            Self::Lightness => "L*",
            Self::Redness => "a*",
        }
    }
}

impl Course {
    /// Returns true if the next reading is due at a time [s], after `taken` readings.
    pub fn is_due(&self, time_s: f64, taken: usize) -> bool {
        let next = self.from_s + self.every_s * taken as f64;
        time_s > next - 0.5 * saute_kitchen::TICK_S
            && self.until_s.is_none_or(|until| next < until + 0.5 * saute_kitchen::TICK_S)
    }
}

/// Returns the largest rise of a value above the lowest one before it; NaN if there are no values.
pub fn largest_rise(values: &[f64]) -> f64 {
    let Some(first) = values.first() else { return f64::NAN };
    let rise = |(low, most): (f64, f64), value: &f64| (low.min(*value), most.max(value - low));
    values.iter().fold((*first, 0.0), rise).1
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_rise_is_measured_from_the_lowest_value_before_it() {
        assert_eq!(largest_rise(&[5.0, 4.0, 3.0, 1.0]), 0.0);
        assert_eq!(largest_rise(&[5.0, 3.0, 3.5, 2.0, 4.0, 3.0]), 2.0);
        assert!(largest_rise(&[]).is_nan());
    }
}
