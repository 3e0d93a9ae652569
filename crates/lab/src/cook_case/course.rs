//! The course of a colour in time, as pictures of a cook show it: it only ever falls.

use saute_food::Lab;
use serde::Deserialize;

use crate::cook_case::case::SeenAt;

/// A coordinate of a colour that should fall and never rise again.
#[derive(Clone, Debug, Deserialize, PartialEq)]
#[serde(deny_unknown_fields)]
pub struct Course {
    /// What it is.
    pub quantity: String,
    /// Where it is looked for.
    pub place: SeenAt,
    /// Which coordinate.
    pub of: Coordinate,
    /// First reading [s].
    pub from_s: f64,
    /// Last reading [s]; the end of the cook unless given.
    pub until_s: Option<f64>,
    /// From reading to reading [s].
    pub every_s: f64,
    /// How far a reading may lie above the lowest one before it.
    pub slack: f64,
    /// Least and largest fall from the first reading to the last.
    pub falls: [f64; 2],
}

/// A coordinate of a colour.
#[derive(Clone, Copy, Debug, Deserialize, PartialEq, Eq)]
pub enum Coordinate {
    /// Lightness.
    #[serde(rename = "L*")]
    Lightness,
    /// Red over green.
    #[serde(rename = "a*")]
    Redness,
}

impl Coordinate {
    /// The coordinate of a colour.
    pub fn read(self, Lab(lab): Lab) -> f64 {
        match self {
            Self::Lightness => lab[0],
            Self::Redness => lab[1],
        }
    }

    /// Its name where units stand.
    pub fn unit(self) -> &'static str {
        match self {
            Self::Lightness => "L*",
            Self::Redness => "a*",
        }
    }
}

impl Course {
    /// Whether the next reading is to be taken at a time [s], when so many have been.
    pub fn is_due(&self, time_s: f64, taken: usize) -> bool {
        let next = self.from_s + self.every_s * taken as f64;
        time_s > next - 0.5 * saute_kitchen::TICK_S
            && self.until_s.is_none_or(|until| next < until + 0.5 * saute_kitchen::TICK_S)
    }
}

/// How far values ever rise above the lowest before them; not a number where there are none.
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
