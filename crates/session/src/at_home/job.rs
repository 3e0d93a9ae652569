//! How kitchens are fitted off the frame.

use std::sync::Arc;

use saute_kitchen::Library;
use saute_plan::fit::observed::Observed;
use saute_plan::fit::predict::Predicting;
use saute_plan::fit::run::{FitRun, Fitted};
use saute_plan::{End, Shared};
use saute_recipe::Recipe;
use serde::{Deserialize, Serialize};
use web_time::Instant;

use super::why_not::WhyNoFit;
use crate::work::job::{self, AT_ONCE, Job, JobAnswer, all_until};

/// A kitchen to be fitted.
#[derive(Debug, Deserialize, Serialize)]
pub struct FitOrder {
    /// Its number, by which answers are known.
    pub number: u64,
    /// The text of the recipe of what was cooked.
    pub recipe: String,
    /// The text of the kitchen at home from which the fit begins; none of the typical one.
    pub home: Option<String>,
    /// What was observed.
    pub observed: Observed,
}

/// How far a fit is: the share of the work that is done [-], or what was found.
pub type Reply = job::Reply<f64, Box<Fitted>, WhyNoFit>;
/// What comes back.
pub type FitAnswer = JobAnswer<Reply>;

impl Job for FitRun {
    type Order = FitOrder;
    type Progress = f64;
    type Found = Box<Fitted>;
    type WhyNot = WhyNoFit;
    type Shared = Shared<Vec<f64>>;

    fn number(order: &FitOrder) -> u64 {
        order.number
    }

    fn begin(order: FitOrder, library: &Library, end: End) -> Result<Self, WhyNoFit> {
        let FitOrder { recipe, home, observed, .. } = order;
        let library = library.in_kitchen(home.as_deref()).map_err(|_| WhyNoFit::NoKitchen)?.into_owned();
        let recipe = Recipe::parse(&recipe, "recipe.toml", &library)?;
        Self::new(recipe, Arc::new(library), &observed, end).map_err(WhyNoFit::from)
    }

    fn go_on(&mut self, until: Instant) -> Result<(), WhyNoFit> {
        Ok(Self::go_on(self, AT_ONCE, |cooks| all_until(cooks, until, Predicting::second))?)
    }

    fn shares(&mut self) -> Vec<Shared<Vec<f64>>> {
        Self::shares(self)
    }

    fn take(&mut self, shared: Shared<Vec<f64>>) {
        Self::take(self, shared);
    }

    fn found(&self) -> Option<Box<Fitted>> {
        self.fitted().cloned().map(Box::new)
    }

    fn progress(&self) -> f64 {
        self.share()
    }
}
