//! A steak that fries in real time on one thread, in the pan that the device holds.

use std::sync::mpsc::Receiver;
use std::time::{Duration, Instant};

use saute_haptics::control::control_loop::{ControlLoop, LoopState};
use saute_haptics::{KitchenWatch, PanInHand, TurnerInHand};
use saute_kitchen::{FRAME_S, Library, Piece};
use saute_recipe::{Cook, Recipe};

use super::stop_key;
use crate::error::CliError;
use crate::output::stderr;

const DISH: &str = include_str!("dish.toml");
/// Largest backlog [frames]; older frames are skipped and counted (chosen: a third of a second).
const LARGEST_BACKLOG: f64 = 20.0;

/// A cook that runs next to a control loop.
pub struct Fry {
    cook: Cook,
    watch: KitchenWatch,
    hand: PanInHand,
    other_hand: TurnerInHand,
    /// The control loop.
    pub control: ControlLoop,
    started: Instant,
    frames: f64,
    skipped: f64,
    is_model_paused: bool,
    is_recipe_running: bool,
    stop_key: Receiver<()>,
}

impl Fry {
    /// Starts the cook.
    pub fn new(library: &Library, control: ControlLoop) -> Result<Self, CliError> {
        let file = "dish.toml";
        let recipe = Recipe::parse(DISH, file, library)?;
        let cook = Cook::new(recipe, library).map_err(|source| CliError::Setup { file: file.into(), source })?;
        Ok(Self {
            cook,
            watch: KitchenWatch::default(),
            hand: PanInHand::default(),
            other_hand: TurnerInHand::default(),
            control,
            started: Instant::now(),
            frames: 0.0,
            skipped: 0.0,
            is_model_paused: false,
            is_recipe_running: true,
            stop_key: stop_key::listen(),
        })
    }

    /// Fries until `enough` returns true or the time is over. Returns true in the first case.
    pub fn until(&mut self, seconds: f64, mut enough: impl FnMut(&LoopState) -> bool) -> bool {
        let end = Instant::now() + Duration::from_secs_f64(seconds);
        while Instant::now() < end {
            if self.stop_key.try_recv().is_ok() {
                stderr::say("emergency stop: the device is switched off");
                self.control.emergency_stop();
            }
            let state = self.control.state();
            if enough(&state) {
                return true;
            }
            self.keep_up(&state);
            std::thread::sleep(Duration::from_millis(1));
        }
        false
    }

    /// Stops or resumes the publication of contact models. A stop looks like a program that hangs.
    pub fn pause_contact_model(&mut self, is_paused: bool) {
        self.is_model_paused = is_paused;
    }

    /// Advances the cook by one frame if one is due.
    fn keep_up(&mut self, state: &LoopState) {
        let due = self.started.elapsed().as_secs_f64() / FRAME_S;
        if due - self.frames > LARGEST_BACKLOG {
            self.skipped += due - self.frames;
            self.frames = due;
        }
        if due - self.frames < 1.0 {
            return;
        }
        self.frames += 1.0;
        if self.is_recipe_running && self.cook.kitchen.is_between_ticks() {
            // A steak that the hand throws out of the pan ends the recipe, not the check.
            self.is_recipe_running = self.cook.fire().is_ok();
        }
        self.hand.step(Some(&state.sample), &mut self.cook.kitchen, FRAME_S);
        self.other_hand.step(state.sample.turner.as_ref(), &mut self.cook.kitchen);
        self.cook.kitchen.advance_frame();
        if !self.is_model_paused {
            self.control.publish(self.watch.look(&self.cook.kitchen, FRAME_S));
        }
    }

    /// Returns the mass of the food in the pan [kg].
    pub fn contents_kg(&self) -> f64 {
        self.cook.kitchen.pieces().iter().filter(|p| p.in_pan()).map(Piece::mass).sum()
    }

    /// Returns the rate of frames that were simulated [Hz].
    pub fn rate_hz(&self) -> f64 {
        (self.frames - self.skipped) / self.started.elapsed().as_secs_f64()
    }
}
