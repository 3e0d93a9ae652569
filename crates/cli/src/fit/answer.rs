//! What a fit found, as text, as JSON and as a data file.

use std::path::Path;
use std::time::Duration;

use saute_kitchen::data::at_home::KitchenAtHome;
use saute_kitchen::{Library, celsius};
use saute_plan::fit::found::{Estimate, FitResult, Worst};
use saute_plan::fit::log::reading::{CurveRead, Reading};
use saute_plan::fit::log::unit::UnitFrom;
use saute_plan::fit::observed::Quantity;
use saute_recipe::Recipe;
use serde::Serialize;

use crate::wording;

/// Name of the data file.
pub const FILE: &str = "kitchen-at-home.toml";

/// What a fit found, next to what the program assumes.
#[derive(Debug, Serialize)]
pub struct FitReport {
    #[serde(skip)]
    found: FitResult,
    /// Electrical power that reaches the pan's metal [-].
    hob_efficiency: Estimate,
    /// Factor on the contact conductance between food and pan [-].
    contact: Estimate,
    /// Thickness of the food [mm].
    thickness_mm: Estimate,
    /// Root mean square of the residuals over their standard deviations [-].
    misfit: f64,
    /// Number of values that were compared [-].
    samples: usize,
    /// Number of rounds [-].
    rounds: usize,
    /// Where it misses most, in words.
    worst: String,
    /// True if a value is at the end of the range in which it was searched.
    is_at_bound: bool,
    /// How the log was read.
    log: Option<Reading>,
    /// Efficiency of the program's hob [-].
    program_hob_efficiency: f64,
    /// Thickness that the recipe states [mm].
    recipe_thickness_mm: f64,
    /// Factor on the efficiency of the shipped hob [-].
    hob_factor: f64,
    /// Factor on the contact conductance of the shipped data [-].
    contact_factor: f64,
    /// The kitchen that was found.
    #[serde(skip)]
    at_home: KitchenAtHome,
    /// Wall time [s].
    wall_s: f64,
}

impl FitReport {
    pub fn new(found: &FitResult, recipe: &Recipe, library: &Library, log: Option<Reading>, wall: Duration) -> Self {
        let at_home = found.at_home(library, "");
        Self {
            found: *found,
            hob_efficiency: found.hob_efficiency,
            contact: found.contact,
            thickness_mm: found.thickness_mm,
            misfit: found.misfit,
            samples: found.samples,
            rounds: found.rounds,
            worst: worst(&found.worst),
            is_at_bound: found.is_at_bound,
            log,
            program_hob_efficiency: library.hob.efficiency(),
            recipe_thickness_mm: recipe.foods.first().map_or(0.0, |food| 1e3 * food.size[2]),
            hob_factor: at_home.hob_factor,
            contact_factor: at_home.contact_factor,
            at_home,
            wall_s: wall.as_secs_f64(),
        }
    }

    pub fn text(&self) -> String {
        let FitResult { samples, rounds, misfit, .. } = self.found;
        let wall = wording::duration(self.wall_s);
        let log = self.log.as_ref().map_or(String::new(), as_read);
        let head = format!(
            "{log}Fitted {samples} values in {rounds} rounds ({wall}); misfit {misfit:.2} (1: as the thermometers err)\n\n{:16} {:>13} {:>14}   90 % interval\n",
            "", "your kitchen", "the program's"
        );
        let row = |name: &str, estimate: &Estimate, assumed: f64, unit: &str, decimals: usize| {
            let Estimate { value, low, high } = estimate;
            let unit = if unit.is_empty() { String::new() } else { format!(" {unit}") };
            let own = format!("{value:.decimals$}{unit}");
            let assumed = format!("{assumed:.decimals$}{unit}");
            format!("{name:16} {own:>13} {assumed:>14}   {low:.decimals$}–{high:.decimals$}{unit}\n")
        };
        let rows = [
            row("hob efficiency", &self.found.hob_efficiency, self.program_hob_efficiency, "", 3),
            row("contact", &self.found.contact, 1.0, "×", 2),
            row("thickness", &self.found.thickness_mm, self.recipe_thickness_mm, "mm", 1),
        ];
        let bound =
            if self.is_at_bound { "A value is at the end of the range in which it was searched.\n" } else { "" };
        format!("{head}{}\nFits worst {}\n{bound}", rows.concat(), self.worst)
    }

