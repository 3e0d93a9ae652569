//! How long it takes to build pieces, judged before one is built.

use saute_food::{Body, BuildError, PieceSpec};

use crate::data::library::Library;
use crate::kitchen::PieceOrder;

/// Time for a node, and for one whose share of fat seams is integrated [s] (measured on a machine whose loop of the brick takes 13.5 ms:
/// 4 µs in steaks, 5 in shrimps, 9 in coins and rings; 28 in a marbled steak).
const PER_NODE_S: f64 = 5e-6;
const PER_MARBLED_NODE_S: f64 = 28e-6;
/// Time in a browser over that of the native program [-] (measured: 2.5 to 3).
const BROWSER: f64 = if cfg!(target_arch = "wasm32") { 3.0 } else { 1.0 };

/// Estimated time to build the models of pieces that are ordered [s]; 0 for food that the library lacks.
///
/// # Errors
///
/// If a food has no piece of that size.
pub fn building_s(library: &Library, orders: &[PieceOrder]) -> Result<f64, BuildError> {
    orders.iter().map(|order| one_s(library, order, &order.spec())).sum()
}

fn one_s(library: &Library, order: &PieceOrder, spec: &PieceSpec) -> Result<f64, BuildError> {
    let Some(food) = library.foods.get(&order.kind) else { return Ok(0.0) };
    let is_marbled = food.marbling.as_ref().is_some_and(|marbling| marbling.adipose_share > 0.0);
    let per_node = if is_marbled { PER_MARBLED_NODE_S } else { PER_NODE_S };
    Ok(BROWSER * per_node * Body::estimated_nodes(food, spec)?)
}
