//! The kitchen with coarse meshes, and its steps.

use std::sync::Arc;

use saute_food::{BuildError, GRAVITY};

use crate::TICK_S;
use crate::hands::command::{Command, Refused, RestOn};
use crate::hands::second_hand::SecondHand;
use crate::kitchen::Kitchen;
use crate::pan::food_load::FoodLoad;
use crate::pan::pan_model::PanSolver;
use crate::piece::food_contact::Touching;
use crate::piece::piece_state::{Piece, Place};
use crate::reduced::Reductions;
use crate::tick::event::EventLog;
use crate::tick::lapse::Lapse;

/// Ticks in a step [-] (chosen: the explicit step of the layers at the faces is 0.35 s; with two of them in half a second a
/// five-minute forecast takes 600 steps).
const TICKS: u64 = 5;
const LAPSE: Lapse = Lapse { ticks: TICKS };

/// Length of a step [s].
pub const LAPSE_S: f64 = TICKS as f64 * TICK_S;

/// Steps during which a flipped piece is in the air [-] (chosen: the turner carries it for 0.4 to 0.6 s).
const FLIP_STEPS: u32 = 1;
/// Steps during which a piece is carried out of the pan [-] (chosen: the tongs carry it for 1.1 s).
const CARRY_STEPS: u32 = 2;

/// A kitchen whose slices have coarse meshes. Nothing moves in it but what its commands turn over or take out, and food that
/// sinks as it grows thinner.
#[derive(Clone, Debug)]
pub struct ReducedKitchen {
    kitchen: Kitchen,
    lifted: Vec<Lifted>,
}

/// A piece in the air.
#[derive(Clone, Copy, Debug)]
struct Lifted {
    key: u32,
    steps_left: u32,
    to: Landing,
}

#[derive(Clone, Copy, Debug)]
enum Landing {
    TurnedOver([f64; 2]),
    On(RestOn),
}

impl Kitchen {
    /// Returns the kitchen with the present state on coarse meshes; waiting pieces are left out.
    ///
    /// # Errors
    /// If a coarse mesh cannot be built.
    pub fn reduced(&self, reductions: &mut Reductions) -> Result<ReducedKitchen, BuildError> {
        let coarse_pan = reductions.learn(self)?;
        let (surface, pan) = (*self.world.pan_shape(), self.world.motion.pose);
        let reduced = |piece: &Piece| {
            let mut coarse = reductions.reduced(piece);
            if let Some(height) = piece.lowest_over(&surface, &pan).filter(|_| piece.in_pan()) {
                coarse.lower_to(height, &surface, &pan);
            }
            coarse
        };
        let pieces: Vec<Piece> = self.pieces.iter().filter(|piece| piece.is_out()).map(reduced).collect();
        let touching = self.touching.iter().filter_map(|touching| {
            let [a, b] = touching.pair.map(|key| pieces.iter().find(|piece| piece.key == key));
            Some(Touching::between(a?, b?, None))
        });
        let kitchen = Kitchen {
            fixed: Arc::clone(&coarse_pan.fixed),
            pan: coarse_pan.restricted(&self.pan),
            pan_solver: PanSolver::default(),
            cloth: self.cloth.clone(),
            load: FoodLoad::none(coarse_pan.fixed.pan.section.points.len()),
            touching: touching.collect(),
            world: self.world.clone(),
            second_hand: SecondHand::default(),
            events: EventLog::default(),
            carried_out: None,
            pieces,
            ..*self
        };
        Ok(ReducedKitchen { kitchen, lifted: Vec::new() })
    }
}

impl ReducedKitchen {
    /// The kitchen, to be read.
    pub fn kitchen(&self) -> &Kitchen {
        &self.kitchen
    }

