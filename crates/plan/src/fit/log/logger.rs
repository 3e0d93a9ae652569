//! Presets for makers of thermometers: what their logs do not state.

use std::sync::LazyLock;

use serde::Deserialize;

use super::unit::Unit;

/// A maker's preset.
#[derive(Clone, Debug, Deserialize, PartialEq)]
#[serde(deny_unknown_fields)]
pub struct Logger {
    /// Its name on the command line.
    pub id: String,
    /// Its name for people.
    pub name: String,
    /// Headers of its columns in their order, where its logs state none.
    #[serde(default)]
    pub headers: Vec<String>,
    /// Headers of the times, the first that is there.
    #[serde(default)]
    pub time: Vec<String>,
    /// Headers of the core's temperatures, the first that is there.
    #[serde(default)]
    pub core: Vec<String>,
    /// Headers of the pan's temperatures, the first that is there.
    #[serde(default)]
    pub pan: Vec<String>,
    /// Unit of the temperatures where nothing else states it.
    #[serde(default, rename = "unit")]
    unit_sign: Option<String>,
    /// Where its form is described.
    pub source: String,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Presets {
    logger: Vec<Logger>,
}

static LOGGERS: LazyLock<Vec<Logger>> = LazyLock::new(|| {
    // A test reads the file that is built in.
    toml::from_str::<Presets>(include_str!("../../../../../data/loggers.toml"))
        .map(|file| file.logger)
        .unwrap_or_default()
});

/// Returns the presets, in the order of their file.
pub fn loggers() -> &'static [Logger] {
    &LOGGERS
}

impl Logger {
    /// Returns the preset with an id.
    pub fn named(id: &str) -> Option<&'static Self> {
        loggers().iter().find(|logger| logger.id == id)
    }

    /// Returns the unit of its temperatures where nothing else states it.
    pub fn unit(&self) -> Option<Unit> {
        self.unit_sign.as_deref().and_then(Unit::of_word)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_presets_are_read_and_each_has_a_source() {
        let text = include_str!("../../../../../data/loggers.toml");
        let presets: Presets = toml::from_str(text).expect("is read");
        assert!(presets.logger.len() >= 10);
        for logger in &presets.logger {
            assert!(!logger.source.is_empty() && Logger::named(&logger.id).is_some(), "{}", logger.id);
            assert!(logger.unit_sign.is_none() || logger.unit().is_some(), "{}: unit", logger.id);
        }
    }
}
