//! Views: which field the colours of a picture show. Each is one row of a table.

use saute_kitchen::celsius;
use saute_kitchen::food::{FoodModel, FoodState, Scale};

use crate::colour::map::{ColourMap, TemperatureMap, doneness_map};
use crate::colour::path::ColourPath;

/// What a view is.
#[derive(Debug)]
pub struct ViewSpec {
    /// Name in files and on the command line.
    pub id: &'static str,
    /// What it shows, for the help of the command line.
    pub about: &'static str,
    /// Keys of its texts in the window: its name, what its colours mean, and what the key on the keyboard shows.
    pub texts: [&'static str; 3],
    /// How its values are written.
    pub unit: Unit,
    /// Values worth a mark in its legend, those that are named first where room is short, in the unit of the field.
    pub marks: &'static [f64],
    colours: Colours,
    value: Value,
}

/// How the values of a view are written.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Unit {
    /// As a temperature.
    Temperature,
    /// As a class of doneness with its measure.
    Doneness,
    /// As a number in a text.
    Number {
        /// Key of the text.
        text: &'static str,
        /// Places after the point.
        places: usize,
        /// Where the field ends, and the key of the text for what is there.
        most: Option<(f64, &'static str)>,
    },
}

/// The colours of a view.
#[derive(Debug)]
enum Colours {
    Natural,
    Temperature,
    Doneness,
    /// A path of colours between two values.
    Along(ColourPath, [f64; 2]),
}

/// Value of a field at a node, given the change that measures doneness where one does.
type Value = fn(&FoodModel, &FoodState, usize, Option<&str>) -> f64;

/// Declares the views, each with its row.
macro_rules! views {
    ($($(#[$doc:meta])* $view:ident: $spec:expr,)*) => {
        /// A view of the food: its look, or one field.
        #[derive(Clone, Copy, Debug, Default, PartialEq, Eq, serde::Deserialize, serde::Serialize)]
        #[serde(rename_all = "lowercase")]
        pub enum View {
            $($(#[$doc])* $view,)*
        }

        impl View {
            /// All views, in the order of their keys from 1 on.
            pub const ALL: [Self; [$(stringify!($view)),*].len()] = [$(Self::$view),*];

            /// Its row of the table.
            pub fn spec(self) -> &'static ViewSpec {
                match self {
                    $(Self::$view => const { &$spec },)*
                }
            }
        }
    };
}

/// Water shown at most [% of the raw water] (chosen: juice that is on its way out through dried flesh, and no more).
const MOST_WATER_PCT: f64 = 110.0;
/// Log₁₀ reduction shown at most (chosen: past every standard that requires a number).
const MOST_KILLED: f64 = 8.0;
/// Freezing, myosin, rare, medium, well done, boiling, quick browning, deep frying, smoke [°C].
const TEMPERATURES_C: &[f64] = &[0.0, 40.0, 52.0, 60.0, 71.0, 100.0, 140.0, 180.0, 220.0];

views! {
    /// As the eye sees it; its field is the temperature.
    #[default]
    Look: ViewSpec {
        id: "look",
        about: "Appearance to the eye",
        texts: ["view.look", "meaning.look", "key.look"],
        unit: Unit::Temperature,
        marks: TEMPERATURES_C,
        colours: Colours::Natural,
        value: |_, state, node, _| celsius(state.temperature[node]),
    },
    /// Temperature now.
    Temperature: ViewSpec {
        id: "temperature",
        about: "Temperature now",
        texts: ["view.temperature", "meaning.temperature", "key.temperature"],
        unit: Unit::Temperature,
        marks: TEMPERATURES_C,
        colours: Colours::Temperature,
        value: |_, state, node, _| celsius(state.temperature[node]),
    },
    /// Water left, of what the raw food held there.
    Moisture: ViewSpec {
        id: "moisture",
        about: "Water content relative to the raw food",
        texts: ["view.moisture", "meaning.moisture", "key.moisture"],
        unit: Unit::Number { text: "value.moisture", places: 0, most: None },
        marks: &[0.0, 25.0, 50.0, 75.0, 100.0],
        colours: Colours::Along(ColourPath::Water, [0.0, MOST_WATER_PCT]),
        value: |model, state, node, _| 100.0 * state.water[node] / model.initial_water()[node],
    },
    /// Doneness in the words of each food: by the highest temperature so far, or by what has changed.
    Doneness: ViewSpec {
        id: "doneness",
        about: "Doneness by the highest temperature so far",
        texts: ["view.doneness", "meaning.doneness", "key.doneness"],
        unit: Unit::Doneness,
        marks: TEMPERATURES_C,
        colours: Colours::Doneness,
        value: doneness,
    },
    /// Browning index.
    Browning: ViewSpec {
        id: "browning",
        about: "Browning index",
        texts: ["view.browning", "meaning.browning", "key.browning"],
        unit: Unit::Number { text: "value.browning", places: 2, most: None },
        marks: &[0.0, 0.25, 0.5, 0.75, 1.0],
        colours: Colours::Along(ColourPath::Browning, [0.0, 1.0]),
        value: |_, state, node, _| state.browning[node],
    },
    /// How far pathogens were killed.
    Lethality: ViewSpec {
        id: "lethality",
        about: "Log reduction of pathogens",
        texts: ["view.lethality", "meaning.lethality", "key.lethality"],
        unit: Unit::Number { text: "value.lethality", places: 1, most: Some((MOST_KILLED, "value.lethality_at_least")) },
        // 90 %, what is required of juice and ready meals, of beef, and the end.
        marks: &[0.0, 1.0, 3.0, 5.0, 6.5, 8.0],
        colours: Colours::Along(ColourPath::Kill, [0.0, MOST_KILLED]),
        // Grows tenfold every few kelvin: beyond the end of the map it would drown its neighbours.
        value: |_, state, node, _| state.lethality[node].min(MOST_KILLED),
    },
    /// Fat in the flesh.
    Marbling: ViewSpec {
        id: "marbling",
        about: "Fat in the flesh",
        texts: ["view.marbling", "meaning.marbling", "key.marbling"],
        unit: Unit::Number { text: "value.marbling", places: 0, most: None },
        marks: &[0.0, 10.0, 20.0, 40.0, 60.0, 80.0],
        colours: Colours::Along(ColourPath::Fat, [0.0, 90.0]),
        value: fat_pct,
    },
}

impl View {
    /// The view with a name.
    pub fn of_id(id: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|view| view.spec().id == id)
    }

    /// The map that colours this view; none for the look. Doneness of a food to which no scale applies is the
    /// highest temperature so far.
    pub fn colour_map(self, temperature: TemperatureMap, scale: Option<&Scale>) -> Option<ColourMap> {
        match self.spec().colours {
            Colours::Natural => None,
            Colours::Temperature => Some(temperature.map()),
            Colours::Doneness => Some(scale.map_or_else(|| temperature.map(), doneness_map)),
            Colours::Along(path, [from, to]) => Some(ColourMap::along(path, from, to)),
        }
    }

    /// The field that this view colours, on the nodes, in the unit of its map; of the look the temperature. Doneness is
    /// the highest temperature so far, or the share of a change where the map shows that.
    pub fn value(self, model: &FoodModel, state: &FoodState, node: usize, change: Option<&str>) -> f64 {
        (self.spec().value)(model, state, node, change)
    }

    /// Returns true if its map is that of temperatures.
    pub fn is_of_temperature(self, scale: Option<&Scale>) -> bool {
        match self.spec().colours {
            Colours::Temperature => true,
            Colours::Doneness => scale.is_none(),
            Colours::Natural | Colours::Along(..) => false,
        }
    }
}

fn doneness(model: &FoodModel, state: &FoodState, node: usize, change: Option<&str>) -> f64 {
    match change.and_then(|name| model.kinetics().change.iter().position(|c| c.name == name)) {
        Some(place) => 100.0 * state.changed[place][node],
        None => celsius(state.peak[node].max(state.temperature[node])),
    }
}

fn fat_pct(model: &FoodModel, state: &FoodState, node: usize, _: Option<&str>) -> f64 {
    let [water, solids, fat] = model.masses(state, node);
    100.0 * fat / (water + solids + fat)
}

#[cfg(test)]
mod tests {
    use serde::Deserialize;
    use serde::de::IntoDeserializer;
    use serde::de::value::Error;

    use super::*;

    #[test]
    fn each_view_has_the_name_that_files_give_it_and_texts_of_that_name() {
        for view in View::ALL {
            let id = view.spec().id;
            let read: Result<View, Error> = View::deserialize(id.into_deserializer());
            assert_eq!(read, Ok(view));
            assert_eq!(View::of_id(id), Some(view));
            assert_eq!(view.spec().texts, ["view", "meaning", "key"].map(|section| format!("{section}.{id}")));
        }
        assert_eq!(View::of_id("taste"), None);
    }
}
