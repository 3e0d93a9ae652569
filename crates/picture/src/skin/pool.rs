//! Juice that has run out of a piece on the board.

use saute_kitchen::Piece;
use saute_kitchen::heat::Layout;

/// Share of the free juice of a halved piece that leaves at the cut [-] (chosen: a steak cut soon after the pan loses some
/// grams).
const LEAVES_AT_CUT: f64 = 0.2;
/// Steps of the juice [g] (chosen: a finer change is not seen).
const STEP: f64 = 0.05;

/// Juice round a slice on the board [g]: what is on its lower face, and what leaves at a cut.
pub(crate) fn juice_on_board(piece: &Piece) -> f32 {
    let Layout::Upright(mesh) = piece.model.mesh().layout() else { return 0.0 };
    if !piece.lies_on_board() {
        return 0.0;
    }
    let lowest = if piece.upside_down() { mesh.levels.len() - 1 } else { 0 };
    let below: f64 = (0..mesh.nodes_per_level()).map(|i| piece.state.juice[mesh.node(lowest, i)]).sum();
    let free: f64 = piece.state.juice.iter().sum();
    let at_cut = if piece.halved().is_some() { LEAVES_AT_CUT * free } else { 0.0 };
    ((1e3 * (below + at_cut) / STEP).round() * STEP) as f32
}
