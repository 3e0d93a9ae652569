//! Pieces of a session: added, removed, laid into the pan.

mod building;

pub(super) use building::{Building, added_to};

use saute_kitchen::kitchen::SetupError;
use saute_kitchen::{Command, PieceOrder};

use super::Session;
use super::choice::{FoodChoice, base_name, orders};
use super::permits::NotDone;
use crate::hands::Hands;
use saute_words::piece_words::group_of;

impl<H: Hands> Session<H> {
    /// Adds waiting pieces in one group; returns the name of the group.
    ///
    /// # Errors
    ///
    /// If they cannot be built.
    pub fn add(&mut self, choice: &FoodChoice, count: usize) -> Result<String, SetupError> {
        let group = self.free_name(&base_name(&self.library, &choice.kind));
        let orders = orders(&self.library, choice, &group, count);
        self.kitchen.check_all_fit(&self.library, &orders)?;
        let built = self.take_built(&orders);
        self.timeline.models().adopt(built);
        orders.into_iter().try_for_each(|order| self.add_one(order))?;
        Ok(group)
    }

    /// Adds one piece.
    pub(super) fn add_one(&mut self, order: PieceOrder) -> Result<(), SetupError> {
        self.finish_travel();
        self.kitchen.add_with(&self.library, &order, self.timeline.models())?;
        self.depart(self.recording.entries().len());
        self.leave_recipe();
        // A piece that was taken away, or added in a cook that was undone, may have had this name.
        self.start_mass_g.remove(&order.id);
        self.recording.add(&self.kitchen, order);
        self.note_last();
        self.weigh_new();
        Ok(())
    }

    /// Returns an unused name for a group: the base, or the base with the first free number.
    fn free_name(&self, base: &str) -> String {
        let taken = |name: &str| self.kitchen.pieces().iter().any(|p| group_of(&p.id) == name);
        let numbered = (2..).map(|n| format!("{base}-{n}"));
        std::iter::once(base.to_owned()).chain(numbered).find(|name| !taken(name)).unwrap_or_else(|| base.to_owned())
    }

    /// Removes pieces from the kitchen.
    pub fn remove(&mut self, ids: &[String]) {
        self.finish_travel();
        self.depart(self.recording.entries().len());
        self.leave_recipe();
        for id in ids {
            self.recording.remove(&self.kitchen, id);
            self.kitchen.remove(id);
            self.note_last();
        }
    }

    /// Stores the mass of new pieces.
    pub(super) fn weigh_new(&mut self) {
        for piece in self.kitchen.pieces() {
            self.start_mass_g.entry(piece.id.clone()).or_insert_with(|| 1e3 * piece.mass());
        }
    }

    /// Lays as many pieces as fit side by side on the floor of the pan; returns their number.
    pub fn lay(&mut self, ids: &[String]) -> Result<usize, NotDone> {
        let places = self.kitchen.free_places(ids, [0.0, 0.0]);
        for (food, at) in ids.iter().zip(&places) {
            self.command(&Command::Put { food: food.clone(), at: *at, heap: false })?;
        }
        Ok(places.len())
    }

    /// Drops pieces into the pan in a loose heap.
    pub fn heap(&mut self, ids: &[String]) -> Result<(), NotDone> {
        let floor = self.kitchen.world().pan_shape().floor;
        for (k, food) in ids.iter().enumerate() {
            let at = on_spiral(k, ids.len(), HEAP_SHARE * floor);
            self.command(&Command::Put { food: food.clone(), at, heap: true })?;
        }
        Ok(())
    }
}

/// Share of the floor's radius over which a heap is dropped [-] (chosen: clear of the wall).
const HEAP_SHARE: f64 = 0.62;

/// Places spread evenly over a disc, the first in its middle [m].
fn on_spiral(k: usize, count: usize, radius: f64) -> [f64; 2] {
    /// The golden angle [rad]: no two turns of the spiral meet.
    const TURN: f64 = 2.399_963_229_728_653;
    let (share, angle) = ((k as f64 / count.max(1) as f64).sqrt(), TURN * k as f64);
    [radius * share * angle.cos(), radius * share * angle.sin()]
}
