//! Truths that were noted too early: before the rest was cooked on, a lesson that ended while its food rested took the present for the end.

use super::histogram::may_be_class;
use super::result_row::{MOST_QUESTIONS, ResultRow};
use super::scenario_file::AskKind;
use super::shipped;
use crate::measures::Measures;

/// A rest after which such a truth is believed [simulated s] (chosen; cooked with the steaks of the shipped lessons at 1000 W: of 25 mm,
/// taken out after 150, 300 and 420 s, the peak comes 859, 548 and 399 s later, and the core lacks 0.2 K of it at 600 s; of 35 mm, after
/// 300 and 480 s, it comes 1470 and 1146 s later, and 2.8 and 1.6 K are lacking).
const BELIEVED_AFTER_S: f64 = 600.0;

impl ResultRow {
    /// The places of questions about the end whose truth may have been noted before the end; none in results of today, which state whether the
    /// food had rested.
    pub fn early_truths(&self) -> Vec<usize> {
        let rested_s = self.out_s.map_or(0.0, |out_s| self.end_s - out_s);
        if self.rest.is_some() || rested_s >= BELIEVED_AFTER_S {
            return Vec::new();
        }
        let asks = shipped::asks(&self.scenario, &self.checksum);
        let is_early = |place: &usize| {
            let Some(truth) = self.questions()[*place][1] else { return false };
            match &asks {
                Some(asks) => matches!(asks.get(*place), Some(AskKind::CorePeak | AskKind::ClassInTheEnd)),
                // Of another scenario the row itself shows: its peak, or the place of a class.
                None => truth == Measures::rounded(self.core_peak_c) || may_be_class(truth),
            }
        };
        (0..MOST_QUESTIONS).filter(is_early).collect()
    }
}
