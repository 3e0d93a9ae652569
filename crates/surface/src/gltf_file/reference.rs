//! References of a glTF file to the files next to it.

use crate::ReadError;

/// Returns the path, relative to the folder of the file, that a reference names.
///
/// Escapes such as `%20` are decoded before the path is judged, so that they hide nothing.
///
/// # Errors
/// [`ReadError`] for a path that could lead out of the folder, on any system.
pub fn in_folder(uri: &str) -> Result<String, ReadError> {
    let refused = |cause: &str| {
        let message = format!("refers to {uri:?}, which is no file in the same folder: {cause}");
        ReadError::new(
            message,
            "put that file into the same folder and refer to it by its name alone, or export a single .glb file",
        )
    };
    let path = String::from_utf8(decoded(uri)).map_err(|_| refused("its escapes are no UTF-8"))?;
    let cause = match path.chars().find(|c| ":\\".contains(*c) || c.is_control()) {
        Some(':') => Some("a colon belongs to a network address or a drive"),
        Some('\\') => Some("it contains a backslash"),
        Some(_) => Some("it contains a control character"),
        None if path.starts_with('/') => Some("it begins at the root"),
        None if path.split('/').any(leads_up) => Some("\"..\" leads out of it"),
        None => None,
    };
    let parts: Vec<&str> = path.split('/').filter(|part| !part.is_empty() && *part != ".").collect();
    match cause {
        Some(cause) => Err(refused(cause)),
        None if parts.is_empty() => Err(refused("it has no name")),
        None => Ok(parts.join("/")),
    }
}

/// Returns true for `..`, also with the dots and spaces at its end that Windows leaves out.
fn leads_up(part: &str) -> bool {
    part.starts_with("..") && part.chars().all(|c| c == '.' || c == ' ')
}

/// Returns a reference with its escapes decoded once (RFC 3986, section 2.1); a percent sign without two digits stays.
pub fn decoded(uri: &str) -> Vec<u8> {
    let mut decoded = Vec::with_capacity(uri.len());
    let mut rest = uri.as_bytes();
    while let [first, more @ ..] = rest {
        let escaped = if *first == b'%' { more.first_chunk::<2>().and_then(escaped_byte) } else { None };
        decoded.push(escaped.unwrap_or(*first));
        rest = if escaped.is_some() { &more[2..] } else { more };
    }
    decoded
}

fn escaped_byte(digits: &[u8; 2]) -> Option<u8> {
    let [high, low] = digits.map(|digit| char::from(digit).to_digit(16));
    u8::try_from(16 * high? + low?).ok()
}
