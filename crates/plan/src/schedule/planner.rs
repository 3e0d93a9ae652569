//! The search: hands out jobs, takes their results, and has a plan in the end.

use std::collections::{BTreeMap, BTreeSet};
use std::sync::Arc;

use saute_kitchen::Library;
use saute_kitchen::food::Reduction;
use saute_kitchen::kitchen::SetupError;
use serde::{Deserialize, Serialize};

use crate::goal::score::HOT_C;
use crate::goal::{Goal, Score, Shortfall};
use crate::schedule::candidate::job::{Job, JobError, JobResult, Mesh, Pull};
use crate::schedule::candidate::work_of_second;
use crate::schedule::heating::Heating;
use crate::schedule::moves::{Stride, combined, neighbours};
use crate::schedule::seeds::seeds;
use crate::schedule::sensitivity::{self, Sensitivity};
use crate::schedule::{Draft, Order, Plan};

/// Mesh spacing of the search relative to the default [-] (chosen: see docs/planning.md for its error).
const COARSE: f64 = 3.0;
/// Thickness from which the search of a slice uses reduced meshes [mm] (chosen: they take a tenth of the time and brown too much in a short
/// sear, which a thin slice has: 15 mm 57 % instead of 11 %. At 25 mm eleven plans found with them score 1.3 points less to 3 more than those
/// found without, and take 8 to 16 s on two cores in place of 27).
const REDUCED_FROM_MM: f64 = 24.0;
/// Mesh spacing of the finish [-].
const FULL: f64 = 1.0;
/// Work of one core in the time that a plan may take [-], in ticks times nodes (chosen: 20 s of a core of 2024, which does 2.4e7 a second).
const CORE_WORK: u64 = 480_000_000;
/// Work that the search may take in any case [-] (chosen: five seconds on two cores).
const LEAST_WORK: u64 = 240_000_000;
/// Work after which no further candidate is cooked on the full mesh [-] (chosen: 26 s on two cores).
const MOST_WORK: u64 = 1_250_000_000;
/// Cores that the search is meant for [-].
const CORES: u64 = 2;
/// Candidates that are cooked on the full mesh at once [-]: one on each core.
const AT_ONCE: usize = CORES as usize;
/// Candidates that are cooked on the full mesh at most, until one meets the goal [-] (chosen).
const MOST_FINALISTS: usize = 2 * AT_ONCE;
/// Crust that each further one of the candidates that are cooked at once is chosen for [points of %] (chosen: coarse meshes miss it by as much).
const NEXT_CRUST: f64 = 10.0;
/// Stride with which the search goes on where the first finalist misses the goal.
const AGAIN: usize = 1;
/// Gain of the score from which the search goes on with the same stride [points] (chosen).
const GAIN: f64 = 0.7;
/// Crust that the search requires in addition to the goal's, with its spacing and on reduced meshes [points of %] (measured on a dozen finalists: the
/// first brown up to 5 points too much, the second 18 to 24, since a column represents a larger area).
const MORE_CRUST: f64 = 5.0;
const MORE_CRUST_REDUCED: f64 = 20.0;
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
    /// The best drafts on the full mesh.
    Finish,
    /// The one that was kept with changes, on the meshes of the search.
    Vary,
    /// Nothing.
    Done,
}

/// What a draft gives on the meshes of the search, and on the full one.
#[derive(Clone, Debug)]
struct Finished {
    coarse: JobResult,
    full: JobResult,
}

