//! What the colours of the picture mean.

use saute_kitchen::celsius;
use saute_kitchen::food::{FoodState, Scale};

use crate::colour_map::{ColourMap, TemperatureMap, doneness_map};

/// A way to look at the food.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, serde::Deserialize, serde::Serialize)]
#[serde(rename_all = "lowercase")]
pub enum View {
    /// As the eye sees it.
    #[default]
    Look,
    /// Temperature now.
    Temperature,
    /// Doneness by the highest temperature so far.
    Doneness,
}

impl View {
    /// All views, in the order of their keys 1, 2, 3.
    pub const ALL: [Self; 3] = [Self::Look, Self::Temperature, Self::Doneness];

    /// Name for people.
    pub fn name(self) -> &'static str {
        match self {
            Self::Look => "Look",
            Self::Temperature => "Temperature",
            Self::Doneness => "Doneness",
        }
    }

    /// The map that colours this view; none for the look. Doneness of a food about which no scale says anything is the
    /// highest temperature so far.
    pub fn colour_map(self, temperature: TemperatureMap, scale: Option<&Scale>) -> Option<ColourMap> {
        match self {
            Self::Look => None,
            Self::Temperature => Some(temperature.map()),
            Self::Doneness => Some(scale.map_or_else(|| temperature.map(), doneness_map)),
        }
    }

    /// The field that this view colours [°C], on the nodes.
    pub fn celsius(self, state: &FoodState, node: usize) -> f64 {
        match self {
            Self::Doneness => celsius(state.peak[node].max(state.temperature[node])),
            _ => celsius(state.temperature[node]),
        }
    }
}
