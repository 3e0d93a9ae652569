//! The languages of the window, and its texts in them: each language is a file in `texts`.

use std::collections::BTreeMap;
use std::fmt::{self, Debug, Display, Formatter};

use serde::{Deserialize, Serialize};

use crate::language_files::LanguageFiles;

/// A language of the window.
#[derive(Clone, Copy, Default, PartialEq, Eq, Deserialize, Serialize)]
#[serde(try_from = "String", into = "String")]
pub struct Language(usize);

/// The font that a language is written with.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Font {
    /// That of the window, which is always there.
    Latin,
    /// One with the characters of Japanese.
    Japanese,
}

impl Language {
    /// English, which has every text.
    pub const ENGLISH: Self = Self(0);

    /// All of them, English first.
    pub fn all() -> impl Iterator<Item = Self> {
        (0..LanguageFiles::shipped().all().len()).map(Self)
    }

    /// The language of a code such as `ja`, by which files and settings name it.
    pub fn of_code(code: &str) -> Option<Self> {
        Self::all().find(|language| language.code() == code)
    }

    /// The language of the system's environment (`LC_ALL`, `LC_MESSAGES`, `LANG`, the first that is set).
    pub fn of_environment() -> Self {
        let said = ["LC_ALL", "LC_MESSAGES", "LANG"].into_iter().filter_map(|key| std::env::var(key).ok());
        said.into_iter().find(|value| !value.is_empty()).map_or(Self::ENGLISH, |value| Self::of_locale(&value))
    }

    /// The language of a locale such as `ja_JP.UTF-8`; English for those that the window does not have.
    pub fn of_locale(locale: &str) -> Self {
        locale.split(['_', '-', '.', '@']).next().and_then(Self::of_code).unwrap_or_default()
    }

    /// The next one; the first after the last.
    pub fn next(self) -> Self {
        Self((self.0 + 1) % LanguageFiles::shipped().all().len().max(1))
    }

    /// Its code.
    pub fn code(self) -> &'static str {
        LanguageFiles::shipped().all().get(self.0).map_or("", |language| language.code)
    }

    /// The file with its texts.
    pub fn file(self) -> &'static str {
        LanguageFiles::shipped().all().get(self.0).map_or("", |language| language.file)
    }

    /// What it is called in itself.
    pub fn name(self) -> &'static str {
        self.text("language.name")
    }

    /// What it is called where its letters cannot be drawn.
    pub fn short_name(self) -> &'static str {
        self.text("language.short_name")
    }

    /// The font that it is written with.
    pub fn font(self) -> Font {
        match self.text("language.font") {
            "japanese" => Font::Japanese,
            _ => Font::Latin,
        }
    }

    /// A text by `section.key`; one that is in no file is its own key, so that it is seen.
    pub fn text(self, key: &'static str) -> &'static str {
        self.find(key).unwrap_or(key)
    }

    /// A text by `section.key`, if there is one.
    pub fn find(self, key: &str) -> Option<&'static str> {
        let (section, key) = key.split_once('.')?;
        LanguageFiles::shipped().find(self.0, section, key)
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
        let key = LanguageFiles::shipped().key_of(section, english);
        key.and_then(|key| LanguageFiles::shipped().find(self.0, section, key)).unwrap_or(english)
    }

    /// A name of the data: as its file calls it in this language, else as [`Self::called`].
    pub fn named<'a>(self, section: &str, english: &'a str, names: &'a BTreeMap<String, String>) -> &'a str {
        names.get(self.code()).map_or_else(|| self.called(section, english), String::as_str)
    }

    /// The name of one of our own ids in a section; ids are written with hyphens, keys with underscores.
    pub fn known(self, section: &str, id: &str) -> Option<&'static str> {
        LanguageFiles::shipped().find(self.0, section, &id.replace('-', "_"))
    }
}

impl Debug for Language {
    fn fmt(&self, f: &mut Formatter) -> fmt::Result {
        f.write_str(self.code())
    }
}

impl From<Language> for String {
    fn from(language: Language) -> Self {
        language.code().to_owned()
    }
}

/// No language has this code.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct NoSuchLanguage(String);

impl std::error::Error for NoSuchLanguage {}

impl Display for NoSuchLanguage {
    fn fmt(&self, f: &mut Formatter) -> fmt::Result {
        let known: Vec<&str> = Language::all().map(Language::code).collect();
        write!(f, "\"{}\" is no language; there are: {}", self.0, known.join(", "))
    }
}

impl TryFrom<String> for Language {
    type Error = NoSuchLanguage;

    fn try_from(code: String) -> Result<Self, NoSuchLanguage> {
        Self::of_code(&code).ok_or(NoSuchLanguage(code))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_file_is_a_language_that_states_its_name_and_its_font() {
        let said: Vec<_> = Language::all().map(|l| (l.code(), l.name(), l.short_name(), l.font())).collect();
        assert_eq!(said, [("en", "EN", "EN", Font::Latin), ("ja", "日本語", "JA", Font::Japanese)]);
        assert_eq!((Language::default(), Language::ENGLISH.code()), (Language::ENGLISH, "en"));
        assert!(Language::all().all(|l| l.next() != l && l.next().next() == l), "there are two");
    }

    #[test]
    fn a_language_is_remembered_by_its_code() {
        for (code, name) in [("en", "EN"), ("ja", "日本語")] {
            let language = Language::try_from(code.to_owned()).expect("is known");
            assert_eq!((language.name(), String::from(language)), (name, code.to_owned()));
        }
        let unknown = Language::try_from("xx".to_owned()).expect_err("no file");
        assert_eq!(unknown.to_string(), "\"xx\" is no language; there are: en, ja");
    }
}
