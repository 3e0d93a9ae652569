//! The embedded library: string devices and haptic parameters that the program ships.

#[cfg(not(target_arch = "wasm32"))]
use std::collections::BTreeMap;

use saute_kitchen::Library;
use saute_schema::InputError;
use serde::de::DeserializeOwned;

use crate::control::feel::Feel;
#[cfg(not(target_arch = "wasm32"))]
use crate::strings::geometry::Geometry;

/// Folder of the devices among the embedded files.
#[cfg(not(target_arch = "wasm32"))]
const DEVICES: &str = "haptics/devices/";

/// Name of the default device.
pub const DEFAULT_DEVICE: &str = "spidar-pan-crossed";

/// Returns the files of the embedded string devices, by name.
#[cfg(not(target_arch = "wasm32"))]
pub fn device_texts() -> BTreeMap<String, String> {
    let name = |path: &str| Some(path.strip_prefix(DEVICES)?.strip_suffix(".toml")?.to_owned());
    Library::embedded_files().into_iter().filter_map(|(path, text)| Some((name(&path)?, text))).collect()
}

/// Returns the embedded string devices, by name.
#[cfg(not(target_arch = "wasm32"))]
pub fn devices() -> Result<BTreeMap<String, Geometry>, InputError> {
    let parse = |(name, text): (String, String)| {
        let geometry = Geometry::parse(&text, &format!("{DEVICES}{name}.toml"))?;
        Ok((name, geometry))
    };
    device_texts().into_iter().map(parse).collect()
}

/// Returns the embedded haptic parameters.
pub fn feel() -> Result<Feel, InputError> {
    const FILE: &str = "haptics/feel.toml";
    let text = Library::embedded_files().remove(FILE).unwrap_or_default();
    Feel::parse(&text, FILE)
}

/// Parses a TOML file; an error names the line.
pub(crate) fn parse_table<T: DeserializeOwned>(text: &str, file: &str, remedy: &str) -> Result<T, InputError> {
    toml::from_str(text).map_err(|e| InputError {
        file: file.to_owned(),
        line: line_of(text, e.span().map_or(0, |s| s.start)),
        message: e.message().trim().to_owned(),
        remedy: remedy.to_owned(),
    })
}

/// Returns an error at the first line with a key.
pub(crate) fn error_at(text: &str, file: &str, key: &str, message: String, remedy: &str) -> InputError {
    let line = text.lines().position(|l| l.split('=').next().is_some_and(|k| k.trim() == key));
    InputError { file: file.to_owned(), line: line.map_or(1, |l| l + 1), message, remedy: remedy.to_owned() }
}

fn line_of(text: &str, offset: usize) -> usize {
    1 + text.as_bytes()[..offset.min(text.len())].iter().filter(|&&b| b == b'\n').count()
}
