//! A job that is under way, second by second: it can be left and gone on with.

use saute_kitchen::kitchen::SetupError;
use saute_kitchen::reduced::{ReducedKitchen, Reductions};
use saute_kitchen::{Command, Kitchen, Library, Piece, TICKS_PER_S, celsius};
use saute_recipe::Cook;

use crate::goal::Score;
use crate::goal::score::HOT_C;
use crate::schedule::Schedule;
use crate::schedule::candidate::fork::{self, Rested, Resting};
use crate::schedule::candidate::job::{Cue, Job, JobError, JobResult, Mesh, Pull};
use crate::schedule::candidate::stove::{self, Stove};

/// Time from putting in to the first look at the core [s] (chosen: a piece that has just been laid down).
const SETTLED_S: u32 = 5;
/// Share of what is missing at the aim after a rest that the next one starts with [-] (chosen: the core rises a little more in the
/// rest of a hotter piece).
const NEXT_SHARE: f64 = 0.9;
/// Temperature of the hottest place of the pan at which the hob is turned down before its time [°C] (chosen: 10 K below what the window
/// warns of, so that a hand may be some seconds late).
const TURN_DOWN_C: f64 = HOT_C - 10.0;

/// Mesh spacing up to the coarse meshes relative to the default [-], and for how long food is in the pan before it is carried over to them
/// [s] (chosen: by then it is still, and the mesh matters little to what happens in that time).
const LAID_COARSE: f64 = 3.0;
const LAID_S: u32 = 3;

/// A job that is under way.
#[derive(Clone, Debug)]
pub struct Cooking {
    job: Job,
    /// The cook up to the pull, or up to the coarse meshes.
    cook: Cook,
    /// Food and pan on coarse meshes, once they are there.
    reduced: Option<Box<ReducedKitchen>>,
    masses: Vec<f64>,
    cues: Vec<Cue>,
    /// Hottest place of the pan a second ago [°C].
    hottest_c: f64,
    at_s: u32,
    work: u64,
    /// Foods that rest at present.
    resting: Option<Resting>,
    /// Core at which the next rest begins [°C or %].
    next: f64,
    rests: u32,
    best: Option<Rested>,
}

impl Cooking {
    /// Begins a job.
    ///
    /// # Errors
    ///
    /// If the order or the schedule makes no recipe.
    pub fn begin(job: Job, library: &Library) -> Result<Self, JobError> {
        // The powers are set here, since they may be set earlier than the schedule states.
        let schedule =
            Schedule { powers: Vec::new(), ..job.schedule.pulled_at(job.schedule.pull_s, job.schedule.rest_s) };
        let mut recipe = schedule.recipe(&job.order, library)?;
        let coarseness = if let Mesh::Spaced(coarseness) = job.mesh { coarseness } else { LAID_COARSE };
        recipe.foods.iter_mut().for_each(|food| food.coarseness = coarseness);
        let cook = Cook::new(recipe, library)?;
        let masses = cook.kitchen.pieces().iter().map(Piece::mass).collect();
        let next = if let Pull::ToAim { rise, .. } = job.pull { job.order.goal.aim - rise } else { f64::INFINITY };
        let (cues, resting, best) = (Vec::new(), None, None);
        let hottest_c = f64::INFINITY;
        let reduced = None;
        Ok(Self { job, cook, reduced, masses, cues, hottest_c, at_s: 0, work: 0, resting, next, rests: 0, best })
    }

    /// Cooks or rests for a second; returns what came of the job once it is over.
    ///
    /// # Errors
    ///
    /// If a step cannot be carried out.
    pub fn second(&mut self) -> Result<Option<JobResult>, JobError> {
        if let Some(resting) = &mut self.resting {
            return Ok(if resting.second() { None } else { self.end_rest() });
        }
        if self.at_s < self.job.schedule.pull_s {
            self.cook_second()?;
        }
        if self.is_time_to_rest() {
            let rest_s =
                (self.job.pull == Pull::AtItsTime).then_some(self.job.schedule.rest_s).or(self.job.order.most_rest_s);
            let goal = &self.job.order.goal;
            self.resting = Some(Resting::begin(self.stove(), self.at_s, goal, rest_s));
        }
        Ok(None)
    }

    /// Cooks on for a second; before it, notes what there is to see where a step comes.
    fn cook_second(&mut self) -> Result<(), JobError> {
        let Schedule { put_s, flips_s, .. } = &self.job.schedule;
        let flips = flips_s.contains(&self.at_s);
        if flips || self.at_s == *put_s {
            self.cues.push(self.cue());
        }
        self.set_hob();
        self.work += match &mut self.reduced {
            Some(reduced) => {
                if flips {
                    turn_over(reduced);
                }
                stove::cook_second(reduced)
            }
            None => {
                for _ in 0..TICKS_PER_S {
                    self.cook.advance()?;
                }
                stove::work_of_cook(&self.cook.kitchen)
            }
        };
        self.at_s += 1;
        if self.job.mesh == Mesh::Reduced && self.at_s == self.job.schedule.put_s + LAID_S {
            self.reduced =
                Some(Box::new(self.cook.kitchen.reduced(&mut Reductions::default()).map_err(SetupError::from)?));
        }
        Ok(())
    }

