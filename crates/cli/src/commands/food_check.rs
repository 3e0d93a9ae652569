//! `saute food check`.

use std::path::Path;
use std::process::ExitCode;

use saute_kitchen::Library;
use saute_kitchen::data::food_check::{Finding, FoodReport, SurfaceReport, check_food};
use saute_kitchen::data::library::surface_file;
use saute_kitchen::heat::{Defect, Surface};
use saute_schema::echo::shortened;
use saute_surface::{Body, Place, ReadError, joined};
use serde::Serialize;

use crate::args::FoodCheckArgs;
use crate::error::CliError;
use crate::exit_code;
use crate::input::{data_library, surface_file as surface, text_file};
use crate::output::{json, stdout};

/// Result of the check, as `--json` prints it.
#[derive(Debug, Serialize)]
struct FoodVerdict {
    file: String,
    ok: bool,
    findings: Vec<Finding>,
    #[serde(skip_serializing_if = "Option::is_none")]
    food: Option<FoodReport>,
    #[serde(skip_serializing_if = "Option::is_none")]
    surface: Option<SurfaceReport>,
    /// The bodies of a file with several.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    surfaces: Vec<Named>,
}

/// One of several bodies of a file.
#[derive(Debug, Serialize)]
struct Named {
    name: String,
    #[serde(flatten)]
    surface: SurfaceReport,
}

/// Checks a food file or a surface.
pub fn run(args: &FoodCheckArgs, data: Option<&Path>) -> Result<ExitCode, CliError> {
    let file = args.file.display().to_string();
    let mut verdict =
        FoodVerdict { file, ok: false, findings: Vec::new(), food: None, surface: None, surfaces: Vec::new() };
    if saute_surface::Format::of(&verdict.file).is_some() {
        check_bodies(&args.file, args.scale_mm, &mut verdict);
    } else {
        if args.scale_mm.is_some() {
            let remedy = "write scale_mm under [mesh] in the food's file, or name the surface itself";
            return Err(CliError::place("--scale-mm", "is only for a surface on its own", remedy));
        }
        match food(&args.file, data)? {
            Ok(report) => verdict.food = Some(report),
            Err(findings) => verdict.findings = findings,
        }
    }
    verdict.ok = verdict.findings.is_empty();
    let text = if args.json { json::text(&verdict)? } else { text(&verdict) };
    stdout::print(&text)?;
    Ok(if verdict.ok { ExitCode::SUCCESS } else { exit_code::failed() })
}

fn food(path: &Path, data: Option<&Path>) -> Result<Result<FoodReport, Vec<Finding>>, CliError> {
    let text = text_file::read(path)?;
    // The user's own kinetics are in a folder next to the one of the food.
    let beside = path.parent().filter(|p| p.ends_with("foods")).and_then(Path::parent);
    let library: Library = data_library::kinetics(data.or(beside))?;
    let named = surface_file(&text).map(|name| path.with_file_name(name));
    let soup = match named.map(|path| surface::read(&path).map_err(|error| surface::refused(&path, error))) {
        None => None,
        Some(Ok(soup)) => Some(soup),
        Some(Err(error)) => {
            let line = 1 + text.lines().position(|l| l.trim_start().starts_with("file")).unwrap_or(0);
            return Ok(Err(vec![finding(line, "mesh.file", &error)]));
        }
    };
    Ok(check_food(&text, soup.as_ref(), &library))
}

/// Checks a surface on its own, given the millimetres in one of its units unless they are the usual ones; of a file with several bodies,
/// which is no food, each of them.
fn check_bodies(path: &Path, scale_mm: Option<f64>, verdict: &mut FoodVerdict) {
    let bodies = match surface::bodies(path) {
        Ok(bodies) => bodies,
        Err(error) => return verdict.findings.push(unread(error)),
    };
    let whole = joined(&bodies);
    let unit_mm = scale_mm.unwrap_or(whole.unit_mm);
    match Surface::close(&whole, 1e-3 * unit_mm) {
        Ok(surface) => verdict.surface = Some(SurfaceReport::of(&surface)),
        Err(Defect::Bodies(_)) if bodies.len() > 1 => {
            bodies.into_iter().enumerate().for_each(|(place, body)| check_body(place, body, unit_mm, verdict));
        }
        Err(defect) => verdict.findings.push(unsound("", &defect, unit_mm)),
    }
}

