//! Messages that echo a file: a long echo is shortened.

use std::borrow::Cow;

/// Longest word that is shown whole [characters] (chosen: longer than every key and every number).
const WORD: usize = 60;
/// Longest message that is shown whole [characters] (chosen: ten lines of a terminal).
const MESSAGE: usize = 800;
/// Characters at the end of a message that remain when it is shortened.
const TAIL: usize = 100;

/// Returns a message with its long words shortened, and shortened itself if it is still long.
///
/// ```
/// use saute_schema::echo::shortened;
///
/// let usual = "food kind = \"beef-lean\" is not a food: use one of: beef-lean, beef-marbled, beef-patty, carrot-coin";
/// assert!(matches!(shortened(usual), std::borrow::Cow::Borrowed(text) if text == usual));
/// let echo = format!("kind = \"{}\" is not a pan", "肉".repeat(1_000_000));
/// let short = shortened(&echo);
/// assert!(short.starts_with("kind = \"肉肉") && short.ends_with("肉\" is not a pan") && short.chars().count() < 100);
/// let words = format!("title {} ends here", "word ".repeat(100_000));
/// assert!(shortened(&words).chars().count() <= 803 && shortened(&words).ends_with("ends here"));
/// ```
pub fn shortened(message: &str) -> Cow<'_, str> {
    // The number of bytes is at least that of characters.
    let is_short = message.len() <= MESSAGE && message.split_whitespace().all(|word| word.len() <= WORD);
    if is_short {
        return Cow::Borrowed(message);
    }
    let words: Vec<Cow<str>> = message.split(' ').map(short_word).collect();
    let text = words.join(" ");
    let length = text.chars().count();
    if length <= MESSAGE {
        return Cow::Owned(text);
    }
    let head: String = text.chars().take(MESSAGE - TAIL).collect();
    let tail: String = text.chars().skip(length - TAIL).collect();
    Cow::Owned(format!("{head} … {tail}"))
}

/// Returns a word, without its middle if it is long.
fn short_word(word: &str) -> Cow<'_, str> {
    let length = word.chars().count();
    if length <= WORD {
        return Cow::Borrowed(word);
    }
    let head: String = word.chars().take(WORD - 20).collect();
    let tail: String = word.chars().skip(length - 10).collect();
    Cow::Owned(format!("{head}…{tail}"))
}
