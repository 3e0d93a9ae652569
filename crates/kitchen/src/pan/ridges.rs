//! Ridges of a grill pan: food lies on their tops and spans the grooves, in which liquids flow.
//!
//! The floor of such a pan is the plane of the tops. Ridges run along the pan's y axis; the centre line of one passes
//! through the pan's centre. The mesh of a piece is as coarse as the ridges, so every patch has the mean conductance:
//! h = s h_top + (1 − s) (h_gap + h_radiation) with s = width / pitch, h_gap by the gap law across the ridge's height.

use saute_food::water::air_film::radiation_coefficient;

use crate::pan::pan_description::{PanDescription, RidgesData};
use crate::piece::contact::{FaceContact, PatchGap};
use crate::piece::contact_gap::ContactGap;

/// Normalisation 1 / (2 mean of sin¹⁰ over all directions) [-], with which the faces of a mesh together pass the flow
/// along the grooves.
const ALONG: f64 = 256.0 / 126.0;

/// Ridges in SI units.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ridges {
    /// Distance between the centre lines of neighbouring ridges [m].
    pub pitch: f64,
    /// Width of their tops [m].
    pub width: f64,
    /// Height of their tops above the plate between them [m].
    pub height: f64,
}

/// Surfaces that exchange radiation across a groove.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct AcrossGroove {
    /// Emissivities of pan and food [-].
    pub emissivity: [f64; 2],
    /// Temperatures of pan and food [K].
    pub temperature: [f64; 2],
}

impl Ridges {
    /// Converts the description of a pan's ridges to SI units.
    pub fn of(data: &RidgesData) -> Self {
        let [pitch, width, height] = [data.pitch_mm, data.width_mm, data.height_mm].map(|v| 1e-3 * v);
        Self { pitch, width, height }
    }

    /// Area share of the tops [-].
    pub fn share(&self) -> f64 {
        self.width / self.pitch
    }

    /// Equivalent thickness of the ridges' metal, averaged over the floor [m].
    pub fn spread_out(&self) -> f64 {
        self.share() * self.height
    }

    /// Indentation into flesh of an elastic modulus [Pa] under the pressure on their tops [Pa]: that of a flat punch of
    /// their width, at most half their width (chosen: flesh is no half space beyond) [m].
    pub fn pressed_in(&self, pressure: f64, modulus: f64) -> f64 {
        (pressure * self.width / modulus).min(0.5 * self.width)
    }

    /// Mean contact conductance to a patch over tops and grooves, given the one on the tops [W/(m²·K)].
    pub fn mixed(&self, top: f64, gap: &ContactGap, face: &FaceContact, patch: &PatchGap, over: &AcrossGroove) -> f64 {
        let share = self.share();
        share * top + (1.0 - share) * self.over_groove(gap, face, patch, over)
    }

    /// Conductance from the bottom of a groove to the part of a patch over it [W/(m²·K)].
    pub fn over_groove(&self, gap: &ContactGap, face: &FaceContact, patch: &PatchGap, over: &AcrossGroove) -> f64 {
        // Oil is at the bottom of the groove, and a coating conducts better than the gap.
        let dry = FaceContact { film: 0.0, ..*face };
        let [pan, food] = over.emissivity;
        let emissivity = 1.0 / (1.0 / pan + 1.0 / food - 1.0);
        let radiation = radiation_coefficient(emissivity, over.temperature[0], over.temperature[1]);
        let deep = PatchGap { thickness: patch.thickness + self.height, wetness: 0.0, ..*patch };
        dry.conductance(gap, &deep) + radiation
    }

    /// Factor on the width of a face of the floor for a liquid of mean `thickness` [m] and surface slope `slope` [-];
    /// `across` is the squared cosine between the edge and the direction across the ridges [-].
    ///
    /// Along a groove the depth is 1/(1 − s) times the mean over a share 1 − s of the width, and u ∝ h²: 1/(1 − s)².
    /// Across the ridges nothing flows until the liquid overtops the next ridge; then it flows as on a plain floor. Faces
    /// of a mesh have all directions: weighted by the eighth power of their sine they pass a ninth as much across as
    /// along.
    pub fn widening(&self, across: f64, thickness: f64, slope: f64) -> f64 {
        let open = 1.0 - self.share();
        let squared = (1.0 - across) * (1.0 - across);
        let along = ALONG * squared * squared / (open * open);
        let over = thickness / open + slope * self.pitch > self.height;
        if over { along.max(1.0) } else { along }
    }
}

impl PanDescription {
    /// Thickness of the metal that stores heat in floor or wall [m]: ridges store heat but do not conduct along the floor.
    pub(crate) fn storing(&self, is_floor: bool) -> f64 {
        let ridges = self.ridges.as_ref().filter(|_| is_floor);
        self.conducting(is_floor) + ridges.map_or(0.0, |ridges| Ridges::of(ridges).spread_out())
    }
}
