//! What came of a trial, in the numbers of a log.

use saute_kitchen::Kitchen;
use saute_recipe::session::Deed;
use saute_recipe::{Recorder, Recording};

use super::log_row::LogRow;
use saute_plan::Aimed;
use saute_plan::goal::{Course, GoalVerdict, Judged, Judgement};

/// What came of a trial.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Measures {
    /// Score [points].
    pub score: f64,
    /// Mark [points].
    pub mark: f64,
    /// True if the goal was met.
    pub is_met: bool,
    /// Share that the goal counts [%].
    pub target_share_pct: f64,
    /// Share of the section beyond the class of the goal [%].
    pub beyond_pct: f64,
    /// Thickness of the grey band, mean of both faces [mm].
    pub grey_band_mm: f64,
    /// Highest temperature of the core [°C].
    pub core_peak_c: f64,
    /// What the scale of the goal measures at the core [°C or %].
    pub at_core: f64,
    /// Browned share of the faces [%].
    pub crust_pct: f64,
    /// Charred share of the faces [%].
    pub charred_pct: f64,
    /// Mass that was lost [%].
    pub lost_pct: f64,
    /// Mass of the raw food [g].
    pub mass_before_g: f64,
    /// Electrical energy of the hob [kJ].
    pub energy_kj: f64,
    /// Number of flips.
    pub flips: u32,
    /// When the food went into the pan, was taken out, and the trial ended [simulated s].
    pub put_s: Option<f64>,
    /// See [`Self::put_s`].
    pub out_s: Option<f64>,
    /// See [`Self::put_s`].
    pub end_s: f64,
}

/// When things were done, and how often food was flipped.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Times {
    /// When food first went into the pan [simulated s].
    pub put_s: Option<f64>,
    /// When food was taken out for the last time [simulated s].
    pub out_s: Option<f64>,
    /// When the cook ended [simulated s].
    pub end_s: f64,
    /// Number of flips.
    pub flips: u32,
}

impl Times {
    /// Reads them of a recording up to its present instant, and the flips of what was seen: those of a tool in the hand are no commands.
    pub fn of(recording: &Recording, seen: &Recorder) -> Self {
        let flips = u32::try_from(seen.turns().count()).unwrap_or(u32::MAX);
        let mut times = Self { end_s: recording.moment().time_s(), flips, ..Self::default() };
        for entry in recording.entries() {
            let Deed::Command(command) = &entry.deed else { continue };
            match command {
                saute_kitchen::Command::Put { .. } => times.put_s = times.put_s.or(Some(entry.time_s())),
                saute_kitchen::Command::Rest { .. } => times.out_s = Some(entry.time_s()),
                _ => {}
            }
        }
        times
    }
}

impl Measures {
    /// Reads what came of a kitchen, given the masses of its pieces at the start [kg]. Without a piece there is nothing but times.
    pub fn read(kitchen: &Kitchen, masses_at_start: &[f64], aimed: &Aimed, times: &Times) -> Self {
        let &Times { put_s, out_s, end_s, flips } = times;
        let of_times = Self { flips, put_s, out_s, end_s, ..Self::default() };
        let judged =
            Judged { kitchen, pieces: kitchen.pieces().iter().collect(), masses_at_start: masses_at_start.to_vec() };
        let course = Course { flips: flips as usize, ..Course::default() };
        let Some(judgement) = Judgement::of(&judged, &course, &aimed.judged) else { return of_times };
        let outcome = judgement.outcome;
        Self {
            score: judgement.score.0,
            mark: judgement.mark.points(),
            is_met: judgement.verdict == GoalVerdict::Met,
            target_share_pct: outcome.target_share_pct,
            beyond_pct: outcome.beyond_pct,
            grey_band_mm: judgement.grey_mm.iter().sum::<f64>() / 2.0,
            core_peak_c: outcome.core_peak_c,
            at_core: outcome.at_core,
            crust_pct: outcome.crust_pct,
            charred_pct: outcome.charred_pct,
            lost_pct: outcome.lost_pct,
            mass_before_g: 1e3 * masses_at_start.iter().sum::<f64>(),
            energy_kj: judgement.energy_kj,
            ..of_times
        }
    }

    /// A value to two decimal places, as logs hold it; −0 is 0.
    pub fn rounded(value: f64) -> f64 {
        libm::round(100.0 * value) / 100.0 + 0.0
    }

    /// The same to two decimal places.
    pub fn to_two_places(&self) -> Self {
        let r = Self::rounded;
        Self {
            score: r(self.score),
            mark: r(self.mark),
            is_met: self.is_met,
            target_share_pct: r(self.target_share_pct),
            beyond_pct: r(self.beyond_pct),
            grey_band_mm: r(self.grey_band_mm),
            core_peak_c: r(self.core_peak_c),
            at_core: r(self.at_core),
            crust_pct: r(self.crust_pct),
            charred_pct: r(self.charred_pct),
            lost_pct: r(self.lost_pct),
            mass_before_g: r(self.mass_before_g),
            energy_kj: r(self.energy_kj),
            flips: self.flips,
            put_s: self.put_s.map(r),
            out_s: self.out_s.map(r),
            end_s: r(self.end_s),
        }
    }

    /// Writes them into a row.
    pub(super) fn written(&self, row: LogRow) -> LogRow {
        let m = self.to_two_places();
        LogRow {
            score: Some(m.score),
            mark: Some(m.mark),
            is_met: Some(m.is_met),
            target_share_pct: Some(m.target_share_pct),
            beyond_pct: Some(m.beyond_pct),
            grey_band_mm: Some(m.grey_band_mm),
            core_peak_c: Some(m.core_peak_c),
            crust_pct: Some(m.crust_pct),
            charred_pct: Some(m.charred_pct),
            lost_pct: Some(m.lost_pct),
            energy_kj: Some(m.energy_kj),
            flips: Some(m.flips),
            put_s: m.put_s,
            out_s: m.out_s,
            end_s: Some(m.end_s),
            ..row
        }
    }
}
