//! Values as JSON text.

use serde::Serialize;

use crate::error::CliError;

/// Returns a value as indented JSON that ends with a line end.
pub fn text(value: &impl Serialize) -> Result<String, CliError> {
    Ok(serde_json::to_string_pretty(value)? + "\n")
}
