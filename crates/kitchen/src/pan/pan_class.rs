//! What a hob assumes of the pan on it: the class of pan that was named to it, as rings of metal about the middle.

use core::f64::consts::PI;

use crate::pan::hob::{HobDescription, PanPose};
use crate::pan::pan_description::PanDescription;

/// Rings of the floor, and of floor and wall together [-] (chosen: 12 and 13 mm wide; the heated ring is 50 mm wide).
pub(crate) const FLOOR: usize = 8;
pub(crate) const RINGS: usize = 12;

/// A pan as its class describes it, in rings from the middle of the floor to the rim.
#[derive(Clone, Debug)]
pub(crate) struct PanClass {
    /// Areas; those of the wall are seen from one side [m²].
    pub(crate) areas: [f64; RINGS],
    /// Heat capacities [J/K].
    pub(crate) capacity: [f64; RINGS],
    /// Conductance to the next ring; 0 at the rim [W/K].
    pub(crate) links: [f64; RINGS],
    /// Shares of the hob's heat [-]; they sum to 1.
    pub(crate) shares: [f64; RINGS],
    /// Heat capacity of the floor [J/K].
    pub(crate) floor_capacity: f64,
    /// Area of the floor [m²].
    pub(crate) floor_area: f64,
}

impl PanClass {
    /// The class of a pan on a hob whose numbers are those of the pan times `hold.class_share`.
    pub(crate) fn of(pan: &PanDescription, hob: &HobDescription) -> Self {
        let radius = 1e-3 * pan.floor.radius_mm;
        let edge = |i: usize| match i.checked_sub(FLOOR) {
            None => radius * i as f64 / FLOOR as f64,
            Some(of_wall) => radius + pan.rise() * of_wall as f64 / (RINGS - FLOOR) as f64,
        };
        let middle = |i: usize| 0.5 * (edge(i) + edge(i + 1));
        let (metal, share) = (&pan.metal, hob.hold().map_or(1.0, |hold| hold.class_share));
        let areas: [f64; RINGS] = core::array::from_fn(|i| PI * (edge(i + 1) * edge(i + 1) - edge(i) * edge(i)));
        let volume_heat = share * metal.density_kg_m3 * metal.specific_heat_j_kgk;
        let capacity: [f64; RINGS] = core::array::from_fn(|i| areas[i] * pan.storing(i < FLOOR) * volume_heat);
        let link = |i: usize| {
            let thickness = 0.5 * (pan.conducting(i < FLOOR) + pan.conducting(i + 1 < FLOOR));
            let sheet = thickness * metal.conductivity_w_mk;
            share * sheet * 2.0 * PI * edge(i + 1) / (middle(i + 1) - middle(i))
        };
        let on_floor: [[f64; 2]; FLOOR] = core::array::from_fn(|i| [middle(i), 0.0]);
        let shares = hob.ring_shares(&on_floor, &areas[..FLOOR], &PanPose::default());
        Self {
            links: core::array::from_fn(|i| if i + 1 < RINGS { link(i) } else { 0.0 }),
            shares: core::array::from_fn(|i| shares.get(i).copied().unwrap_or(0.0)),
            floor_capacity: capacity[..FLOOR].iter().sum(),
            floor_area: areas[..FLOOR].iter().sum(),
            areas,
            capacity,
        }
    }

    /// Area mean over the floor of a quantity of each ring.
    pub(crate) fn floor_mean(&self, rings: &[f64; RINGS]) -> f64 {
        rings[..FLOOR].iter().zip(&self.areas).map(|(t, a)| t * a).sum::<f64>() / self.floor_area
    }

    /// Mean over the heated ring, as heat is made, of a quantity of each ring.
    pub(crate) fn heated_mean(&self, rings: &[f64; RINGS]) -> f64 {
        rings.iter().zip(&self.shares).map(|(t, share)| t * share).sum()
    }
}
