//! Forecast on a coarse mesh: five minutes ahead, and until the carry-over is over.

use saute_kitchen::food::BuildError;
use saute_kitchen::reduced::{LAPSE_S, ReducedKitchen, Reductions};
use saute_kitchen::{FRAME_S, Kitchen};

use crate::forecast::outlook::{Outlook, SAMPLE_S, Sample};
use crate::forecast::question::{Ask, Question};

/// How far a forecast looks ahead [s].
pub const HORIZON_S: f64 = 300.0;
/// Longest time until the core of a piece that was taken out has its peak [s] (chosen: that of 60 mm peaks within half an
/// hour).
const LONGEST_REST_S: f64 = 1800.0;
/// Core above the room's air below which food is raw, and how long that is followed [K, s] (chosen: on the board it only warms to the room, for
/// hours, which is no carry-over).
const RAW_K: f64 = 10.0;
const LONGEST_RAW_S: f64 = 600.0;
/// Steps of resting food at once [-] (measured with 25 mm: two change the core by 0.01 K, five by 0.06 K; ten can be unstable).
const LEAP: u64 = 2;
/// What a sum of frames may miss of a time [s].
const HAIR_S: f64 = 1e-6;
/// Fall of the core below its peak after which the carry-over is over [K] (chosen: twenty times the noise of a core).
const FALLEN_K: f64 = 0.2;

/// A kitchen on coarse meshes that runs ahead with the action of the question.
#[derive(Clone, Debug)]
pub struct Ahead {
    kitchen: ReducedKitchen,
    ask: Ask,
    outlook: Outlook,
    /// Core of the full mesh less that of the coarse one, at the present [K]. It is added to what the coarse one finds.
    offset: f64,
    steps: u64,
    /// By how much the present has moved on since it began [s].
    present_s: f64,
    is_done: bool,
}

impl Ahead {
    /// Carries the present over to the coarse meshes and does the action of the question; none where that is not possible now.
    ///
    /// # Errors
    /// If a coarse mesh cannot be built.
    pub fn begin(kitchen: &Kitchen, ask: &Ask, reductions: &mut Reductions) -> Result<Option<Self>, BuildError> {
        let reduced = kitchen.reduced(reductions)?;
        Ok(Self::from(kitchen, reduced, ask))
    }

    /// As [`Self::begin`], with the present on coarse meshes, which several questions share.
    pub fn from(kitchen: &Kitchen, mut reduced: ReducedKitchen, ask: &Ask) -> Option<Self> {
        let commands = ask.question.commands(kitchen, &ask.food)?;
        let outlook = Outlook::begin(kitchen, ask)?;
        let offset = outlook.samples.first()?.core - reduced.kitchen().piece(&ask.food)?.core();
        // What the kitchen refuses of its present, as a lid that is on, it refuses here too: then nothing is foreseen.
        commands.iter().try_for_each(|command| reduced.apply(command)).ok()?;
        Some(Self { kitchen: reduced, ask: ask.clone(), outlook, offset, steps: 0, present_s: 0.0, is_done: false })
    }

    /// Advances by `steps`, by one more where food rests; returns those that it took.
    pub fn advance(&mut self, steps: u64) -> u64 {
        let mut taken = 0;
        while taken < steps && !self.is_done {
            let steps = self.step();
            taken += steps;
            self.steps += steps;
            self.note();
        }
        taken
    }

    /// Takes a step, or at rest as many as meet the samples; returns how many.
    fn step(&mut self) -> u64 {
        if self.steps.is_multiple_of(LEAP) {
            return self.kitchen.step_resting(LEAP);
        }
        self.kitchen.step();
        1
    }

    fn note(&mut self) {
        let after_s = self.after_s();
        let per_sample = (SAMPLE_S / LAPSE_S).round() as u64;
        let Some(piece) = self.kitchen.kitchen().piece(&self.ask.food) else {
            self.is_done = true;
            return;
        };
        let core = piece.core() + self.offset;
        self.outlook.note_core(core, after_s);
        let is_last_known = self.outlook.samples.last().is_some_and(|last| !is_before_horizon(last.after_s));
        let beyond = !is_before_horizon(after_s);
        if beyond && !is_last_known || !beyond && self.steps.is_multiple_of(per_sample) {
            self.outlook.samples.push(Sample { core, ..Sample::of(piece, &self.ask, after_s) });
        }
        let fallen = core < self.outlook.peak.core - FALLEN_K;
        self.outlook.peak.is_over = fallen;
        let carries_over = self.ask.question == Question::TakeOut && !fallen && after_s < self.longest_rest_s(core);
        self.is_done = beyond && !carries_over;
    }

    /// How long a core is waited for that does not fall [s].
    fn longest_rest_s(&self, core: f64) -> f64 {
        let room = self.kitchen.kitchen().room().temperature();
        if core < room + RAW_K { LONGEST_RAW_S } else { LONGEST_REST_S }
    }

    /// Looks as far from a later present of the kitchen, which it has passed: its results from there on stay, and only the rest is still
    /// to run. Nothing happens without the piece.
    pub fn look_further(&mut self, kitchen: &Kitchen) {
        let Some(piece) = kitchen.piece(&self.ask.food) else { return };
        let frames = kitchen.frame().saturating_sub(self.outlook.frame);
        let by_s = frames as f64 * FRAME_S;
        self.outlook.begin_later(by_s, frames);
        self.outlook.samples.retain(|sample| sample.after_s > HAIR_S);
        self.outlook.samples.insert(0, Sample::of(piece, &self.ask, 0.0));
        self.outlook.note_core(piece.core(), 0.0);
        self.present_s += by_s;
        self.is_done = !is_before_horizon(self.after_s());
    }

    /// How far it has run beyond the present [s].
    fn after_s(&self) -> f64 {
        self.steps as f64 * LAPSE_S - self.present_s
    }

    /// How long ago its state was that of the kitchen [s].
    pub fn since_begun_s(&self) -> f64 {
        self.present_s
    }

    /// Returns true once it has run as far as it looks.
    pub fn is_done(&self) -> bool {
        self.is_done
    }

    /// What it has found so far.
    pub fn outlook(&self) -> &Outlook {
        &self.outlook
    }
}

fn is_before_horizon(after_s: f64) -> bool {
    after_s < HORIZON_S - HAIR_S
}
