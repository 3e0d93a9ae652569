//! How plans are searched for off the frame: orders and answers as bytes, the search in slices.

use std::sync::Arc;

use saute_kitchen::Library;
use saute_plan::schedule::asked::Asked;
use saute_plan::schedule::search::{PlanData, Search, SearchProgress};
use saute_plan::schedule::{Cooking, JobError, JobResult};
use serde::{Deserialize, Serialize};
use web_time::{Duration, Instant};

use super::why_not::WhyNot;
use crate::work::bench::Craft;

/// Jobs that are carried out at once [-] (chosen: two where there are threads; the picture needs the rest of the machine).
const AT_ONCE: usize = if cfg!(target_arch = "wasm32") { 1 } else { 2 };
/// Computing time between two answers (chosen: a bar that moves a few times a second).
const COMPUTED_PER_ANSWER: Duration = Duration::from_millis(250);

/// A plan to be searched for.
#[derive(Debug, Deserialize, Serialize)]
pub struct PlanOrder {
    /// Its number, by which answers are known.
    pub number: u64,
    /// The text of the kitchen at home, unless it is the typical one.
    pub home: Option<String>,
    /// What is asked.
    pub asked: Asked,
}

/// What comes back.
#[derive(Debug, Deserialize, Serialize)]
pub struct PlanAnswer {
    /// The number of the order.
    pub number: u64,
    /// How far it is.
    pub told: Told,
}

/// How far a search is.
#[derive(Debug, Deserialize, Serialize)]
pub enum Told {
    /// It goes on.
    Progress(SearchProgress),
    /// It is over.
    Found(Box<PlanData>),
    /// It cannot be done, and why.
    Refused(WhyNot),
}

/// The search for plans.
pub struct Planning {
    library: Arc<Library>,
    work: Option<(u64, Box<Search>)>,
    /// Why the order that came last cannot be done.
    refused: Option<(u64, WhyNot)>,
    computed: Duration,
}

impl Planning {
    /// Without an order.
    pub fn new(library: Arc<Library>) -> Self {
        Self { library, work: None, refused: None, computed: Duration::ZERO }
    }

    fn begin(&self, PlanOrder { home, asked, .. }: &PlanOrder) -> Result<Search, WhyNot> {
        let library = self.library.in_kitchen(home.as_deref()).map_err(|_| WhyNot::NoKitchen)?;
        Search::new(asked, Arc::new(library.into_owned())).map_err(WhyNot::from)
    }

    /// Works on; returns how far it is where that is to be told.
    fn slice(&mut self, budget: Duration) -> Option<(u64, Told)> {
        let (number, search) = self.work.as_mut()?;
        let (number, begun) = (*number, Instant::now());
        let done = search.go_on(AT_ONCE, |cookings| cook_until(cookings, begun + budget));
        self.computed += begun.elapsed();
        let told = match (done, search.plan()) {
            (Err(error), _) => Told::Refused(error.into()),
            (Ok(()), Some(plan)) => Told::Found(Box::new(PlanData::from(&plan))),
            (Ok(()), None) if self.computed < COMPUTED_PER_ANSWER => return None,
            (Ok(()), None) => Told::Progress(search.progress()),
        };
        self.computed = Duration::ZERO;
        if !matches!(told, Told::Progress(_)) {
            self.work = None;
        }
        Some((number, told))
    }
}

impl Craft for Planning {
    fn take(&mut self, order: &[u8]) {
        (self.work, self.refused, self.computed) = (None, None, Duration::ZERO);
        let Ok(order) = postcard::from_bytes::<PlanOrder>(order) else { return };
        match self.begin(&order) {
            Ok(search) => self.work = Some((order.number, Box::new(search))),
            Err(why) => self.refused = Some((order.number, why)),
        }
    }

    fn is_busy(&self) -> bool {
        self.work.is_some() || self.refused.is_some()
    }

    fn go_on(&mut self, budget: Duration) -> Option<Vec<u8>> {
        let refused = self.refused.take().map(|(number, why)| (number, Told::Refused(why)));
        let (number, told) = refused.or_else(|| self.slice(budget))?;
        postcard::to_allocvec(&PlanAnswer { number, told }).ok()
    }
}

/// Lets cooks go on until a time, each on a thread of its own where there are threads.
#[cfg(not(target_arch = "wasm32"))]
fn cook_until(cookings: &mut [&mut Cooking], until: Instant) -> Result<Vec<Option<JobResult>>, JobError> {
    let Some((first, others)) = cookings.split_first_mut() else { return Ok(Vec::new()) };
    std::thread::scope(|scope| {
        let others: Vec<_> =
            others.iter_mut().map(|cooking| scope.spawn(move || seconds_until(cooking, until))).collect();
        let first = seconds_until(first, until);
        let others = others.into_iter().map(|t| t.join().unwrap_or_else(|panic| std::panic::resume_unwind(panic)));
        std::iter::once(first).chain(others).collect()
    })
}

/// Lets cooks go on until a time, one after the other.
#[cfg(target_arch = "wasm32")]
fn cook_until(cookings: &mut [&mut Cooking], until: Instant) -> Result<Vec<Option<JobResult>>, JobError> {
    cookings.iter_mut().map(|cooking| seconds_until(cooking, until)).collect()
}

/// Lets a cook go on until a time; at least a second of it.
fn seconds_until(cooking: &mut Cooking, until: Instant) -> Result<Option<JobResult>, JobError> {
    loop {
        if let Some(result) = cooking.second()? {
            return Ok(Some(result));
        }
        if Instant::now() >= until {
            return Ok(None);
        }
    }
}
