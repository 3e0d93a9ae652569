//! Devices and the feel that the program carries.

use std::collections::BTreeMap;

use saute_kitchen::InputError;
use saute_kitchen::Library;
use serde::de::DeserializeOwned;

use crate::feel::Feel;
use crate::geometry::Geometry;

/// Where devices lie among the data.
const DEVICES: &str = "haptics/devices/";

/// The device that is taken unless another is named.
pub const DEFAULT_DEVICE: &str = "spidar-pan-crossed";

/// Texts of the string devices that the program carries, by name.
pub fn device_texts() -> BTreeMap<String, String> {
    let name = |path: &str| Some(path.strip_prefix(DEVICES)?.strip_suffix(".toml")?.to_owned());
    Library::embedded_files().into_iter().filter_map(|(path, text)| Some((name(&path)?, text))).collect()
}

/// The string devices that the program carries, by name.
pub fn devices() -> Result<BTreeMap<String, Geometry>, InputError> {
    let parse = |(name, text): (String, String)| {
        let geometry = Geometry::parse(&text, &format!("{DEVICES}{name}.toml"))?;
        Ok((name, geometry))
    };
    device_texts().into_iter().map(parse).collect()
}

/// The feel that the program carries.
pub fn feel() -> Result<Feel, InputError> {
    const FILE: &str = "haptics/feel.toml";
    let text = Library::embedded_files().remove(FILE).unwrap_or_default();
    Feel::parse(&text, FILE)
}

/// Reads a file as TOML, or says where it is wrong.
pub(crate) fn parse_table<T: DeserializeOwned>(text: &str, file: &str, remedy: &str) -> Result<T, InputError> {
    toml::from_str(text).map_err(|e| InputError {
        file: file.to_owned(),
        line: line_of(text, e.span().map_or(0, |s| s.start)),
        message: e.message().trim().to_owned(),
        remedy: remedy.to_owned(),
    })
}

/// An error at the line where a key first stands.
pub(crate) fn error_at(text: &str, file: &str, key: &str, message: String, remedy: &str) -> InputError {
    let line = text.lines().position(|l| l.split('=').next().is_some_and(|k| k.trim() == key));
    InputError { file: file.to_owned(), line: line.map_or(1, |l| l + 1), message, remedy: remedy.to_owned() }
}

fn line_of(text: &str, offset: usize) -> usize {
    1 + text.as_bytes()[..offset.min(text.len())].iter().filter(|&&b| b == b'\n').count()
}
