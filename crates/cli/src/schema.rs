//! `saute schema`.

use std::process::ExitCode;

use saute_kitchen::recipe_file::RecipeFile;

use crate::error::CliError;
use crate::stdout;

/// Prints the JSON Schema of recipe files.
pub fn recipe() -> Result<ExitCode, CliError> {
    let schema = serde_json::to_string_pretty(&schemars::schema_for!(RecipeFile))?;
    stdout::print(&format!("{schema}\n"))?;
    Ok(ExitCode::SUCCESS)
}
