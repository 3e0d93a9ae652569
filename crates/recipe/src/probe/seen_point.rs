//! A point in the flesh, by the nodes of its mesh.

use std::sync::Arc;

use saute_kitchen::food::FoodModel;
use saute_kitchen::{Kitchen, Piece};

/// A point of a piece, as shares of its nodes: the mesh's own shape functions, so that it stays where it is in the
/// flesh however the flesh contracts, and any field is read there as the picture shows it.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct NodeShares(pub Vec<(u32, f64)>);

impl NodeShares {
    /// Value of a node field at the point, in the field's unit.
    pub fn read(&self, field: impl Fn(usize) -> f64) -> f64 {
        self.0.iter().map(|&(node, share)| share * field(node as usize)).sum()
    }

    /// Adds a share of another point.
    pub fn add(&mut self, other: &Self, share: f64) {
        self.0.extend(other.0.iter().map(|&(node, w)| (node, w * share)));
    }
}

/// The point of a piece that a place in the picture shows.
#[derive(Clone, Debug)]
pub struct SeenPoint {
    /// The piece.
    pub piece: String,
    /// Its place in the flesh.
    pub shares: NodeShares,
    /// The model whose nodes those are.
    pub model: Arc<FoodModel>,
}

impl SeenPoint {
    /// Returns the piece, while it is the one that was seen.
    pub fn piece<'a>(&self, kitchen: &'a Kitchen) -> Option<&'a Piece> {
        kitchen.piece(&self.piece).filter(|p| Arc::ptr_eq(&p.model, &self.model))
    }
}
