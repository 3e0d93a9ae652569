//! Wiping the pan with a paper towel: oil, water and loose fond leave, the film of a seasoned pan stays.

use crate::data::room::Room;
use crate::hands::pour::Brought;
use crate::pan::{PanModel, PanState};

/// Least oil that paper leaves [kg] (chosen: a film of two thousandths of a millimetre on a floor of 20 cm).
const LEFT_BY_PAPER: f64 = 0.05e-3;
/// Share of the dried fond that stays on the metal [-] (chosen: what is stuck is scraped, not wiped).
const STUCK: f64 = 0.5;

impl PanModel {
    /// Wipes the pan; what leaves counts as spilled, and its heat as gone with the paper.
    pub(crate) fn wipe(&self, state: &mut PanState, room: &Room) -> Brought {
        let before = self.stored(state);
        let liquids = &mut state.liquids;
        let (oil, water) = (liquids.oil.total(), liquids.water.total());
        let film = (1e-3 * self.description.surface.film_g).max(LEFT_BY_PAPER);
        let left = if oil > film { film / oil } else { 1.0 };
        liquids.oil.keep(left);
        liquids.water.clear();
        let lump = liquids.butter.wipe();
        liquids.fond.wipe(STUCK, &self.liquids.bed);
        liquids.spilled += (1.0 - left) * oil + water + lump;
        self.liquids.refresh_film(liquids, room);
        Brought { stored: self.stored(state) - before, ..Brought::default() }
    }
}
