//! A simulated person: habits, slips and practice.

use std::sync::Arc;

use saute_kitchen::Library;

use super::cook::{CookError, Rules, cook};
use crate::log_row::LogRow;
use crate::measures::Measures;
use crate::participant::Participant;
use crate::protocol::{Answering, CookForReal, LIKERT_STEPS, Protocol, Simulate};
use crate::protocol_file::{Entered, Information};
use crate::random::Random;
use crate::state::{Answer, Answers, Event, Stage, Study, StudyError};

/// Mean and standard deviation of the habit by which the core is misjudged, and standard deviation of the slip [K] (all numbers
/// of this page are chosen, see the module).
const HABIT_K: [f64; 2] = [4.0, 6.0];
const SLIP_K: f64 = 5.0;
/// Misjudged share of the time of a flip [-], heat of the pan [K] and power [W].
const FLIP_SHARE: f64 = 0.25;
const PAN_K: f64 = 30.0;
const POWER_W: f64 = 150.0;
/// Exponents of practice where read-outs are hidden and shown [-], and share of the misjudgement with which those begin who are shown
/// them [-].
const PRACTICE: [f64; 2] = [0.35, 0.6];
const SHOWN_SHARE: f64 = 0.5;
/// What a practised cook does: heat of the pan [°C], powers [W], pauses between flips at first and at last [s].
const PAN_C: f64 = 200.0;
const HEAT_W: f64 = 1600.0;
const FRY_W: f64 = 650.0;
const PAUSES_S: [f64; 2] = [260.0, 45.0];
/// Rise of the core in the rest that a practised cook expects [K] (one flip on a hot pan; recipes/medium.toml).
const RISE_K: f64 = 5.0;
/// Slips at a real stove over those in the simulator [-], and error of a thermometer [K].
const REAL_SLIPS: f64 = 1.5;
const THERMOMETER_K: f64 = 1.0;
/// Step in which a share is estimated by eye [%].
const BY_EYE_PCT: f64 = 5.0;
/// Wall time between two events, of which nothing depends [s].
const BETWEEN_S: f64 = 60.0;

/// Simulated participants of a protocol.
#[derive(Clone, Debug)]
pub struct Simulation {
    /// The protocol.
    pub protocol: Arc<Protocol>,
    /// The seed of all draws.
    pub seed: u64,
}

/// One person.
struct Person {
    random: Random,
    habit_k: f64,
    /// Cooks so far, in the simulator and at the stove.
    cooks: u32,
}

impl Simulation {
    /// Lets the participant with a number, from 1, take part; returns the log.
    ///
    /// # Errors
    ///
    /// If a kitchen of the protocol cannot be set up.
    pub fn log(&self, number: u32, library: &Library) -> Result<(Participant, Vec<LogRow>), CookError> {
        let code = format!("S{number:02}").parse();
        // The code is one: a letter and digits.
        let participant: Participant = code.unwrap_or_else(|_| unreachable!("S and digits are a code"));
        let mut study = Study::simulated(Arc::clone(&self.protocol), participant.clone());
        let mut person = Person::new(Random::new(&[self.seed, u64::from(number)]));
        let (mut rows, mut elapsed_s) = (Vec::new(), 0.0);
        while study.stage() != Stage::Over {
            let event = person.does(&study, library)?;
            elapsed_s += BETWEEN_S;
            match study.take(event, elapsed_s) {
                Ok(taken) => rows.extend(taken),
                // A person answers within the ranges of the protocol.
                Err(error @ StudyError::OutOfOrder) => unreachable!("{error}"),
                Err(error) => unreachable!("{error}"),
            }
        }
        Ok((participant, rows))
    }
}

impl Person {
    fn new(mut random: Random) -> Self {
        let habit_k = HABIT_K[0] + HABIT_K[1] * random.normal();
        Self { random, habit_k, cooks: 0 }
    }

    fn does(&mut self, study: &Study, library: &Library) -> Result<Event, CookError> {
        if let Some(simulate) = study.simulate() {
            let measures = Box::new(self.cook(simulate, study.information(), 1.0, library)?);
            return Ok(Event::TrialEnded { measures, wall_s: None, pace: None, session: None, devices: None });
        }
        if let Some(real) = study.cook_for_real() {
            return Ok(Event::Answered(self.cooks_for_real(real, study, library)?));
        }
        Ok(match study.questionnaire() {
            None => Event::Agreed,
            Some(asked) => {
                Event::Answered(asked.items.iter().map(|item| (item.id.clone(), self.answer(&item.answer))).collect())
            }
        })
    }

