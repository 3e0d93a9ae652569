//! What a food is called: its file states it for each language.

use std::collections::BTreeMap;

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
    /// How a piece that is done feels, by its highest core temperature, ascending; without them the English ones.
    #[serde(default)]
    pub feel: Vec<Feel>,
}

/// How a piece feels that is done, from a highest core temperature on.
#[derive(Clone, Debug, Default, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Feel {
    /// Highest core temperature from which it feels so [°C]; the first one also holds below.
    #[schemars(range(min = 0.0, max = 120.0), example = 55.0)]
    pub from_c: f64,
    /// The sentence.
    #[schemars(length(min = 1), example = &"Springs back under a finger.")]
    pub says: String,
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

    /// Returns how a piece feels that is done, by the code of the language, given its highest core temperature [°C]; empty where the
    /// file states no words for it.
    pub fn feel_at(&self, peak_c: f64) -> BTreeMap<String, String> {
        let at = |words: &FoodWords| {
            let reached = words.feel.iter().take_while(|feel| feel.from_c <= peak_c).last();
            reached.or(words.feel.first()).map(|feel| feel.says.clone())
        };
        self.words.iter().filter_map(|(language, words)| Some((language.clone(), at(words)?))).collect()
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

#[cfg(test)]
mod tests {
    use super::*;

    fn food(words: &str) -> FoodDescription {
        let shipped = include_str!("../../../../data/foods/carrot-coin.toml");
        let (head, _) = shipped.split_once("[words.en]").expect("has words");
        let (_, tail) = shipped.split_once("[size]").expect("has sizes");
        toml::from_str(&format!("{head}{words}\n[size]{tail}")).expect("is sound")
    }

    #[test]
    fn a_done_piece_feels_by_its_peak_and_below_the_first_words_as_by_them() {
        let food = food(
            "[words.en]\nfeel = [{ from_c = 45.0, says = \"soft\" }, { from_c = 60.0, says = \"firm\" }]\n[words.ja]\nnoun = \"x\"",
        );
        let says = |peak_c: f64| food.feel_at(peak_c).get("en").cloned();
        assert_eq!(
            [20.0, 59.9, 60.0].map(says),
            [Some("soft".to_owned()), Some("soft".to_owned()), Some("firm".to_owned())]
        );
        assert!(!food.feel_at(70.0).contains_key("ja"), "the English words serve");
    }

    #[test]
    fn a_food_without_such_words_says_nothing() {
        assert!(food("[words.en]\nnoun = \"x\"").feel_at(60.0).is_empty());
    }
}
