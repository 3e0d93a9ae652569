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
///
/// Steady heat flux through meat on a hot plate with a thermal contact between them, two resistances in series:
///
/// ```
/// use saute_heat::conduction::axis::{Axis, End};
/// use saute_heat::conduction::column::{Between, Column};
/// use saute_heat::conduction::product::{Constants, ProductOperator};
/// use saute_heat::conduction::super_step::Rates;
/// use saute_heat::conduction::tensor::TensorBody;
///
/// // Nodes 0 and 1 are the two sides of the contact; 10 mm of meat are above it.
/// let axis = Axis::straight(vec![0.0, 0.0, 5e-3, 10e-3]);
/// let between = vec![Between::Contact(400.0), Between::Layer(0), Between::Layer(0)];
/// let body = TensorBody::stacked(vec![axis], Some(0), Column { between, plate: 1e4 });
/// let meat = Constants { conductivity: 0.5, capacity: 3.7e6 };
/// let operator = ProductOperator::new(&body, &[meat], &[]);
///
/// let resistance = 1.0 / 400.0 + 0.01 / 0.5;
/// let flux_w_m2 = (473.0 - 293.0) / resistance;
/// let face_k = 473.0 - flux_w_m2 / 400.0;
/// let mut rate = [0.0; 4];
/// operator.rates(&[473.0, face_k, 0.5 * (face_k + 293.0), 293.0], &mut rate);
/// // The inner nodes are steady; the plate of 10 kJ/(m²·K) loses the flux.
/// assert!(rate[1].abs() < 1e-9 && rate[2].abs() < 1e-9);
/// assert!((-1e4 * rate[0] - 8000.0).abs() < 1e-6, "{} W/m²", -1e4 * rate[0]);
/// ```
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
