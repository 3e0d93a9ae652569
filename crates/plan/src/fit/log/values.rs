//! What one field states about a temperature.

use super::stamp::number_of;
use super::unit::Unit;

/// Content of a field of temperatures.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Value {
    /// A number, and the unit next to it.
    Number(f64, Option<Unit>),
    /// Nothing: the probe was not there, or the logger lost it.
    Missing,
    /// Something else.
    Other,
}

/// What loggers write for a probe that is not there, in small letters.
const MISSING: [&str; 27] = [
    "nan",
    "n/a",
    "na",
    "#n/a",
    "#value!",
    "null",
    "none",
    "nil",
    "unavailable",
    "unknown",
    "open",
    "err",
    "error",
    "fault",
    "lo",
    "hi",
    "low",
    "high",
    "ol",
    "inf",
    "-inf",
    "disconnected",
    "unplugged",
    "no probe",
    "not connected",
    "off",
    "lll",
];

impl Value {
    /// Reads a field.
    pub fn of(text: &str) -> Self {
        let text = text.trim().trim_matches(['"', '\'']).trim();
        if let Some(number) = number_of(text) {
            return Self::Number(number, None);
        }
        let is_dashes = text.chars().all(|c| "-._?* ".contains(c));
        if is_dashes || MISSING.contains(&text.to_lowercase().as_str()) {
            return Self::Missing;
        }
        let end = text.find(|c: char| !c.is_ascii_digit() && !"+-.,".contains(c)).unwrap_or(text.len());
        let (number, unit) = text.split_at(end);
        match (number_of(number), Unit::of_word(&unit.replace("deg", "").replace([' ', '.'], ""))) {
            (Some(number), Some(unit)) => Self::Number(number, Some(unit)),
            _ => Self::Other,
        }
    }

    /// Returns the number.
    pub fn number(self) -> Option<f64> {
        if let Self::Number(number, _) = self { Some(number) } else { None }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_field_is_a_number_with_or_without_its_unit_or_a_probe_that_is_not_there() {
        for (text, value) in [
            ("54.3", Value::Number(54.3, None)),
            ("54,3 °C", Value::Number(54.3, Some(Unit::Celsius))),
            ("129.7F", Value::Number(129.7, Some(Unit::Fahrenheit))),
            ("129.7 deg F", Value::Number(129.7, Some(Unit::Fahrenheit))),
            ("-3", Value::Number(-3.0, None)),
            ("", Value::Missing),
            ("--.-", Value::Missing),
            ("Unavailable", Value::Missing),
            ("hot", Value::Other),
            ("5 g", Value::Other),
        ] {
            assert_eq!(Value::of(text), value, "{text}");
        }
    }
}
