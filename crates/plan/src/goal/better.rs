//! The one thing to do better the next time: chosen by rule, from what costs the most points.

use core::mem::discriminant;

use saute_kitchen::advice::{HOT_C, TOO_COLD_C, WARM_ENOUGH_C};
use saute_kitchen::data::goals::Counted;
use saute_kitchen::food::change::doneness::Measure;

use crate::goal::score::HOT_C as MOST_C;
use crate::goal::{Course, Goal, Outcome, Shortfall, Term, TermKind};

/// What to do better the next time.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Better {
    /// Let it rest longer: the core is still warming.
    RestLonger,
    /// Take it out earlier.
    PullEarlier {
        /// How far the core is beyond the aim, in the unit of the scale [K or points of %].
        by: f64,
        /// How much earlier [s]; none if the state does not show it.
        by_s: Option<f64>,
    },
    /// Leave it in longer.
    PullLater {
        /// How far the core is below the aim, in the unit of the scale [K or points of %].
        by: f64,
        /// How much longer [s]; none if the state does not show it.
        by_s: Option<f64>,
    },
    /// Leave it in much longer: it was far from done.
    LeaveIn {
        /// How far the core is below the aim, in the unit of the scale [K or points of %].
        by: f64,
        /// What the core is to come near, in the unit of the scale [°C or %].
        until: f64,
    },
    /// Wait until the pan is hot before the food goes in.
    HotterPan {
        /// What it had [°C].
        had_c: f64,
        /// What to wait for [°C].
        until_c: f64,
    },
    /// Keep the pan below a temperature: the oil came near its flash point.
    CoolerPan {
        /// Hottest place of its floor [°C].
        had_c: f64,
        /// What it should stay below [°C].
        most_c: f64,
    },
    /// Put in less at a time.
    LessCrowded {
        /// Share of the floor that the food covered [%].
        covered_pct: f64,
    },
    /// Dry the food: its water cooled the pan.
    DryFaces {
        /// Lowest temperature of the pan under the food [°C].
        lowest_c: f64,
    },
    /// Give the paler face more time.
    PalerFace {
        /// Browned shares of the paler and the browner face [%].
        faces_pct: [f64; 2],
    },
    /// Brown with more power.
    MorePower {
        /// What the hob drew on average while the food was in the pan [W]; none if it is not known.
        had_w: Option<f64>,
    },
    /// Fry with less power.
    LessPower {
        /// What the hob drew on average while the food was in the pan [W]; none if it is not known.
        had_w: Option<f64>,
    },
    /// Flip more often.
    FlipMoreOften {
        /// Flips that there were.
        had: usize,
        /// Time between flips [s].
        every_s: f64,
    },
}

/// What the rules read.
pub(crate) struct Evidence<'a> {
    pub(crate) outcome: &'a Outcome,
    pub(crate) terms: &'a [Term],
    pub(crate) course: &'a Course,
    pub(crate) goal: &'a Goal,
    /// Browned shares of the two faces [%].
    pub(crate) faces_pct: [f64; 2],
    /// What is missing.
    pub(crate) shortfalls: &'a [Shortfall],
    /// True if the core of a resting piece still warms, and is expected to meet the goal.
    pub(crate) warms: bool,
    /// Share of the pan's floor that the food covers [%].
    pub(crate) covered_pct: f64,
}

/// Points below which nothing is worth a word (chosen: less than a sixtieth of a good score).
const LEAST_POINTS: f64 = 1.0;
/// Share of a section beyond the class that a good cook in a pan has [%] (tests/plan/advised.rs: 46 to 52 % with two flips and more, 57 % with
/// one; flips every half minute leave 45 %).
const UNAVOIDABLE_PCT: f64 = 52.0;
/// Share of the floor above which food is crowded [%] (chosen: steam has no way out between the pieces).
const CROWDED_PCT: f64 = 60.0;
/// Difference of the browned shares from which one face is the paler one [%] (chosen: the eye sees it at once).
const UNEVEN_PCT: f64 = 20.0;
/// Distance of a core from its aim below which the time in the pan was right [K or points of %] (chosen: twice what a probe errs).
const NEAR_AIM: f64 = 2.0;
/// Time between flips that makes a thin grey band [s] (the recipe `flip-every-30-s` and plans of its kind).
const FLIP_EVERY_S: f64 = 30.0;
/// Flips from which more of them gain little [-] (chosen: the band of plans with four is nearly that of plans with twelve).
const MANY_FLIPS: usize = 4;
/// Time beyond which a change of the time in the pan is given without it [s] (chosen: the core does not rise evenly for that long).
const FAR_S: f64 = 300.0;
/// Distance of a core from its aim from which it was far from done where no time is known [K or points of %] (chosen: two classes).
const FAR_OFF: f64 = 20.0;
/// What takes one off the other: times are given in steps of this [s] (chosen: nobody pulls by the second).
const STEP_S: f64 = 5.0;

