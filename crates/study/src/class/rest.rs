//! A rest that time has not yet shown: it is cooked on in a copy of the kitchen, on its own meshes.

use saute_kitchen::advice::RESTED_K;
use saute_kitchen::{Command, Kitchen, Piece, TICK_S};

use super::lesson::Lesson;
use super::result_row::RestKind;

/// Longest rest that is cooked on [simulated s] (chosen: a steak of 35 mm that was fried for 300 s has its peak after
/// 1470 s; one that is nearly raw warms towards the room for longer).
const LONGEST_S: f64 = 3600.0;

/// Returns true if food was taken out and its core has begun to cool.
pub fn has_rested(kitchen: &Kitchen) -> bool {
    let rested =
        |piece: &Piece| piece.lies_on_board() && piece.core_peak.1 > 0.0 && piece.core() < piece.core_peak.0 - RESTED_K;
    is_out(kitchen) && kitchen.pieces().iter().all(rested)
}

/// Returns true if food was taken out, and none is left in the pan.
pub fn is_out(kitchen: &Kitchen) -> bool {
    let pieces = kitchen.pieces();
    !pieces.is_empty() && pieces.iter().all(Piece::lies_on_board)
}

/// Food that lies on the board, cooked on in a copy of the kitchen until it has rested.
#[derive(Clone, Debug)]
pub struct Rest {
    kitchen: Kitchen,
    began_s: f64,
}

impl Rest {
    /// The rest of a lesson's food from an instant on; none where food is still in the pan, or never was: what would come of it
    /// depends on what is done.
    pub fn of(lesson: &Lesson, kitchen: &Kitchen) -> Option<Self> {
        if !lesson.was_cooked() || !is_out(kitchen) {
            return None;
        }
        let mut kitchen = kitchen.clone();
        // Nobody is at the stove any more.
        kitchen.apply(&Command::Hob(0.0)).ok()?;
        let began_s = kitchen.time_s();
        Some(Self { kitchen, began_s })
    }

    /// Cooks on by a tick; returns true once all is known, or the longest rest is over. The truth of each question about an instant that
    /// has come is noted.
    pub fn tick(&mut self, lesson: &mut Lesson) -> bool {
        if self.is_over(lesson) {
            return true;
        }
        self.kitchen.step();
        lesson.learn(&self.kitchen);
        self.is_over(lesson)
    }

    fn is_over(&self, lesson: &Lesson) -> bool {
        let is_known = has_rested(&self.kitchen) && !lesson.awaits(self.kitchen.time_s());
        is_known || self.lasted_s() + TICK_S > LONGEST_S
    }

    /// How long it was cooked on [simulated s].
    pub fn lasted_s(&self) -> f64 {
        self.kitchen.time_s() - self.began_s
    }

    /// Whether the food has rested by now, and before whose eyes.
    pub fn kind(&self) -> RestKind {
        match has_rested(&self.kitchen) {
            false => RestKind::None,
            true if self.lasted_s() > 0.0 => RestKind::CookedOn,
            true => RestKind::Seen,
        }
    }

    /// The kitchen at the end of the rest.
    pub fn kitchen(&self) -> &Kitchen {
        &self.kitchen
    }
}
