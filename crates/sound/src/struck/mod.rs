//! All bodies that ring when they are struck, with the forces at work on them.

mod families;
mod modes;
pub(crate) mod plate;
mod strikes;

use alloc::vec::Vec;

use crate::event::Event;
use crate::random::Random;
use crate::struck::families::{BELL, BOARD, FLESH, TOOL};
use crate::struck::modes::Modes;
use crate::struck::plate::{Metal, Plate};
use crate::struck::strikes::{BODIES, Body, Strike, forces};

/// Largest number of forces at work at once [-] (chosen: ten blows within a quarter of a second).
const MOST_STRIKES: usize = 32;
/// Loss 1/Q of a pan whose floor is wholly under food or liquid [-] (chosen: Q 8, a thud).
const LOADED: f32 = 0.125;
/// Thickness of a lid of pressed steel [m] (chosen: usual).
const LID_M: f32 = 0.8e-3;

/// Loss 1/Q of a lid by the rim that it lies on and the hand at its knob [-] (chosen: Q 30).
const HELD_LID: f32 = 0.033;

/// The bodies and the forces on them.
#[derive(Clone, Debug)]
pub(crate) struct Struck {
    bodies: [Modes; BODIES],
    strikes: Vec<Strike>,
    random: Random,
    covered: f32,
    rate: f32,
}

impl Struck {
    pub(crate) fn new(pan: &Plate, random: Random, rate: f32) -> Self {
        let lid = Plate { metal: Metal::StainlessClad, thickness_m: LID_M, ..*pan };
        // In the order of the bodies.
        let mut bodies = [
            Modes::new(pan.modes(), rate),
            Modes::new(lid.modes(), rate),
            Modes::new(TOOL.modes(), rate),
            Modes::new(BOARD.modes(), rate),
            Modes::new(FLESH.modes(), rate),
            Modes::new(BELL.modes(), rate),
        ];
        bodies[Body::Lid as usize].damp(HELD_LID);
        Self { bodies, strikes: Vec::with_capacity(MOST_STRIKES), random, covered: 0.0, rate }
    }

    /// Damps the pan by what covers a share of its floor [-].
    pub(crate) fn cover(&mut self, covered: f32) {
        if covered != self.covered {
            self.covered = covered;
            self.bodies[Body::Pan as usize].damp(covered * LOADED);
        }
    }

    /// Strikes what an event strikes.
    pub(crate) fn strike(&mut self, event: &Event) {
        for force in forces(event.kind) {
            if self.strikes.len() < MOST_STRIKES {
                self.strikes.push(Strike::begin(force, event.strength, self.rate));
            }
        }
    }

    /// Returns the next sample of what rings in the pan, and of what rings outside.
    pub(crate) fn next(&mut self) -> [f32; 2] {
        let mut force = [0.0; BODIES];
        let Self { strikes, random, .. } = self;
        strikes.retain_mut(|strike| {
            let Some(now) = strike.next(random) else { return false };
            force[strike.on as usize] += now;
            true
        });
        let mut heard = [0.0; 2];
        for (index, (body, force)) in self.bodies.iter_mut().zip(force).enumerate() {
            heard[usize::from(index != Body::Flesh as usize)] += body.next(force);
        }
        heard
    }

    /// Lets bodies sleep that no longer ring.
    pub(crate) fn settle(&mut self) {
        self.bodies.iter_mut().for_each(Modes::settle);
    }
}
