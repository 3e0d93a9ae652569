//! How much a plan depends on what a kitchen does differently.

use saute_kitchen::{Library, PieceOrder};
use serde::{Deserialize, Serialize};

use crate::goal::{Outcome, Shortfall};
use crate::schedule::candidate::job::{Job, JobResult, Mesh, Pull};
use crate::schedule::{Order, Schedule};

/// Something that differs from the order.
#[derive(Clone, Copy, Debug, Deserialize, PartialEq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Change {
    /// Thickness [mm].
    ThicknessMm(f64),
    /// Temperature at which the food goes in [K].
    InitialK(f64),
    /// Power of the hob [%].
    PowerPct(f64),
}

impl Change {
    /// The changes that every plan is checked for (chosen: what a ruler, a refrigerator and a hob differ by).
    pub const ALL: [Self; 6] = [
        Self::ThicknessMm(-3.0),
        Self::ThicknessMm(3.0),
        Self::InitialK(-5.0),
        Self::InitialK(5.0),
        Self::PowerPct(-10.0),
        Self::PowerPct(10.0),
    ];

    /// Returns the change in English: `thickness +3 mm`.
    pub fn words(self) -> String {
        match self {
            Self::ThicknessMm(mm) => format!("thickness {mm:+} mm"),
            Self::InitialK(k) => format!("start {k:+} °C"),
            Self::PowerPct(pct) => format!("power {pct:+} %"),
        }
    }
}

/// What a plan gives if something is different and the times stay the same.
#[derive(Clone, Debug, Deserialize, PartialEq, Serialize)]
pub struct Sensitivity {
    /// What is different.
    pub change: Change,
    /// Highest temperature of the core [°C].
    pub core_peak_c: f64,
    /// Share of the section in the class of the goal [%].
    pub target_share_pct: f64,
    /// Browned share of the faces [%].
    pub crust_pct: f64,
    /// What is missing to the goal, the first of all; none if it is still met.
    pub missing: Option<Shortfall>,
}

/// Returns the jobs of a schedule with each of the changes.
pub(crate) fn jobs(order: &Order, schedule: &Schedule, mesh: Mesh, library: &Library) -> [Job; Change::ALL.len()] {
    let base = Job { order: order.clone(), schedule: schedule.clone(), pull: Pull::AtItsTime, mesh };
    Change::ALL.map(|change| changed(base.clone(), change, library))
}

/// Returns what each of the changes does to what is promised, from their results and that of the same mesh without a change.
pub(crate) fn noted(promised: &Outcome, base: &JobResult, changed: &[JobResult], order: &Order) -> Vec<Sensitivity> {
    let each = Change::ALL.into_iter().zip(changed);
    each.map(|(change, result)| Sensitivity::new(change, promised, base, result, order)).collect()
}

/// Returns the job of a schedule with a change.
fn changed(job: Job, change: Change, library: &Library) -> Job {
    let Job { order, schedule, .. } = &job;
    match change {
        Change::ThicknessMm(mm) => Job { order: order.with_thickness(order.thickness_mm() + mm, library), ..job },
        Change::InitialK(k) => {
            let [frozen, most] = PieceOrder::INITIAL_C;
            // Food from the refrigerator is compared with colder food, not with ice.
            let least = if order.initial_c < 0.0 { frozen } else { 0.0 };
            let initial_c = (order.initial_c + k).clamp(least, most);
            Job { order: Order { initial_c, ..order.clone() }, ..job }
        }
        Change::PowerPct(pct) => {
            let largest_w = library.hob.largest_w();
            Job { schedule: schedule.with_power(1.0 + 0.01 * pct, largest_w), ..job }
        }
    }
}

impl Sensitivity {
    /// Returns what a plan gives with a change: what it promises, and the difference between two cooks on the same mesh.
    fn new(change: Change, promised: &Outcome, base: &JobResult, changed: &JobResult, order: &Order) -> Self {
        let (from, to) = (&base.outcome, &changed.outcome);
        let moved = |value: fn(&Outcome) -> f64| value(promised) + value(to) - value(from);
        let share = |value: fn(&Outcome) -> f64| moved(value).clamp(0.0, 100.0);
        let expected = Outcome {
            core_peak_c: moved(|o| o.core_peak_c),
            at_core: moved(|o| o.at_core),
            target_share_pct: share(|o| o.target_share_pct),
            crust_pct: share(|o| o.crust_pct),
            least_crust_pct: share(|o| o.least_crust_pct),
            charred_pct: share(|o| o.charred_pct),
            ..*to
        };
        Self {
            change,
            core_peak_c: expected.core_peak_c,
            target_share_pct: expected.target_share_pct,
            crust_pct: expected.crust_pct,
            missing: Shortfall::of(&expected, &order.goal).first().copied(),
        }
    }
}
