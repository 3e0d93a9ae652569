//! The search: hands out jobs, takes their results, and has a plan in the end.

use std::collections::{BTreeMap, BTreeSet};
use std::sync::Arc;

use saute_kitchen::Library;
use serde::{Deserialize, Serialize};

use crate::goal::score::HOT_C;
use crate::goal::{Goal, Score, Shortfall};
use crate::schedule::fork::work_of_tick;
use crate::schedule::heating::Heating;
use crate::schedule::job::{Job, JobError, JobResult, Pull};
use crate::schedule::moves::{Stride, combined, neighbours};
use crate::schedule::seeds::seeds;
use crate::schedule::sensitivity::{self, Change, Sensitivity};
use crate::schedule::{Draft, Order, Plan};

/// Mesh spacing of the search relative to the default [-] (chosen: see docs/planning.md for its error).
const COARSE: f64 = 3.0;
/// Mesh spacing of the finish [-].
const FULL: f64 = 1.0;
/// Work of one core in the time that a plan may take [-], in ticks times nodes (chosen: 20 s of a core of 2024, which does 2.4e7 a second).
const CORE_WORK: u64 = 480_000_000;
/// Cores that the search is meant for [-].
const CORES: u64 = 2;
/// Candidates that are cooked on the full mesh at most, one after the other until one meets the goal [-] (chosen).
const MOST_FINALISTS: usize = 2;
/// Stride with which the search goes on where the first finalist misses the goal.
const AGAIN: usize = 1;
/// Gain of the score from which the search goes on with the same stride [points] (chosen).
const GAIN: f64 = 0.7;
/// Crust that the search wants on top of the goal's [points of %] (chosen: the coarse mesh misses it by up to 5).
const MORE_CRUST: f64 = 5.0;
/// Expected rise of the core during the rest before there is an experience, as a share of the aim [-], and what is added to
/// one in the search and in the finish [K or points of %] (chosen: rather too much; a rest too early costs another one, a
/// rest too late costs the aim).
const FIRST_RISE: f64 = 0.2;
const MORE_RISE: [f64; 2] = [0.7, 1.0];
/// Misses of the aim that are left, in the search and in the finish [K or points of %] (chosen).
const WITHIN: [f64; 2] = [1.0, 0.2];
/// Rests that are cooked, in the search and in the finish [-] (chosen).
const RESTS: [u32; 2] = [2, 3];
/// Latest time to pull, after putting in [s], and for each millimetre of thickness [s/mm] (chosen: a thick steak is well done
/// at 400 W by then).
const LIMIT_S: f64 = 180.0;
const LIMIT_S_MM: f64 = 70.0;

/// What comes next in a search.
#[derive(Clone, Copy, Debug, Deserialize, PartialEq, Serialize)]
pub enum Stage {
    /// The drafts to start with.
    Seeds,
    /// Neighbours of the best draft, at a stride.
    Refine(usize),
    /// The best draft on the full mesh, and changes around it.
    Finish,
    /// Nothing.
    Done,
}

/// The search for a schedule.
#[derive(Clone, Debug)]
pub struct Planner {
    order: Order,
    /// The order with more crust, for the coarse mesh.
    search: Order,
    library: Arc<Library>,
    heating: Heating,
    /// Work of a tick on the full mesh over that on the coarse one [-].
    finish_over_search: f64,
    stage: Stage,
    /// Drafts of the jobs that were handed out, in their order.
    handed: Vec<Draft>,
    /// Draft around which they are.
    centre: Option<Draft>,
    tried: BTreeMap<Draft, JobResult>,
    /// Drafts that were cooked on the full mesh.
    finalists: BTreeSet<Draft>,
    finished: Option<JobResult>,
    sensitivity: Vec<Sensitivity>,
    work: u64,
}

impl Planner {
    /// Prepares the search: heats the empty pan.
    ///
    /// # Errors
    ///
    /// If the order makes no recipe.
    pub fn new(order: Order, library: Arc<Library>) -> Result<Self, JobError> {
        if order.hob_w.is_empty() {
            return Err(JobError::NoPower);
        }
        let nodes = |coarseness| order.check(&library, coarseness).map(|model| work_of_tick(model.mesh().node_count()));
        let finish_over_search = nodes(FULL)? as f64 / nodes(COARSE)? as f64;
        let heating = Heating::of(&order, &library)?;
        let wanted = order.goal.crust_pct;
        let crust_pct = if wanted > 0.0 { (wanted + MORE_CRUST).min(100.0) } else { 0.0 };
        let search = Order { goal: Goal { crust_pct, ..order.goal.clone() }, ..order.clone() };
        Ok(Self {
            order,
            search,
            library,
            heating,
            finish_over_search,
            stage: Stage::Seeds,
            handed: Vec::new(),
            centre: None,
            tried: BTreeMap::new(),
            finalists: BTreeSet::new(),
            finished: None,
            sensitivity: Vec::new(),
            work: 0,
        })
    }