    /// Carries out a command: pieces are turned over and taken out without their motion, all other commands are those of
    /// the kitchen, of which those that move bodies have no effect.
    ///
    /// # Errors
    /// As [`Kitchen::apply`].
    pub fn apply(&mut self, command: &Command) -> Result<(), Refused> {
        self.kitchen.check_lid(command)?;
        match command {
            Command::Flip { food } => {
                let Place::Pan(at) = self.in_pan(food)?.place else { return Err(Refused::NotInPan(food.clone())) };
                self.lift(food, FLIP_STEPS, Landing::TurnedOver(at))
            }
            Command::Rest { food, on } => {
                let key = self.in_pan(food)?.key;
                // On the board nothing of pan and other pieces reaches it.
                self.kitchen.pieces.retain(|piece| piece.key == key);
                self.kitchen.touching.clear();
                self.lift(food, CARRY_STEPS, Landing::On(*on))
            }
            other => self.kitchen.apply(other),
        }
    }

    fn in_pan(&self, food: &str) -> Result<&Piece, Refused> {
        let piece = self.kitchen.piece(food).ok_or_else(|| Refused::NoSuchFood(food.into()))?;
        if piece.in_pan() { Ok(piece) } else { Err(Refused::NotInPan(food.into())) }
    }

    fn lift(&mut self, food: &str, steps_left: u32, to: Landing) -> Result<(), Refused> {
        let piece = self.kitchen.piece_mut(food)?;
        piece.leave_pan();
        piece.place = Place::Held;
        let key = piece.key;
        self.kitchen.touching.retain(|touching| !touching.pair.contains(&key));
        self.lifted.push(Lifted { key, steps_left, to });
        Ok(())
    }

    /// Advances it by [`LAPSE_S`].
    pub fn step(&mut self) {
        self.step_by(LAPSE);
    }

    /// Advances it by `steps` at once if all food rests on wood, where nothing changes fast, else by one; returns how many it took.
    pub fn step_resting(&mut self, steps: u64) -> u64 {
        let rests = |piece: &Piece| matches!(piece.place, Place::Rest(_));
        let steps = if self.kitchen.pieces.iter().all(rests) { steps } else { 1 };
        self.step_by(Lapse { ticks: steps * TICKS });
        steps
    }

    fn step_by(&mut self, lapse: Lapse) {
        self.lay_down();
        let kitchen = &mut self.kitchen;
        let fixed = Arc::clone(&kitchen.fixed);
        let (surface, pan) = (*kitchen.world.pan_shape(), kitchen.world.motion.pose);
        kitchen.load.clear();
        for piece in &mut kitchen.pieces {
            piece.free_all();
            piece.follow_shape_down(&surface, &pan);
        }
        kitchen.exchange_between_foods(&fixed.room, lapse);
        for index in 0..kitchen.pieces.len() {
            kitchen.step_piece(&fixed, index, lapse);
        }
        // A pan without food, to which none comes back, matters to no piece.
        if kitchen.pieces.iter().any(Piece::in_pan) || !self.lifted.is_empty() {
            kitchen.step_pan(&fixed, lapse);
        }
        kitchen.clock.count(lapse);
    }

    /// Lays down the pieces that have been in the air for long enough.
    fn lay_down(&mut self) {
        let kitchen = &mut self.kitchen;
        let (surface, pan) = (*kitchen.world.pan_shape(), kitchen.world.motion.pose);
        self.lifted.retain_mut(|lifted| {
            if lifted.steps_left > 0 {
                lifted.steps_left -= 1;
                return true;
            }
            if let Some(piece) = kitchen.pieces.iter_mut().find(|piece| piece.key == lifted.key) {
                match lifted.to {
                    Landing::TurnedOver(at) => {
                        piece.turn_over(&surface, &pan);
                        piece.place = Place::Pan(at);
                        piece.on_pan.force = GRAVITY * piece.mass();
                    }
                    Landing::On(on) => {
                        piece.onto_wood(kitchen.fixed.room.temperature());
                        (piece.resting_on, piece.place) = (on, Place::Rest(on));
                    }
                }
            }
            false
        });
    }
}
