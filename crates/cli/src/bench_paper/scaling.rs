//! Growth of the cost of a cycle with the number of pieces.

use saute_kitchen::{Library, MeshSize};
use serde::Serialize;

use super::scene::{PAN, Scene};
use super::stopwatch;
use crate::error::CliError;
use crate::output::progress::Progress;

/// Numbers of pieces, half of them carrots and half shrimps.
const PIECES: [usize; 5] = [10, 20, 40, 70, 100];
/// Number of pieces that the ordinary pan is just large enough for (chosen: they cover its floor once).
const FILLS: f64 = 20.0;
/// Goal: the largest exponent [-] (chosen: close to linear).
const GOAL: f64 = 1.1;
/// Number of scenes that are timed.
pub const SCENES: usize = 2 * PIECES.len();
/// Id of the pan that grows.
const GROWING: &str = "growing";

/// One scene of the series.
#[derive(Debug, Serialize)]
pub struct Point {
    /// Number of pieces.
    pub pieces: usize,
    /// Radius of the pan's floor [mm].
    pub floor_radius_mm: f64,
    /// Median of the runs [cycles/s].
    pub cycles_per_s: f64,
    /// Largest penetration [mm].
    pub max_penetration_mm: f64,
    /// Number of pieces that fell out of the pan.
    pub lost: usize,
}

/// Cost against the number of pieces, at rest with the meshes of 2013.
#[derive(Debug, Serialize)]
pub struct Scaling {
    /// In a pan whose floor grows with the count.
    pub growing: Vec<Point>,
    /// Slope of a straight line through their costs in logarithms [-].
    pub exponent: f64,
    /// Goal for the exponent [-].
    pub goal: f64,
    /// True if the goal is met.
    pub met: bool,
    /// In the 26 cm pan, where they pile up.
    pub fixed: Vec<Point>,
}

/// Times both pans.
pub fn measure(library: &Library, progress: &Progress) -> Result<Scaling, CliError> {
    let series =
        |grows: bool| PIECES.iter().map(|n| point(*n, grows, library, progress)).collect::<Result<Vec<_>, _>>();
    let (growing, fixed) = (series(true)?, series(false)?);
    let exponent = exponent(&growing);
    Ok(Scaling { growing, exponent, goal: GOAL, met: exponent <= GOAL, fixed })
}

fn point(pieces: usize, grows: bool, library: &Library, progress: &Progress) -> Result<Point, CliError> {
    let mut library = library.clone();
    let mut pan = library.pans[PAN].clone();
    if grows {
        let wider = ((pieces as f64 / FILLS).sqrt() - 1.0) * pan.floor.radius_mm;
        pan.floor.radius_mm += wider;
        pan.wall.rim_radius_mm += wider;
    }
    let floor_radius_mm = pan.floor.radius_mm;
    library.pans.insert(GROWING.to_owned(), pan);
    let (carrots, shrimps) = (pieces / 2, pieces - pieces / 2);
    let scene = Scene { carrots, shrimps, mesh: MeshSize::Paper2013, shaking: false, pan: GROWING.to_owned() };
    progress.next(scene.in_words());
    let timed = stopwatch::time(&scene, &library)?;
    let (cycles_per_s, max_penetration_mm, lost) = (timed.cycles_per_s, timed.max_penetration_mm, timed.lost);
    Ok(Point { pieces, floor_radius_mm, cycles_per_s, max_penetration_mm, lost })
}

/// Returns the slope of log cost against log pieces, by least squares [-].
fn exponent(points: &[Point]) -> f64 {
    let logs: Vec<[f64; 2]> = points.iter().map(|p| [(p.pieces as f64).ln(), -p.cycles_per_s.ln()]).collect();
    let mean = |k: usize| logs.iter().map(|l| l[k]).sum::<f64>() / logs.len() as f64;
    let (x, y) = (mean(0), mean(1));
    let above: f64 = logs.iter().map(|l| (l[0] - x) * (l[1] - y)).sum();
    above / logs.iter().map(|l| (l[0] - x) * (l[0] - x)).sum::<f64>()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn costs_that_grow_as_a_power_have_that_exponent() {
        let point = |pieces: usize| Point {
            pieces,
            floor_radius_mm: 100.0,
            cycles_per_s: 3e4 * (pieces as f64).powf(-1.3),
            max_penetration_mm: 0.0,
            lost: 0,
        };
        assert!((exponent(&PIECES.map(point)) - 1.3).abs() < 1e-12);
    }
}
