//! How far a forecast on coarse meshes may be from a full cook.
//!
//! `data/forecast.toml` contains, for each question, the quantile of the errors of many forecasts against full cooks at some
//! times ahead. `docs/forecast.md` states how they were found.

use serde::Deserialize;

use crate::forecast::question::Question;

/// Times ahead for which the band is stated [s].
pub const SPANS_S: [f64; 3] = [60.0, 120.0, 300.0];

/// `data/forecast.toml` as it is written.
const TEXT: &str = include_str!("../../../../data/forecast.toml");

/// Half the width of the band around the answer to a question: as many forecasts as the [`Bands`] state are within it.
#[derive(Clone, Debug, Deserialize, PartialEq)]
#[serde(deny_unknown_fields)]
pub struct Band {
    /// The question.
    pub question: Question,
    /// Of the core temperature after each of [`SPANS_S`] [K].
    pub core_k: [f64; SPANS_S.len()],
    /// Of the highest core temperature ahead [K].
    pub peak_k: f64,
    /// Where the numbers come from.
    pub source: String,
    /// How sure they are.
    pub confidence: Confidence,
}

/// How sure a number is.
#[derive(Clone, Copy, Debug, Deserialize, PartialEq, Eq)]
#[serde(rename_all = "lowercase")]
pub enum Confidence {
    /// Measured directly.
    High,
    /// Measured elsewhere or inferred.
    Medium,
    /// A guess.
    Low,
}

/// The bands of all questions.
#[derive(Clone, Debug, Deserialize, PartialEq)]
#[serde(deny_unknown_fields)]
pub struct Bands {
    /// Share of forecasts within the band [-].
    pub within: f64,
    band: Vec<Band>,
}

/// `data/forecast.toml` cannot be used.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum BandsError {
    /// It cannot be read.
    #[error("forecast.toml: {0}")]
    Unreadable(String),
    /// A question has no band.
    #[error("forecast.toml has no band for {0:?}: state one for every question")]
    Missing(Question),
}

impl Bands {
    /// The bands that the program carries.
    ///
    /// # Errors
    /// If the file cannot be read, or lacks a question.
    pub fn embedded() -> Result<Self, BandsError> {
        let bands: Self = toml::from_str(TEXT).map_err(|e| BandsError::Unreadable(e.to_string()))?;
        match Question::ALL.into_iter().find(|question| bands.of(*question).is_none()) {
            Some(missing) => Err(BandsError::Missing(missing)),
            None => Ok(bands),
        }
    }

    /// The band of a question.
    pub fn of(&self, question: Question) -> Option<&Band> {
        self.band.iter().find(|band| band.question == question)
    }
}

impl Band {
    /// Half its width around the core at a time from the present on: linear between the stated times, from 0 at the present;
    /// the last one beyond them [K].
    pub fn core_at(&self, after_s: f64) -> f64 {
        let (mut before, mut width) = (0.0, 0.0);
        for (span, stated) in SPANS_S.into_iter().zip(self.core_k) {
            if after_s < span {
                return width + (stated - width) * (after_s.max(0.0) - before) / (span - before);
            }
            (before, width) = (span, stated);
        }
        width
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_question_has_a_band_that_begins_at_nothing_and_runs_through_its_numbers() {
        let bands = Bands::embedded().expect("bands");
        for question in Question::ALL {
            let band = bands.of(question).expect("a band");
            assert_eq!(band.core_at(0.0), 0.0);
            for (span, width) in SPANS_S.into_iter().zip(band.core_k) {
                assert!(width > 0.0 && (band.core_at(span) - width).abs() < 1e-12, "{question:?}");
            }
            assert!((band.core_at(90.0) - 0.5 * (band.core_k[0] + band.core_k[1])).abs() < 1e-12);
            assert_eq!(band.core_at(900.0), band.core_k[2]);
        }
    }
}
