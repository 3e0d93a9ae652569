//! What a kitchen at home has otherwise than the hob's and the room's data: two factors that a fit finds.

use saute_food::description::Confidence;
use schemars::JsonSchema;
use serde::Deserialize;

use crate::data::room::Room;
use crate::pan::hob::HobDescription;

/// `data/kitchen-at-home.toml`: factors on the program's kitchen.
#[derive(Clone, Debug, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(title = "saute kitchen-at-home")]
pub struct KitchenAtHome {
    /// Factor on the hob's efficiency [-]; the efficiency is 1 at most.
    #[schemars(range(min = 0.3, max = 1.5), example = 0.93)]
    pub hob_factor: f64,
    /// Factor on the contact conductance between food and pan [-].
    #[schemars(range(min = 0.2, max = 5.0), example = 1.1)]
    pub contact_factor: f64,
    /// Source of the numbers.
    #[schemars(example = &"fitted to steak.csv")]
    pub source: String,
    /// Confidence in the numbers.
    #[schemars(example = &"medium")]
    pub confidence: Confidence,
}

impl Default for KitchenAtHome {
    fn default() -> Self {
        let source = "the program's kitchen".to_owned();
        Self { hob_factor: 1.0, contact_factor: 1.0, source, confidence: Confidence::High }
    }
}

impl KitchenAtHome {
    /// Sets the factors in the data of hob and room.
    ///
    /// The conductance of a gap that is not filled by the layer of steam is proportional to 1/gap and to that of the
    /// asperities; both get the factor. The layer of steam stays, as it follows from the load.
    pub fn set_in(&self, hob: &mut HobDescription, room: &mut Room) {
        hob.coil.efficiency = (self.hob_factor * hob.coil.efficiency).min(1.0);
        room.contact.gap_mm /= self.contact_factor;
        room.contact.settling_gap_mm /= self.contact_factor;
        room.contact.asperity_w_m2k *= self.contact_factor;
    }
}
