//! Forecast with the full model: the present kitchen, run on.

use saute_kitchen::{FRAME_S, Kitchen, Refused, TICK_S};

use crate::forecast::outlook::{Outlook, SAMPLE_S, Sample};
use crate::forecast::question::Ask;

/// How far "as it is" runs the full model [s].
pub const EXACT_S: f64 = 60.0;

/// A kitchen that runs on from the present with the action of the question. Its states are those of the kitchen itself, bit for bit, as
/// long as nothing else is done there.
#[derive(Clone, Debug)]
pub struct Exact {
    kitchen: Kitchen,
    ask: Ask,
    outlook: Outlook,
    ticks: u64,
    last: u64,
}

impl Exact {
    /// Forks a kitchen and does the action of the question; none where that is not possible now.
    ///
    /// # Errors
    /// If the kitchen refuses it.
    pub fn begin(kitchen: &Kitchen, ask: &Ask, for_s: f64) -> Result<Option<Self>, Refused> {
        let Some(commands) = ask.question.commands(kitchen, &ask.food) else { return Ok(None) };
        let Some(outlook) = Outlook::begin(kitchen, ask) else { return Ok(None) };
        let mut kitchen = kitchen.clone();
        commands.iter().try_for_each(|command| kitchen.apply(command))?;
        let last = (for_s / TICK_S).round() as u64;
        Ok(Some(Self { kitchen, ask: ask.clone(), outlook, ticks: 0, last }))
    }

    /// Advances by `ticks` at most; returns those that it took.
    pub fn advance(&mut self, ticks: u64) -> u64 {
        let per_sample = (SAMPLE_S / TICK_S).round() as u64;
        let todo = ticks.min(self.last - self.ticks);
        for _ in 0..todo {
            self.kitchen.step();
            self.ticks += 1;
            let after_s = self.ticks as f64 * TICK_S;
            if let Some(piece) = self.kitchen.piece(&self.ask.food) {
                self.outlook.note_core(piece.core(), after_s);
                if self.ticks.is_multiple_of(per_sample) {
                    self.outlook.samples.push(Sample::of(piece, &self.ask, after_s));
                }
            }
        }
        todo
    }

    /// Looks as far from a later present that it has passed, up to which nothing else was done: `by_s` later, a multiple of the time between
    /// two samples. Its results from there on stay, and only the rest is still to run.
    pub fn look_further(&mut self, by_s: f64) {
        self.ticks -= (by_s / TICK_S).round() as u64;
        self.outlook.begin_later(by_s, (by_s / FRAME_S).round() as u64);
    }

    /// Returns true once it has run as far as requested.
    pub fn is_done(&self) -> bool {
        self.ticks == self.last
    }

    /// The kitchen at the instant that it has reached.
    pub fn kitchen(&self) -> &Kitchen {
        &self.kitchen
    }

    /// What it has found so far.
    pub fn outlook(&self) -> &Outlook {
        &self.outlook
    }
}
