//! Bytes of a log as text.

/// What a file is that is no text of a log, and what to do with it.
pub(super) struct NoText {
    /// What it is.
    pub message: &'static str,
    /// What to do.
    pub remedy: &'static str,
}

/// First bytes of files that are handed in as logs, with what they are.
const KNOWN: [(&[u8], &str, &str); 9] = [
    (b"PK\x03\x04", "is a spreadsheet or an archive (ZIP)", "open it and save the sheet as CSV"),
    (b"\xd0\xcf\x11\xe0", "is a spreadsheet of the old Excel format", "open it and save the sheet as CSV"),
    (b"%PDF", "is a PDF document", "export the log as CSV"),
    (b"\x1f\x8b", "is compressed (gzip)", "unpack it first"),
    (b"SQLite format 3", "is a database (SQLite)", "export the table as CSV"),
    (b"\x89PNG", "is a picture", "export the log as CSV, or enter values by hand"),
    (b"\xff\xd8\xff", "is a picture", "export the log as CSV, or enter values by hand"),
    (b"PAR1", "is a Parquet file", "write it as CSV first"),
    (b"{\\rtf", "is a text document (RTF)", "save it as plain text or CSV"),
];

/// Returns the text of a log: UTF-8 with a byte order mark or without, UTF-16 with one, else Windows-1252, in which every byte is a
/// letter.
pub(super) fn text_of(bytes: &[u8]) -> Result<String, NoText> {
    if let Some((_, message, remedy)) = KNOWN.iter().find(|(start, ..)| bytes.starts_with(start)) {
        return Err(NoText { message, remedy });
    }
    let text = match bytes {
        [0xff, 0xfe, rest @ ..] => utf_16(rest, u16::from_le_bytes),
        [0xfe, 0xff, rest @ ..] => utf_16(rest, u16::from_be_bytes),
        _ => match std::str::from_utf8(bytes) {
            Ok(text) => text.to_owned(),
            Err(_) => bytes.iter().map(|byte| windows_1252(*byte)).collect(),
        },
    };
    checked(folded(text.trim_start_matches('\u{feff}')))
}

/// Refuses text that is no table.
fn checked(text: String) -> Result<String, NoText> {
    let remedy = "export the log as CSV";
    // Bytes above 0x7f occur in texts of unknown encodings; their numbers are read all the same.
    let is_control = |c: char| c.is_ascii_control() && !['\n', '\r', '\t'].contains(&c);
    if text.chars().take(4096).any(is_control) {
        return Err(NoText { message: "is no text", remedy });
    }
    match text.trim_start().chars().next() {
        Some('{' | '[') => Err(NoText { message: "is JSON, which is not read", remedy }),
        Some('<') => Err(NoText { message: "is a page or a document (HTML, XML), which is not read", remedy }),
        _ => Ok(text),
    }
}

fn utf_16(bytes: &[u8], unit: fn([u8; 2]) -> u16) -> String {
    let units = bytes.chunks_exact(2).map(|pair| unit([pair[0], pair[1]]));
    char::decode_utf16(units).map(|letter| letter.unwrap_or(char::REPLACEMENT_CHARACTER)).collect()
}

/// Letters of Windows-1252 between 0x80 and 0x9f; a byte without one stays as it is.
const WINDOWS: [char; 32] = [
    '€', '\u{81}', '‚', 'ƒ', '„', '…', '†', '‡', 'ˆ', '‰', 'Š', '‹', 'Œ', '\u{8d}', 'Ž', '\u{8f}', '\u{90}', '‘', '’',
    '“', '”', '•', '–', '—', '˜', '™', 'š', '›', 'œ', '\u{9d}', 'ž', 'Ÿ',
];

fn windows_1252(byte: u8) -> char {
    match byte {
        0x80..=0x9f => WINDOWS[usize::from(byte - 0x80)],
        _ => char::from(byte),
    }
}

/// Letters that replace others, as in Unicode's form NFKC, as far as logs have them: signs of degrees, wide letters, blanks.
fn folded(text: &str) -> String {
    let mut folded = String::with_capacity(text.len());
    for letter in text.chars() {
        match letter {
            '℉' => folded.push_str("°F"),
            '℃' => folded.push_str("°C"),
            'º' | '˚' | '∘' => folded.push('°'),
            '\u{ff01}'..='\u{ff5e}' => folded.push(char::from_u32(u32::from(letter) - 0xfee0).unwrap_or(letter)),
            '\u{a0}' | '\u{202f}' | '\u{2009}' | '\u{3000}' => folded.push(' '),
            '−' | '‐' | '‑' => folded.push('-'),
            '\u{200b}' | '\u{200e}' | '\u{200f}' | '\u{feff}' | '\0' => {}
            _ => folded.push(letter),
        }
    }
    folded
}

#[cfg(test)]
mod tests {
    use super::*;

    fn text(bytes: &[u8]) -> String {
        text_of(bytes).ok().expect("a text")
    }

    #[test]
    fn text_of_any_encoding_is_read_and_degrees_are_one_sign() {
        assert_eq!(text("\u{feff}Core (℉)".as_bytes()), "Core (°F)");
        assert_eq!(text(b"Core (\xb0F)"), "Core (°F)", "Windows-1252");
        let wide: Vec<u8> = "\u{feff}core (ºC)".encode_utf16().flat_map(u16::to_le_bytes).collect();
        assert_eq!(text(&wide), "core (°C)", "UTF-16");
        assert_eq!(text("Ｔｅｍｐ　（℃）".as_bytes()), "Temp (°C)", "wide letters");
    }

    #[test]
    fn what_is_no_log_is_called_by_its_name() {
        let said = |bytes: &[u8]| text_of(bytes).err().map(|no| no.message).expect("refused");
        assert!(said(b"PK\x03\x04rest").contains("spreadsheet"));
        assert!(said(b"{\"a\": 1}").contains("JSON"));
        assert!(said(b"<html>").contains("HTML"));
        assert!(said(b"a\x01\x02").contains("no text"));
    }
}
