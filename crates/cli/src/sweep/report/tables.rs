//! Sensitivities as CSV and as text.

use std::fmt::Write;

use saute_sweep::Manifest;

use super::{Indices, Sensitivity};
use crate::error::CliError;

/// Returns a table with one line for each number and value.
pub fn csv(manifest: &Manifest, found: &[Sensitivity]) -> Result<String, CliError> {
    let mut writer = csv::Writer::from_writer(Vec::new());
    let head: &[&str] = match found.first().map(|one| &one.found) {
        Some(Indices::Effects(_)) => &["mean", "mean_size", "deviation"],
        _ => &["first", "first_low", "first_high", "total", "total_low", "total_high"],
    };
    let head = ["number", "unit", "value"].iter().chain(head).chain(&["used", "left_out"]);
    writer.write_record(head)?;
    for one in found {
        for (place, path) in manifest.varied.iter().enumerate() {
            let (numbers, counts) = line(&one.found, place);
            let words = [&one.heading.name, &one.heading.unit, path].map(String::clone);
            let numbers = numbers.iter().map(|v| format!("{v:.6}"));
            writer.write_record(words.into_iter().chain(numbers).chain(counts.map(|n| n.to_string())))?;
        }
    }
    let bytes = writer.into_inner().map_err(|e| csv::Error::from(e.into_error()))?;
    Ok(String::from_utf8_lossy(&bytes).into_owned())
}

fn line(found: &Indices, place: usize) -> (Vec<f64>, [usize; 2]) {
    match found {
        Indices::Sobol(indices) => {
            let of = indices.of[place];
            let numbers = [of.first, of.total].iter().flat_map(|e| [e.value, e.low, e.high]).collect();
            (numbers, [indices.used, indices.left_out])
        }
        Indices::Effects(effects) => {
            let of = effects.of[place];
            (vec![of.mean, of.mean_size, of.deviation], [effects.used, effects.left_out])
        }
    }
}

/// Returns what one number depends on, as lines of text.
pub fn text(manifest: &Manifest, one: &Sensitivity) -> String {
    let mut text = format!("{}\n", one.heading.name);
    for (place, path) in manifest.varied.iter().enumerate() {
        // Writing to a string cannot fail.
        let _ = writeln!(text, "  {path:40} {}", words(one, place));
    }
    text
}

/// Returns what a number owes to one value, in words.
pub fn words(one: &Sensitivity, place: usize) -> String {
    let unit = &one.heading.unit;
    match &one.found {
        Indices::Sobol(indices) => {
            let pct = |share: f64| (100.0 * share).round() + 0.0;
            let (first, total) = (indices.of[place].first, indices.of[place].total);
            format!(
                "alone {} % ({} to {}), with others {} % ({} to {})",
                pct(first.value),
                pct(first.low),
                pct(first.high),
                pct(total.value),
                pct(total.low),
                pct(total.high)
            )
        }
        Indices::Effects(effects) => {
            let of = effects.of[place];
            format!("{:+.3} {unit} over its range, deviation {:.3} {unit}", of.mean, of.deviation)
        }
    }
}
