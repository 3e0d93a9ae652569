//! Forecast, advice and scale for the piece that the panels show.

use std::sync::Arc;

use saute_kitchen::advice::{Advice, Goal, Situation};
use saute_kitchen::celsius;
use saute_kitchen::food::Scale;
use saute_kitchen::piece::carry_over::foreseen_peak;
use saute_picture::stage::fitting_piece;

use super::Session;

/// Forecast for food that is taken out now.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Forecast {
    /// Expected core peak [°C].
    pub peak_c: f64,
    /// In how many seconds.
    pub in_s: f64,
}

impl Session {
    /// Returns the forecast for taking the food out now; updated every simulated second.
    pub fn forecast(&mut self) -> Option<Forecast> {
        let piece = self.steak().filter(|p| p.in_pan())?;
        let second = self.kitchen.tick() / 10;
        if self.forecast.as_ref().is_none_or(|(id, at, _)| *at != second || *id != piece.id) {
            let (peak, in_s) = foreseen_peak(&piece.model, &piece.state, self.kitchen.room());
            self.forecast = Some((piece.id.clone(), second, Forecast { peak_c: celsius(peak), in_s }));
        }
        self.forecast.as_ref().map(|(.., f)| *f)
    }

    /// Returns advice for the piece that the panels show, with a goal for its core [°C] where a scale of doneness applies.
    pub fn advice(&mut self, goal_c: Option<f64>) -> Option<Advice> {
        let foreseen = goal_c.and_then(|_| self.forecast());
        let goal = goal_c.zip(foreseen).map(|(core_c, f)| Goal { core_c, foreseen_c: f.peak_c });
        Situation::of(&self.kitchen, self.steak()?).advice(goal)
    }

    /// Returns the scale of doneness with an id, else the first.
    pub fn chosen_scale(&self, id: &str) -> Option<&Arc<Scale>> {
        self.library.scale(id).or_else(|| self.library.scales.first())
    }

    /// Returns the chosen scale if it applies to the piece that the panels show.
    pub fn scale(&self, id: &str) -> Option<Arc<Scale>> {
        fitting_piece(self.steak(), self.chosen_scale(id)?)
    }
}
