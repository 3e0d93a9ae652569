//! The rules of the 2013 Interactive Cooking Simulator, kept for comparison.
//!
//! Conduction follows line segments. A distance threshold decides on contact. All heat above the boiling point becomes latent
//! heat; there is no juice and no evaporation below boiling. Browning begins at 150 °C and follows the weight loss in four
//! stages. Nothing contracts. Source: Kato, Hasegawa, "Interactive Cooking Simulator", SIGGRAPH Asia 2013
//! `[@kato-hasegawa-2013]`.

use crate::ZERO_C;
use crate::body::form::Form;
use crate::components::{Components, Properties};
use crate::description::{FoodDescription, Kinetics};
use serde::{Deserialize, Serialize};

/// Physical rules of a piece.
#[derive(Clone, Copy, Debug, Default, Deserialize, PartialEq, Eq, Serialize)]
pub enum Rules {
    /// The full physics.
    #[default]
    #[serde(rename = "full")]
    Full,
    /// The rules of 2013.
    #[serde(rename = "2013")]
    Paper2013,
}

/// Resolution of a mesh.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Deserialize, Serialize)]
pub enum MeshSize {
    /// The default mesh, graded towards the surface.
    #[default]
    #[serde(rename = "default")]
    Default,
    /// As many vertices as the foods of 2013, evenly spaced.
    #[serde(rename = "2013")]
    Paper2013,
}

/// Rings of a section, each as (number of nodes, share of the radius).
pub type Rings = &'static [(usize, f64)];

/// Rings and levels: 18 × 3 = 54, 17 × 7 = 119, 17 × 5 = 85, 71 × 17 = 1207 and 84 × 10 = 840 vertices (tables of the
/// paper).
const CARROT: (Rings, usize) = (&[(12, 1.0), (5, 0.5), (1, 0.0)], 3);
const SHRIMP: (Rings, usize) = (&[(8, 1.0), (8, 0.5), (1, 0.0)], 7);
const LEEK: (Rings, usize) = (&[(11, 1.0), (5, 0.5), (1, 0.0)], 5);
const MARBLED: (Rings, usize) = (&[(28, 1.0), (21, 0.75), (14, 0.5), (7, 0.25), (1, 0.0)], 17);
const LEAN: (Rings, usize) = (&[(34, 1.0), (26, 0.75), (16, 0.5), (7, 0.25), (1, 0.0)], 10);

/// Returns rings and number of levels of a food's mesh of 2013.
pub fn mesh_of(description: &FoodDescription) -> (Rings, usize) {
    match description.form {
        Form::Coin | Form::Stick => CARROT,
        Form::Ring => LEEK,
        Form::Shrimp => SHRIMP,
        Form::Steak if description.marbling.is_some() => MARBLED,
        // The paper has no mesh for a closed surface, a patty or what is poured; a closed surface keeps its own.
        Form::Steak | Form::Patty | Form::Poured | Form::Mesh => LEAN,
    }
}

/// Boiling point of water [K].
pub const BOILING: f64 = ZERO_C + 100.0;
/// Temperature at which browning begins [K].
const BROWNS_FROM: f64 = ZERO_C + 150.0;
/// Number of stages of browning [-].
const STAGES: f64 = 4.0;

/// Returns the food without the physics that the rules of 2013 lack: juice, rendering, contraction, an insulating crust.
pub fn simplified(
    description: &FoodDescription,
    kinetics: &Kinetics,
    components: &Components,
) -> (FoodDescription, Kinetics) {
    let lean = &description.lean;
    let properties = Properties::new(components, lean, &description.fat_melting, None);
    let raw = properties.conductivity(&[lean.water, lean.lean_solids(), lean.fat], ZERO_C + 20.0);
    let (mut description, mut kinetics) = (description.clone(), kinetics.clone());
    kinetics.water_holding.release_per_s = 0.0;
    kinetics.fat_release.rate_per_s.fill(0.0);
    kinetics.shrinkage.across.clear();
    kinetics.shrinkage.along.clear();
    kinetics.shrinkage.least_volume = 1.0;
    description.crust.conductivity_w_mk = raw;
    description.anisotropy = None;
    description.freezing = None;
    if let Some(change) = description.colour.change_2013.take() {
        description.colour.change = change;
    }
    if let Some(sheaths) = &mut description.sheaths {
        sheaths.conductance_w_m2k = f64::INFINITY;
    }
    (description, kinetics)
}

/// Returns the browning of a point [-] at `temperature` [K] that has lost the share `lost` of its water [-].
///
/// Above 150 °C browning rises to the next quarter of the weight loss; it never falls.
///
/// ```
/// use saute_food::ZERO_C;
/// use saute_food::paper_2013::browning;
///
/// assert_eq!(browning(0.0, ZERO_C + 160.0, 0.3), 0.5);
/// assert_eq!(browning(0.0, ZERO_C + 140.0, 0.3), 0.0);
/// ```
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
