//! Ranges of the numbers in data files: what parses must also be possible.

use saute_food::FoodDescription;
use saute_food::description::Composition;

use crate::library::{LibraryError, line_of};
use crate::pan::{CoatingDescription, PanDescription};

/// A number with its place in the file and the range in which it makes sense.
struct Ranged {
    table: &'static str,
    key: &'static str,
    value: f64,
    low: f64,
    high: f64,
}

const fn ranged(table: &'static str, key: &'static str, value: f64, low: f64, high: f64) -> Ranged {
    Ranged { table, key, value, low, high }
}

/// Checks a pan's numbers.
pub fn pan(pan: &PanDescription, file: &str, text: &str) -> Result<(), LibraryError> {
    let rim_low = pan.floor.radius_mm;
    check(
        file,
        text,
        &[
            ranged("floor", "radius_mm", pan.floor.radius_mm, 40.0, 250.0),
            ranged("floor", "thickness_mm", pan.floor.thickness_mm, 0.5, 20.0),
            ranged("wall", "rim_radius_mm", pan.wall.rim_radius_mm, rim_low, 400.0),
            ranged("wall", "height_mm", pan.wall.height_mm, 5.0, 300.0),
            ranged("wall", "thickness_mm", pan.wall.thickness_mm, 0.5, 20.0),
            ranged("metal", "conductivity_w_mk", pan.metal.conductivity_w_mk, 1.0, 500.0),
            ranged("metal", "density_kg_m3", pan.metal.density_kg_m3, 1000.0, 20_000.0),
            ranged("metal", "specific_heat_j_kgk", pan.metal.specific_heat_j_kgk, 100.0, 2000.0),
            ranged("surface", "emissivity", pan.surface.emissivity, 0.0, 1.0),
            ranged("look", "metalness", pan.look.metalness, 0.0, 1.0),
            ranged("look", "roughness", pan.look.roughness, 0.0, 1.0),
        ],
    )
}

/// Checks a coating's numbers.
pub fn coating(coating: &CoatingDescription, file: &str, text: &str) -> Result<(), LibraryError> {
    check(
        file,
        text,
        &[
            ranged("", "conductance_w_m2k", coating.conductance_w_m2k, 10.0, 1e7),
            ranged("", "emissivity", coating.emissivity, 0.0, 1.0),
        ],
    )
}

/// Checks a food's numbers.
pub fn food(food: &FoodDescription, file: &str, text: &str) -> Result<(), LibraryError> {
    check(
        file,
        text,
        &[
            ranged("outline", "exponent", food.outline.exponent, 2.0, 20.0),
            ranged("outline", "ripple", food.outline.ripple, 0.0, 0.1),
            ranged("marbling", "adipose_share", food.marbling.adipose_share, 0.0, 0.6),
            ranged("marbling", "seam_mm", food.marbling.seam_mm, 1.0, 50.0),
            ranged("marbling", "flattening", food.marbling.flattening, 1.0, 20.0),
            ranged("fat_melting", "width_k", food.fat_melting.width_k, 0.5, 50.0),
            ranged("fat_melting", "latent_j_kg", food.fat_melting.latent_j_kg, 0.0, 4e5),
            ranged("sorption", "monolayer", food.sorption.monolayer, 0.01, 0.3),
            ranged("sorption", "c", food.sorption.c, 1.1, 100.0),
            ranged("sorption", "k", food.sorption.k, 0.5, 1.0),
            ranged("sorption", "fresh_activity", food.sorption.fresh_activity, 0.8, 1.0),
            ranged("crust", "conductivity_w_mk", food.crust.conductivity_w_mk, 0.01, 1.0),
            ranged("surface", "emissivity", food.surface.emissivity, 0.0, 1.0),
        ],
    )?;
    let sizes =
        ["min_mm", "default_mm", "max_mm"].into_iter().zip([food.size.min_mm, food.size.default_mm, food.size.max_mm]);
    let mut low = [5.0; 3];
    for (key, size) in sizes {
        (0..3).try_for_each(|axis| check(file, text, &[ranged("size", key, size[axis], low[axis], 300.0)]))?;
        low = size;
    }
    composition("lean", &food.lean, file, text)?;
    composition("adipose", &food.adipose, file, text)
}

fn composition(table: &'static str, tissue: &Composition, file: &str, text: &str) -> Result<(), LibraryError> {
    check(
        file,
        text,
        &[
            ranged(table, "water", tissue.water, 0.01, 0.99),
            ranged(table, "protein", tissue.protein, 0.001, 0.99),
            ranged(table, "fat", tissue.fat, 0.0, 0.99),
            ranged(table, "carbohydrate", tissue.carbohydrate, 0.0, 0.99),
            ranged(table, "fibre", tissue.fibre, 0.0, 0.99),
            ranged(table, "ash", tissue.ash, 0.0, 0.2),
        ],
    )?;
    let total = tissue.total();
    if (total - 1.0).abs() <= 0.005 {
        return Ok(());
    }
    let message = format!("the mass fractions of [{table}] add up to {total:.4}; they must add up to 1 (± 0.005)");
    Err(LibraryError { file: file.to_owned(), line: line_of(text, place(text, table, "water")), message })
}

fn check(file: &str, text: &str, numbers: &[Ranged]) -> Result<(), LibraryError> {
    let Some(wrong) = numbers.iter().find(|n| !(n.low..=n.high).contains(&n.value)) else { return Ok(()) };
    let Ranged { table, key, value, low, high } = wrong;
    let line = line_of(text, place(text, table, key));
    Err(LibraryError {
        file: file.to_owned(),
        line,
        message: format!("{key} = {value} is out of range: use {low} to {high}"),
    })
}

/// Where a key of a table stands in a file, or its start.
fn place(text: &str, table: &str, key: &str) -> usize {
    let start = if table.is_empty() { 0 } else { text.find(&format!("[{table}]")).unwrap_or(0) };
    let found = text[start..].match_indices(key).find(|(at, _)| text[..start + at].ends_with('\n') || start + at == 0);
    start + found.map_or(0, |(at, _)| at)
}
