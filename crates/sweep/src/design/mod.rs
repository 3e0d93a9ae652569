//! Designs: which point of the unit cube belongs to a row.
//!
//! A point is computed from the number of its row, so a design takes no memory and rows can be made in any order.

pub mod latin_hypercube;
pub mod morris;
pub mod random;
pub mod saltelli;
pub mod sobol;
mod sobol_directions;

pub use sobol_directions::MOST_DIMENSIONS;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// The kind of a design.
#[derive(Clone, Copy, Debug, Deserialize, JsonSchema, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum DesignKind {
    /// Every combination of all levels; the last value of `[vary]` changes fastest.
    Grid,
    /// `n` rows; each value is in every one of `n` strata once.
    LatinHypercube,
    /// `n` rows of a Sobol' sequence; best for a power of two.
    Sobol,
    /// `n` × (number of values + 2) rows, from which `saute sweep report` estimates Sobol' indices.
    Saltelli,
    /// `n` × (number of values + 1) rows: `n` trajectories, from which `saute sweep report` estimates elementary effects.
    Morris,
}

/// A design with its size: how many rows there are and what varies in each.
#[derive(Clone, Debug, Deserialize, PartialEq, Serialize)]
pub struct Design {
    /// Kind.
    pub kind: DesignKind,
    /// Number of rows, base rows or trajectories; not used by a grid [-].
    pub n: u64,
    /// Seed of the random parts [-].
    pub seed: u64,
    /// Levels of each varied value for a grid [-].
    pub levels: Vec<u64>,
}

impl Design {
    /// Returns the number of varied values.
    pub fn dimensions(&self) -> usize {
        self.levels.len()
    }

    /// Returns true if the Sobol' sequence has as many dimensions as the design needs, if it needs one.
    pub fn has_dimensions(&self) -> bool {
        match self.kind {
            DesignKind::Sobol => self.dimensions() <= MOST_DIMENSIONS,
            DesignKind::Saltelli => 2 * self.dimensions() <= MOST_DIMENSIONS,
            DesignKind::Grid | DesignKind::LatinHypercube | DesignKind::Morris => true,
        }
    }

    /// Returns the number of rows; none if it does not fit into 64 bits.
    pub fn rows(&self) -> Option<u64> {
        match self.kind {
            DesignKind::Grid => self.levels.iter().try_fold(1_u64, |all, levels| all.checked_mul(*levels)),
            DesignKind::LatinHypercube | DesignKind::Sobol => Some(self.n),
            DesignKind::Saltelli | DesignKind::Morris => self.n.checked_mul(self.block()),
        }
    }

    /// Returns the number of rows that belong together: of a base row or of a trajectory.
    pub fn block(&self) -> u64 {
        let dimensions = self.levels.len() as u64;
        match self.kind {
            DesignKind::Saltelli => dimensions + 2,
            DesignKind::Morris => dimensions + 1,
            DesignKind::Grid | DesignKind::LatinHypercube | DesignKind::Sobol => 1,
        }
    }

    /// Returns the point of a row in the unit cube; of a grid the number of the level over the number of levels.
    pub fn point(&self, row: u64) -> Vec<f64> {
        let dimensions = self.dimensions();
        match self.kind {
            DesignKind::Grid => self.grid_point(row),
            DesignKind::LatinHypercube => {
                (0..dimensions).map(|d| latin_hypercube::coordinate(row, d, self.n, self.seed)).collect()
            }
            DesignKind::Sobol => (0..dimensions).map(|d| sobol::shifted(row, d, self.seed)).collect(),
            DesignKind::Saltelli => saltelli::point(row, dimensions, self.seed),
            DesignKind::Morris => morris::point(row, dimensions, self.seed),
        }
    }

    fn grid_point(&self, row: u64) -> Vec<f64> {
        let mut rest = row;
        let mut point = vec![0.0; self.levels.len()];
        for (coordinate, levels) in point.iter_mut().zip(&self.levels).rev() {
            // The middle of the level's interval, so that rounding cannot reach the next one.
            *coordinate = ((rest % levels) as f64 + 0.5) / *levels as f64;
            rest /= levels;
        }
        point
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_grid_has_every_combination_once_and_its_last_value_changes_fastest() {
        let design = Design { kind: DesignKind::Grid, n: 0, seed: 0, levels: vec![2, 3] };
        assert_eq!(design.rows(), Some(6));
        let level = |u: f64, n: f64| (u * n) as u64;
        let levels: Vec<[u64; 2]> =
            (0..6).map(|row| design.point(row)).map(|p| [level(p[0], 2.0), level(p[1], 3.0)]).collect();
        assert_eq!(levels, [[0, 0], [0, 1], [0, 2], [1, 0], [1, 1], [1, 2]]);
    }
}
