//! Lines and words of texts in any encoding that extends ASCII.

use crate::ReadError;

/// Marks of the order of bytes at the beginning of a text: UTF-8, and UTF-16 in both orders.
const UTF_8: &[u8] = b"\xef\xbb\xbf";
const UTF_16: [&[u8]; 2] = [b"\xff\xfe", b"\xfe\xff"];

/// Returns a text without its mark of UTF-8.
///
/// # Errors
/// [`ReadError`] for a text in UTF-16, whose numbers are no ASCII.
pub fn unmarked(bytes: &[u8]) -> Result<&[u8], ReadError> {
    if UTF_16.iter().any(|mark| bytes.starts_with(mark)) {
        return Err(ReadError::at_line(1, "is text in UTF-16", "save the file as UTF-8 or plain ASCII text"));
    }
    Ok(bytes.strip_prefix(UTF_8).unwrap_or(bytes))
}

/// A line without white space around it.
#[derive(Clone, Copy, Debug)]
pub struct Line<'a> {
    /// Its number, from 1.
    pub number: usize,
    pub text: &'a [u8],
}

/// Returns the lines of a text; each ends with a line feed, a carriage return, or both.
pub fn lines(text: &[u8]) -> impl Iterator<Item = Line<'_>> {
    let feeds = text.split(|byte| *byte == b'\n').map(|line| line.strip_suffix(b"\r").unwrap_or(line));
    let lines = feeds.flat_map(|line| line.split(|byte| *byte == b'\r'));
    (1..).zip(lines).map(|(number, line)| Line { number, text: line.trim_ascii() })
}

/// A word with the number of its line.
#[derive(Clone, Copy, Debug)]
pub struct Word<'a> {
    /// Number of its line, from 1.
    pub line: usize,
    pub text: &'a [u8],
}

impl<'a> Line<'a> {
    /// Returns the words of the line.
    pub fn words(self) -> impl Iterator<Item = Word<'a>> {
        let words = self.text.split(u8::is_ascii_whitespace).filter(|word| !word.is_empty());
        words.map(move |text| Word { line: self.number, text })
    }
}

impl Word<'_> {
    /// Returns the word for messages; characters in other encodings become question marks.
    pub fn shown(&self) -> String {
        format!("\"{}\"", String::from_utf8_lossy(self.text).replace(char::REPLACEMENT_CHARACTER, "?"))
    }

    /// Returns an error at the line of the word.
    pub fn error(&self, message: impl Into<String>, remedy: impl Into<String>) -> ReadError {
        ReadError::at_line(self.line, message, remedy)
    }

    /// Returns the finite number that the word states, in single or double precision.
    ///
    /// # Errors
    /// [`ReadError`] for a comma as the decimal sign, for what is no number, and for what is not finite.
    pub fn number<T: std::str::FromStr + Into<f64>>(&self) -> Result<f64, ReadError> {
        let number = std::str::from_utf8(self.text).ok().and_then(|text| text.parse::<T>().ok()).map(T::into);
        match number {
            Some(number) if number.is_finite() => Ok(number),
            Some(_) => Err(self.error(format!("{} is no finite number", self.shown()), NOT_FINITE)),
            None if self.text.contains(&b',') => Err(self.error(format!("{} has a comma", self.shown()), COMMA)),
            None => Err(self.error(format!("{} is no number", self.shown()), "write a number such as 12.5 there")),
        }
    }
}

/// The remedy for numbers with a comma as the decimal sign.
const COMMA: &str =
    "write numbers with a point, as 12.5: export it with English as the language of the program or system";
/// The remedy for coordinates that are infinite or no numbers.
pub const NOT_FINITE: &str = "in your modelling program, delete the corners without a place, and export it again";
