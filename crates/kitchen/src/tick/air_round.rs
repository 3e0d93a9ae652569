//! Air around a piece: the pan's plume or lid, foil, or the room's still air.

use saute_food::{FreeAir, Rules};

use crate::data::room::Room;
use crate::hands::command::RestOn;
use crate::kitchen::{Fixed, Kitchen};
use crate::piece::piece_state::{Piece, Place};

impl Kitchen {
    /// Air above, below and around a piece. By the rules of 2013 it takes up no vapour.
    pub(crate) fn air_round(&self, fixed: &Fixed, piece: &Piece) -> [FreeAir; 3] {
        match piece.model.rules() {
            Rules::Full => self.moist_air_round(fixed, piece),
            Rules::Paper2013 => self.air_round_2013(fixed, piece).map(Room::without_evaporation),
        }
    }

    fn moist_air_round(&self, fixed: &Fixed, piece: &Piece) -> [FreeAir; 3] {
        match piece.place {
            Place::Rest(RestOn::Foil) => [fixed.room.under_foil(); 3],
            Place::Pan(_) => fixed.pan.airs(&self.pan, &fixed.room, || piece.face(false)),
            _ => [fixed.room.still_air(); 3],
        }
    }

    fn air_round_2013(&self, fixed: &Fixed, piece: &Piece) -> [FreeAir; 3] {
        match piece.place {
            Place::Pan(_) if self.pan.lid.is_none() => {
                let (up, side) = fixed.room.plume_2013(fixed.pan.floor_temperature(&self.pan));
                [up, up, side]
            }
            Place::Rest(RestOn::Foil) | Place::Pan(_) => self.moist_air_round(fixed, piece),
            _ => [fixed.room.still_air_2013(); 3],
        }
    }
}
