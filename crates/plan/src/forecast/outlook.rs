//! The result of a forecast: the course of a piece from now on.

use saute_kitchen::food::change::doneness::Measure;
use saute_kitchen::food::readings::FaceReading;
use saute_kitchen::food::{Scale, Shares};
use saute_kitchen::{Kitchen, Piece};
use serde::{Deserialize, Serialize};

use crate::forecast::question::{Ask, Question};

/// Time between two samples [s].
pub const SAMPLE_S: f64 = 5.0;

/// State of the piece at an instant ahead.
#[derive(Clone, Copy, Debug, Deserialize, PartialEq, Serialize)]
pub struct Sample {
    /// Time from the present on [s].
    pub after_s: f64,
    /// Core temperature [K].
    pub core: f64,
    /// Lower face, upper face: temperature, colour, browning, charring, moisture.
    pub faces: [FaceReading; 2],
    /// Shares of the section's doneness, in the order of the scale's classes [%].
    pub shares: Option<Shares>,
}

/// Highest core temperature ahead.
#[derive(Clone, Copy, Debug, Deserialize, PartialEq, Serialize)]
pub struct Peak {
    /// Temperature [K].
    pub core: f64,
    /// Time from the present on [s].
    pub after_s: f64,
    /// True if the core falls again within what was computed: the carry-over is over.
    pub is_over: bool,
}

/// The course of a piece from the present on.
#[derive(Clone, Debug, Deserialize, PartialEq, Serialize)]
pub struct Outlook {
    /// The question.
    pub question: Question,
    /// Name of the piece.
    pub food: String,
    /// Frames of the kitchen at its present: the age of the forecast counts from there.
    pub frame: u64,
    /// Its states, from the present on.
    pub samples: Vec<Sample>,
    /// Highest core temperature so far and ahead.
    pub peak: Peak,
}

impl Sample {
    /// Reads a piece.
    pub(super) fn of(piece: &Piece, ask: &Ask, after_s: f64) -> Self {
        let (model, state, up) = (&piece.model, &piece.state, piece.up());
        let shares = ask.scale.as_ref().map(|scale| model.cut_shares(state, &model.cut_across(0.0), scale));
        let faces = [up, up.map(|v| -v)].map(|up| model.face_reading(state, up));
        Self { after_s, core: piece.core(), faces, shares }
    }
}

impl Outlook {
    /// The course of a piece of which only the present is known; none without the piece.
    pub(super) fn begin(kitchen: &Kitchen, ask: &Ask) -> Option<Self> {
        let piece = kitchen.piece(&ask.food)?;
        let sample = Sample::of(piece, ask, 0.0);
        Some(Self {
            question: ask.question,
            food: ask.food.clone(),
            frame: kitchen.frame(),
            peak: Peak { core: sample.core, after_s: 0.0, is_over: false },
            samples: vec![sample],
        })
    }

    /// Adds the core at an instant ahead to the peak.
    pub(super) fn note_core(&mut self, core: f64, after_s: f64) {
        if core > self.peak.core {
            (self.peak.core, self.peak.after_s) = (core, after_s);
        }
    }

    /// Lets it begin later [s, and as frames]: samples before that are dropped, and a peak among them is that of the others.
    pub(super) fn begin_later(&mut self, by_s: f64, frames: u64) {
        self.frame += frames;
        self.samples.retain(|sample| sample.after_s >= by_s);
        self.samples.iter_mut().for_each(|sample| sample.after_s -= by_s);
        self.peak.after_s -= by_s;
        if self.peak.after_s < 0.0 {
            let hottest = self.samples.iter().max_by(|a, b| a.core.total_cmp(&b.core));
            let (core, after_s) = hottest.map_or((0.0, 0.0), |sample| (sample.core, sample.after_s));
            (self.peak.core, self.peak.after_s) = (core, after_s);
        }
    }

    /// True if what was taken out still warms at the end: its highest core is higher than what is known.
    pub fn still_warms(&self) -> bool {
        self.question == Question::TakeOut && !self.peak.is_over
    }

    /// Class in which the core ends, given what a scale measures there now [K or -]: the class of the highest core temperature so far
    /// and ahead; where the scale measures a share, the class that most of the last section is in, if sections were shared out.
    pub fn class(&self, scale: &Scale, reached: f64) -> Option<usize> {
        match scale.measure() {
            Measure::Peak => Some(scale.class_of(reached.max(self.peak.core))),
            Measure::Share => {
                let Shares(shares) = self.samples.last()?.shares?;
                (0..scale.class.len().min(shares.len())).max_by(|a, b| shares[*a].total_cmp(&shares[*b]))
            }
        }
    }

    /// Core temperature at a time from the present on, linear between the samples; the last one beyond them [K].
    pub fn core_at(&self, after_s: f64) -> f64 {
        let next = self.samples.partition_point(|sample| sample.after_s < after_s);
        let Some(after) = self.samples.get(next) else { return self.samples.last().map_or(f64::NAN, |s| s.core) };
        let Some(before) = next.checked_sub(1).map(|i| &self.samples[i]) else { return after.core };
        let share = (after_s - before.after_s) / (after.after_s - before.after_s);
        before.core + share * (after.core - before.core)
    }
}
