//! `saute bench frame`: the frame rate of the window, rendered off-screen.

use std::process::ExitCode;
use std::sync::Arc;
use std::time::Instant;

use clap::ValueEnum;
use saute_controls::settings::quality_choice::QualityChoice;
use saute_recipe::Recipe;
use saute_recipe::full_pan::{SHRIMPS, SHRIMPS_LIE_S};
use saute_window::desktop::bench_frame::{DISH, DISH_FROM_S, FROM_S, FrameCase, bench_frame};
use saute_window::{DesktopOptions, Start};

use super::choices::QualityName;
use super::size::size;
use crate::error::CliError;
use crate::input::data_library::DataLibrary;
use crate::input::recipe_source;
use crate::output::{json, stdout};

/// `saute bench frame`.
#[derive(Debug, clap::Args)]
pub struct BenchFrameArgs {
    /// Recipe file, or id of a shipped recipe.
    #[arg(value_name = "RECIPE", default_value = "medium")]
    pub recipe: String,
    /// Built-in scene instead of a recipe.
    #[arg(long, value_enum)]
    pub scene: Option<SceneName>,
    /// Size of the frame in pixels.
    #[arg(long, value_name = "WIDTHxHEIGHT", default_value = "1280x720", value_parser = size)]
    pub size: [u32; 2],
    /// Rendering quality [default: automatic].
    #[arg(long, value_enum)]
    pub quality: Option<QualityName>,
    /// Simulated time over wall time.
    #[arg(long, value_name = "TIMES", default_value_t = 1.0, value_parser = speed)]
    pub speed: f64,
    /// Simulated time from which frames are measured [s] [default: 60, or when the foods of the scene lie].
    #[arg(long = "from", value_name = "SECONDS", value_parser = from)]
    pub from_s: Option<f64>,
    /// Makes forecasts meanwhile, as the window does.
    #[arg(long)]
    pub forecasts: bool,
    /// Prints the numbers as JSON.
    #[arg(long)]
    pub json: bool,
}

fn speed(text: &str) -> Result<f64, String> {
    let speed = text.parse::<f64>().map_err(|e| e.to_string())?;
    if (0.1..=100.0).contains(&speed) { Ok(speed) } else { Err("state a number from 0.1 to 100".to_owned()) }
}

fn from(text: &str) -> Result<f64, String> {
    let from_s = text.parse::<f64>().map_err(|e| e.to_string())?;
    if (0.0..=3600.0).contains(&from_s) { Ok(from_s) } else { Err("state a number from 0 to 3600".to_owned()) }
}

/// Built-in scenes.
#[derive(Clone, Copy, Debug, ValueEnum)]
pub enum SceneName {
    /// 35 shrimps of the default mesh in the pan.
    Shrimps,
    /// A frying steak with 11 carrots and 11 leeks.
    Dish,
}

/// Measures the frame rate and prints it.
pub fn run(args: &BenchFrameArgs, data: &DataLibrary, process_start: Instant) -> Result<ExitCode, CliError> {
    let (recipe, from_s) = match args.scene {
        Some(SceneName::Dish) => (Recipe::parse(DISH, "dish", &data.library)?, DISH_FROM_S),
        Some(SceneName::Shrimps) => (Recipe::parse(SHRIMPS, "shrimps", &data.library)?, SHRIMPS_LIE_S),
        None => (recipe_source::load(&args.recipe, data)?, FROM_S),
    };
    let quality = args.quality.map_or(QualityChoice::Automatic, |name| QualityChoice::Always(name.into()));
    let library = Some(Arc::new(data.library.clone()));
    let desktop = DesktopOptions { threads: args.forecasts, ..DesktopOptions::default() };
    let start = Start { library, recipe: Some(recipe), desktop, ..Start::default() };
    let case = FrameCase { size: args.size, from_s: args.from_s.unwrap_or(from_s), quality, speed: args.speed };
    let bench = bench_frame(start, case, process_start)?;
    if args.json {
        stdout::print(&json::text(&bench)?)?;
        return Ok(ExitCode::SUCCESS);
    }
    let [w, h] = bench.scene_size;
    stdout::print(&format!(
        "{}, {}\nwindow {} × {}, scene {w} × {h}, quality {}, {} frames\nmedian {:.1} frames/s, 5th percentile {:.1} frames/s, first frame after {:.2} s\n{:.2} simulated seconds a second, {} rounds of forecasts\n",
        bench.recipe,
        bench.adapter,
        bench.size[0],
        bench.size[1],
        format!("{:?}", bench.quality).to_lowercase(),
        bench.frames,
        bench.frames_per_s.median,
        bench.frames_per_s.p5,
        bench.first_frame_s,
        bench.simulated_per_wall,
        bench.forecast_rounds
    ))?;
    Ok(ExitCode::SUCCESS)
}
