//! The rules of the 2013 Interactive Cooking Simulator, kept for comparison.
//!
//! Conduction along line segments; contact heat by a distance threshold; all heat above boiling into latent heat, no
//! juice, no evaporation below boiling; browning above 150 °C by weight loss in four stages; no contraction. Source:
//! Kato, Hasegawa, "Interactive Cooking Simulator", SIGGRAPH Asia 2013.

use crate::ZERO_C;
use crate::body::form::Form;
use crate::components::{Components, Properties};
use crate::description::{FoodDescription, Kinetics};

/// Which rules a piece follows.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, serde::Serialize)]
pub enum Rules {
    /// Everything that this program knows.
    #[default]
    #[serde(rename = "full")]
    Full,
    /// Those of 2013.
    #[serde(rename = "2013")]
    Paper2013,
}

/// How finely a piece is meshed.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, serde::Deserialize, serde::Serialize)]
pub enum MeshSize {
    /// As finely as this program does, graded towards the surface.
    #[default]
    #[serde(rename = "default")]
    Default,
    /// With as many vertices as the foods of 2013 had, at even distances.
    #[serde(rename = "2013")]
    Paper2013,
}

/// Rings of a section, as `(count, share of the radius)`, and levels.
pub type Rings = &'static [(usize, f64)];

/// 18 × 3 = 54, 17 × 7 = 119, 17 × 5 = 85, 71 × 17 = 1207 and 84 × 10 = 840 vertices (the paper's tables).
const CARROT: (Rings, usize) = (&[(12, 1.0), (5, 0.5), (1, 0.0)], 3);
const SHRIMP: (Rings, usize) = (&[(8, 1.0), (8, 0.5), (1, 0.0)], 7);
const LEEK: (Rings, usize) = (&[(11, 1.0), (5, 0.5), (1, 0.0)], 5);
const MARBLED: (Rings, usize) = (&[(28, 1.0), (21, 0.75), (14, 0.5), (7, 0.25), (1, 0.0)], 17);
const LEAN: (Rings, usize) = (&[(34, 1.0), (26, 0.75), (16, 0.5), (7, 0.25), (1, 0.0)], 10);

/// Rings and levels of a food's mesh of 2013.
pub fn mesh_of(description: &FoodDescription) -> (Rings, usize) {
    match description.form {
        Form::Coin | Form::Stick => CARROT,
        Form::Ring => LEEK,
        Form::Shrimp => SHRIMP,
        Form::Steak if description.marbling.is_some() => MARBLED,
        // A surface of the user's has no mesh of 2013; it keeps its own.
        Form::Steak | Form::Patty | Form::Mesh => LEAN,
    }
}

/// Water boils here [K].
pub const BOILING: f64 = ZERO_C + 100.0;
/// Browning begins here [K].
const BROWNS_FROM: f64 = ZERO_C + 150.0;
/// Stages of browning.
const STAGES: f64 = 4.0;

/// The food without what the rules of 2013 did not know: juice, rendering, contraction, a crust that conducts less.
pub fn simplified(
    description: &FoodDescription,
    kinetics: &Kinetics,
    components: &Components,
) -> (FoodDescription, Kinetics) {
    let lean = &description.lean;
    let properties = Properties::new(components, lean, &description.fat_melting);
    let raw = properties.conductivity(&[lean.water, lean.lean_solids(), lean.fat], ZERO_C + 20.0);
    let (mut description, mut kinetics) = (description.clone(), kinetics.clone());
    kinetics.water_holding.release_per_s = 0.0;
    kinetics.fat_release.rate_per_s.fill(0.0);
    kinetics.shrinkage.across.clear();
    kinetics.shrinkage.along.clear();
    kinetics.shrinkage.least_volume = 1.0;
    description.crust.conductivity_w_mk = raw;
    description.anisotropy = None;
    if let Some(sheaths) = &mut description.sheaths {
        sheaths.conductance_w_m2k = f64::INFINITY;
    }
    (description, kinetics)
}

/// Browning of a point at `temperature` [K] that has lost the share `lost` of its water: above 150 °C it rises to the
/// quarter that its weight loss has reached; it never falls [-].
pub fn browning(before: f64, temperature: f64, lost: f64) -> f64 {
    if temperature <= BROWNS_FROM {
        return before;
    }
    before.max(libm::ceil(STAGES * lost.clamp(0.0, 1.0)) / STAGES)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn browning_goes_in_four_stages_by_weight_loss_and_only_above_150() {
        assert_eq!(browning(0.0, ZERO_C + 149.0, 1.0), 0.0);
        let stages: Vec<f64> = [0.1, 0.3, 0.6, 0.9].iter().map(|l| browning(0.0, ZERO_C + 160.0, *l)).collect();
        assert_eq!(stages, [0.25, 0.5, 0.75, 1.0]);
        assert_eq!(browning(0.75, ZERO_C + 160.0, 0.1), 0.75);
    }
}
