//! Pan and food of a candidate: the whole kitchen, or on coarse meshes.

use saute_kitchen::reduced::{LAPSE_S, ReducedKitchen};
use saute_kitchen::{Command, Kitchen, RestOn, TICKS_PER_S};

/// Steps on coarse meshes in a second [-].
const STEPS_PER_S: u64 = (1.0 / LAPSE_S + 0.5) as u64;
/// Work of pan, hob and rigid bodies in a tick, in nodes of food [-] (measured: a coarse steak of 1000 nodes takes about as long
/// as an empty pan).
const NODES_OF_PAN: u64 = 1000;
/// Work of a node in a step on coarse meshes, in nodes of a tick [-] (measured: 651 nodes take 0.07 ms, with the pan).
const STEP_OVER_TICK: u64 = 3;

/// Where food cooks or rests.
#[derive(Clone, Debug)]
pub(crate) enum Stove {
    /// The whole kitchen.
    Whole(Box<Kitchen>),
    /// On coarse meshes, where bodies are still.
    Reduced(Box<ReducedKitchen>),
}

impl Stove {
    /// The kitchen, to be read.
    pub(crate) fn kitchen(&self) -> &Kitchen {
        match self {
            Self::Whole(kitchen) => kitchen,
            Self::Reduced(reduced) => reduced.kitchen(),
        }
    }

    /// Carries out what is possible now; what is not is left.
    pub(crate) fn apply(&mut self, command: &Command) {
        let _ = match self {
            Self::Whole(kitchen) => kitchen.apply(command),
            Self::Reduced(reduced) => reduced.apply(command),
        };
    }

    /// Takes the foods out of the pan and switches the hob off, as the last steps of a recipe do.
    pub(crate) fn pull(&mut self) {
        let in_pan = self.kitchen().pieces().iter().filter(|piece| piece.in_pan());
        let foods: Vec<String> = in_pan.map(|piece| piece.id.clone()).collect();
        let rests = foods.into_iter().map(|food| Command::Rest { food, on: RestOn::Board });
        rests.chain([Command::Hob(0.0)]).for_each(|command| self.apply(&command));
    }

    /// Lets a second pass for food that rests; returns the work that it took [-].
    pub(crate) fn rest_second(&mut self) -> u64 {
        match self {
            Self::Whole(kitchen) => {
                (0..TICKS_PER_S).for_each(|_| kitchen.step_rest());
                let pan = if kitchen.only_rests() { 0 } else { NODES_OF_PAN };
                u64::from(TICKS_PER_S) * (nodes_of_food(kitchen) + pan)
            }
            Self::Reduced(reduced) => {
                let mut steps = 0;
                while steps < STEPS_PER_S {
                    steps += reduced.step_resting(STEPS_PER_S - steps);
                }
                STEP_OVER_TICK * STEPS_PER_S * nodes_of_food(reduced.kitchen())
            }
        }
    }
}

/// Lets a second pass on coarse meshes; returns the work that it took [-].
pub(super) fn cook_second(reduced: &mut ReducedKitchen) -> u64 {
    (0..STEPS_PER_S).for_each(|_| reduced.step());
    STEP_OVER_TICK * STEPS_PER_S * nodes_of_food(reduced.kitchen())
}

/// Work of a second of the whole kitchen [-].
pub(super) fn work_of_cook(kitchen: &Kitchen) -> u64 {
    work_of_second(nodes_of_food(kitchen))
}

/// Work of a second with a number of nodes of food [-].
pub(crate) fn work_of_second(nodes: u64) -> u64 {
    u64::from(TICKS_PER_S) * (nodes + NODES_OF_PAN)
}

fn nodes_of_food(kitchen: &Kitchen) -> u64 {
    kitchen.pieces().iter().map(|piece| piece.model.mesh().node_count() as u64).sum()
}
