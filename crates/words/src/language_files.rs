//! The files of the languages: which there are, and the texts in them.

use std::collections::BTreeMap;
use std::sync::{LazyLock, OnceLock};

use include_dir::{Dir, include_dir};

static TEXTS: Dir = include_dir!("$CARGO_MANIFEST_DIR/texts");

/// Code of the language whose file has every text.
const WHOLE: &str = "en";

/// Texts by section and key.
type Texts = BTreeMap<String, BTreeMap<String, String>>;

/// A language and its file, which is read when it is first spoken.
#[derive(Debug)]
pub(crate) struct LanguageFile {
    /// Its code, which is the name of the file.
    pub(crate) code: &'static str,
    /// The content of the file.
    pub(crate) file: &'static str,
    texts: OnceLock<Texts>,
}

impl LanguageFile {
    fn texts(&self) -> &Texts {
        // All files are parts of the program, and a test reads them: an error cannot reach a user.
        self.texts.get_or_init(|| toml::from_str(self.file).unwrap_or_default())
    }

    fn get(&self, section: &str, key: &str) -> Option<&str> {
        self.texts().get(section)?.get(key).map(String::as_str)
    }
}

/// The languages: first the one that has every text, then the others in the order of their codes.
#[derive(Debug)]
pub(crate) struct LanguageFiles(Vec<LanguageFile>);

impl LanguageFiles {
    /// Returns those of the program.
    pub(crate) fn shipped() -> &'static Self {
        static SHIPPED: LazyLock<LanguageFiles> = LazyLock::new(|| {
            let named =
                TEXTS.files().filter_map(|file| Some((file.path().file_stem()?.to_str()?, file.contents_utf8()?)));
            LanguageFiles::of(named)
        });
        &SHIPPED
    }

    /// Returns languages by their codes and files.
    pub(crate) fn of(files: impl IntoIterator<Item = (&'static str, &'static str)>) -> Self {
        let one = |(code, file)| LanguageFile { code, file, texts: OnceLock::new() };
        let mut all: Vec<LanguageFile> = files.into_iter().map(one).collect();
        all.sort_by_key(|language| (language.code != WHOLE, language.code));
        Self(all)
    }

    /// Returns the languages in their order.
    pub(crate) fn all(&self) -> &[LanguageFile] {
        &self.0
    }

    /// Returns a text of the language at a place; where its file lacks it, that of the first.
    pub(crate) fn find(&self, place: usize, section: &str, key: &str) -> Option<&str> {
        [place, 0].into_iter().find_map(|at| self.0.get(at)?.get(section, key))
    }

    /// Returns the key of a text of the first language in a section.
    pub(crate) fn key_of(&self, section: &str, text: &str) -> Option<&str> {
        let texts = self.0.first()?.texts().get(section)?;
        texts.iter().find(|(_, known)| *known == text).map(|(key, _)| key.as_str())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_third_language_says_in_the_first_what_its_file_lacks() {
        let files = [
            ("xx", "[deed]\nflip = \"wupf\"\n[language]\nname = \"Xaxa\"\n"),
            ("ja", "[deed]\nflip = \"返す\"\nput = \"入れる\"\n"),
            ("en", "[deed]\nflip = \"flip\"\nput = \"put in\"\n[language]\nname = \"EN\"\nfont = \"latin\"\n"),
        ];
        let languages = LanguageFiles::of(files);
        assert_eq!(languages.all().iter().map(|language| language.code).collect::<Vec<_>>(), ["en", "ja", "xx"]);
        let said = |key| [0, 1, 2].map(|place| languages.find(place, "deed", key));
        assert_eq!(said("flip"), [Some("flip"), Some("返す"), Some("wupf")]);
        assert_eq!(said("put"), [Some("put in"), Some("入れる"), Some("put in")]);
        assert_eq!(said("dance"), [None; 3]);
        assert_eq!(languages.find(2, "language", "font"), Some("latin"));
        assert_eq!(languages.key_of("deed", "put in"), Some("put"));
    }
}