/// The search for a schedule.
#[derive(Clone, Debug)]
pub struct Planner {
    order: Order,
    /// The order with more crust, for the coarse mesh.
    search: Order,
    library: Arc<Library>,
    heating: Heating,
    /// Meshes of the search.
    mesh: Mesh,
    /// Nodes of all foods on the full mesh [-].
    nodes: u64,
    stage: Stage,
    /// Drafts of the jobs that were handed out, in their order.
    handed: Vec<Draft>,
    /// Draft around which they are.
    centre: Option<Draft>,
    tried: BTreeMap<Draft, JobResult>,
    /// Drafts that were cooked on the full mesh.
    finalists: BTreeSet<Draft>,
    finished: Option<Finished>,
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
        let model = order.check(&library, FULL)?;
        let pieces = order.count.unwrap_or(1);
        let nodes = pieces as u64 * model.mesh().node_count() as u64;
        // Where bodies are still, only one slice cooks as in a kitchen.
        let is_slice = pieces == 1
            && order.thickness_mm() >= REDUCED_FROM_MM
            && Reduction::of(&model).map_err(SetupError::from)?.is_some();
        let (mesh, more_crust) =
            if is_slice { (Mesh::Reduced, MORE_CRUST_REDUCED) } else { (Mesh::Spaced(COARSE), MORE_CRUST) };
        let heating = Heating::of(&order, &library)?;
        let search = Order { goal: with_more_crust(&order.goal, more_crust), ..order.clone() };
        Ok(Self {
            order,
            search,
            library,
            heating,
            mesh,
            nodes,
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
            Stage::Vary => self.changes(),
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
            Stage::Vary => self.note_changes(&results),
            Stage::Done => {}
        }
    }

    /// Returns the plan once the search is over.
    pub fn plan(&self) -> Option<Plan> {
        self.so_far().filter(|_| self.stage == Stage::Done)
    }

    /// Returns the best plan so far, for a search that is stopped; until the finish its promise is one of coarse meshes. None before a
    /// candidate was cooked.
    pub fn so_far(&self) -> Option<Plan> {
        let full = self.finished.as_ref().map(|best| &best.full);
        let best = full.or_else(|| self.best().map(|(_, coarse)| coarse))?;
        Some(Plan {
            order: self.order.clone(),
            schedule: best.schedule.clone(),
            promised: best.outcome,
            // A coarse one was ranked by more crust.
            score: Score::of(&best.outcome, best.schedule.flips_s.len(), &self.order.goal),
            cues: best.cues.clone(),
            sensitivity: self.sensitivity.clone(),
            candidates: self.tried.len(),
            is_stopped: self.stage != Stage::Done,
            is_rough: full.is_none(),
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
            Stage::Finish => "the best candidates on the full mesh",
            Stage::Vary => "the best one with changes",
            Stage::Done => "done",
        }
    }

    /// The best of the drafts that were cooked so far, with its result; of equals the smaller one.
    fn best(&self) -> Option<(&Draft, &JobResult)> {
        self.tried.iter().reduce(|best, next| if self.rank(next.1) > self.rank(best.1) { next } else { best })
    }

    /// The best of the drafts that were not cooked on the full mesh yet; if the goal requires crust, with a further one for more of it, so that one
    /// meets the goal if the coarse mesh browned too much.
    fn next_finalists(&self) -> Vec<Draft> {
        let mut chosen: Vec<Draft> = Vec::new();
        let at_once = if self.order.goal.crust_pct > 0.0 { AT_ONCE } else { 1 };
        for further in 0..at_once {
            let goal = with_more_crust(&self.search.goal, further as f64 * NEXT_CRUST);
            let rank = |result: &JobResult| {
                let score = Score::of(&result.outcome, result.schedule.flips_s.len(), &goal);
                self.rank(&JobResult { score, ..result.clone() })
            };
            let open = |draft: &Draft| !self.finalists.contains(draft) && !chosen.contains(draft);
            let ranked =
                self.tried.iter().filter(|(draft, _)| open(draft)).map(|(draft, result)| (draft, rank(result)));
            let best = ranked.reduce(|best, next| if next.1 > best.1 { next } else { best });
            chosen.extend(best.map(|(draft, _)| *draft));
        }
        chosen
    }

    /// Rank of a result on the coarse mesh: faces as the goal requires first, then a pan that does not become too hot, then the score.
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
            mesh: self.mesh,
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
        (CORES * CORE_WORK.saturating_sub(self.full_work())).max(LEAST_WORK)
    }

    /// Work of a cook on the full mesh, with two rests [-].
    fn full_work(&self) -> u64 {
        let lasts_s = self.best().map_or(0, |(_, best)| best.schedule.pull_s + 2 * best.schedule.rest_s);
        u64::from(lasts_s) * work_of_second(self.nodes)
    }

