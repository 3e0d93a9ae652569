//! Views: which field the colours of a picture show.

use saute_kitchen::celsius;
use saute_kitchen::food::{FoodModel, FoodState, Scale};

use crate::colour::map::{ColourMap, TemperatureMap, doneness_map};
use crate::colour::path::ColourPath;

/// A view of the food: its look, or one field.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, serde::Deserialize, serde::Serialize)]
#[serde(rename_all = "lowercase")]
pub enum View {
    /// As the eye sees it.
    #[default]
    Look,
    /// Temperature now.
    Temperature,
    /// Water left, of what the raw food held there.
    Moisture,
    /// Doneness in the words of each food: by the highest temperature so far, or by what has changed.
    Doneness,
    /// Browning index.
    Browning,
    /// How far pathogens were killed.
    Lethality,
    /// Fat in the flesh.
    Marbling,
}

/// Water shown at most [% of the raw water] (chosen: juice that is on its way out through dried flesh, and no more).
const MOST_WATER_PCT: f64 = 110.0;
/// Log₁₀ reduction shown at most (chosen: past every standard that asks for a number).
pub const MOST_KILLED: f64 = 8.0;

impl View {
    /// All views, in the order of their keys 1 to 7.
    pub const ALL: [Self; 7] = [
        Self::Look,
        Self::Temperature,
        Self::Moisture,
        Self::Doneness,
        Self::Browning,
        Self::Lethality,
        Self::Marbling,
    ];

    /// The map that colours this view; none for the look. Doneness of a food about which no scale says anything is the
    /// highest temperature so far.
    pub fn colour_map(self, temperature: TemperatureMap, scale: Option<&Scale>) -> Option<ColourMap> {
        Some(match self {
            Self::Look => return None,
            Self::Temperature => temperature.map(),
            Self::Moisture => ColourMap::along(ColourPath::Water, 0.0, MOST_WATER_PCT),
            Self::Doneness => scale.map_or_else(|| temperature.map(), doneness_map),
            Self::Browning => ColourMap::along(ColourPath::Browning, 0.0, 1.0),
            Self::Lethality => ColourMap::along(ColourPath::Kill, 0.0, MOST_KILLED),
            Self::Marbling => ColourMap::along(ColourPath::Fat, 0.0, 90.0),
        })
    }

    /// The field that this view colours, on the nodes, in the unit of its map; of the look the temperature. Doneness is
    /// the highest temperature so far, or the share of a change where the map shows that.
    pub fn value(self, model: &FoodModel, state: &FoodState, node: usize, change: Option<&str>) -> f64 {
        match self {
            Self::Look | Self::Temperature => celsius(state.temperature[node]),
            Self::Moisture => 100.0 * state.water[node] / model.initial_water()[node],
            Self::Doneness => match change.and_then(|name| model.kinetics().change.iter().position(|c| c.name == name))
            {
                Some(place) => 100.0 * state.changed[place][node],
                None => celsius(state.peak[node].max(state.temperature[node])),
            },
            Self::Browning => state.browning[node],
            // Grows tenfold every few kelvin: beyond the end of the map it would drown its neighbours.
            Self::Lethality => state.lethality[node].min(MOST_KILLED),
            Self::Marbling => {
                let [water, solids, fat] = model.masses(state, node);
                100.0 * fat / (water + solids + fat)
            }
        }
    }

    /// Returns true if its map is that of temperatures.
    pub fn is_of_temperature(self, scale: Option<&Scale>) -> bool {
        self == Self::Temperature || (self == Self::Doneness && scale.is_none())
    }

    /// Values worth a mark in its legend, those that are named first where room is short, in the unit of the field.
    pub fn marks(self) -> &'static [f64] {
        match self {
            // Freezing, myosin, rare, medium, well done, boiling, quick browning, deep frying, smoke.
            Self::Look | Self::Temperature | Self::Doneness => {
                &[0.0, 40.0, 52.0, 60.0, 71.0, 100.0, 140.0, 180.0, 220.0]
            }
            Self::Moisture => &[0.0, 25.0, 50.0, 75.0, 100.0],
            Self::Browning => &[0.0, 0.25, 0.5, 0.75, 1.0],
            // 90 %, what is asked of juice and ready meals, of beef, and the end.
            Self::Lethality => &[0.0, 1.0, 3.0, 5.0, 6.5, 8.0],
            Self::Marbling => &[0.0, 10.0, 20.0, 40.0, 60.0, 80.0],
        }
    }
}
