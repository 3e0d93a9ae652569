//! Tables and paths of the water and fat that leave a piece.

use crate::ZERO_C;
use crate::body::rest_shape::RestShape;
use crate::change::changes::arrhenius;
use crate::description::{Effects, FoodDescription, Kinetics, NoSuchChange, WaterHolding};
use crate::paper_2013::{BOILING, Rules};
use crate::table::Table;
use crate::water::fat::FatRates;
use crate::water::juice::juice_outlets;
use crate::water::juice_way::juice_ways;
use crate::water::sorption::Isotherm;
use crate::water::vapour::saturation_density;

/// Sorption, water holding, rendering rates and the paths of juice in one piece.
#[derive(Clone, Debug)]
pub(crate) struct WaterTransport {
    pub(crate) isotherm: Isotherm,
    /// Density of saturated vapour against temperature [kg/m³].
    pub(crate) vapour: Table,
    /// Share of the raw water that is still held against temperature [-].
    pub(crate) held: Table,
    /// Rate at which water that is no longer held becomes free juice, against temperature [1/s].
    pub(crate) release: Table,
    /// Share of the raw water that each complete change squeezes out at least [-].
    pub(crate) squeeze: Effects,
    pub(crate) fat_rates: FatRates,
    /// Nodes from which juice runs off, with their area [m²].
    pub(crate) outlets: Vec<(u32, f64)>,
    /// Steps of juice in a body of cells, outermost first: from a node to the next one outwards, and their distance [m].
    pub(crate) outwards: Vec<(u32, u32, f64)>,
}

impl WaterTransport {
    /// Tabulates the rates and finds the paths of juice.
    pub(crate) fn new(
        food: &FoodDescription,
        kinetics: &Kinetics,
        rules: Rules,
        shape: &RestShape,
    ) -> Result<Self, NoSuchChange> {
        let holding = &kinetics.water_holding;
        let fibres = food.mesh.as_ref().and_then(|m| m.fibres);
        Ok(Self {
            isotherm: match rules {
                Rules::Full => Isotherm::new(&food.sorption),
                Rules::Paper2013 => Isotherm::free_water(BOILING),
            },
            vapour: Table::new(250.0, 380.0, 0.5, saturation_density),
            held: Table::new(ZERO_C, ZERO_C + 120.0, 0.5, |t| held_share(holding, t - ZERO_C)),
            release: release(holding),
            squeeze: kinetics.effects("water_holding", &holding.change)?,
            fat_rates: FatRates::new(&kinetics.fat_release, &food.fat_melting, &shape.mesh),
            outlets: juice_outlets(shape),
            outwards: shape.mesh.cells().map(|cells| juice_ways(cells, fibres)).unwrap_or_default(),
        })
    }
}

impl WaterTransport {
    /// Adds an outlet of `area` [m²] to a node.
    pub(crate) fn open_outlet(&mut self, node: u32, area: f64) {
        match self.outlets.iter_mut().find(|outlet| outlet.0 == node) {
            Some(outlet) => outlet.1 += area,
            None => self.outlets.push((node, area)),
        }
    }

    /// Removes the steps of juice between nodes on different sides of a cut.
    pub(crate) fn part(&mut self, beyond: &[bool]) {
        self.outwards.retain(|step| beyond[step.0 as usize] == beyond[step.1 as usize]);
    }
}

/// Rate of release, tabulated from 0 to 110 °C and held beyond [1/s].
fn release(holding: &WaterHolding) -> Table {
    let rate = arrhenius(holding.release_activation_energy_kj_mol, holding.release_anchor_c, holding.release_per_s);
    Table::new(ZERO_C, ZERO_C + 110.0, 0.5, rate)
}

/// Share of the raw water that is held, a sigmoid in temperature: 1 − drop / (1 + spread · exp(−slope (T − T_m))) [-].
fn held_share(holding: &WaterHolding, celsius: f64) -> f64 {
    1.0 - holding.drop / (1.0 + holding.spread * libm::exp(-holding.slope_per_k * (celsius - holding.middle_c)))
}
