//! A body to be filled with food: each form's mesh, outline and faces.

use saute_heat::{MeshError, Outline, Rule, Section, Station, SweptMesh, graded_levels};

use crate::description::FoodDescription;
use crate::form::Form;
use crate::model::{BuildError, PieceSpec};
use crate::noise::{fractal, uniform};
use crate::paper_2013::{MeshSize, Rings, Rules};
use crate::patch::{Patch, patches};
use crate::rounded::{ring_shares, ringed};

/// In-plane spacing of the default mesh [m] (chosen: the gradient length √(αt) is 9 mm after 10 minutes).
const SPACING: f64 = 5.0e-3;
/// First layer below a big face [m] (chosen: a crust is 0.5–1.5 mm thick).
const FIRST_LAYER: f64 = 0.35e-3;
/// Growth of the layers inwards [-] and the thickest layer [m] (chosen; convergence is tested).
const LAYER_GROWTH: f64 = 1.38;
const THICKEST_LAYER: f64 = 2.2e-3;
/// Run of the bumps of a cut over the smaller of length and width [-] (chosen: two or three of them side by side).
const BUMP_RUN: f64 = 0.35;
/// Nodes around a stick and rings below its skin (chosen: 1.6 mm apart on a baton of 10 mm).
const STICK_AROUND: usize = 24;
const STICK_RINGS: usize = 4;
/// Growth of a stick's layers from its ends inwards [-], and the longest over the length [-] (chosen).
const STICK_GROWTH: f64 = 1.5;
const STICK_LONGEST: f64 = 0.05;

/// A body to be filled with food: its mesh, how it meets the outside, and its outline seen from above.
#[derive(Clone, Debug)]
pub struct Body {
    /// Length, width, thickness; of a curved body along its curve, across it in its plane, and its height [m].
    pub size: [f64; 3],
    /// Rest mesh.
    pub mesh: SweptMesh,
    /// Outline seen from above.
    pub outline: Outline,
    /// Faces towards the outside.
    pub patches: Vec<Patch>,
    /// Whether it contracts, and bends as a plate if it is one.
    pub contracts: bool,
}

impl Body {
    /// Cuts and meshes a piece.
    pub fn cut(description: &FoodDescription, piece: &PieceSpec) -> Result<Self, BuildError> {
        match description.form {
            Form::Steak | Form::Patty | Form::Coin | Form::Ring => Self::slice(description, piece),
            Form::Stick => Self::stick(description, piece),
            Form::Shrimp => Self::shrimp(description, piece),
            Form::Mesh => Self::inside_surface(description, piece),
        }
    }

    pub(crate) fn of_mesh(size: [f64; 3], mesh: SweptMesh, outline: Outline) -> Self {
        Self { size, patches: patches(&mesh), mesh, outline, contracts: true }
    }

    /// A slice that lies flat: its outline carried upwards.
    fn slice(description: &FoodDescription, piece: &PieceSpec) -> Result<Self, BuildError> {
        let outline = outline(description, piece);
        let (section, levels) = match paper_mesh(description, piece) {
            Some((rings, levels)) => (Section::concentric(&outline, rings)?, even_levels(piece.size[2], levels)),
            None => graded(&outline, piece)?,
        };
        let mesh = SweptMesh::uneven(section, levels, |p| unevenness(description, piece, p), rule(piece));
        Ok(Self::of_mesh(piece.size, mesh, outline))
    }

    /// A bar along x: its rounded cross-section carried lengthwise.
    fn stick(description: &FoodDescription, piece: &PieceSpec) -> Result<Self, BuildError> {
        let [length, width, thickness] = piece.size;
        let exponent = description.outline.exponent;
        let edge = Outline::superellipse(width, thickness, exponent, &harmonics(description, piece));
        let half = 0.5 * width.min(thickness);
        let first = FIRST_LAYER * piece.coarseness;
        let (section, levels) = match paper_mesh(description, piece) {
            Some((rings, levels)) => (Section::concentric(&edge, rings)?, even_levels(length, levels)),
            None => {
                let around = ((STICK_AROUND as f64 / piece.coarseness) as usize).max(12);
                let rings = ringed(around, &ring_shares(half, first, STICK_RINGS));
                (
                    Section::concentric(&edge, &rings)?,
                    graded_levels(length, first, STICK_GROWTH, STICK_LONGEST * length),
                )
            }
        };
        let across = [[0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
        let at = |level: &f64| Station::scaled(&section, [level - 0.5 * length, 0.0, 0.0], across, [1.0; 2]);
        let path = levels.iter().map(at).collect::<Result<Vec<_>, _>>()?;
        let outline = Outline::superellipse(length, width, 2.0 * exponent, &[]);
        Ok(Self::of_mesh(piece.size, SweptMesh::along(section, path, rule(piece)), outline))
    }
}

/// The rule that turns the mesh into conductances.
pub(crate) fn rule(piece: &PieceSpec) -> Rule {
    if piece.rules == Rules::Paper2013 { Rule::Segments } else { Rule::ShapeFunctions }
}

/// Rings and levels of the sizes of 2013, where they are asked for.
pub(crate) fn paper_mesh(description: &FoodDescription, piece: &PieceSpec) -> Option<(Rings, usize)> {
    (piece.mesh == MeshSize::Paper2013).then(|| crate::paper_2013::mesh_of(description))
}

/// Levels at even distances.
pub(crate) fn even_levels(length: f64, count: usize) -> Vec<f64> {
    let last = (count - 1) as f64;
    (0..count).map(|i| length * i as f64 / last).collect()
}

/// The outline's seeded natural waviness in harmonics 2 to 5.
fn harmonics(description: &FoodDescription, piece: &PieceSpec) -> Vec<(u32, f64, f64)> {
    let harmonic = |m: u32| {
        let amplitude = description.outline.ripple * (0.4 + 0.6 * uniform(piece.seed, u64::from(m))) / f64::from(m - 1);
        (m, amplitude, core::f64::consts::TAU * uniform(piece.seed, 100 + u64::from(m)))
    };
    (2..=5).map(harmonic).collect()
}

fn outline(description: &FoodDescription, piece: &PieceSpec) -> Outline {
    let exponent = description.outline.exponent;
    Outline::superellipse(piece.size[0], piece.size[1], exponent, &harmonics(description, piece))
}

fn graded(outline: &Outline, piece: &PieceSpec) -> Result<(Section, Vec<f64>), MeshError> {
    let smallest = piece.size[0].min(piece.size[1]);
    let spacing = (SPACING * piece.coarseness).min(smallest / 8.0);
    let section = Section::mesh(outline, spacing, 0.38 * spacing)?;
    let levels =
        graded_levels(piece.size[2], FIRST_LAYER * piece.coarseness, LAYER_GROWTH, THICKEST_LAYER * piece.coarseness);
    Ok((section, levels))
}

/// Departure of the thickness from its mean over that mean: a wedge in a seeded direction and gentle bumps [-].
fn unevenness(description: &FoodDescription, piece: &PieceSpec, [x, y]: [f64; 2]) -> f64 {
    let (shape, [length, width, _]) = (&description.outline, piece.size);
    let angle = core::f64::consts::TAU * uniform(piece.seed, 201);
    let slope = x / length * libm::cos(angle) + y / width * libm::sin(angle);
    let run = BUMP_RUN * length.min(width);
    let steep = 0.5 + 0.5 * uniform(piece.seed, 202);
    steep * shape.wedge * slope + shape.bumps * fractal(piece.seed ^ 0x0b_0e55, [x / run, y / run, 0.0])
}
