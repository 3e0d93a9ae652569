//! Units of temperatures.

use saute_kitchen::food::ZERO_C;
use serde::{Deserialize, Serialize};

use super::header_words::words_of;

/// Unit of the temperatures of a column.
#[derive(Clone, Copy, Debug, Deserialize, PartialEq, Eq, Serialize)]
pub enum Unit {
    /// °C.
    #[serde(rename = "°C")]
    Celsius,
    /// °F.
    #[serde(rename = "°F")]
    Fahrenheit,
    /// K.
    #[serde(rename = "K")]
    Kelvin,
}

/// Why a unit was taken.
#[derive(Clone, Copy, Debug, Deserialize, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum UnitFrom {
    /// It was requested.
    Asked,
    /// The maker's logs have it.
    Maker,
    /// The column's header names it.
    Header,
    /// The rows or their values name it.
    Rows,
    /// The lines above the table name it.
    Preamble,
    /// Another column's header names it.
    OtherColumn,
    /// Nothing names it: °C, as only that makes sense.
    Assumed,
}

impl Unit {
    /// Returns the unit that a header names: `core (°F)`, `probe_f`, `CoreTempF`, `Temp [F]`.
    pub fn of_header(header: &str) -> Option<Self> {
        let words = words_of(header);
        let last = words.last().map(String::as_str);
        let by_degree =
            header.split_once('°').and_then(|(_, rest)| Self::of_word(&rest.chars().take(1).collect::<String>()));
        let by_word = || words.iter().filter(|word| word.len() > 1).find_map(|word| Self::of_word(word));
        by_degree.or_else(by_word).or_else(|| (words.len() > 1).then(|| Self::of_word(last?)).flatten())
    }

    /// Returns the unit that a word means: `F`, `degF`, `Fahrenheit`.
    pub fn of_word(word: &str) -> Option<Self> {
        match word.trim().trim_start_matches(['°', '*']).trim().to_lowercase().as_str() {
            "f" | "degf" | "degreesf" | "fahrenheit" | "華氏" => Some(Self::Fahrenheit),
            "c" | "degc" | "degreesc" | "celsius" | "centigrade" | "摂氏" => Some(Self::Celsius),
            "k" | "kelvin" => Some(Self::Kelvin),
            _ => None,
        }
    }

    /// Returns a temperature [K].
    pub fn kelvin(self, value: f64) -> f64 {
        match self {
            Self::Celsius => value + ZERO_C,
            Self::Fahrenheit => (value - 32.0) / 1.8 + ZERO_C,
            Self::Kelvin => value,
        }
    }

    /// Returns its sign.
    pub fn sign(self) -> &'static str {
        match self {
            Self::Celsius => "°C",
            Self::Fahrenheit => "°F",
            Self::Kelvin => "K",
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_header_names_its_unit() {
        use Unit::{Celsius, Fahrenheit};
        for (header, unit) in [
            ("Core (°F)", Some(Fahrenheit)),
            ("Probe1 -°F", Some(Fahrenheit)),
            ("probe_f", Some(Fahrenheit)),
            ("CoreTempF", Some(Fahrenheit)),
            ("Temp [F]", Some(Fahrenheit)),
            ("tempDegF", Some(Fahrenheit)),
            ("Temperature Fahrenheit 1", Some(Fahrenheit)),
            ("core_c", Some(Celsius)),
            ("Core ° C", Some(Celsius)),
            ("Surface", None),
            ("Fan", None),
            ("F", None),
        ] {
            assert_eq!(Unit::of_header(header), unit, "{header}");
        }
        assert!((Fahrenheit.kelvin(140.0) - 333.15).abs() < 1e-9);
    }
}