    /// Returns the jobs that can be run now, in any order or at once, for [`Self::take`]. There are none when there is a plan; a
    /// round of the search may have none too.
    pub fn next_jobs(&mut self) -> Vec<Job> {
        match self.stage {
            Stage::Seeds => {
                self.handed = seeds(&self.search).into_iter().collect();
                self.handed.iter().map(|draft| self.job(draft)).collect()
            }
            Stage::Refine(stride) => {
                self.handed = self.neighbours(Stride::ALL[stride]);
                self.handed.iter().map(|draft| self.job(draft)).collect()
            }
            Stage::Finish => self.finish(),
            Stage::Done => Vec::new(),
        }
    }

    /// Takes the results of the jobs that were handed out last, in their order.
    pub fn take(&mut self, results: Vec<JobResult>) {
        self.work += results.iter().map(|r| r.work).sum::<u64>();
        match self.stage {
            Stage::Seeds => {
                self.keep(results);
                self.stage = Stage::Refine(0);
            }
            Stage::Refine(stride) => self.refine(stride, results),
            Stage::Finish => self.conclude(results),
            Stage::Done => {}
        }
    }

    /// Returns the plan once the search is over.
    pub fn plan(&self) -> Option<Plan> {
        let best = self.finished.as_ref().filter(|_| self.stage == Stage::Done)?;
        Some(Plan {
            order: self.order.clone(),
            schedule: best.schedule.clone(),
            promised: best.outcome,
            score: best.score,
            cues: best.cues.clone(),
            sensitivity: self.sensitivity.clone(),
            candidates: self.tried.len(),
        })
    }

    /// Returns what comes next.
    pub fn stage(&self) -> Stage {
        self.stage
    }

