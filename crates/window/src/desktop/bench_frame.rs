//! Measures whole frames of the window, off-screen, with the simulation running.

use std::time::Instant;

use saute_kitchen::heat::sorted::{Quantile, Sorted};
use saute_recipe::Recipe;
use saute_scene::quality::Quality;
use serde::Serialize;

use crate::desktop::offscreen::{Offscreen, OffscreenError};
use crate::start::Start;
use saute_controls::settings::quality_choice::QualityChoice;

/// Simulated time from which frames are measured, as a rule [s].
pub const FROM_S: f64 = 60.0;
/// How long they are measured [s].
const FOR_S: f64 = 30.0;

/// The paper's dish all at once: steak, carrots and leeks that fry and steam.
pub const DISH: &str = include_str!("dish.toml");

/// When the foods of that dish lie and steam [s].
pub const DISH_FROM_S: f64 = 20.0;

/// What was measured.
#[derive(Clone, Debug, Serialize)]
pub struct FrameBench {
    /// Frames per second.
    pub frames_per_s: FrameRates,
    /// From the start of the process to the first frame [s].
    pub first_frame_s: f64,
    /// Graphics adapter.
    pub adapter: String,
    /// Size of the window [pixels].
    pub size: [u32; 2],
    /// Size at which the scene was drawn [pixels].
    pub scene_size: [u32; 2],
    /// Quality at which the last frame was drawn.
    pub quality: Quality,
    /// Title of the recipe.
    pub recipe: String,
    /// Frames that were measured.
    pub frames: usize,
    /// Simulated time at the start and at the end [s].
    pub simulated_s: [f64; 2],
    /// Simulated time over wall time [-].
    pub simulated_per_wall: f64,
    /// How often a forecast came; 0 where none are made.
    pub forecast_rounds: u64,
}

/// Frames per second: the middle, and what 95 % of the frames reach.
#[derive(Clone, Copy, Debug, Serialize)]
pub struct FrameRates {
    /// Median.
    pub median: f64,
    /// 5th percentile.
    pub p5: f64,
}

/// How frames are measured.
#[derive(Clone, Copy, Debug)]
pub struct FrameCase {
    /// Size of the window [pixels].
    pub size: [u32; 2],
    /// Simulated time from which frames are measured [s].
    pub from_s: f64,
    /// Rendering quality.
    pub quality: QualityChoice,
    /// Simulated time over wall time [-].
    pub speed: f64,
}

/// Plays a recipe from a time on, half a minute long, and draws frames as fast as they come.
pub fn bench_frame(start: Start, case: FrameCase, process_start: Instant) -> Result<FrameBench, OffscreenError> {
    let FrameCase { size, from_s, quality, speed } = case;
    let recipe = start.recipe.as_ref().map(|r: &Recipe| r.title.clone()).unwrap_or_default();
    let mut window = Offscreen::open(start, size)?;
    window.app.set_quality(quality);
    window.app.session_mut().set_speed(speed);
    window.frame(0.0);
    let first_frame_s = process_start.elapsed().as_secs_f64();
    while window.app.session().kitchen.time_s() < from_s && !window.app.session().paused {
        // A recipe that goes wrong shows as frames of an idle kitchen; its title and times are reported.
        if window.app.session_mut().tick().is_err() {
            break;
        }
    }
    let simulated_from = window.app.session().kitchen.time_s();
    let begin = Instant::now();
    let mut durations = Vec::new();
    while begin.elapsed().as_secs_f64() < FOR_S {
        let frame = Instant::now();
        window.frame(begin.elapsed().as_secs_f64());
        durations.push(frame.elapsed().as_secs_f64());
    }
    let wall_s = begin.elapsed().as_secs_f64();
    let durations = Sorted::new(durations);
    let at = |share: f64| durations.quantile(share, Quantile::Nearest).unwrap_or(wall_s);
    let session = window.app.session();
    let simulated_until = session.kitchen.time_s();
    Ok(FrameBench {
        frames_per_s: FrameRates { median: 1.0 / at(0.5), p5: 1.0 / at(0.95) },
        first_frame_s,
        adapter: window.adapter(),
        size,
        scene_size: window.app.scene_size(),
        quality: window.app.quality(),
        recipe,
        frames: durations.values().len(),
        simulated_s: [simulated_from, simulated_until],
        simulated_per_wall: (simulated_until - simulated_from) / wall_s,
        forecast_rounds: session.forecasts().rounds(),
    })
}
