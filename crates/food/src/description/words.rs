//! What a food is called: its file states it for each language.

use schemars::JsonSchema;
use serde::Deserialize;

use crate::description::FoodDescription;

/// Code of the language in which files and the command line name things.
pub const FILE_LANGUAGE: &str = "en";

/// What a food is called in a language.
#[derive(Clone, Debug, Default, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct FoodWords {
    /// Display name; without it that of the food.
    #[schemars(length(min = 1), example = &"My food")]
    pub name: Option<String>,
    /// Noun in a sentence, as in "a raw steak"; without it the English one, else the display name in small letters.
    #[schemars(length(min = 1), example = &"steak")]
    pub noun: Option<String>,
    /// Name of a piece beside pieces of other foods; without it the noun. Pieces that are set out have the English one as id.
    #[schemars(length(min = 1), example = &"steak")]
    pub piece: Option<String>,
}

impl FoodDescription {
    /// Returns the display name in a language, given its code; the food's own where its file states none.
    pub fn name_in(&self, language: &str) -> &str {
        self.words.get(language).and_then(|words| words.name.as_deref()).unwrap_or(&self.name)
    }

    /// Returns the noun in a language, given its code; the English one where its file states none.
    pub fn noun_in(&self, language: &str) -> String {
        let noun = |language| self.words.get(language)?.noun.clone();
        noun(language).or_else(|| noun(FILE_LANGUAGE)).unwrap_or_else(|| self.name.to_lowercase())
    }

    /// Returns the name of a piece in a language, given its code; none where the file states no words for pieces.
    pub fn piece_in(&self, language: &str) -> Option<&str> {
        let piece = |language| {
            let words = self.words.get(language)?;
            words.piece.as_deref().or(words.noun.as_deref())
        };
        piece(language).or_else(|| piece(FILE_LANGUAGE))
    }

    /// Returns the id of a piece of the food that is set out without a recipe, given the food's id.
    pub fn piece_id(&self, id: &str) -> String {
        let Some(name) = self.piece_in(FILE_LANGUAGE) else { return id.to_owned() };
        let plain = |c: char| if c.is_ascii_alphanumeric() || c == '_' { c } else { '-' };
        let plain: String = name.chars().map(plain).collect();
        let plain = plain.trim_matches('-');
        if plain.is_empty() { id.to_owned() } else { plain.to_owned() }
    }
}
