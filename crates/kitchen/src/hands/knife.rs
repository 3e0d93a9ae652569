//! The knife: it halves a piece on the board and opens it.

use crate::hands::command::Refused;
use crate::kitchen::Kitchen;
use crate::tick::event::{Event, EventKind};

impl Kitchen {
    /// Halves a piece on the board across its long axis, at a distance from its centre [m].
    pub(crate) fn halve(&mut self, food: &str, at: f64) -> Result<(), Refused> {
        let (time_s, pan) = (self.time_s(), self.world.motion.pose);
        let piece = self.piece_mut(food)?;
        if !piece.lies_on_board() {
            return Err(Refused::NotOnBoard(food.into()));
        }
        piece.halve(at)?;
        let (at, amount) = (pan.to_body(piece.pose.position).to_array(), piece.mass());
        self.events.push(Event { time_s, kind: EventKind::Halved, at, amount });
        Ok(())
    }
}
