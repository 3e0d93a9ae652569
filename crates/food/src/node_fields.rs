//! The fields of a piece's nodes by name, with units, for whoever writes or shows them all.

use std::borrow::Cow;

use crate::ZERO_C;
use crate::model::FoodModel;
use crate::state::FoodState;

/// A field of the nodes of a body.
#[derive(Clone, Debug, PartialEq)]
pub struct NodeField<'a> {
    /// Name, with the unit at its end if there is one.
    pub name: String,
    /// Unit, as `°C`; empty where there is none.
    pub unit: &'static str,
    /// True for an amount per node, so that the sum over all nodes is the body's; false for a value at a point.
    pub is_amount: bool,
    /// A value for each node.
    pub values: Cow<'a, [f64]>,
}

impl<'a> NodeField<'a> {
    /// Returns a field of what nodes hold.
    pub fn amount(name: &str, unit: &'static str, values: &'a [f64]) -> Self {
        Self { name: name.to_owned(), unit, is_amount: true, values: Cow::Borrowed(values) }
    }

    /// Returns a field of values at points.
    pub fn point(name: &str, unit: &'static str, values: &'a [f64]) -> Self {
        Self { name: name.to_owned(), unit, is_amount: false, values: Cow::Borrowed(values) }
    }

    /// Returns a field of values at points that were computed.
    pub fn computed(name: &str, unit: &'static str, values: Vec<f64>) -> Self {
        Self { name: name.to_owned(), unit, is_amount: false, values: Cow::Owned(values) }
    }

    /// Returns a field of temperatures [°C], from those in [K].
    pub fn celsius(name: &str, kelvin: &[f64]) -> Self {
        Self::computed(name, "°C", kelvin.iter().map(|t| t - ZERO_C).collect())
    }
}

impl FoodModel {
    /// Returns all fields of a piece, in a fixed order; those of its changes come last, as `changed.myosin`.
    pub fn node_fields<'a>(&'a self, state: &'a FoodState) -> Vec<NodeField<'a>> {
        let of_nodes = |value: &dyn Fn(usize) -> f64| (0..state.temperature.len()).map(value).collect::<Vec<f64>>();
        let left = of_nodes(&|node| 100.0 * state.water[node] / self.initial_water()[node]);
        let mut fields = vec![
            NodeField::celsius("temperature_c", &state.temperature),
            NodeField::point("temperature_k", "K", &state.temperature),
            NodeField::celsius("peak_c", &state.peak),
            NodeField::point("peak_k", "K", &state.peak),
            NodeField::amount("enthalpy_j", "J", &state.enthalpy),
            NodeField::amount("water_kg", "kg", &state.water),
            NodeField::amount("raw_water_kg", "kg", self.initial_water()),
            NodeField::computed("water_pct", "%", left),
            NodeField::amount("juice_kg", "kg", &state.juice),
            NodeField::amount("rising_kg", "kg", &state.rising),
            NodeField::amount("fat_kg", "kg", &state.fat),
            NodeField::amount("lean_solids_kg", "kg", self.lean_solids()),
            NodeField::amount("volume_m3", "m³", self.mesh().volumes()),
            NodeField::point("browning", "", &state.browning),
            NodeField::point("charring", "", &state.charring),
            NodeField::point("lethality", "", &state.lethality),
            NodeField::point("oiled", "", &state.oiled),
            NodeField::point("stretch", "", &state.stretch.axial),
            NodeField::point("adipose", "", self.adipose()),
            NodeField::point("second_tissue", "", self.second_tissue()),
            NodeField::computed("modulus_kpa", "kPa", of_nodes(&|node| self.node_modulus_kpa(state, node))),
        ];
        let changes = self.kinetics().names().into_iter().zip(&state.changed);
        fields.extend(changes.map(|(name, share)| NodeField::point(&format!("changed.{name}"), "", share)));
        fields
    }
}
