//! Words of a header.

/// Returns the words of a header in small letters: `CoreTempF`, `core_temp_f` and `Core temp (F)` are all core, temp, f.
pub(super) fn words_of(header: &str) -> Vec<String> {
    let mut words = Vec::new();
    let mut word = String::new();
    let letters: Vec<char> = header.chars().collect();
    for (at, letter) in letters.iter().copied().enumerate() {
        let begins = at > 0 && begins_a_word(letters[at - 1], letter, letters.get(at + 1).copied());
        if (begins || !letter.is_alphanumeric()) && !word.is_empty() {
            words.push(std::mem::take(&mut word));
        }
        if letter.is_alphanumeric() {
            word.extend(letter.to_lowercase());
        }
    }
    if !word.is_empty() {
        words.push(word);
    }
    words
}

/// True if a letter begins a word after the one before it: a capital after a small one, the last capital of several before a small one,
/// a letter next to a digit.
fn begins_a_word(before: char, letter: char, after: Option<char>) -> bool {
    let camel = before.is_lowercase() && letter.is_uppercase();
    let last_capital = before.is_uppercase() && letter.is_uppercase() && after.is_some_and(char::is_lowercase);
    let digit = before.is_numeric() != letter.is_numeric() && before.is_alphanumeric() && letter.is_alphanumeric();
    camel || last_capital || digit
}

/// True if one of some words is among those of a header. Words of scripts that write without blanks are looked for within.
pub(super) fn has_any(words: &[String], wanted: &[&str]) -> bool {
    let is = |word: &String, wanted: &str| {
        word == wanted || (!wanted.is_ascii() && word.contains(wanted)) || is_several(word, wanted)
    };
    wanted.iter().any(|wanted| words.iter().any(|word| is(word, wanted)))
}

/// True if a word is another one in the plural or runs on from a longer one, as `kerntemperatur` does from `kern`.
fn is_several(word: &str, wanted: &str) -> bool {
    wanted.len() >= 4 && word.strip_prefix(wanted).is_some_and(|rest| rest == "s" || rest.starts_with("temp"))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_header_is_split_into_its_words() {
        for (header, words) in [
            ("CoreTempF", "core temp f"),
            ("VirtualSurfaceTemperature", "virtual surface temperature"),
            ("Probe1 (°F)", "probe 1 f"),
            ("TEMP_F", "temp f"),
            ("steak.core_c", "steak core c"),
            ("ETTemp", "et temp"),
        ] {
            assert_eq!(words_of(header).join(" "), words, "{header}");
        }
    }

    #[test]
    fn a_word_is_found_in_the_plural_in_compounds_and_in_scripts_without_blanks() {
        assert!(has_any(&words_of("Kerntemperatur"), &["kern"]));
        assert!(has_any(&words_of("フライパン温度"), &["フライパン"]));
        assert!(!has_any(&words_of("Panel"), &["pan"]) && !has_any(&words_of("Corel"), &["core"]));
    }
}
