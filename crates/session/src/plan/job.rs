//! How plans are searched for off the frame.

use std::sync::Arc;

use saute_kitchen::Library;
use saute_plan::schedule::asked::Asked;
use saute_plan::schedule::search::{PlanData, Search, SearchProgress};
use saute_plan::schedule::{Cooking, JobResult};
use saute_plan::{End, Shared};
use serde::{Deserialize, Serialize};
use web_time::Instant;

use super::why_not::WhyNoPlan;
use crate::work::job::{self, AT_ONCE, Job, JobAnswer, all_until};

/// A plan to be searched for.
#[derive(Debug, Deserialize, Serialize)]
pub struct PlanOrder {
    /// Its number, by which answers are known.
    pub number: u64,
    /// The text of the kitchen at home, unless it is the typical one.
    pub home: Option<String>,
    /// The request.
    pub asked: Asked,
}

/// How far a search is, and the best plan so far.
#[derive(Debug, Deserialize, Serialize)]
pub struct PlanProgress {
    /// How far it is.
    pub search: SearchProgress,
    /// What a stop now keeps; none before a candidate was cooked.
    pub so_far: Option<Box<PlanData>>,
}

/// How far a search is.
pub type Reply = job::Reply<PlanProgress, Box<PlanData>, WhyNoPlan>;
/// What comes back.
pub type PlanAnswer = JobAnswer<Reply>;

impl Job for Search {
    type Order = PlanOrder;
    type Progress = PlanProgress;
    type Found = Box<PlanData>;
    type WhyNot = WhyNoPlan;
    type Shared = Shared<JobResult>;

    fn number(order: &PlanOrder) -> u64 {
        order.number
    }

    fn begin(PlanOrder { home, asked, .. }: PlanOrder, library: &Library, end: End) -> Result<Self, WhyNoPlan> {
        let library = library.in_kitchen(home.as_deref()).map_err(|_| WhyNoPlan::NoKitchen)?;
        Self::new(&asked, Arc::new(library.into_owned()), end).map_err(WhyNoPlan::from)
    }

    fn go_on(&mut self, until: Instant) -> Result<(), WhyNoPlan> {
        Ok(Self::go_on(self, AT_ONCE, |cookings| all_until(cookings, until, Cooking::second))?)
    }

    fn shares(&mut self) -> Vec<Shared<JobResult>> {
        Self::shares(self)
    }

    fn take(&mut self, shared: Shared<JobResult>) {
        Self::take(self, shared);
    }

    fn found(&self) -> Option<Box<PlanData>> {
        self.plan().map(|plan| Box::new(PlanData::from(&plan)))
    }

    fn progress(&self) -> PlanProgress {
        let so_far = self.so_far().map(|plan| Box::new(PlanData::from(&plan)));
        PlanProgress { search: Self::progress(self), so_far }
    }
}
