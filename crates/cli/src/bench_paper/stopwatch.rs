//! The speed of a scene in cycles per second. A cycle is one frame with all the physics of `saute cook`.

use std::time::Instant;

use saute_kitchen::heat::sorted::Sorted;
use saute_kitchen::{FRAME_S, Kitchen, Library};
use saute_recipe::Cook;

use super::scene::Scene;
use crate::error::CliError;

/// Number of runs; their median is reported (chosen).
pub const RUNS: usize = 7;
/// Parts of a run; the penetration is measured between them, outside the timing (chosen).
const PARTS: usize = 10;
/// Frames in a part: two ticks of heat.
const FRAMES: usize = 12;

/// The measurements of a scene.
#[derive(Clone, Debug)]
pub struct Timed {
    /// Median of the runs [cycles/s].
    pub cycles_per_s: f64,
    /// Speed of each run [cycles/s].
    pub runs: Vec<f64>,
    /// Rise of the core temperature over all runs, mean of the pieces [K].
    pub core_rise_k: f64,
    /// Largest penetration [mm].
    pub max_penetration_mm: f64,
    /// Number of pieces that are no longer in the pan.
    pub lost: usize,
    /// The kitchen at the end.
    pub kitchen: Kitchen,
}

/// Returns the simulated time of all runs [s].
pub fn timed_s() -> f64 {
    (RUNS * PARTS * FRAMES) as f64 * FRAME_S
}

/// Plays a scene until it is ready, then times it.
pub fn time(scene: &Scene, library: &Library) -> Result<Timed, CliError> {
    // One second more: shaking must not end before the measurement.
    let mut cook = scene.cook(library, timed_s() + 1.0)?;
    cook.kitchen.set_sleeping(false);
    play_to(&mut cook, scene.ready_at_s())?;
    let mut kitchen = cook.kitchen;
    let (before, mut deepest) = (mean_core(&kitchen), 0.0f64);
    let runs: Vec<f64> = (0..RUNS).map(|_| run(&mut kitchen, &mut deepest)).collect();
    Ok(Timed {
        cycles_per_s: Sorted::new(runs.clone()).median().unwrap_or(0.0),
        runs,
        core_rise_k: mean_core(&kitchen) - before,
        max_penetration_mm: 1e3 * deepest,
        lost: kitchen.pieces().iter().filter(|p| !p.in_pan()).count(),
        kitchen,
    })
}

/// Continues a cook until a time [s].
fn play_to(cook: &mut Cook, until_s: f64) -> Result<(), CliError> {
    while cook.kitchen.time_s() < until_s - 0.5 * FRAME_S && cook.stopped().is_none() {
        cook.advance()?;
    }
    Ok(())
}

/// Measures one run [cycles/s].
fn run(kitchen: &mut Kitchen, deepest: &mut f64) -> f64 {
    let mut seconds = 0.0;
    for _ in 0..PARTS {
        let start = Instant::now();
        for _ in 0..FRAMES {
            kitchen.advance_frame();
        }
        seconds += start.elapsed().as_secs_f64();
        *deepest = deepest.max(kitchen.world().deepest_overlap());
    }
    (PARTS * FRAMES) as f64 / seconds
}

fn mean_core(kitchen: &Kitchen) -> f64 {
    kitchen.pieces().iter().map(saute_kitchen::Piece::core).sum::<f64>() / kitchen.pieces().len() as f64
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]
    use super::super::scene::PAN;
    use super::*;
    use saute_kitchen::MeshSize;

    /// Rise of the core in the same recipe as `saute cook` plays it, with bodies at rest asleep [K].
    fn cooked_rise(scene: &Scene, library: &Library) -> f64 {
        let mut cook = scene.cook(library, timed_s() + 1.0).unwrap();
        play_to(&mut cook, scene.ready_at_s()).unwrap();
        let before = mean_core(&cook.kitchen);
        play_to(&mut cook, scene.ready_at_s() + timed_s()).unwrap();
        mean_core(&cook.kitchen) - before
    }

    #[test]
    fn cores_rise_as_in_a_cook_and_no_piece_is_lost() {
        let library = Library::embedded().unwrap();
        for (mesh, shaking) in [(MeshSize::Paper2013, false), (MeshSize::Paper2013, true), (MeshSize::Default, false)] {
            let scene = Scene { carrots: 3, shrimps: 3, mesh, shaking, pan: PAN.to_owned() };
            let timed = time(&scene, &library).unwrap();
            let cooked = cooked_rise(&scene, &library);
            assert!(timed.core_rise_k > 0.1, "the bench heats nothing: {}", timed.core_rise_k);
            assert!((timed.core_rise_k - cooked).abs() < 0.1, "{scene:?}: {} {cooked}", timed.core_rise_k);
            assert!(timed.lost == 0 && timed.max_penetration_mm < 0.5, "{scene:?}: {}", timed.max_penetration_mm);
        }
    }
}
