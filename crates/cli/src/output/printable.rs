//! Text for a terminal: control characters are shown as escapes, because a file must not command the terminal.

use std::borrow::Cow;
use std::fmt::Write;

/// Returns a text with its control characters as escapes such as `\u001b`, which are valid in JSON too. Line ends and tabs
/// stay.
pub fn printable(text: &str) -> Cow<'_, str> {
    if !text.chars().any(is_escaped) {
        return Cow::Borrowed(text);
    }
    let mut shown = String::with_capacity(text.len());
    for c in text.chars() {
        if is_escaped(c) {
            // Writing into a String does not fail.
            let _ = write!(shown, "\\u{:04x}", u32::from(c));
        } else {
            shown.push(c);
        }
    }
    Cow::Owned(shown)
}

/// Returns true for control characters, and for those that reorder the text of a line.
fn is_escaped(c: char) -> bool {
    let reorders = matches!(c, '\u{200e}' | '\u{200f}' | '\u{202a}'..='\u{202e}' | '\u{2066}'..='\u{2069}');
    (c.is_control() && c != '\n' && c != '\t') || reorders
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn control_characters_become_escapes_and_the_rest_stays() {
        assert!(matches!(printable("12 °C\n\tµ 肉"), Cow::Borrowed(_)));
        assert_eq!(printable("\u{1b}[31mred\u{7}\r"), "\\u001b[31mred\\u0007\\u000d");
        assert_eq!(printable("\u{9b}31m \u{202e}gnp"), "\\u009b31m \\u202egnp");
        let json = format!("\"{}\"", printable("\u{9b}\u{7f}"));
        assert_eq!(serde_json::from_str::<String>(&json).ok().as_deref(), Some("\u{9b}\u{7f}"));
    }
}
