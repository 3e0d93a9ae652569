//! Forecast on a coarse mesh: five minutes ahead, and until the carry-over is over.

use saute_kitchen::Kitchen;
use saute_kitchen::food::BuildError;
use saute_kitchen::reduced::{LAPSE_S, ReducedKitchen, Reductions};

use crate::forecast::outlook::{Outlook, SAMPLE_S, Sample};
use crate::forecast::question::{Ask, Question};

/// How far a forecast looks ahead [s].
pub const HORIZON_S: f64 = 300.0;
/// Longest time until the core of a piece that was taken out has its peak [s] (chosen: that of 60 mm peaks within half an
/// hour).
const LONGEST_REST_S: f64 = 1800.0;
/// Fall of the core below its peak after which the carry-over is over [K] (chosen: twenty times the noise of a core).
const FALLEN_K: f64 = 0.2;

/// A kitchen on coarse meshes that runs ahead with what was asked.
#[derive(Clone, Debug)]
pub struct Ahead {
    kitchen: ReducedKitchen,
    ask: Ask,
    outlook: Outlook,
    /// Core of the full mesh less that of the coarse one, at the present [K]. It is added to what the coarse one finds.
    offset: f64,
    steps: u64,
    is_done: bool,
}

impl Ahead {
    /// Carries the present over to the coarse meshes and does what is asked; none where that is not possible now.
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
        Some(Self { kitchen: reduced, ask: ask.clone(), outlook, offset, steps: 0, is_done: false })
    }

    /// Advances by `steps` at most; returns those that it took.
    pub fn advance(&mut self, steps: u64) -> u64 {
        let mut taken = 0;
        while taken < steps && !self.is_done {
            self.kitchen.step();
            taken += 1;
            self.steps += 1;
            self.note();
        }
        taken
    }

    fn note(&mut self) {
        let after_s = self.steps as f64 * LAPSE_S;
        let per_sample = (SAMPLE_S / LAPSE_S).round() as u64;
        let Some(piece) = self.kitchen.kitchen().piece(&self.ask.food) else {
            self.is_done = true;
            return;
        };
        let core = piece.core() + self.offset;
        self.outlook.note_core(core, after_s);
        let beyond = after_s >= HORIZON_S;
        if self.steps.is_multiple_of(per_sample) && after_s <= HORIZON_S {
            self.outlook.samples.push(Sample { core, ..Sample::of(piece, &self.ask, after_s) });
        }
        let fallen = core < self.outlook.peak.core - FALLEN_K;
        self.outlook.peak.is_over = fallen;
        let rests = self.ask.question == Question::TakeOut;
        self.is_done = beyond && (!rests || fallen || after_s >= LONGEST_REST_S);
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