    /// Returns the jobs of the best drafts on the full mesh.
    fn finish(&mut self) -> Vec<Job> {
        self.handed = self.next_finalists();
        let best = self.handed.iter().filter_map(|draft| Some((draft, self.tried.get(draft)?)));
        let full = best.map(|(draft, best)| {
            let pull = Pull::ToAim { rise: best.rise + MORE_RISE[1], within: WITHIN[1], most_rests: RESTS[1] };
            Job { order: self.order.clone(), pull, mesh: Mesh::Spaced(FULL), ..self.job(draft) }
        });
        full.collect()
    }

    /// Keeps the finalist that is the best so far; if all miss the goal, the next ones have their turn.
    fn conclude(&mut self, results: Vec<JobResult>) {
        let mut paler = 0.0_f64;
        for (draft, full) in std::mem::take(&mut self.handed).into_iter().zip(results) {
            if let Some(coarse) = self.tried.get(&draft).cloned() {
                paler = paler.max(coarse.outcome.least_crust_pct - full.outcome.least_crust_pct);
                self.keep_finalist(Finished { coarse, full });
            }
            self.finalists.insert(draft);
        }
        let is_met = self.finished.as_ref().is_some_and(|best| self.missing(&best.full) == (0, 0));
        let no_time = self.work + CORES * self.full_work() > MOST_WORK;
        let is_over = is_met || no_time || self.finalists.len() >= MOST_FINALISTS;
        self.stage = if is_over { Stage::Vary } else { Stage::Refine(AGAIN) };
        if !is_over {
            self.want_more_crust(paler);
        }
    }

    /// Keeps a finalist if it is the best so far.
    fn keep_finalist(&mut self, new: Finished) {
        let is_best = self.finished.as_ref().is_none_or(|best| {
            let (now, before) = (self.missing(&new.full), self.missing(&best.full));
            now < before || (now == before && new.full.score > best.full.score)
        });
        if is_best {
            self.finished = Some(new);
        }
    }

    /// Returns the jobs of what was kept with each change.
    fn changes(&self) -> Vec<Job> {
        let schedules = self.finished.iter().map(|best| &best.coarse.schedule);
        schedules.flat_map(|schedule| sensitivity::jobs(&self.search, schedule, self.mesh, &self.library)).collect()
    }

    /// Notes what the changes do, which ends the search.
    fn note_changes(&mut self, changed: &[JobResult]) {
        if let Some(Finished { coarse, full }) = &self.finished {
            self.sensitivity = sensitivity::noted(&full.outcome, coarse, changed, &self.order);
        }
        self.stage = Stage::Done;
    }

    /// What a cook on the full mesh misses; a pan that becomes too hot counts less than anything else.
    fn missing(&self, result: &JobResult) -> (usize, usize) {
        (Shortfall::of(&result.outcome, &self.order.goal).len(), usize::from(!stays_cool(result)))
    }

    /// Requires more crust of the coarse mesh than so far: more than the goal's by what it browned too much [points of %], and some.
    fn want_more_crust(&mut self, paler: f64) {
        let Self { order, search: Order { goal, .. }, tried, .. } = self;
        let more = (paler + MORE_CRUST).max(goal.crust_pct + MORE_CRUST - order.goal.crust_pct);
        *goal = with_more_crust(&order.goal, more);
        for result in tried.values_mut() {
            result.score = Score::of(&result.outcome, result.schedule.flips_s.len(), goal);
        }
    }
}

/// A goal with more crust [points of %], if it requires any.
fn with_more_crust(goal: &Goal, more: f64) -> Goal {
    let crust_pct = if goal.crust_pct > 0.0 { (goal.crust_pct + more).min(100.0) } else { 0.0 };
    Goal { crust_pct, ..goal.clone() }
}

/// True if no place of the pan became hotter than a cook should let it.
fn stays_cool(result: &JobResult) -> bool {
    result.outcome.hottest_c <= HOT_C
}