    /// Returns the file for a `--data` folder.
    pub fn data_file(&self, log: Option<&Path>) -> String {
        let FitResult { hob_efficiency: hob, contact, thickness_mm, misfit, samples, .. } = self.found;
        let log = log.and_then(Path::file_name).map_or("weight or class".into(), |name| name.to_string_lossy());
        let read = self.log.as_ref().map_or(String::new(), |log| format!(" ({})", columns(log).join("; ")));
        let source = format!("fitted to {samples} values of {log}{read}; misfit {misfit:.2}");
        let at_home = KitchenAtHome { source, ..self.at_home.clone() };
        format!(
            "# Found by saute fit. 90 % intervals: efficiency of the hob {:.3}–{:.3}, contact {:.2}–{:.2}, thickness of that food {:.1}–{:.1} mm.\n{}",
            hob.low,
            hob.high,
            contact.low,
            contact.high,
            thickness_mm.low,
            thickness_mm.high,
            at_home.to_file()
        )
    }
}

/// How a log was read, as lines.
fn as_read(log: &Reading) -> String {
    let mut lines = columns(log);
    lines.push(times(log));
    lines.iter().map(|line| format!("Read {line}\n")).collect::<String>() + "\n"
}

/// The columns of temperatures that were read, with their unit and why it was taken.
fn columns(log: &Reading) -> Vec<String> {
    let of = |(what, curve): (&str, &Option<CurveRead>)| {
        let curve = curve.as_ref()?;
        let why = match curve.unit_from {
            UnitFrom::Asked => "as asked",
            UnitFrom::Maker => "as the maker's logs have it",
            UnitFrom::Header => "by its header",
            UnitFrom::Rows => "by its rows",
            UnitFrom::Preamble => "by the lines above the table",
            UnitFrom::OtherColumn => "by another column's header",
            UnitFrom::Assumed => "assumed",
        };
        let left_out = match curve.left_out {
            0 => String::new(),
            count => format!(", {count} rows without a temperature left out"),
        };
        Some(format!("{what} from {} in {}, {why}{left_out}", curve.column, curve.unit.sign()))
    };
    [("core", &log.core), ("pan", &log.pan)].into_iter().filter_map(of).collect()
}

fn times(log: &Reading) -> String {
    let order = if log.is_newest_first { ", newest row first" } else { "" };
    let (minutes, seconds) = ((log.span_s / 60.0).floor(), log.span_s % 60.0);
    format!(
        "times from {} as {}: {} rows, {minutes:.0} min {seconds:.0} s from {}{order}",
        log.time_column,
        log.time_form.words(),
        log.rows,
        log.begins
    )
}

/// Where a fit misses most: `at 4:15: core read 0.0 °C, expected 31.0 °C`.
pub fn worst(worst: &Worst) -> String {
    let whole = worst.at_s.round() as u64;
    let at =
        if worst.at_s.is_finite() { format!("at {}:{:02}", whole / 60, whole % 60) } else { "at the end".to_owned() };
    let (what, value): (&str, fn(f64) -> String) = match worst.quantity {
        Quantity::Pan => ("pan", |kelvin| format!("{:.1} °C", celsius(kelvin))),
        Quantity::Core => ("core", |kelvin| format!("{:.1} °C", celsius(kelvin))),
        Quantity::CorePeak => ("core's peak", |kelvin| format!("{:.1} °C", celsius(kelvin))),
        Quantity::Mass => ("weight", |kg| format!("{:.1} g", 1e3 * kg)),
    };
    format!("{at}: {what} read {}, expected {}", value(worst.read), value(worst.expected))
}
