//! Ridges of a grill pan: food lies on their tops and hangs over the grooves between them, in which liquids run.
//!
//! The floor of such a pan is the plane of the tops; ridges run along the pan's y, the middle of one through its centre.
//! The mesh of a piece is as coarse as the ridges, so every patch takes the mixture of both, whatever its place:
//! h = s h_top + (1 − s) (h_gap + h_radiation) with s = width / pitch, h_gap by the gap law across the ridge's height.

use saute_food::air_film::radiation_coefficient;

use crate::data::room::ContactGap;
use crate::pan::pan_description::RidgesData;
use crate::piece::contact::FaceContact;

/// One over twice the mean of sin¹⁰ over all directions [-]: what makes the faces of a mesh pass as much along the grooves as
/// they should together.
const ALONG: f64 = 256.0 / 126.0;

/// Ridges in SI units.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ridges {
    /// Distance from the middle of one to that of the next [m].
    pub pitch: f64,
    /// Width of their tops [m].
    pub width: f64,
    /// Height of their tops above the plate between them [m].
    pub height: f64,
}

/// What radiates across a groove.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct AcrossGroove {
    /// Emissivities of pan and food [-].
    pub emissivity: [f64; 2],
    /// Temperatures of pan and food [K].
    pub temperature: [f64; 2],
}

impl Ridges {
    /// From a pan's file.
    pub fn of(data: &RidgesData) -> Self {
        let [pitch, width, height] = [data.pitch_mm, data.width_mm, data.height_mm].map(|v| 1e-3 * v);
        Self { pitch, width, height }
    }

    /// Share of the floor that is ridge [-].
    pub fn share(&self) -> f64 {
        self.width / self.pitch
    }

    /// Metal of the ridges, spread out over the floor [m].
    pub fn spread_out(&self) -> f64 {
        self.share() * self.height
    }

    /// How deep they press into flesh of an elastic modulus [Pa] under the pressure on their tops [Pa]: that of a flat punch as
    /// wide as they are, and no deeper than half of their width (chosen: beyond that flesh is no half space) [m].
    pub fn pressed_in(&self, pressure: f64, modulus: f64) -> f64 {
        (pressure * self.width / modulus).min(0.5 * self.width)
    }

    /// Mean conductance to a face `distance` above the tops, given that on the tops [W/(m²·K)].
    pub fn mixed(&self, top: f64, gap: &ContactGap, face: &FaceContact, distance: f64, over: &AcrossGroove) -> f64 {
        // Oil lies at the bottom of the groove, and a coating passes more than the gap does.
        let dry = FaceContact { film: 0.0, ..*face };
        let [pan, food] = over.emissivity;
        let emissivity = 1.0 / (1.0 / pan + 1.0 / food - 1.0);
        let radiation = radiation_coefficient(emissivity, over.temperature[0], over.temperature[1]);
        let share = self.share();
        share * top + (1.0 - share) * (dry.conductance(gap, distance + self.height) + radiation)
    }

    /// Widening of a face of the floor that liquid `thickness` thick on the mean [m] passes, which runs across the ridges
    /// with the share `across` of its direction, where its surface falls by `slope` [-].
    ///
    /// Along a groove the liquid stands 1/(1 − s) as high over a share 1 − s of the width, and u ∝ h²: 1/(1 − s)². Across,
    /// nothing passes until the liquid reaches over the next ridge; then it runs as on a plain floor. Faces of a mesh look in
    /// all directions: weighted by the eighth power of their sine they pass a ninth as much across as along.
    pub fn widening(&self, across: f64, thickness: f64, slope: f64) -> f64 {
        let open = 1.0 - self.share();
        let squared = (1.0 - across) * (1.0 - across);
        let along = ALONG * squared * squared / (open * open);
        let over = thickness / open + slope * self.pitch > self.height;
        if over { along.max(1.0) } else { along }
    }
}