    fn cook(
        &mut self,
        simulate: &Simulate,
        information: Information,
        slips: f64,
        library: &Library,
    ) -> Result<Measures, CookError> {
        let rules = self.rules(simulate, information, slips);
        self.cooks += 1;
        cook(&simulate.recipe, &rules, &simulate.goal, library)
    }

    /// What the person does in the next cook.
    fn rules(&mut self, simulate: &Simulate, information: Information, slips: f64) -> Rules {
        let is_shown = information == Information::Shown;
        let left = libm::pow(1.0 + f64::from(self.cooks), -PRACTICE[usize::from(is_shown)]);
        let size = left * if is_shown { SHOWN_SHARE } else { 1.0 };
        let mut slip = |scale: f64| slips * size * scale * self.random.normal();
        let pause = PAUSES_S[1] + (PAUSES_S[0] - PAUSES_S[1]) * left;
        let scale = &simulate.goal.scale;
        let class = scale.class.iter().position(|c| Some(&c.name) == simulate.goal.goal.class.as_ref());
        let aim_c = saute_kitchen::advice::class_goal(scale, class.unwrap_or(scale.class.len() - 1));
        let misjudged = slip(SLIP_K);
        Rules {
            heat_w: HEAT_W,
            pan_c: (PAN_C + slip(PAN_K)).clamp(120.0, 260.0),
            fry_w: (FRY_W + slip(POWER_W)).clamp(300.0, 1200.0),
            first_flip_s: pause * (1.0 + slip(FLIP_SHARE)).clamp(0.3, 2.0),
            between_flips_s: pause * (1.0 + slip(FLIP_SHARE)).clamp(0.3, 2.0),
            pull_c: (aim_c - RISE_K + size * self.habit_k + misjudged).clamp(20.0, 95.0),
            max_s: simulate.max_s,
        }
    }

    /// Cooks at a stove that is simulated too; what is entered of it.
    fn cooks_for_real(&mut self, real: &CookForReal, study: &Study, library: &Library) -> Result<Answers, CookError> {
        let trials = study.protocol().phases.iter().find_map(|phase| match &phase.task {
            super::super::protocol::Task::Simulate(simulate) => Some(simulate),
            _ => None,
        });
        let Some(simulate) = trials else {
            return Ok(real.enter.iter().map(|e| self.without_a_cook(*e, real)).collect());
        };
        let measures = self.cook(simulate, Information::Hidden, REAL_SLIPS, library)?;
        Ok(real.enter.iter().map(|entered| (entered.id().to_owned(), self.entry(*entered, real, &measures))).collect())
    }

    fn entry(&mut self, entered: Entered, real: &CookForReal, measures: &Measures) -> Answer {
        let core_c = measures.core_peak_c + THERMOMETER_K * self.random.normal();
        let value = match entered {
            Entered::CoreC => libm::round(10.0 * core_c) / 10.0,
            Entered::Class => {
                let scale = &real.goal.scale;
                return Answer::Choice(scale.class_of(scale.of_nodes(measures.at_core)));
            }
            Entered::TargetSharePct => BY_EYE_PCT * libm::round(measures.target_share_pct / BY_EYE_PCT),
            Entered::WeightBeforeG => measures.mass_before_g,
            Entered::WeightAfterG => measures.mass_before_g * (1.0 - measures.lost_pct / 100.0),
            Entered::PanTimeS => measures.out_s.unwrap_or(measures.end_s) - measures.put_s.unwrap_or(0.0),
            Entered::RestTimeS => measures.end_s - measures.out_s.unwrap_or(measures.end_s),
            Entered::Flips => f64::from(measures.flips),
        };
        let [low, high] = entered.range().unwrap_or([0.0, 0.0]);
        Answer::Number(libm::round(10.0 * value.clamp(low, high)) / 10.0)
    }

    /// Something in its range, where the protocol has no trials from which a cook is known.
    fn without_a_cook(&mut self, entered: Entered, real: &CookForReal) -> (String, Answer) {
        let answer = match entered.range() {
            Some([low, high]) => Answer::Number(libm::round(low + (high - low) * self.random.unit())),
            None => Answer::Choice(self.random.place(real.goal.scale.class.len())),
        };
        (entered.id().to_owned(), answer)
    }

    /// An answer to a question: any of them; a simulated person has no opinion.
    fn answer(&mut self, answering: &Answering) -> Answer {
        match answering {
            Answering::Likert(_) => Answer::Number(1.0 + self.random.place(LIKERT_STEPS.into()) as f64),
            Answering::Number([low, high], _) => {
                Answer::Number(libm::round(low + (high - low) * self.random.unit()).clamp(*low, *high))
            }
            Answering::Choice(choices) => Answer::Choice(self.random.place(choices.len())),
            Answering::Text => Answer::Text(String::new()),
        }
    }
}
