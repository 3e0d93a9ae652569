//! A stick: a rounded cross-section swept lengthwise.

use saute_heat::{Outline, Section, Station, SweptMesh, graded_levels};

use crate::body::natural::Variation;
use crate::body::rounded::{node_count, ring_shares, ringed};
use crate::body::slice::FIRST_LAYER;
use crate::body::{Body, even_levels, harmonics, paper_mesh, rule};
use crate::build_error::BuildError;
use crate::description::FoodDescription;
use crate::piece_spec::PieceSpec;

/// Nodes around a stick and rings below its skin (chosen: 1.6 mm apart on a baton of 10 mm).
const STICK_AROUND: usize = 24;
const STICK_RINGS: usize = 4;
/// Growth of a stick's layers from its ends inwards [-], and the longest over the length [-] (chosen).
const STICK_GROWTH: f64 = 1.5;
const STICK_LONGEST: f64 = 0.05;

impl Body {
    /// Meshes a bar along x: its rounded cross-section swept lengthwise.
    pub(crate) fn stick(description: &FoodDescription, piece: &PieceSpec) -> Result<Self, BuildError> {
        let [length, width, thickness] = piece.size;
        let exponent = description.outline.exponent;
        let edge = Outline::superellipse(width, thickness, exponent, &harmonics(description, piece));
        let (section, levels) = match paper_mesh(description, piece) {
            Some((rings, levels)) => (Section::concentric(&edge, rings)?, even_levels(length, levels)),
            None => (Section::concentric(&edge, &rings(piece))?, levels(piece)),
        };
        let across = [[0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
        let natural = piece.natural(description).map(|form| Variation { form, size: piece.size, seed: piece.seed });
        let at = |level: &f64| {
            let plain = ([level - 0.5 * length, 0.0, 0.0], [1.0; 2]);
            let (centre, scale) = natural.as_ref().map_or(plain, |natural| natural.station(level / length));
            Station::scaled(&section, centre, across, scale)
        };
        let path = levels.iter().map(at).collect::<Result<Vec<_>, _>>()?;
        let outline = Outline::superellipse(length, width, 2.0 * exponent, &[]);
        Ok(Self::swept(piece.size, SweptMesh::along(section, path, rule(piece)), outline))
    }
}

fn rings(piece: &PieceSpec) -> Vec<(usize, f64)> {
    let [_, width, thickness] = piece.size;
    let around = ((STICK_AROUND as f64 / piece.coarseness) as usize).max(12);
    ringed(around, &ring_shares(0.5 * width.min(thickness), FIRST_LAYER * piece.coarseness, STICK_RINGS))
}

fn levels(piece: &PieceSpec) -> Vec<f64> {
    let length = piece.size[0];
    graded_levels(length, FIRST_LAYER * piece.coarseness, STICK_GROWTH, STICK_LONGEST * length)
}

/// Number of nodes of a stick, before it is meshed [-].
pub(super) fn nodes(piece: &PieceSpec) -> f64 {
    (node_count(&rings(piece)) * levels(piece).len()) as f64
}

/// Taper of a stick's height over that of its breadth [-] (chosen: it was sliced flat, then cut by hand).
const FLATNESS: f64 = 0.4;

impl Variation<'_> {
    /// Centre and scale of a natural stick's section at a share of its length: tapered and bent sideways, its lower side
    /// flat [m].
    fn station(&self, share: f64) -> ([f64; 3], [f64; 2]) {
        let [length, width, thickness] = self.size;
        let (along, taper) = (2.0 * share - 1.0, self.form.taper * self.signed(510));
        // The volume of the plain stick: the mean of both scales' product over the length is 1.
        let even = 1.0 / libm::sqrt(1.0 + FLATNESS * taper * taper / 3.0);
        let scale = [even * (1.0 + taper * along), even * (1.0 + FLATNESS * taper * along)];
        let aside = self.form.bend * self.signed(511) * width * (along * along - 1.0 / 3.0);
        ([0.5 * length * along, aside, 0.5 * thickness * (scale[1] - 1.0)], scale)
    }
}
