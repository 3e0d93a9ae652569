//! Composition of a vertical axis: layers of materials, thermal contacts, and a lumped plate.

use core::ops::RangeInclusive;

/// The connection between two neighbouring nodes of the vertical axis.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Between {
    /// Material of the layer with this index.
    Layer(usize),
    /// Thermal contact with this conductance [W/(m²·K)].
    Contact(f64),
}

/// The composition of a vertical axis, node by node from below.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Column {
    /// Connection of node i and node i + 1.
    pub between: Vec<Between>,
    /// Areal heat capacity of a plate lumped into the first node [J/(m²·K)].
    ///
    /// Valid for a small Biot number of the plate: it has one temperature, that of the node.
    pub plate: f64,
}

impl Column {
    /// Returns a column of one material with `nodes` nodes and no plate.
    pub fn uniform(nodes: usize) -> Self {
        Self { between: vec![Between::Layer(0); nodes.saturating_sub(1)], plate: 0.0 }
    }

    /// Returns the layers below and above a node; `None` outside the body and across a contact.
    pub fn layers_at(&self, node: usize) -> [Option<usize>; 2] {
        let layer = |link: Option<&Between>| match link {
            Some(Between::Layer(layer)) => Some(*layer),
            _ => None,
        };
        [node.checked_sub(1).and_then(|i| layer(self.between.get(i))), layer(self.between.get(node))]
    }

    /// Returns the nodes of the layer above `node`, or of the layer below it where there is none above.
    ///
    /// Between two contacts, as in a lumped plate, this is the node alone.
    pub fn layer_around(&self, node: usize) -> RangeInclusive<usize> {
        let [below, above] = self.layers_at(node);
        let Some(layer) = above.or(below) else { return node..=node };
        let belongs = |i: &usize| self.layers_at(*i).contains(&Some(layer));
        let count = self.between.len() + 1;
        let first = (0..count).find(belongs).unwrap_or(node);
        let last = (0..count).rev().find(belongs).unwrap_or(node);
        first..=last
    }
}
