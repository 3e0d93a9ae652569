//! `saute list`.

use std::process::ExitCode;

use saute_kitchen::food::FoodDescription;
use saute_kitchen::{Library, Recipe};
use serde::Serialize;

use crate::args::{ListArgs, Listed};
use crate::error::CliError;
use crate::shelf::Shelf;
use crate::stdout;

/// One line of a list.
#[derive(Debug, Serialize)]
struct Entry {
    id: String,
    name: String,
    #[serde(skip_serializing_if = "Option::is_none")]
    size_mm: Option<Sizes>,
}

/// Length, width, thickness that a food may have [mm].
#[derive(Debug, Serialize)]
struct Sizes {
    default: Vec<f64>,
    min: Vec<f64>,
    max: Vec<f64>,
}

/// Prints a list, for people or for programs.
pub fn run(args: &ListArgs, shelf: &Shelf) -> Result<ExitCode, CliError> {
    let entries = match args.what {
        Listed::Foods => foods(&shelf.library),
        Listed::Pans => pans(&shelf.library),
        Listed::Recipes => recipes(shelf)?,
    };
    let text = if args.json { serde_json::to_string_pretty(&entries)? + "\n" } else { table(&entries) };
    stdout::print(&text)?;
    Ok(ExitCode::SUCCESS)
}

fn foods(library: &Library) -> Vec<Entry> {
    let sizes = |f: &FoodDescription| Sizes {
        default: f.size.default_mm.clone(),
        min: f.size.min_mm.clone(),
        max: f.size.max_mm.clone(),
    };
    library
        .foods
        .iter()
        .map(|(id, f)| Entry { id: id.clone(), name: f.name.clone(), size_mm: Some(sizes(f)) })
        .collect()
}

fn pans(library: &Library) -> Vec<Entry> {
    library.pans.iter().map(|(id, p)| Entry { id: id.clone(), name: p.name.clone(), size_mm: None }).collect()
}

fn recipes(shelf: &Shelf) -> Result<Vec<Entry>, CliError> {
    let entry = |(id, text): (&String, &String)| {
        let recipe = Recipe::parse(text, &shelf.recipe_place(id), &shelf.library)?;
        Ok(Entry { id: id.clone(), name: recipe.title, size_mm: None })
    };
    shelf.library.recipes.iter().map(entry).collect()
}

fn table(entries: &[Entry]) -> String {
    let width = entries.iter().map(|e| e.id.chars().count()).max().unwrap_or(0);
    entries
        .iter()
        .map(|e| format!("{:width$}  {}{}\n", e.id, e.name, e.size_mm.as_ref().map_or(String::new(), sizes)))
        .collect()
}

fn sizes(sizes: &Sizes) -> String {
    let ranges: Vec<String> = sizes.min.iter().zip(&sizes.max).map(|(low, high)| format!("{low}–{high}")).collect();
    format!(" ({} mm)", ranges.join(" × "))
}