    /// The kitchen as it is now.
    fn kitchen(&self) -> &Kitchen {
        self.reduced.as_deref().map_or(&self.cook.kitchen, ReducedKitchen::kitchen)
    }

    /// A copy of food and pan.
    fn stove(&self) -> Stove {
        let whole = || Stove::Whole(Box::new(self.cook.kitchen.clone()));
        self.reduced.clone().map_or_else(whole, Stove::Reduced)
    }

    fn apply(&mut self, command: &Command) {
        // Every hob can be set to the powers of an order.
        let _ = match &mut self.reduced {
            Some(reduced) => reduced.apply(command),
            None => self.cook.kitchen.apply(command),
        };
    }

    /// Sets the hob as the schedule states; in a search it is turned down where the pan becomes hot, and the schedule with it.
    fn set_hob(&mut self) {
        let hottest_c = celsius(self.kitchen().hottest_temperature());
        let still_heats = hottest_c >= TURN_DOWN_C && hottest_c > self.hottest_c;
        if still_heats && matches!(self.job.pull, Pull::ToAim { .. }) {
            self.job.schedule.turn_down(self.at_s);
        }
        self.hottest_c = hottest_c;
        if let Some(power) = self.job.schedule.powers.iter().find(|power| power.at_s == self.at_s) {
            self.apply(&Command::Hob(power.hob_w));
        }
    }

    fn cue(&self) -> Cue {
        let kitchen = self.kitchen();
        let pieces = kitchen.pieces();
        let mean = |value: &dyn Fn(&Piece) -> f64| pieces.iter().map(value).sum::<f64>() / pieces.len() as f64;
        Cue {
            at_s: self.at_s,
            pan_c: celsius(kitchen.pan_temperature()),
            smoke_mg_s: kitchen.pan_state().smoke_mg_s(),
            core_c: mean(&|p| celsius(p.core())),
            browned_pct: mean(&|p| p.model.face_reading(&p.state, p.up()).crust_pct),
            steam_g_s: 1e3 * pieces.iter().map(|p| p.vapour_flow).sum::<f64>(),
        }
    }

    fn is_last(&self) -> bool {
        self.at_s >= self.job.schedule.pull_s
    }

    /// True at the time of the schedule, or when the core is expected to come to the aim after its rest.
    fn is_time_to_rest(&self) -> bool {
        if self.is_last() {
            return true;
        }
        let has_settled = self.at_s > self.job.schedule.put_s + SETTLED_S;
        let looks = matches!(self.job.pull, Pull::ToAim { .. }) && has_settled;
        looks && fork::core_now(self.kitchen(), &self.job.order.goal) >= self.next
    }

    /// Keeps the closest of the rests so far; returns the result if this was the last one.
    fn end_rest(&mut self) -> Option<JobResult> {
        let goal = &self.job.order.goal;
        let missing = |rested: &Rested| goal.aim - rested.outcome.at_core;
        let rested = Rested { pull: Some(self.cue()), ..self.resting.take()?.rested(&self.masses, goal) };
        self.work += rested.work;
        self.rests += 1;
        let is_over = match self.job.pull {
            Pull::AtItsTime => true,
            Pull::ToAim { within, most_rests, .. } => {
                self.next = fork::core_now(self.kitchen(), goal) + NEXT_SHARE * missing(&rested);
                self.is_last() || self.rests >= most_rests || missing(&rested) <= within
            }
        };
        let closest = self.best.take().filter(|best| missing(best).abs() <= missing(&rested).abs()).unwrap_or(rested);
        if is_over {
            return Some(self.result(closest));
        }
        self.best = Some(closest);
        None
    }

    fn result(&mut self, rested: Rested) -> JobResult {
        let schedule = self.job.schedule.pulled_at(rested.pull_s, rested.rest_s);
        let pull = rested.pull.into_iter();
        let cues = std::mem::take(&mut self.cues);
        JobResult {
            score: Score::of(&rested.outcome, schedule.flips_s.len(), &self.job.order.goal),
            outcome: rested.outcome,
            rise: rested.rise,
            work: self.work,
            cues: cues.into_iter().filter(|cue| cue.at_s < rested.pull_s).chain(pull).collect(),
            schedule,
        }
    }
}

fn turn_over(reduced: &mut ReducedKitchen) {
    let foods: Vec<String> = reduced.kitchen().pieces().iter().map(|piece| piece.id.clone()).collect();
    for food in foods {
        // A food in the pan can be turned over.
        let _ = reduced.apply(&Command::Flip { food });
    }
}
