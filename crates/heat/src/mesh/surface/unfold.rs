//! Small folds of a surface, as skins that contracted have them, are smoothed.

use std::collections::BTreeMap;

use glam::DVec3;

use super::Surface;
use super::crossing::{crossing_pairs, trouble};
use super::defect::Defect;
use super::triangle_tree::TriangleTree;
use super::weld::slivers_among;

/// Farthest that a vertex is moved [m] (chosen: mostly along the skin; those of cooked foods are moved by up to 0.6 mm).
const FARTHEST: f64 = 1e-3;
/// Largest change of the volume over the volume [-] (chosen: a fiftieth of what the cells of a volume mesh are corrected by).
const LARGEST_CHANGE: f64 = 1e-3;
/// Rounds of smoothing [-] (measured: folds of cooked foods need up to eight).
const ROUNDS: usize = 16;
/// Pairs that intersect, over the triangles [-] (measured: cooked foods have one for 200).
const LARGEST_SHARE: f64 = 0.02;

/// Smooths folds until no two triangles intersect; a surface without folds stays as it is.
///
/// # Errors
/// [`Defect::Crossing`] with the folds found first, if they do not vanish while the surface keeps its shape;
/// [`Defect::Dense`] if there are too many pairs of triangles to look at.
pub fn unfold(surface: &mut Surface) -> Result<(), Defect> {
    let tree = TriangleTree::new(surface);
    let found = crossing_pairs(surface, &tree, 0..surface.triangles.len(), 0.0)?;
    let Some(crossing) = trouble(surface, &found) else { return Ok(()) };
    let crossing = Defect::Crossing(crossing);
    if found.len() as f64 > LARGEST_SHARE * surface.triangles.len() as f64 {
        return Err(crossing);
    }
    let before = surface.clone();
    let mut wrong: Vec<usize> = found.iter().flatten().map(|t| *t as usize).collect();
    let mut moved = vec![false; surface.vertices.len()];
    for _ in 0..ROUNDS {
        if !smooth(surface, &wrong, &mut moved, &before) {
            return Err(crossing);
        }
        wrong = still_wrong(surface, &tree, &moved)?;
        if wrong.is_empty() {
            let change = (surface.volume() - before.volume()).abs();
            return if change <= LARGEST_CHANGE * before.volume() { Ok(()) } else { Err(crossing) };
        }
    }
    Err(crossing)
}

/// Returns the triangles with moved vertices that intersect others, and those that became flat.
fn still_wrong(surface: &Surface, tree: &TriangleTree, moved: &[bool]) -> Result<Vec<usize>, Defect> {
    let is_touched = |t: &usize| surface.triangles[*t].iter().any(|v| moved[*v as usize]);
    let touched: Vec<usize> = (0..surface.triangles.len()).filter(is_touched).collect();
    let found = crossing_pairs(surface, tree, touched.iter().copied(), FARTHEST)?;
    Ok(found.iter().flatten().map(|t| *t as usize).chain(slivers_among(surface, &touched)).collect())
}

/// Moves the vertices of some triangles half-way to the mean of their neighbours; returns false if one is moved too far.
fn smooth(surface: &mut Surface, wrong: &[usize], moved: &mut [bool], before: &Surface) -> bool {
    let corners = wrong.iter().flat_map(|t| surface.triangles[*t]);
    let mut around: BTreeMap<u32, (DVec3, f64)> = corners.map(|v| (v, (DVec3::ZERO, 0.0))).collect();
    around.keys().for_each(|v| moved[*v as usize] = true);
    for triangle in surface.triangles.iter().filter(|t| t.iter().any(|v| moved[*v as usize])) {
        for k in 0..3 {
            // Each neighbour is next in one triangle on a closed surface.
            if let Some((sum, count)) = around.get_mut(&triangle[k]) {
                *sum += surface.vertex(triangle[(k + 1) % 3]);
                *count += 1.0;
            }
        }
    }
    around.into_iter().all(|(vertex, (sum, count))| {
        let place = 0.5 * (surface.vertex(vertex) + sum / count);
        surface.vertices[vertex as usize] = place.to_array();
        before.vertex(vertex).distance(place) <= FARTHEST
    })
}
