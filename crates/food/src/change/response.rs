//! The response of flesh to heat: rates of its changes and their effects on texture, shape and colour.

use crate::ZERO_C;
use crate::change::browning::Browning;
use crate::change::changes::ChangeRates;
use crate::change::colour::Palette;
use crate::description::{Effects, FoodDescription, Kinetics, Lethality, NoSuchChange};
use crate::table::Table;

/// Rates of the changes, and the contribution of each complete change to texture, shape and colour.
#[derive(Clone, Debug)]
pub(crate) struct HeatResponse {
    pub(crate) rates: ChangeRates,
    pub(crate) browning: Browning,
    /// Log₁₀ reduction of pathogens against temperature [1/s].
    pub(crate) lethality: Table,
    /// Contribution to the elastic modulus [kPa].
    pub(crate) modulus: Effects,
    /// Contribution to the hardness index [-].
    pub(crate) hardness: Effects,
    /// Contribution to the juiciness factor [-].
    pub(crate) juiciness: Effects,
    /// Contraction across and along the fibres [-].
    pub(crate) contraction: [Effects; 2],
    /// Difference of contraction between belly and back [-].
    pub(crate) curl: Effects,
    pub(crate) palette: Palette,
}

impl HeatResponse {
    /// Tabulates the rates and puts the contributions into the order of the changes.
    pub(crate) fn new(food: &FoodDescription, kinetics: &Kinetics) -> Result<Self, NoSuchChange> {
        let shrinkage = &kinetics.shrinkage;
        Ok(Self {
            rates: ChangeRates::new(kinetics),
            browning: Browning::new(&kinetics.browning, &kinetics.charring),
            lethality: lethality(&kinetics.lethality),
            modulus: kinetics.effects("texture", &kinetics.texture.change_kpa)?,
            hardness: kinetics.effects("hardness", &kinetics.hardness.change)?,
            juiciness: kinetics.effects("juiciness", &kinetics.juiciness.change)?,
            contraction: [
                kinetics.effects("shrinkage", &shrinkage.across)?,
                kinetics.effects("shrinkage", &shrinkage.along)?,
            ],
            curl: kinetics.curl.as_ref().map_or(Ok(Effects::default()), |c| kinetics.effects("curl", &c.change))?,
            palette: Palette::new(&food.colour, food.second_colour(), kinetics)?,
        })
    }
}

/// Rate of [`Lethality`], tabulated from 40 to 100 °C and held beyond (below nothing dies, above all is dead) [1/s].
fn lethality(data: &Lethality) -> Table {
    Table::new(ZERO_C + 40.0, ZERO_C + 100.0, 0.25, |t| data.rate_per_min(t - ZERO_C) / 60.0)
}
