//! The languages of the window, and its texts in them.

use std::collections::BTreeMap;
use std::fmt::Display;
use std::sync::OnceLock;

use serde::{Deserialize, Serialize};

/// A language of the window.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Deserialize, Serialize)]
pub enum Language {
    /// English.
    #[default]
    #[serde(rename = "en")]
    English,
    /// Japanese.
    #[serde(rename = "ja")]
    Japanese,
}

/// Texts by section and key.
type Texts = BTreeMap<String, BTreeMap<String, String>>;

const ENGLISH: &str = include_str!("../texts/en.toml");
const JAPANESE: &str = include_str!("../texts/ja.toml");

impl Language {
    /// Both of them.
    pub const ALL: [Self; 2] = [Self::English, Self::Japanese];

    /// The language of the system's environment (`LC_ALL`, `LC_MESSAGES`, `LANG`, the first that says anything).
    pub fn of_environment() -> Self {
        let said = ["LC_ALL", "LC_MESSAGES", "LANG"].into_iter().filter_map(|key| std::env::var(key).ok());
        said.into_iter().find(|value| !value.is_empty()).map_or(Self::English, |value| Self::of_locale(&value))
    }

    /// The language of a locale such as `ja_JP.UTF-8`; English for those that the window does not speak.
    pub fn of_locale(locale: &str) -> Self {
        if locale.split(['_', '-', '.', '@']).next() == Some("ja") { Self::Japanese } else { Self::English }
    }

    /// Its code, by which files and settings name it.
    pub fn code(self) -> &'static str {
        match self {
            Self::English => "en",
            Self::Japanese => "ja",
        }
    }

    /// The other one.
    pub fn other(self) -> Self {
        match self {
            Self::English => Self::Japanese,
            Self::Japanese => Self::English,
        }
    }

    /// The file that holds its texts.
    pub fn file(self) -> &'static str {
        match self {
            Self::English => ENGLISH,
            Self::Japanese => JAPANESE,
        }
    }

    /// A text by `section.key`; one that is in no file is its own key, so that it is seen.
    pub fn text(self, key: &'static str) -> &'static str {
        self.find(key).unwrap_or(key)
    }

    /// A text by `section.key`, if there is one.
    pub fn find(self, key: &str) -> Option<&'static str> {
        let (section, key) = key.split_once('.')?;
        self.texts().get(section)?.get(key).map(String::as_str)
    }

    /// A text with what it leaves open put in.
    pub fn fill(self, key: &'static str, open: &[(&str, &dyn Display)]) -> String {
        let put = |text: String, (name, value): &(&str, &dyn Display)| {
            text.replace(&format!("{{{name}}}"), &value.to_string())
        };
        open.iter().fold(self.text(key).to_owned(), put)
    }

    /// What the core calls by an English name, found in a section; a name of a user's own stays as it is.
    pub fn called<'a>(self, section: &str, english: &'a str) -> &'a str {
        let Some(names) = Self::English.texts().get(section) else { return english };
        let key = names.iter().find(|(_, name)| *name == english).map(|(key, _)| key);
        key.and_then(|key| self.texts().get(section)?.get(key)).map_or(english, String::as_str)
    }

    /// The name of one of our own ids in a section; ids are written with hyphens, keys with underscores.
    pub fn known(self, section: &str, id: &str) -> Option<&'static str> {
        self.texts().get(section)?.get(&id.replace('-', "_")).map(String::as_str)
    }

    fn texts(self) -> &'static Texts {
        static PARSED: [OnceLock<Texts>; 2] = [const { OnceLock::new() }; 2];
        // Both files are parts of the program, and a test reads them: an error cannot reach a user.
        PARSED[self as usize].get_or_init(|| toml::from_str(self.file()).unwrap_or_default())
    }
}
