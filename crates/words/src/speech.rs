//! How a person is spoken to: the language, and the unit of temperatures.

use crate::language::Language;

/// The language of the texts, and the unit of temperatures.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Speech {
    /// The language.
    pub language: Language,
    /// °F instead of °C.
    pub fahrenheit: bool,
}

impl Speech {
    /// A temperature in the chosen unit, with its unit, never broken over two lines.
    pub fn temperature(self, celsius: f64) -> String {
        format!("{:.0}\u{a0}{}", self.degrees(celsius), self.unit())
    }

    /// As [`Self::temperature`], to a tenth.
    pub fn fine_temperature(self, celsius: f64) -> String {
        format!("{:.1}\u{a0}{}", self.degrees(celsius), self.unit())
    }

    /// A temperature in the chosen unit.
    pub fn degrees(self, celsius: f64) -> f64 {
        if self.fahrenheit { celsius * 1.8 + 32.0 } else { celsius }
    }

    /// °C from the chosen unit.
    pub fn celsius(self, degrees: f64) -> f64 {
        if self.fahrenheit { (degrees - 32.0) / 1.8 } else { degrees }
    }

    /// The chosen unit.
    pub fn unit(self) -> &'static str {
        if self.fahrenheit { "°F" } else { "°C" }
    }
}

/// Returns a text that begins with a capital letter.
pub fn capitalised(text: &str) -> String {
    let mut letters = text.chars();
    letters.next().map_or_else(String::new, |first| first.to_uppercase().chain(letters).collect())
}
