//! `saute food check`.

use std::path::Path;
use std::process::ExitCode;

use saute_kitchen::Library;
use saute_kitchen::data::food_check::{Finding, FoodReport, SurfaceReport, check_food};
use saute_kitchen::data::library::{close_surface, surface_file};
use serde::Serialize;

use crate::args::FoodCheckArgs;
use crate::error::CliError;
use crate::exit_code;
use crate::input::{data_library, surface_file as surface, text_file};
use crate::output::{json, stdout};

/// Result of the check, as `--json` prints it.
#[derive(Debug, Serialize)]
struct Verdict {
    file: String,
    ok: bool,
    findings: Vec<Finding>,
    #[serde(skip_serializing_if = "Option::is_none")]
    food: Option<FoodReport>,
    #[serde(skip_serializing_if = "Option::is_none")]
    surface: Option<SurfaceReport>,
}

/// Checks a food file or a surface.
pub fn run(args: &FoodCheckArgs, data: Option<&Path>) -> Result<ExitCode, CliError> {
    let file = args.file.display().to_string();
    let mut verdict = Verdict { file, ok: false, findings: Vec::new(), food: None, surface: None };
    if saute_surface::Format::of(&verdict.file).is_some() {
        match closed(&args.file) {
            Ok(report) => verdict.surface = Some(report),
            Err(finding) => verdict.findings.push(finding),
        }
    } else {
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
    let soup = match surface_file(&text).map(|name| surface::read(&path.with_file_name(name))) {
        None => None,
        Some(Ok(soup)) => Some(soup),
        Some(Err(error)) => {
            let line = 1 + text.lines().position(|l| l.trim_start().starts_with("file")).unwrap_or(0);
            return Ok(Err(vec![finding(line, "mesh.file", &error)]));
        }
    };
    Ok(check_food(&text, soup.as_ref(), &library))
}

fn closed(path: &Path) -> Result<SurfaceReport, Finding> {
    let soup = surface::read(path).map_err(|e| finding(1, "", &e))?;
    let error = |message| Finding { line: 1, key: String::new(), message, remedy: "correct the surface".into() };
    close_surface(&soup, "the surface", None).map(|s| SurfaceReport::of(&s)).map_err(error)
}

fn finding(line: usize, key: &str, error: &CliError) -> Finding {
    let (message, remedy) = match error {
        CliError::Place { place, message, remedy } => (format!("{place} {message}"), remedy.clone()),
        other => (other.to_string(), String::from("check the file")),
    };
    Finding { line, key: key.to_owned(), message, remedy }
}

fn text(verdict: &Verdict) -> String {
    let finding = |f: &Finding| format!("{}:{}: {}\n  remedy: {}\n", verdict.file, f.line, f.message, f.remedy);
    let findings: String = verdict.findings.iter().map(finding).collect();
    let food = verdict.food.as_ref().map_or(String::new(), food_text);
    findings + &food + &verdict.surface.as_ref().map_or(String::new(), surface_text)
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
