//! Forecast, advice and scale for the piece that the panels show.

use std::sync::Arc;

use saute_kitchen::advice::{Advice, FORECAST_HIGH_K, Goal, advise};
use saute_kitchen::doneness::{ScaleChoice, at_core, fitting};
use saute_kitchen::food::Scale;
use saute_kitchen::food::change::doneness::Measure;
use saute_kitchen::piece::carry_over::foreseen_peak;
use saute_kitchen::{Place, celsius};

use super::Session;
use super::foreseen_peak::Forecast;
use crate::hands::Hands;
use crate::kept_order::Moment;

/// Least rise of a resting core that is spoken of [K] (chosen: as much as the forecast is wrong).
const RISES_K: f64 = 0.5;

impl<H: Hands> Session<H> {
    /// Returns how high the core of food that was taken out still rises, and in how long; none once it is near its highest, or
    /// cools. Updated every simulated second.
    pub fn rise(&mut self) -> Option<Forecast> {
        self.shown_piece().filter(|piece| matches!(piece.place, Place::Rest(_)))?;
        let foreseen = self.peak_to_come()?;
        let (piece, peak_c) = (self.shown_piece()?, foreseen.peak_c - FORECAST_HIGH_K);
        let is_at_peak = piece.core() > piece.core_peak.0 - RISES_K;
        (is_at_peak && peak_c > celsius(piece.core()) + RISES_K).then_some(Forecast { peak_c, ..foreseen })
    }

    /// Returns the forecast for taking the food out now; updated every simulated second.
    pub fn forecast(&mut self) -> Option<Forecast> {
        self.shown_piece().filter(|piece| piece.in_pan())?;
        self.peak_to_come()
    }

    /// The highest core to expect of the piece where it lies, if it gets no more heat.
    fn peak_to_come(&mut self) -> Option<Forecast> {
        let piece = self.shown_piece()?;
        let second = self.kitchen.tick() / 10;
        if self.forecast.as_ref().is_none_or(|(id, at, _)| *at != second || *id != piece.id) {
            let (peak, in_s) = foreseen_peak(&piece.model, &piece.state, self.kitchen.room());
            self.forecast = Some((piece.id.clone(), second, Forecast { peak_c: celsius(peak), in_s }));
        }
        self.forecast.as_ref().map(|(.., f)| *f)
    }

    /// Returns the core peak that the advice expects if the food were taken out now [°C]; none of food that is not in the pan.
    pub fn expected_peak_c(&self) -> Option<f64> {
        let piece = self.shown_piece().filter(|piece| piece.in_pan())?;
        self.forecast.as_ref().filter(|(id, ..)| *id == piece.id).map(|(.., found)| found.peak_c - FORECAST_HIGH_K)
    }

    /// Returns advice for the piece that the panels show, the most urgent first, with a goal for its core, in the unit of the scale [°C or %],
    /// where a scale of doneness applies.
    pub fn advice(&mut self, goal: Option<(Arc<Scale>, f64)>) -> Vec<Advice> {
        let goal = goal.and_then(|(scale, wanted)| match scale.measure() {
            Measure::Peak => self.forecast().map(|f| Goal::Peak { core_c: wanted, foreseen_c: f.peak_c }),
            Measure::Share => {
                let reached_pct = 100.0 * at_core(self.shown_piece()?, &scale);
                Some(Goal::Share { wanted_pct: wanted, reached_pct })
            }
        });
        let advice = self.shown_piece().map_or_else(Vec::new, |piece| advise(&self.kitchen, piece, goal));
        let now = Moment { hob_w: self.kitchen.hob_w(), time_s: self.kitchen.time_s(), speed: self.speed };
        self.order.keep(advice, now)
    }

    /// Returns the scales of doneness with the one with an id chosen.
    pub fn scales(&self, id: &str) -> ScaleChoice {
        ScaleChoice::new(&self.library.scales, id)
    }

    /// Returns the scale in whose words the piece that the panels show is spoken of, given the id of the chosen one.
    pub fn scale(&self, id: &str) -> Option<Arc<Scale>> {
        let scales = self.scales(id);
        self.shown_piece().map_or_else(|| scales.alone(), |piece| scales.of(&piece.model)).cloned()
    }

    /// Returns the scales among which the cook chooses for the piece that the panels show.
    pub fn fitting_scales(&self) -> Vec<Arc<Scale>> {
        let all = &self.library.scales;
        self.shown_piece()
            .map_or_else(|| all.clone(), |piece| fitting(all, &piece.model).into_iter().cloned().collect())
    }
}
