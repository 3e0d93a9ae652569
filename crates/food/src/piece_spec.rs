//! What a piece is built from, apart from its food.

use serde::{Deserialize, Serialize};

use crate::body::pool::Pool;
use crate::description::{FoodDescription, NaturalForm, OutlineKind};
use crate::paper_2013::{MeshSize, Rules};

/// Size, seed and mesh of a piece to be built.
#[derive(Clone, Copy, Debug, Deserialize, PartialEq, Serialize)]
pub struct PieceSpec {
    /// Length, width, thickness [m].
    pub size: [f64; 3],
    /// Seed of the natural variation.
    pub seed: u64,
    /// Mesh spacing relative to the default [-]; 2 gives about an eighth of the nodes.
    pub coarseness: f64,
    /// Mesh to be built.
    pub mesh: MeshSize,
    /// Physical rules.
    pub rules: Rules,
    /// Outline to be cut.
    pub outline: OutlineKind,
    /// How a poured food lies, once it does; none before, and of other foods.
    pub pool: Option<Pool>,
}

/// Largest area of a pool over the product of length and width as ordered [-] (chosen: a film of a tenth of its mean thickness).
const WIDEST: f64 = 8.0;

impl PieceSpec {
    /// Returns true if the piece is not poured yet, or lies in a pool that its volume fills.
    pub fn has_sound_pool(&self) -> bool {
        let widest = WIDEST * self.size[0] * self.size[1];
        self.pool.as_ref().is_none_or(|pool| pool.is_sound() && pool.most_area() <= widest)
    }

    /// A plain piece of a size [m] on the default mesh, whose spacing is `coarseness` times the default [-].
    pub fn plain(size: [f64; 3], coarseness: f64) -> Self {
        Self {
            size,
            seed: 1,
            coarseness,
            mesh: MeshSize::Default,
            rules: Rules::Full,
            outline: OutlineKind::Plain,
            pool: None,
        }
    }

    /// Returns the natural form of the piece, or none if it is plain, as every piece of 2013 is.
    pub(crate) fn natural<'a>(&self, description: &'a FoodDescription) -> Option<&'a NaturalForm> {
        description.natural.as_ref().filter(|_| self.is_of_today() && self.outline != OutlineKind::Plain)
    }

    /// Returns true if the piece differs from the mean of its food; none of 2013 does.
    pub(crate) fn is_individual(&self) -> bool {
        self.is_of_today() && self.outline == OutlineKind::Individual
    }

    fn is_of_today(&self) -> bool {
        self.rules == Rules::Full && self.mesh == MeshSize::Default
    }
}
