//! `saute schema`.

use std::process::ExitCode;

use saute_lab::CaseFile;
use saute_recipe::recipe_file::RecipeFile;

use crate::args::Schema;
use crate::error::CliError;
use crate::output::{json, stdout};

/// Prints the JSON Schema of a file format.
pub fn run(which: Schema) -> Result<ExitCode, CliError> {
    let schema = match which {
        Schema::Recipe => schemars::schema_for!(RecipeFile),
        Schema::Lab => schemars::schema_for!(CaseFile),
    };
    stdout::print(&json::text(&schema)?)?;
    Ok(ExitCode::SUCCESS)
}
