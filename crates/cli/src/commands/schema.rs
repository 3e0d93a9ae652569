//! `saute schema`: the JSON Schema of a file format, or its reference page.

use std::process::ExitCode;

use saute_kitchen::food::{FoodDescription, Kinetics};
use saute_kitchen::liquids::oil::OilDescription;
use saute_kitchen::pan::hob::HobDescription;
use saute_kitchen::pan::pan_description::{CoatingDescription, PanDescription};
use saute_lab::CaseFile;
use saute_mirror::rig_file::RigFile;
use saute_recipe::recipe_file::RecipeFile;
use saute_schema::FormatSchema;
use saute_study::class::scenario_file::ScenarioFile;
use saute_study::protocol_file::ProtocolFile;
use saute_sweep::SpecFile;
use schemars::JsonSchema;

use crate::args::{Schema, SchemaArgs};
use crate::error::CliError;
use crate::output::{json, stdout};

/// Prints the JSON Schema of a file format, or its reference page.
pub fn run(args: &SchemaArgs) -> Result<ExitCode, CliError> {
    let text = match args.format {
        Schema::Food => text::<FoodDescription>,
        Schema::Pan => text::<PanDescription>,
        Schema::Coating => text::<CoatingDescription>,
        Schema::Oil => text::<OilDescription>,
        Schema::Kinetics => text::<Kinetics>,
        Schema::Hob => text::<HobDescription>,
        Schema::Recipe => text::<RecipeFile>,
        Schema::Lab => text::<CaseFile>,
        Schema::Rig => text::<RigFile>,
        Schema::Study => text::<ProtocolFile>,
        Schema::Scenario => text::<ScenarioFile>,
        Schema::Sweep => text::<SpecFile>,
    };
    stdout::print(&text(args.markdown)?)?;
    Ok(ExitCode::SUCCESS)
}

/// Returns the reference page of a format as Markdown, or its JSON Schema.
fn text<T: JsonSchema>(markdown: bool) -> Result<String, CliError> {
    if markdown { Ok(FormatSchema::of::<T>().page()) } else { json::text(&schemars::schema_for!(T)) }
}