/// Checks one of several bodies.
fn check_body(place: usize, Body { name, soup }: Body, unit_mm: f64, verdict: &mut FoodVerdict) {
    let name = name.unwrap_or_else(|| format!("body {}", place + 1));
    match Surface::close(&soup, 1e-3 * unit_mm) {
        Ok(surface) => verdict.surfaces.push(Named { name, surface: SurfaceReport::of(&surface) }),
        Err(defect) => verdict.findings.push(unsound(&format!("{name} "), &defect, unit_mm)),
    }
}

fn unsound(whose: &str, defect: &Defect, unit_mm: f64) -> Finding {
    of_file(1, &format!("{whose}is not sound: {defect}"), remedy(defect, unit_mm))
}

/// A finding about a line of a file, which has no keys.
fn of_file(line: usize, message: &str, remedy: String) -> Finding {
    Finding { line, key: String::new(), message: shortened(message).into_owned(), remedy }
}

fn unread(error: ReadError) -> Finding {
    match error.place {
        Place::Line(line) => of_file(line, &error.message, error.remedy),
        Place::File | Place::Byte(_) => of_file(1, &error.to_string(), error.remedy),
    }
}

/// Returns the remedy for a surface on its own: its unit is an option, not yet a key of a food.
fn remedy(defect: &Defect, unit_mm: f64) -> String {
    match defect {
        Defect::TooSmall(_) | Defect::TooLarge(_) => format!(
            "state the length of its unit, taken as {unit_mm} mm: --scale-mm 1000 for metres, 25.4 for inches, 10 for \
             centimetres, 1 for millimetres; or scale the body in your modelling program"
        ),
        other => other.remedy(),
    }
}

fn finding(line: usize, key: &str, error: &CliError) -> Finding {
    let (message, remedy) = match error {
        CliError::Place { place, message, remedy } => (format!("{place} {message}"), remedy.clone()),
        other => (other.to_string(), String::from("check the file")),
    };
    Finding { line, key: key.to_owned(), message, remedy }
}

fn text(verdict: &FoodVerdict) -> String {
    let finding = |f: &Finding| format!("{}:{}: {}\n  remedy: {}\n", verdict.file, f.line, f.message, f.remedy);
    let findings: String = verdict.findings.iter().map(finding).collect();
    let food = verdict.food.as_ref().map_or(String::new(), food_text);
    let named = |body: &Named| format!("{}:\n{}", body.name, surface_text(&body.surface));
    let bodies: String = verdict.surfaces.iter().map(named).collect();
    findings + &food + &verdict.surface.as_ref().map_or(String::new(), surface_text) + &bodies
}

fn food_text(food: &FoodReport) -> String {
    let sizes: Vec<String> = food.size_mm.iter().zip(&food.dimensions).map(|(v, d)| format!("{d} {v:.1} mm")).collect();
    let [cold, warm] = food.conductivity_w_mk;
    let bath = food.core_55_c_min.map_or_else(
        || "in water of 60 °C the core does not reach 55 °C in a day".to_owned(),
        |min| format!("in water of 60 °C, from 5 °C, the core has 55 °C after {min:.0} min"),
    );
    format!(
        "{}: sound\n  form {}, {}\n  {:.1} g, {:.0} kg/m³, {cold:.3} W/(m·K) at 20 °C, {warm:.3} at 60 °C\n  {} nodes, the first {:.2} mm below the surface\n  {bath}\n{}",
        food.name,
        food.form,
        sizes.join(", "),
        food.mass_g,
        food.density_kg_m3,
        food.nodes,
        food.first_layer_mm,
        food.surface.as_ref().map_or(String::new(), surface_text),
    )
}

fn surface_text(surface: &SurfaceReport) -> String {
    let [x, y, z] = surface.extent_mm;
    format!(
        "  closed surface: {} triangles, {x:.1} × {y:.1} × {z:.1} mm, {:.2} cm³, {:.1} cm²\n",
        surface.triangles, surface.volume_cm3, surface.area_cm2
    )
}
