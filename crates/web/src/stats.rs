//! State and speed of a page, for its tests.

use saute_kitchen::{Kitchen, Piece, celsius};
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
    /// True if the picture stays as it is until something happens.
    rests: bool,
    /// Simulated time [s].
    time_s: f64,
    /// Simulated seconds per second that are requested.
    speed: f64,
    /// Simulated seconds per second over the last ten seconds.
    time_ratio: f64,
    paused: bool,
    /// True if only the controls of a first cook are shown.
    few: bool,
    quality: Quality,
    recipe: Option<String>,
    /// Number of commands that the kitchen has taken.
    commands: usize,
    /// Power of the hob [W].
    hob_w: f64,
    /// Temperature of the pan's floor [°C].
    pan_c: f64,
    /// Tilt of the pan from level [°].
    pan_tilt_deg: f64,
    pieces: Vec<PieceStats>,
    /// How far the cook came with which the window offers to go on [s].
    offered_s: Option<f64>,
    /// How much of this cook was handed to the storage [s].
    kept_s: Option<f64>,
    /// True while a recorded cook is played again, or time is turned.
    travels: bool,
    /// End of what was recorded [s].
    end_s: f64,
    /// The notices, the last first.
    said: Vec<String>,
    /// Memory of the module [bytes].
    memory_bytes: usize,
    /// Length of the longest frame of the last ten seconds [s].
    longest_frame_s: f64,
}

/// Size of a page of WebAssembly's memory [bytes].
const MEMORY_PAGE: usize = 65_536;

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
            rests: app.rests(),
            time_s: kitchen.time_s(),
            speed: session.speed,
            time_ratio: meter.time_ratio(),
            paused: session.paused,
            few: app.settings().few,
            quality: app.quality(),
            recipe: session.recipe_title().map(str::to_owned),
            commands: session.recording().entries().len(),
            hob_w: kitchen.hob_w(),
            pan_c: celsius(kitchen.pan_temperature()),
            pan_tilt_deg: tilt_deg(kitchen),
            pieces: kitchen.pieces().iter().map(PieceStats::of).collect(),
            offered_s: app.offered_s(),
            kept_s: app.kept_s(),
            travels: session.is_travelling(),
            end_s: session.end_s(),
            said: app.said(),
            memory_bytes: core::arch::wasm32::memory_size(0) * MEMORY_PAGE,
            longest_frame_s: meter.longest_frame_s(),
        }
    }
}

/// Tilt of the pan from level [°].
fn tilt_deg(kitchen: &Kitchen) -> f64 {
    let turned = kitchen.world().motion.pose.rotation;
    let up = 1.0 - 2.0 * (turned.x * turned.x + turned.y * turned.y);
    up.clamp(-1.0, 1.0).acos().to_degrees()
}
