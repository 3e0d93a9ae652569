//! What lies between the nodes of a vertical axis: layers of materials, contacts, and lumped plates.

use core::ops::RangeInclusive;

/// What joins two neighbouring nodes of the vertical axis.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Between {
    /// A piece of this layer.
    Layer(usize),
    /// A contact of this conductance [W/(m²·K)].
    Contact(f64),
}

/// The make-up of a vertical axis.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Column {
    /// What joins node i and the next.
    pub between: Vec<Between>,
    /// Heat capacity of a plate, thin for its conductance, that shares the first node's temperature [J/(m²·K)].
    pub plate: f64,
}

impl Column {
    /// One material over `nodes` nodes.
    pub fn uniform(nodes: usize) -> Self {
        Self { between: vec![Between::Layer(0); nodes.saturating_sub(1)], plate: 0.0 }
    }

    /// Layer below and above a node, none outside the body and across a contact.
    pub fn layers_at(&self, node: usize) -> [Option<usize>; 2] {
        let layer = |link: Option<&Between>| match link {
            Some(Between::Layer(layer)) => Some(*layer),
            _ => None,
        };
        [node.checked_sub(1).and_then(|i| layer(self.between.get(i))), layer(self.between.get(node))]
    }

    /// Nodes of the layer that reaches up from `node`, or down from it where none does; the node alone in a plate.
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
