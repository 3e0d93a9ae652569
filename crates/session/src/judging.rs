//! The judgement of the cook that is shown, as far as it went.

use saute_kitchen::{Piece, Place};
use saute_plan::goal::{Course, Goal, Judged, Judgement};

use super::Session;
use crate::hands::Hands;

impl<H: Hands> Session<H> {
    /// Judges the group of the piece that the panels show by a goal; none without food.
    pub fn judgement(&self, goal: &Goal) -> Option<Judgement> {
        let first = self.shown_piece()?;
        let group = self.its_group();
        let others = group.iter().filter(|id| **id != first.id).filter_map(|id| self.kitchen.piece(id));
        let pieces: Vec<&Piece> = std::iter::once(first).chain(others).collect();
        let mass = |piece: &&Piece| self.start_mass_g.get(&piece.id).map_or_else(|| piece.mass(), |g| 1e-3 * g);
        let masses_at_start = pieces.iter().map(mass).collect();
        let times = [self.marks.iter().find(|mark| mark.is_put()).map(|mark| mark.time_s), self.came_out_s()];
        let course = Course::of(&self.recorder, self.shown_index(), times, self.recorder.turns_of(&first.id));
        Judgement::of(&Judged { kitchen: &self.kitchen, pieces, masses_at_start }, &course, goal)
    }

    /// When food was last taken out of the pan [s]; none if it never was.
    pub fn came_out_s(&self) -> Option<f64> {
        self.marks.iter().rev().find(|mark| mark.is_rest()).map(|mark| mark.time_s)
    }

    /// When food last went into the pan or came out by a command [s]; 0 before that. What tongs carry out makes no mark: it came out after
    /// it went in.
    pub fn last_moved_s(&self) -> f64 {
        self.marks.iter().rev().find(|mark| mark.is_put() || mark.is_rest()).map_or(0.0, |mark| mark.time_s)
    }

    /// Returns true if all of the group that the panels show rests and nothing is in the pan.
    pub fn is_out(&self) -> bool {
        let rests = |id: &String| self.kitchen.piece(id).is_some_and(|piece| matches!(piece.place, Place::Rest(_)));
        let group = self.its_group();
        !group.is_empty() && group.iter().all(rests) && !self.kitchen.pieces().iter().any(Piece::in_pan)
    }
}
