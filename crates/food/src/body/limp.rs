//! Bending of a long body under its own weight: a raw shrimp lies flat along its length, a raw carrot rests on two points.

use std::f64::consts::PI;

use saute_heat::Layout;
use serde::{Deserialize, Serialize};

use crate::GRAVITY;
use crate::model::FoodModel;
use crate::state::FoodState;

/// Gap up to which a station carries weight [m] (chosen: the flattening of round flesh under its own weight).
const CARRIES: f64 = 0.1e-3;

/// Beam model of a body along its stations: Euler–Bernoulli bending under its own weight.
#[derive(Clone, Debug, Deserialize, PartialEq, Serialize)]
pub struct Limp {
    nodes_per_level: usize,
    /// Positions of the stations along the path [m].
    along: Vec<f64>,
    /// Weight per length over eight times the bending rigidity, w/(8EI) [1/m³]: a cantilever of length d deflects by
    /// w d⁴/(8EI).
    weight_over_rigidity: f64,
}

impl FoodModel {
    /// Returns the beam model of a body along stations, or none for other bodies.
    ///
    /// Rigidity E I = E A²/4π with the relaxed elastic modulus E and a round section of the mean area A.
    pub fn limp(&self, state: &FoodState) -> Option<Limp> {
        let Layout::Along(mesh, _) = self.shape.mesh.layout() else { return None };
        let length = mesh.thickness();
        let area = mesh.graph.volume.iter().sum::<f64>() / length;
        let modulus = 1e3 * self.elastic_modulus_kpa(state) * self.kinetics.texture.relaxed_share;
        let weight = GRAVITY * state.mass(self) / length;
        Some(Limp {
            nodes_per_level: mesh.nodes_per_level(),
            along: mesh.levels.clone(),
            weight_over_rigidity: weight / (8.0 * modulus * area * area / (4.0 * PI)),
        })
    }
}

impl Limp {
    /// Returns true if it has the stations of a model.
    pub fn fits(&self, model: &FoodModel) -> bool {
        let Layout::Along(mesh, _) = model.shape.mesh.layout() else { return false };
        self.nodes_per_level == mesh.nodes_per_level() && self.along.len() == mesh.levels.len()
    }

    /// Index of the station of a node.
    pub fn station(&self, node: u32) -> usize {
        node as usize / self.nodes_per_level
    }

    /// Number of stations.
    pub fn stations(&self) -> usize {
        self.along.len()
    }

    /// Returns the gaps that are left under the stations after the body has bent under its weight [m].
    ///
    /// Stations that touch down pull the stations between them along, until the free spans carry their own weight. The gap
    /// of a station with nothing below it is ∞.
    pub fn settled(&self, mut gaps: Vec<f64>) -> Vec<f64> {
        let least = gaps.iter().copied().fold(f64::INFINITY, f64::min);
        if !least.is_finite() {
            return gaps;
        }
        let mut lying: Vec<Option<f64>> =
            gaps.iter().map(|gap| Some(gap - least).filter(|over| *over <= CARRIES)).collect();
        let mut drops = vec![0.0; gaps.len()];
        loop {
            self.drop(&lying, &mut drops);
            // The station that moves farthest beyond its gap touches down first.
            let beyond = |i: usize| drops[i] - (gaps[i] - least);
            let hanging = (0..gaps.len()).filter(|&i| lying[i].is_none() && beyond(i) >= 0.0);
            let Some(station) = hanging.max_by(|&a, &b| beyond(a).total_cmp(&beyond(b))) else { break };
            lying[station] = Some(gaps[station] - least);
        }
        gaps.iter_mut().zip(drops).for_each(|(gap, drop)| *gap -= drop);
        gaps
    }

    /// Computes how far each station moves down between its supports: interpolated between them, plus the deflection of a
    /// free end [m].
    fn drop(&self, lying: &[Option<f64>], drops: &mut [f64]) {
        let mut before: Option<(f64, f64)> = None;
        let mut next = 0;
        for (station, drop) in drops.iter_mut().enumerate() {
            let here = self.along[station];
            if let Some(lies) = lying[station] {
                (before, *drop) = (Some((here, lies)), lies);
                continue;
            }
            while next < lying.len() && (next <= station || lying[next].is_none()) {
                next += 1;
            }
            let after = lying.get(next).copied().flatten().map(|lies| (self.along[next], lies));
            *drop = match (before, after) {
                (Some((a, from)), Some((b, tfrom))) => {
                    let share = (here - a) / (b - a);
                    from + share * (tfrom - from) + self.give((here - a).min(b - here))
                }
                (Some((at, lies)), None) | (None, Some((at, lies))) => lies + self.give((here - at).abs()),
                (None, None) => 0.0,
            };
        }
    }

    /// Deflection of a free end that extends `reach` beyond its support [m].
    fn give(&self, away: f64) -> f64 {
        self.weight_over_rigidity * away * away * away * away
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A rod of 60 mm whose free end gives by `give` when the other is held.
    fn rod(give: f64) -> Limp {
        let along: Vec<f64> = (0..13).map(|i| 0.005 * f64::from(i)).collect();
        Limp { nodes_per_level: 10, along, weight_over_rigidity: give / 0.06f64.powi(4) }
    }

    fn wedge(limp: &Limp) -> Vec<f64> {
        limp.along.iter().map(|s| 0.05 * s).collect()
    }

    #[test]
    fn a_limp_rod_lies_with_all_its_length_and_a_stiff_one_stays_as_it_is() {
        let limp = rod(50.0);
        let left = limp.settled(wedge(&limp));
        assert!(left.iter().all(|gap| *gap <= CARRIES), "{left:?}");
        let stiff = rod(1e-6);
        let left = stiff.settled(wedge(&stiff));
        assert!(left.iter().zip(wedge(&stiff)).all(|(now, before)| before - now < 2e-6), "{left:?}");
    }

    #[test]
    fn an_end_gives_as_a_cantilever_does() {
        let limp = rod(1e-3);
        let left = limp.settled(wedge(&limp));
        // Its 3 mm less a give of 1 mm.
        assert!((left[12] - 2e-3).abs() < 1e-9, "{left:?}");
    }

    #[test]
    fn nothing_gives_where_nothing_lies() {
        let limp = rod(1.0);
        assert!(limp.settled(vec![f64::INFINITY; 13]).iter().all(|gap| gap.is_infinite()));
    }
}