    /// Returns what comes next in English, for a progress display.
    pub fn doing(&self) -> &'static str {
        match self.stage {
            Stage::Seeds => "first candidates",
            Stage::Refine(_) => "neighbours of the best candidate",
            Stage::Finish => "the best candidate on the full mesh, and with changes",
            Stage::Done => "done",
        }
    }

    /// The best of the drafts that were cooked so far, with its result; of equals the smaller one.
    fn best(&self) -> Option<(&Draft, &JobResult)> {
        self.tried.iter().reduce(|best, next| if self.rank(next.1) > self.rank(best.1) { next } else { best })
    }

    /// The best of the drafts that were not cooked on the full mesh yet, with its result on the coarse one.
    fn finalist(&self) -> Option<(&Draft, &JobResult)> {
        let open = self.tried.iter().filter(|(draft, _)| !self.finalists.contains(draft));
        open.reduce(|best, next| if self.rank(next.1) > self.rank(best.1) { next } else { best })
    }

    /// Rank of a result on the coarse mesh: faces as they are wanted first, then a pan that does not become too hot, then the score.
    /// The core is left to the finish.
    fn rank(&self, result: &JobResult) -> ([bool; 2], Score) {
        let is_core = |s: &Shortfall| matches!(s, Shortfall::Undercooked | Shortfall::Overcooked);
        let faces = Shortfall::of(&result.outcome, &self.search.goal).iter().all(is_core);
        ([faces, stays_cool(result)], result.score)
    }

    /// Returns the job of a draft on the coarse mesh.
    fn job(&self, draft: &Draft) -> Job {
        let limit_s = LIMIT_S + LIMIT_S_MM * self.order.thickness_mm();
        let rise = self.best().map_or(FIRST_RISE * self.order.goal.aim, |(_, best)| best.rise + MORE_RISE[0]);
        Job {
            schedule: draft.schedule(&self.order, self.heating.put_s(draft.preheat_c), limit_s as u32),
            order: self.search.clone(),
            pull: Pull::ToAim { rise, within: WITHIN[0], most_rests: RESTS[0] },
            coarseness: COARSE,
        }
    }

    fn keep(&mut self, results: Vec<JobResult>) {
        self.tried.extend(std::mem::take(&mut self.handed).into_iter().zip(results));
    }

    /// Returns neighbours of the best draft that were not cooked yet, and what was better around the draft before, at once.
    fn neighbours(&mut self, stride: Stride) -> Vec<Draft> {
        let Some((best, _)) = self.best() else { return Vec::new() };
        let best = *best;
        let mut around: BTreeSet<Draft> = self.around(&best, stride).into_iter().collect();
        if let Some(centre) = self.centre.replace(best).filter(|centre| *centre != best) {
            let score = self.tried.get(&centre).map(|result| result.score);
            let near = self.around(&centre, stride).into_iter();
            let mut better: Vec<(Draft, f64)> =
                near.filter_map(|d| Some((d, self.tried.get(&d).filter(|r| Some(r.score) > score)?.score.0))).collect();
            // What is best counts last, so that it wins where two change the same.
            better.sort_by(|(_, a), (_, b)| a.total_cmp(b));
            let better: Vec<Draft> = better.into_iter().map(|(draft, _)| draft).collect();
            around.insert(combined(&centre, &better));
        }
        around.into_iter().filter(|draft| !self.tried.contains_key(draft)).collect()
    }

    /// Returns the neighbours of a draft that was cooked.
    fn around(&self, draft: &Draft, stride: Stride) -> Vec<Draft> {
        let changed_s = self.tried.get(draft).and_then(|cooked| draft.changed_s(&cooked.schedule, &self.order));
        neighbours(draft, changed_s, &self.search, stride)
    }

    /// Goes on at the same stride while it finds something better, then at the next one, until the work is done.
    fn refine(&mut self, stride: usize, results: Vec<JobResult>) {
        let before = self.best().map(|(draft, result)| (*draft, self.rank(result)));
        self.keep(results);
        let after = self.best().map(|(draft, result)| (*draft, self.rank(result)));
        let (Some((from, before)), Some((to, after))) = (before, after) else { return };
        let gains = after.0 > before.0 || after.1.0 >= before.1.0 + GAIN;
        let other_powers = (from.first, from.then) != (to.first, to.then);
        let stays = gains && (other_powers || !Stride::ALL[stride].powers);
        let next = if stays { stride } else { stride + 1 };
        let goes_on = next < Stride::ALL.len() && self.work < self.search_work();
        self.stage = if goes_on { Stage::Refine(next) } else { Stage::Finish };
    }

    /// Work that the search may take: what the finish leaves of every core.
    fn search_work(&self) -> u64 {
        let coarse = self.best().map_or(0, |(_, best)| best.work);
        CORES * CORE_WORK.saturating_sub((coarse as f64 * self.finish_over_search) as u64)
    }

    /// Returns the job of the best draft on the full mesh, which takes longest, and those with changes on the coarse one.
    fn finish(&self) -> Vec<Job> {
        let Some((draft, best)) = self.finalist() else { return Vec::new() };
        let pull = Pull::ToAim { rise: best.rise + MORE_RISE[1], within: WITHIN[1], most_rests: RESTS[1] };
        let full = Job { order: self.order.clone(), pull, coarseness: FULL, ..self.job(draft) };
        let coarse = sensitivity::base(&self.search, &best.schedule, COARSE);
        let changed = Change::ALL.map(|change| sensitivity::changed(coarse.clone(), change, &self.library));
        std::iter::once(full).chain(changed).collect()
    }

    /// Keeps the finalist if it is the best so far; if it misses the goal, the next one has its turn.
    fn conclude(&mut self, mut results: Vec<JobResult>) {
        let finalist = self.finalist().map(|(draft, coarse)| (*draft, coarse));
        let (Some((draft, coarse)), [full, changed @ ..]) = (finalist, results.as_slice()) else {
            return self.stage = Stage::Done;
        };
        // A pan that becomes too hot counts less than anything that is missing.
        let missing = |result: &JobResult| {
            (Shortfall::of(&result.outcome, &self.order.goal).len(), usize::from(!stays_cool(result)))
        };
        let is_met = missing(full) == (0, 0);
        let paler = (coarse.outcome.least_crust_pct - full.outcome.least_crust_pct).max(0.0);
        let is_best = self.finished.as_ref().is_none_or(|best| {
            let (new, old) = (missing(full), missing(best));
            new < old || (new == old && full.score > best.score)
        });
        if is_best {
            let each = Change::ALL.into_iter().zip(changed);
            let new = |(change, result)| Sensitivity::new(change, &full.outcome, coarse, result, &self.order);
            self.sensitivity = each.map(new).collect();
            self.finished = Some(results.swap_remove(0));
        }
        self.finalists.insert(draft);
        let is_over = is_met || self.finalists.len() >= MOST_FINALISTS;
        self.stage = if is_over { Stage::Done } else { Stage::Refine(AGAIN) };
        if !is_over {
            self.want_more_crust(paler);
        }
    }

    /// Wants more crust on the coarse mesh [points of %]: as much as it browned too much.
    fn want_more_crust(&mut self, more: f64) {
        let Self { search: Order { goal, .. }, tried, .. } = self;
        goal.crust_pct = (goal.crust_pct + more).min(100.0);
        for result in tried.values_mut() {
            result.score = Score::of(&result.outcome, result.schedule.flips_s.len(), goal);
        }
    }
}

/// True if no place of the pan became hotter than a cook should let it.
fn stays_cool(result: &JobResult) -> bool {
    result.outcome.hottest_c <= HOT_C
}
