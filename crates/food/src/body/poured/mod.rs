//! The body of a poured food: columns of the height at which it lies.

pub mod pool;
mod repoured;

use saute_heat::{Section, SweptMesh, graded_levels};

use crate::body::pool::Pool;
use crate::body::slice::{graded_by, spacing};
use crate::body::{Body, even_levels, paper_mesh, rule};
use crate::build_error::BuildError;
use crate::description::FoodDescription;
use crate::piece_spec::PieceSpec;

/// First layer below a face of the mean thickness, its growth inwards and the thickest layer [m] (chosen: at the rim, a third as thick, a
/// layer still takes a whole step).
const FIRST_LAYER: f64 = 0.55e-3;
const GROWTH: f64 = 1.5;
const THICKEST: f64 = 2.2e-3;

impl Body {
    /// Meshes a poured piece as it lies, or as it would lie on a level floor; its volume is that of the ordered size.
    pub(crate) fn poured(description: &FoodDescription, piece: &PieceSpec) -> Result<Self, BuildError> {
        let pool = match piece.pool {
            Some(pool) => pool,
            None => level(description, piece)?,
        };
        let pool = pool.wavy(description, piece);
        let outline = pool.outline();
        let section = match paper_mesh(description, piece) {
            Some((rings, _)) => Section::concentric(&outline, rings)?,
            None => graded_by(&outline, spacing(piece))?,
        };
        let [length, width, thickness] = piece.size;
        let mean = 0.25 * core::f64::consts::PI * length * width * thickness / section.area();
        // As many layers as the ordered size has, so that states go from one shape to the next layer by layer.
        let levels = match paper_mesh(description, piece) {
            Some((_, count)) => even_levels(mean, count),
            None => layers(piece).iter().map(|z| z * mean / thickness).collect(),
        };
        let heights: Vec<f64> = section.points.iter().map(|p| pool.height_at(*p)).collect();
        let lies = heights.iter().zip(&section.areas).map(|(h, a)| h * a).sum::<f64>() / section.area();
        let mesh = SweptMesh::uneven(section, levels, |p| pool.height_at(p) / lies, rule(piece));
        let extent = |axis: usize| {
            let along = outline.points.iter().map(|p| p[axis]);
            along.clone().fold(f64::NEG_INFINITY, f64::max) - along.fold(f64::INFINITY, f64::min)
        };
        let size = [extent(0), extent(1), mean];
        Ok(Self { pool: Some(pool), ..Self::swept(size, mesh, outline) })
    }
}

fn layers(piece: &PieceSpec) -> Vec<f64> {
    let coarse = piece.coarseness;
    graded_levels(piece.size[2], FIRST_LAYER * coarse, GROWTH, THICKEST * coarse)
}

/// The piece as it lies on a level floor.
fn level(description: &FoodDescription, piece: &PieceSpec) -> Result<Pool, BuildError> {
    let missing = |table| BuildError::Missing { form: "poured", table };
    let yolk = description.yolk.as_ref().ok_or(missing("yolk"))?;
    let pour = description.pour.as_ref().ok_or(missing("pour"))?;
    Ok(Pool::level(yolk, pour, piece))
}
