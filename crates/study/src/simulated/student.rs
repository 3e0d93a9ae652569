//! A simulated student of a lesson: habits, slips and guesses.

use std::sync::Arc;

use saute_kitchen::{Command, Kitchen, Library, Piece, RestOn, celsius};

use super::cook::CookError;
use crate::class::rest::has_rested;
use crate::class::{Ask, Lesson, RestKind, ResultRow, Scenario};
use crate::measures::{Measures, Times};
use crate::participant::Participant;
use crate::random::Random;

/// Power to heat the pan with, and to fry with: mean and spread [W] (all numbers of this page are chosen, as those of the participants).
const HEAT_W: [f64; 2] = [1400.0, 200.0];
const FRY_W: [f64; 2] = [650.0, 120.0];
/// Heat of the pan at which the food goes in [°C].
const PAN_C: [f64; 2] = [190.0, 20.0];
/// Time on a side [s].
const SIDE_S: [f64; 2] = [200.0, 60.0];
/// Core at which the food is taken out, from the middle of the target class [K].
const PULL_K: [f64; 2] = [-3.0, 5.0];
/// What a guess adds to the present core for one ahead, and for the highest one: beginners forget that the rest warms the core [K].
const AHEAD_K: [f64; 2] = [12.0, 8.0];
const PEAK_K: [f64; 2] = [2.0, 3.0];
/// Guess of a browned share [%].
const BROWN_PCT: [f64; 2] = [50.0, 20.0];

/// Simulated students of a lesson.
#[derive(Clone, Debug)]
pub struct SimulatedClass {
    /// The lesson.
    pub scenario: Arc<Scenario>,
    /// The seed of all draws.
    pub seed: u64,
}

/// What one of them does.
struct Student {
    random: Random,
    fry_w: f64,
    pan_c: f64,
    side_s: f64,
    pull_c: f64,
    times: Times,
    last_flip_s: f64,
}

impl SimulatedClass {
    /// Code of the student with a number, which no teacher gives to a person.
    pub fn code(number: u32) -> String {
        format!("SIM-{number:02}")
    }

    /// Lets the student with a number, from 1, take the lesson; returns what is handed in.
    ///
    /// # Errors
    ///
    /// If the kitchen of the lesson cannot be set up, or has several pieces of food.
    pub fn row(&self, number: u32, library: &Library) -> Result<ResultRow, CookError> {
        let scenario = &self.scenario;
        let mut kitchen = scenario.recipe.kitchen(library)?;
        let masses: Vec<f64> = kitchen.pieces().iter().map(Piece::mass).collect();
        if masses.len() != 1 {
            return Err(CookError::Pieces(masses.len()));
        }
        let mut random = Random::new(&[self.seed, u64::from(number)]);
        kitchen.apply(&Command::Hob(drawn(&mut random, HEAT_W)))?;
        let mut student = Student::new(random, scenario);
        let code: Option<Participant> = Self::code(number).parse().ok();
        let mut lesson = Lesson::begin(Arc::clone(scenario), code);
        while kitchen.time_s() < scenario.max_s && !has_rested(&kitchen) {
            student.acts(&mut kitchen)?;
            kitchen.step();
            if lesson.observe(&kitchen) {
                student.guesses(&mut lesson, &kitchen);
            }
        }
        student.times.end_s = kitchen.time_s();
        let measures = Measures::read(&kitchen, &masses, &scenario.goal, &student.times);
        Ok(lesson.end(&measures, if has_rested(&kitchen) { RestKind::Seen } else { RestKind::None }))
    }
}

impl Student {
    fn new(mut random: Random, scenario: &Scenario) -> Self {
        let (scale, wanted) = (&scenario.goal.scale, scenario.goal.goal.class.as_ref());
        let class = scale.class.iter().position(|class| Some(&class.name) == wanted);
        let aim_c = saute_kitchen::advice::class_goal(scale, class.unwrap_or(scale.class.len() - 1));
        let [fry_w, pan_c, side_s] = [FRY_W, PAN_C, SIDE_S].map(|of| drawn(&mut random, of));
        let pull_c = aim_c + drawn(&mut random, PULL_K);
        let times = Times { put_s: None, out_s: None, end_s: 0.0, flips: 0 };
        Self { random, fry_w, pan_c, side_s: side_s.max(45.0), pull_c, times, last_flip_s: 0.0 }
    }

    /// The next act, if it is time for one.
    fn acts(&mut self, kitchen: &mut Kitchen) -> Result<(), CookError> {
        let Some(piece) = kitchen.pieces().first() else { return Ok(()) };
        let (food, now) = (piece.id.clone(), kitchen.time_s());
        if self.times.put_s.is_none() && celsius(kitchen.pan_temperature()) >= self.pan_c {
            kitchen.apply(&Command::Put { food, at: [0.0, 0.0], heap: false })?;
            kitchen.apply(&Command::Hob(self.fry_w))?;
            (self.times.put_s, self.last_flip_s) = (Some(now), now);
        } else if piece.in_pan() && celsius(piece.core()) >= self.pull_c {
            kitchen.apply(&Command::Rest { food, on: RestOn::Board })?;
            kitchen.apply(&Command::Hob(0.0))?;
            self.times.out_s = Some(now);
        } else if piece.in_pan() && now - self.last_flip_s >= self.side_s {
            kitchen.apply(&Command::Flip { food })?;
            (self.times.flips, self.last_flip_s) = (self.times.flips + 1, now);
        }
        Ok(())
    }

    /// Answers the question that waits.
    fn guesses(&mut self, lesson: &mut Lesson, kitchen: &Kitchen) {
        let Some((place, piece)) = lesson.waiting().zip(kitchen.pieces().first()) else { return };
        let (ask, core_c) = (lesson.scenario.predictions[place].ask, celsius(piece.core()));
        let guess = match ask {
            Ask::CoreNow => core_c + drawn(&mut self.random, [0.0, AHEAD_K[1]]),
            Ask::CoreIn(_) => core_c + drawn(&mut self.random, AHEAD_K),
            Ask::CorePeak => core_c + drawn(&mut self.random, PEAK_K),
            Ask::UndersideBrown => drawn(&mut self.random, BROWN_PCT),
            Ask::ClassInTheEnd => self.random.place(lesson.scenario.goal.scale.class.len()) as f64,
        };
        let [low, high] = ask.range().unwrap_or([guess, guess]);
        lesson.answer(libm::round(guess.clamp(low, high)));
    }
}

/// A number from a mean and a spread; none is further from it than two spreads.
fn drawn(random: &mut Random, [mean, spread]: [f64; 2]) -> f64 {
    mean + spread * random.normal().clamp(-2.0, 2.0)
}
