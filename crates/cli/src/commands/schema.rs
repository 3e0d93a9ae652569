//! `saute schema`.

use std::process::ExitCode;

use saute_kitchen::food::{FoodDescription, Kinetics};
use saute_kitchen::liquids::oil::OilDescription;
use saute_kitchen::pan::hob::HobDescription;
use saute_kitchen::pan::pan_description::{CoatingDescription, PanDescription};
use saute_lab::CaseFile;
use saute_recipe::recipe_file::RecipeFile;

use crate::args::Schema;
use crate::error::CliError;
use crate::output::{json, stdout};

/// Prints the JSON Schema of a file format.
pub fn run(which: Schema) -> Result<ExitCode, CliError> {
    let schema = match which {
        Schema::Food => schemars::schema_for!(FoodDescription),
        Schema::Pan => schemars::schema_for!(PanDescription),
        Schema::Coating => schemars::schema_for!(CoatingDescription),
        Schema::Oil => schemars::schema_for!(OilDescription),
        Schema::Kinetics => schemars::schema_for!(Kinetics),
        Schema::Hob => schemars::schema_for!(HobDescription),
        Schema::Recipe => schemars::schema_for!(RecipeFile),
        Schema::Lab => schemars::schema_for!(CaseFile),
    };
    stdout::print(&json::text(&schema)?)?;
    Ok(ExitCode::SUCCESS)
}
