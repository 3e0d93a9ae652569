//! A condition on the pan or on foods, for `when` and `until`.

use serde_json::{Value, json};

use crate::action::tidy;
use crate::recipe::{ALL, Quantity, Target};
use saute_kitchen::celsius;
use saute_kitchen::kitchen::Kitchen;

/// A condition: a measured quantity is above or below a value.
///
/// Of several foods each must have met it since the condition is looked at; the last one counts.
#[derive(Clone, Debug, PartialEq)]
pub struct Condition {
    /// What is measured.
    pub measured: Measured,
    /// Side of the value on which it must be.
    pub side: Side,
    /// Value [K, kg].
    pub value: f64,
    /// True if the recipe has a bare number, whose side follows from the quantity.
    pub plain: bool,
}

/// What a condition measures.
#[derive(Clone, Debug, PartialEq)]
pub enum Measured {
    /// Mean temperature of the pan's floor [K].
    Pan,
    /// A quantity of each food of a target [K, kg].
    Food {
        /// Foods.
        food: Target,
        /// Quantity.
        quantity: Quantity,
    },
}

/// Side of a value.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Side {
    /// At the value or above it.
    Above,
    /// At the value or below it.
    Below,
}

impl Side {
    /// Returns the side as a recipe writes it: `above`.
    pub fn name(self) -> &'static str {
        match self {
            Self::Above => "above",
            Self::Below => "below",
        }
    }
}

impl Measured {
    /// Returns the key of the quantity in a recipe: `core_c`.
    pub fn key(&self) -> &'static str {
        match self {
            Self::Pan => "pan_c",
            Self::Food { quantity, .. } => quantity.key(),
        }
    }

    /// Returns the side that a bare number means: temperatures rise, masses fall.
    pub fn plain_side(&self) -> Side {
        match self {
            Self::Food { quantity: Quantity::Mass, .. } => Side::Below,
            Self::Pan | Self::Food { .. } => Side::Above,
        }
    }

    /// Returns a value in the unit of the key [°C, g].
    fn shown(&self, value: f64) -> f64 {
        match self {
            Self::Food { quantity: Quantity::Mass, .. } => tidy(value * 1e3),
            Self::Pan | Self::Food { .. } => tidy(celsius(value)),
        }
    }
}

impl Condition {
    /// Returns the measured values: one for the pan, one for each food [K, kg].
    pub fn values(&self, kitchen: &Kitchen) -> Vec<f64> {
        match &self.measured {
            Measured::Pan => vec![kitchen.pan_temperature()],
            Measured::Food { food, quantity } => {
                food.foods.iter().map(|id| kitchen.piece(id).map_or(f64::NAN, |p| quantity.of(p))).collect()
            }
        }
    }

    /// Returns the condition in the units of the recipe, as JSON.
    pub fn json(&self) -> Value {
        let mut side = serde_json::Map::new();
        side.insert(self.side.name().to_owned(), self.measured.shown(self.value).into());
        match &self.measured {
            Measured::Pan => json!({ "pan_c": side }),
            Measured::Food { food, quantity } => json!({ "food": food.name, quantity.key(): side }),
        }
    }

    /// Returns the condition in English: `the core of steak reaches 52 °C`.
    pub fn words(&self) -> String {
        let shown = self.measured.shown(self.value);
        let verb = if self.side == Side::Above { "reaches" } else { "falls to" };
        let Measured::Food { food, quantity } = &self.measured else {
            return format!("the pan {verb} {shown:.0} °C");
        };
        let name = match (food.group, food.name.as_str()) {
            (true, ALL) => "every food".to_owned(),
            (true, group) => format!("each of {group}"),
            (false, food) => food.to_owned(),
        };
        match quantity {
            Quantity::Mass if self.side == Side::Above => format!("{name} weighs {shown:.0} g or more"),
            Quantity::Mass => format!("{name} weighs {shown:.0} g"),
            Quantity::Core => format!("the core of {name} {verb} {shown:.0} °C"),
            Quantity::Top => format!("the top of {name} {verb} {shown:.0} °C"),
            Quantity::Bottom => format!("the underside of {name} {verb} {shown:.0} °C"),
        }
    }

    /// Returns the warning on a bare number that is passed when the condition is first looked at, in a step on a line of
    /// the recipe. Recipes for older versions meant a fall there.
    pub(crate) fn warning(&self, line: usize) -> String {
        let (key, value) = (self.measured.key(), self.measured.shown(self.value));
        format!(
            "line {line}: {key} = {value} is already exceeded when this step is reached, so the step goes ahead at once; \
             to wait until it has fallen, write {key} = {{ below = {value} }}, otherwise {key} = {{ above = {value} }}"
        )
    }
}
