//! A slice: an outline swept upwards through an uneven thickness.

use saute_heat::{MeshError, Outline, Section, SweptMesh, graded_levels};

use crate::body::natural::Variation;
use crate::body::{Body, Waves, even_levels, harmonics, paper_mesh, rule};
use crate::build_error::BuildError;
use crate::description::FoodDescription;
use crate::piece_spec::PieceSpec;
use crate::tissue::noise::{fractal, uniform};

/// In-plane spacing of the default mesh [m] (chosen: the gradient length √(αt) is 9 mm after 10 minutes).
const SPACING: f64 = 5.0e-3;
/// Depth of the ring of nodes below the rim over the spacing [-] (chosen: heat enters at the rim, too).
const RIM: f64 = 0.38;
/// First layer below a big face [m] (chosen: a crust is 0.5–1.5 mm thick).
pub(crate) const FIRST_LAYER: f64 = 0.35e-3;
/// Growth of the layers inwards [-] and the thickest layer [m] (chosen; convergence is tested).
const LAYER_GROWTH: f64 = 1.38;
const THICKEST_LAYER: f64 = 2.2e-3;
/// Run of the bumps of a cut over the smaller of length and width [-] (chosen: two or three of them side by side).
const BUMP_RUN: f64 = 0.35;

impl Body {
    /// Meshes a slice: its outline swept upwards.
    pub(crate) fn slice(description: &FoodDescription, piece: &PieceSpec) -> Result<Self, BuildError> {
        let natural = piece.natural(description);
        let natural = natural.map(|form| Variation { form, size: piece.size, seed: piece.seed });
        let plain = outline(description, piece);
        let outline =
            natural.as_ref().map_or_else(|| plain.clone(), |natural| natural.outline(&plain, 0.75 * spacing(piece)));
        let (section, levels) = match paper_mesh(description, piece) {
            Some((rings, levels)) => (Section::concentric(&outline, rings)?, even_levels(piece.size[2], levels)),
            None => graded(&outline, piece)?,
        };
        let further = |p| natural.as_ref().map_or(0.0, |natural| natural.thickness(p) - natural.shoulder(&outline, p));
        let mesh = SweptMesh::uneven(section, levels, |p| unevenness(description, piece, p) + further(p), rule(piece));
        let waves = description.outline.waves_mm.map(|length| Waves::new(1e-3 * length, piece.size[1], piece.seed));
        Ok(Self { waves, ..Self::swept(piece.size, mesh, outline) })
    }
}

fn outline(description: &FoodDescription, piece: &PieceSpec) -> Outline {
    let corners = &description.outline.corners;
    if !corners.is_empty() {
        return Outline::polygon(corners, piece.size[0], piece.size[1]);
    }
    let exponent = description.outline.exponent;
    Outline::superellipse(piece.size[0], piece.size[1], exponent, &harmonics(description, piece))
}

/// Spacing of the nodes inside the section [m].
pub(super) fn spacing(piece: &PieceSpec) -> f64 {
    (SPACING * piece.coarseness).min(piece.size[0].min(piece.size[1]) / 8.0)
}

fn graded(outline: &Outline, piece: &PieceSpec) -> Result<(Section, Vec<f64>), MeshError> {
    Ok((graded_by(outline, spacing(piece))?, levels(piece)))
}

/// A section with a ring of nodes below its rim, for nodes at a spacing [m].
pub(super) fn graded_by(outline: &Outline, spacing: f64) -> Result<Section, MeshError> {
    Section::mesh(outline, spacing, RIM * spacing)
}

fn levels(piece: &PieceSpec) -> Vec<f64> {
    graded_levels(piece.size[2], FIRST_LAYER * piece.coarseness, LAYER_GROWTH, THICKEST_LAYER * piece.coarseness)
}

/// Estimated number of nodes of a slice, before it is meshed [-].
pub(super) fn nodes(description: &FoodDescription, piece: &PieceSpec) -> f64 {
    let section = Section::estimated_nodes(&outline(description, piece), spacing(piece), RIM * spacing(piece));
    section * levels(piece).len() as f64
}

/// Relative deviation of the thickness from its mean: a wedge in a seeded direction and gentle bumps [-].
fn unevenness(description: &FoodDescription, piece: &PieceSpec, [x, y]: [f64; 2]) -> f64 {
    let (shape, [length, width, _]) = (&description.outline, piece.size);
    let angle = core::f64::consts::TAU * uniform(piece.seed, 201);
    let slope = x / length * libm::cos(angle) + y / width * libm::sin(angle);
    let run = BUMP_RUN * length.min(width);
    let steep = 0.5 + 0.5 * uniform(piece.seed, 202);
    steep * shape.wedge * slope + shape.bumps * fractal(piece.seed ^ 0x0b_0e55, [x / run, y / run, 0.0])
}
