//! State and speed of a page, for its tests.

use saute_kitchen::{Piece, celsius};
use saute_scene::quality::Quality;
use saute_window::SauteApp;
use serde::Serialize;

/// What a page reports.
#[derive(Serialize)]
pub(crate) struct Stats {
    /// Graphics interface in use.
    backend: String,
    /// Frames since the start.
    frames: u64,
    /// Frames per second, the median of the last ten seconds.
    frames_per_s: f64,
    /// Size at which the scene was drawn last [pixels].
    scene_size: [u32; 2],
    /// Simulated time [s].
    time_s: f64,
    /// Simulated seconds per second that are asked for.
    speed: f64,
    /// Simulated seconds per second over the last ten seconds.
    time_ratio: f64,
    paused: bool,
    quality: Quality,
    recipe: Option<String>,
    /// Power of the hob [W].
    hob_w: f64,
    /// Temperature of the pan's floor [°C].
    pan_c: f64,
    pieces: Vec<PieceStats>,
}

/// One piece.
#[derive(Serialize)]
struct PieceStats {
    id: String,
    place: &'static str,
    core_c: f64,
    /// True if it lies on the face that was up at first.
    upside_down: bool,
    halved: bool,
}

impl PieceStats {
    fn of(piece: &Piece) -> Self {
        Self {
            id: piece.id.clone(),
            place: piece.place.name(),
            core_c: celsius(piece.core()),
            upside_down: piece.upside_down(),
            halved: piece.halved().is_some(),
        }
    }
}

impl Stats {
    /// Reads the program.
    pub fn of(app: &SauteApp, backend: String) -> Self {
        let (session, meter) = (app.session(), app.meter());
        let kitchen = &session.kitchen;
        Self {
            backend,
            frames: meter.count(),
            frames_per_s: meter.frames_per_s(),
            scene_size: app.scene_size(),
            time_s: kitchen.time_s(),
            speed: session.speed,
            time_ratio: meter.time_ratio(),
            paused: session.paused,
            quality: app.quality(),
            recipe: session.recipe_title().map(str::to_owned),
            hob_w: kitchen.hob_w(),
            pan_c: celsius(kitchen.pan_temperature()),
            pieces: kitchen.pieces().iter().map(PieceStats::of).collect(),
        }
    }
}
