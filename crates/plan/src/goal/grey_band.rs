//! The grey band: how deep below each face the food is beyond the class of the goal.

use saute_kitchen::Piece;

use crate::goal::Goal;

/// Points on the line through the core at which its doneness is read [-] (chosen: a tenth of a millimetre apart in a thick steak).
const POINTS: usize = 401;

/// Thickness of what is beyond the class of the goal, from the lower and from the upper face inwards to where the class begins, on
/// the line through the core, as the piece lies [m]. A class without an upper end has none.
pub(crate) fn grey_band(piece: &Piece, goal: &Goal) -> [f64; 2] {
    let Some(end) = goal.scale.end(goal.class).map(|end| goal.scale.of_nodes(end)) else { return [0.0; 2] };
    let field = piece.model.measured(&piece.state, &goal.scale);
    if field.is_empty() {
        return [0.0; 2];
    }
    let beyond = |share: f64| piece.model.above_core(field, share) >= end;
    let share = |point: usize| 2.0 * point as f64 / (POINTS - 1) as f64 - 1.0;
    let run = |from_top: bool| {
        let at = |point: usize| share(if from_top { POINTS - 1 - point } else { point });
        (0..POINTS).take_while(|point| beyond(at(*point))).count()
    };
    // The body's lower face is on top once it was turned over.
    let runs = [run(piece.upside_down()), run(!piece.upside_down())];
    let thickness = piece.model.thickness(&piece.state);
    // Where all of the line is beyond, each face has its half of it.
    let share = if runs == [POINTS; 2] { 0.5 } else { 1.0 };
    runs.map(|points| share * thickness * (points as f64 / POINTS as f64))
}
