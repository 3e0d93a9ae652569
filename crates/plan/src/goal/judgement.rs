//! The judgement of a finished cook: verdict, score, what shows why, and what to do better.

use saute_kitchen::advice::FORECAST_HIGH_K;
use saute_kitchen::food::change::doneness::Measure;
use saute_kitchen::piece::carry_over::foreseen_peak;
use saute_kitchen::{Kitchen, Piece, celsius};

use crate::goal::better::Evidence;
use crate::goal::grey_band::grey_band;
use crate::goal::mark::Mark;
use crate::goal::{Better, Course, Goal, Outcome, Score, Shortfall, Term};

/// A cook as it is judged: pieces of one kind, with their masses at the start.
#[derive(Clone, Debug)]
pub struct Judged<'a> {
    /// The kitchen.
    pub kitchen: &'a Kitchen,
    /// The pieces, the one whose faces and grey band are reported first.
    pub pieces: Vec<&'a Piece>,
    /// Their masses at the start, in the same order [kg].
    pub masses_at_start: Vec<f64>,
}

/// Whether a cook meets its goal.
#[derive(Clone, Debug, PartialEq)]
pub enum GoalVerdict {
    /// It does.
    Met,
    /// It does not: what is missing.
    Missed(Vec<Shortfall>),
}

/// The judgement of a finished cook. Of pairs the first is the lower face, the second the upper one, as the first piece lies.
#[derive(Clone, Debug, PartialEq)]
pub struct Judgement {
    /// Whether the goal is met.
    pub verdict: GoalVerdict,
    /// What the cook gave.
    pub outcome: Outcome,
    /// The terms of the score.
    pub terms: [Term; 9],
    /// The score.
    pub score: Score,
    /// The mark.
    pub mark: Mark,
    /// Thickness of what is beyond the class of the goal, below each face, on the line through the core [mm].
    pub grey_mm: [f64; 2],
    /// Browned share of each face, on ridges of the bars [%].
    pub crust_pct: [f64; 2],
    /// Charred share of each face [%].
    pub charred_pct: [f64; 2],
    /// Energy that the hob drew so far [kJ].
    pub energy_kj: f64,
    /// Kill of germs; none of foods whose kinetics call none pasteurised.
    pub kill: Option<Pasteurisation>,
    /// The one thing to do better; none if nothing costs a point.
    pub better: Option<Better>,
}

/// How far germs were killed where it was least, and how far food is called pasteurised.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pasteurisation {
    /// Log₁₀ reduction [-].
    pub log: f64,
    /// Log₁₀ reduction from which the food is called pasteurised [-].
    pub asked_log: f64,
}

impl Pasteurisation {
    /// True if the kill is what is asked.
    pub fn is_enough(self) -> bool {
        self.log >= self.asked_log
    }
}

impl Judgement {
    /// Judges a cook by a goal, given how it went; none without a piece.
    pub fn of(judged: &Judged, course: &Course, goal: &Goal) -> Option<Self> {
        let first = *judged.pieces.first()?;
        let outcome = Outcome::of(judged.kitchen, &judged.pieces, &judged.masses_at_start, goal);
        let terms = Term::all(&outcome, course.flips, goal);
        let faces = [true, false].map(|below| {
            let up = first.up().map(|u| if below { u } else { -u });
            first.model.face_reading(&first.state, up)
        });
        let crust_pct = faces.map(|face| face.crust_pct);
        let shortfalls = Shortfall::of(&outcome, goal);
        let evidence = Evidence {
            outcome: &outcome,
            terms: &terms,
            course,
            goal,
            faces_pct: crust_pct,
            shortfalls: &shortfalls,
            warms: judged.warms_to(goal),
            covered_pct: judged.covered_pct(),
        };
        let better = Better::of(&evidence);
        Some(Self {
            better,
            verdict: if shortfalls.is_empty() { GoalVerdict::Met } else { GoalVerdict::Missed(shortfalls) },
            score: Score::sum(&terms),
            mark: Mark::of(&outcome, goal),
            grey_mm: grey_band(first, goal).map(|metres| 1e3 * metres),
            charred_pct: faces.map(|face| face.charred_pct),
            energy_kj: 1e-3 * judged.kitchen.energy().hob,
            kill: judged.kill(),
            crust_pct,
            terms,
            outcome,
        })
    }
}

impl Judged<'_> {
    /// True if the first piece rests and its core is expected to meet the goal yet.
    fn warms_to(&self, goal: &Goal) -> bool {
        let piece = self.pieces[0];
        let foreseen = || celsius(foreseen_peak(&piece.model, &piece.state, self.kitchen.room()).0) - FORECAST_HIGH_K;
        goal.scale.measure() == Measure::Peak && !piece.in_pan() && foreseen() >= goal.core[0]
    }

    /// The least kill in any piece: at its core, or where its own surface was heated least.
    fn kill(&self) -> Option<Pasteurisation> {
        let asked_log = self.pieces[0].model.kinetics().lethality.pasteurised_log?;
        let least = self.pieces.iter().map(|piece| {
            let (core, surface) = piece.model.log_reduction(&piece.state);
            core.min(surface)
        });
        Some(Pasteurisation { log: least.fold(f64::INFINITY, f64::min), asked_log })
    }

    /// Share of the pan's floor that the raw pieces cover [%].
    fn covered_pct(&self) -> f64 {
        let radius = 1e-3 * self.kitchen.pan_model().description.floor.radius_mm;
        let area: f64 = self.pieces.iter().map(|piece| piece.model.size()[0] * piece.model.size()[1]).sum();
        100.0 * area / (core::f64::consts::PI * radius * radius)
    }
}