impl Better {
    /// Chooses what to do better; none if nothing costs a point.
    pub(crate) fn of(evidence: &Evidence) -> Option<Self> {
        let costs = evidence.costs();
        // What is wrong in two ways and mended in one counts twice.
        let saves = |better: &Self| -> f64 {
            let same = costs.iter().filter(|(_, other)| discriminant(other) == discriminant(better));
            same.map(|(points, _)| points).sum()
        };
        let worst = costs.iter().map(|(_, better)| better).max_by(|a, b| saves(a).total_cmp(&saves(b)))?;
        (saves(worst) >= LEAST_POINTS).then_some(*worst)
    }
}

impl Evidence<'_> {
    fn points(&self, kind: TermKind) -> f64 {
        self.terms.iter().filter(|term| term.kind == kind).map(|term| term.points().abs()).sum()
    }

    /// What costs points, with what would save them: of a goal that is missed what it misses, of one that is met everything.
    fn costs(&self) -> Vec<(f64, Better)> {
        let goal = self.goal;
        if self.shortfalls.is_empty() {
            let grey = ((self.outcome.beyond_pct - UNAVOIDABLE_PCT).max(0.0), self.grey());
            let all = [Shortfall::Fire, Shortfall::Crust, Shortfall::Burnt].map(|one| self.cost(one));
            return all
                .into_iter()
                .chain(goal.core_counts.then(|| self.cost(Shortfall::Overcooked)))
                .chain([grey])
                .collect();
        }
        self.shortfalls.iter().map(|shortfall| self.cost(*shortfall)).collect()
    }

    /// What a shortfall costs, and what would save that.
    fn cost(&self, shortfall: Shortfall) -> (f64, Better) {
        let (outcome, goal, had_w) = (self.outcome, self.goal, self.course.power_w);
        let points = |kinds: &[TermKind]| kinds.iter().map(|kind| self.points(*kind)).sum();
        match shortfall {
            Shortfall::Undercooked | Shortfall::Overcooked => {
                (points(&[TermKind::CoreMiss, TermKind::OffAim]), self.pull(outcome.at_core - goal.aim))
            }
            Shortfall::Share => ((goal.least_share_pct - outcome.target_share_pct).max(0.0), self.share()),
            Shortfall::Crust => (points(&[TermKind::MissingCrust]), self.crust()),
            Shortfall::Burnt => (points(&[TermKind::Charred]), Better::LessPower { had_w }),
            Shortfall::Fire => {
                let (had_c, most_c) = (outcome.hottest_c, MOST_C);
                (points(&[TermKind::Fire, TermKind::Hot]), Better::CoolerPan { had_c, most_c })
            }
        }
    }

    /// What gives a larger share: of the faces more crust, of the section a core that is nearer to the aim, else a thinner band.
    fn share(&self) -> Better {
        let off = self.outcome.at_core - self.goal.aim;
        match self.goal.counts {
            Counted::Faces => self.crust(),
            Counted::Section if off.abs() > NEAR_AIM => self.pull(off),
            Counted::Section => self.grey(),
        }
    }

    /// When to take it out, given how far the core is off [K or points of %].
    fn pull(&self, off: f64) -> Better {
        let is_peak = self.goal.scale.measure() == Measure::Peak;
        let rise = self.course.rise_k_s.filter(|rise| is_peak && *rise > 0.0);
        let by_s = rise.map(|rise| STEP_S * libm::round(off.abs() / rise / STEP_S).max(1.0));
        match off {
            off if off > 0.0 => Better::PullEarlier { by: off, by_s: by_s.filter(|by_s| *by_s <= FAR_S) },
            _ if self.warms => Better::RestLonger,
            off if by_s.map_or(-off > FAR_OFF, |by_s| by_s > FAR_S) => {
                Better::LeaveIn { by: -off, until: self.goal.aim }
            }
            off => Better::PullLater { by: -off, by_s },
        }
    }

    /// What gives more crust.
    fn crust(&self) -> Better {
        let [low, high] = [f64::min, f64::max].map(|pick| pick(self.faces_pct[0], self.faces_pct[1]));
        match (self.course.pan_at_put_c, self.course.pan_lowest_c) {
            (Some(had_c), _) if had_c < WARM_ENOUGH_C => Better::HotterPan { had_c, until_c: HOT_C },
            _ if self.covered_pct > CROWDED_PCT => Better::LessCrowded { covered_pct: self.covered_pct },
            _ if high - low > UNEVEN_PCT => Better::PalerFace { faces_pct: [low, high] },
            (_, Some(lowest_c)) if lowest_c < TOO_COLD_C => Better::DryFaces { lowest_c },
            _ => Better::MorePower { had_w: self.course.power_w },
        }
    }

    /// What makes the grey band thinner.
    fn grey(&self) -> Better {
        match self.course.flips {
            had if had < MANY_FLIPS => Better::FlipMoreOften { had, every_s: FLIP_EVERY_S },
            _ => Better::LessPower { had_w: self.course.power_w },
        }
    }
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use saute_kitchen::Library;

    use super::*;

    const GOOD: Outcome = Outcome {
        core_peak_c: 61.5,
        at_core: 61.5,
        target_share_pct: 60.0,
        beyond_pct: 30.0,
        crust_pct: 80.0,
        least_crust_pct: 80.0,
        charred_pct: 0.0,
        lost_pct: 0.0,
        hottest_c: 240.0,
        fire_hazard: false,
    };

    fn goal(id: &str) -> Goal {
        let library = Library::embedded().unwrap();
        Goal::described(library.goal(id).unwrap(), library.scale("paper-2013").unwrap()).unwrap()
    }

    fn better(outcome: Outcome, course: Course, change: impl Fn(&mut Evidence)) -> Option<Better> {
        let goal = goal("medium");
        let terms = Term::all(&outcome, course.flips, &goal);
        let faces_pct = [outcome.least_crust_pct, 80.0];
        let shortfalls = &Shortfall::of(&outcome, &goal)[..];
        let (outcome, terms, course, goal) = (&outcome, &terms[..], &course, &goal);
        let (warms, covered_pct) = (false, 20.0);
        let mut evidence = Evidence { outcome, terms, course, goal, faces_pct, shortfalls, warms, covered_pct };
        change(&mut evidence);
        Better::of(&evidence)
    }

    #[test]
    fn a_good_cook_has_nothing_to_do_better() {
        assert_eq!(better(GOOD, Course::default(), |_| {}), None);
    }

    #[test]
    fn a_core_that_is_off_says_when_to_take_it_out_and_by_how_much() {
        let rises = Course { rise_k_s: Some(0.1), ..Course::default() };
        let over = Outcome { at_core: 73.5, ..GOOD };
        assert_eq!(better(over, rises, |_| {}), Some(Better::PullEarlier { by: 12.0, by_s: Some(120.0) }));
        assert_eq!(better(over, Course::default(), |_| {}), Some(Better::PullEarlier { by: 12.0, by_s: None }));
        let under = Outcome { at_core: 55.5, ..GOOD };
        assert_eq!(better(under, rises, |_| {}), Some(Better::PullLater { by: 6.0, by_s: Some(60.0) }));
        assert_eq!(better(under, rises, |evidence| evidence.warms = true), Some(Better::RestLonger));
        let raw = Outcome { at_core: 21.5, ..GOOD };
        assert_eq!(better(raw, rises, |_| {}), Some(Better::LeaveIn { by: 40.0, until: 61.5 }), "400 s tell nothing");
        assert!(matches!(better(raw, Course::default(), |_| {}), Some(Better::LeaveIn { .. })), "nor does no time");
    }

    #[test]
    fn a_missing_crust_has_its_cause() {
        let pale = Outcome { least_crust_pct: 10.0, ..GOOD };
        let put_at = |c| Course { pan_at_put_c: Some(c), pan_lowest_c: Some(110.0), ..Course::default() };
        assert_eq!(better(pale, put_at(120.0), |_| {}), Some(Better::HotterPan { had_c: 120.0, until_c: HOT_C }));
        let both = |evidence: &mut Evidence| evidence.faces_pct = [10.0; 2];
        assert_eq!(better(pale, put_at(200.0), |_| {}), Some(Better::PalerFace { faces_pct: [10.0, 80.0] }));
        assert_eq!(better(pale, put_at(200.0), both), Some(Better::DryFaces { lowest_c: 110.0 }));
        assert_eq!(better(pale, Course::default(), both), Some(Better::MorePower { had_w: None }));
        let crowded = better(pale, put_at(200.0), |evidence| evidence.covered_pct = 75.0);
        assert_eq!(crowded, Some(Better::LessCrowded { covered_pct: 75.0 }));
    }

    #[test]
    fn a_thick_grey_band_asks_for_flips_then_for_less_power_and_smoke_for_a_cooler_pan() {
        let grey = Outcome { beyond_pct: 60.0, target_share_pct: 35.0, ..GOOD };
        let flips = |flips| Course { flips, power_w: Some(2000.0), ..Course::default() };
        assert_eq!(better(grey, flips(1), |_| {}), Some(Better::FlipMoreOften { had: 1, every_s: 30.0 }));
        assert_eq!(better(grey, flips(9), |_| {}), Some(Better::LessPower { had_w: Some(2000.0) }));
        let hot = Outcome { hottest_c: 315.0, fire_hazard: true, ..grey };
        assert_eq!(better(hot, flips(1), |_| {}), Some(Better::CoolerPan { had_c: 315.0, most_c: MOST_C }));
    }

    #[test]
    fn the_task_of_2013_says_when_to_pull_though_it_judges_no_core() {
        let goal = goal("study-2013");
        let outcome = Outcome { at_core: 45.0, target_share_pct: 15.0, beyond_pct: 20.0, ..GOOD };
        let terms = Term::all(&outcome, 1, &goal);
        let course = Course { flips: 5, ..Course::default() };
        let shortfalls = &Shortfall::of(&outcome, &goal)[..];
        assert_eq!(shortfalls, [Shortfall::Share]);
        let (outcome, terms, course, goal) = (&outcome, &terms[..], &course, &goal);
        let (faces_pct, warms, covered_pct) = ([80.0; 2], false, 20.0);
        let evidence = Evidence { outcome, terms, course, goal, faces_pct, shortfalls, warms, covered_pct };
        assert!(matches!(Better::of(&evidence), Some(Better::PullLater { .. })));
    }
}
