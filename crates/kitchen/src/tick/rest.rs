//! Ticks of food that rests, without its pan.

use std::sync::Arc;

use crate::kitchen::Kitchen;
use crate::piece::piece_state::{Piece, Place};
use crate::tick::lapse::Lapse;

impl Kitchen {
    /// True if all food rests and nothing moves: no heat passes between food and pan.
    pub fn only_rests(&self) -> bool {
        let rests = |piece: &Piece| matches!(piece.place, Place::Rest(_));
        self.world.is_settled() && !self.is_moving_food() && self.pieces.iter().all(rests)
    }

    /// Advances the kitchen to its next tick as [`Self::step`] does, but leaves the pan as it is where [`Self::only_rests`]: for a rest of
    /// whose pan no value is needed any more.
    pub fn step_rest(&mut self) {
        if !self.only_rests() {
            return self.step();
        }
        while !self.clock.count_frame() {}
        self.food_tick(&Arc::clone(&self.fixed));
        self.clock.count(Lapse::TICK);
    }
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use crate::{Command, Kitchen, Library, MeshSize, OutlineKind, PieceOrder, RestOn, kelvin};
    use saute_food::Rules;

    #[test]
    fn food_that_rests_is_the_same_without_its_pan() {
        let library = Library::embedded().unwrap();
        let mut kitchen = Kitchen::new(&library, "carbon-steel-26", kelvin(200.0)).unwrap();
        let steak = PieceOrder {
            id: "steak".into(),
            kind: "beef-lean".into(),
            size: [0.080, 0.060, 0.012],
            temperature: kelvin(5.0),
            seed: 1,
            coarseness: 3.0,
            rules: Rules::Full,
            mesh: MeshSize::Default,
            outline: OutlineKind::Plain,
        };
        kitchen.add(&library, &steak).unwrap();
        let food = || "steak".to_owned();
        kitchen.apply(&Command::Put { food: food(), at: [0.0, 0.0], heap: false }).unwrap();
        (0..200).for_each(|_| kitchen.step());
        kitchen.apply(&Command::Rest { food: food(), on: RestOn::Board }).unwrap();
        assert!(!kitchen.only_rests());
        let mut alone = kitchen.clone();
        (0..300).for_each(|_| kitchen.step());
        (0..300).for_each(|_| alone.step_rest());
        assert!(alone.only_rests());
        let [a, b] = [&kitchen, &alone].map(|kitchen| &kitchen.pieces()[0]);
        assert_eq!((a.core_peak, &a.state, kitchen.frame()), (b.core_peak, &b.state, alone.frame()));
        assert_ne!(kitchen.pan_temperature(), alone.pan_temperature(), "of its pan nothing is asked");
    }
}
