//! How kitchens are fitted off the frame: orders and answers as bytes, the fit in slices.

use std::sync::Arc;

use saute_kitchen::Library;
use saute_plan::fit::observed::Observed;
use saute_plan::fit::predict::{FitError, Predicting};
use saute_plan::fit::run::{FitRun, Fitted};
use saute_recipe::Recipe;
use serde::{Deserialize, Serialize};
use web_time::{Duration, Instant};

use super::why_not::WhyNot;
use crate::work::bench::Craft;

/// Cooks at once [-] (chosen: two where there are threads; the picture needs the rest of the machine).
const AT_ONCE: usize = if cfg!(target_arch = "wasm32") { 1 } else { 2 };
/// Computing time between two answers (chosen: a bar that moves a few times a second).
const COMPUTED_PER_ANSWER: Duration = Duration::from_millis(250);

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

/// What comes back.
#[derive(Debug, Deserialize, Serialize)]
pub struct FitAnswer {
    /// The number of the order.
    pub number: u64,
    /// How far it is.
    pub told: Told,
}

/// How far a fit is.
#[derive(Debug, Deserialize, Serialize)]
pub enum Told {
    /// The share of the work that is done [-].
    Progress(f64),
    /// It is over.
    Fitted(Box<Fitted>),
    /// It cannot be done, and why.
    Refused(WhyNot),
}

/// The fitting of kitchens.
pub struct Fitting {
    library: Arc<Library>,
    work: Option<(u64, Box<FitRun>)>,
    /// Why the order that came last cannot be done.
    refused: Option<(u64, WhyNot)>,
    computed: Duration,
}

impl Fitting {
    /// Without an order.
    pub fn new(library: Arc<Library>) -> Self {
        Self { library, work: None, refused: None, computed: Duration::ZERO }
    }

    fn begin(&self, order: &FitOrder) -> Result<FitRun, WhyNot> {
        let library = self.library.in_kitchen(order.home.as_deref()).map_err(|_| WhyNot::NoKitchen)?.into_owned();
        let recipe = Recipe::parse(&order.recipe, "recipe.toml", &library)?;
        FitRun::new(recipe, Arc::new(library), &order.observed).map_err(WhyNot::from)
    }

    /// Works on; returns how far it is where that is to be told.
    fn slice(&mut self, budget: Duration) -> Option<(u64, Told)> {
        let (number, run) = self.work.as_mut()?;
        let (number, begun) = (*number, Instant::now());
        let done = run.go_on(AT_ONCE, |cooks| cook_until(cooks, begun + budget));
        self.computed += begun.elapsed();
        let told = match (done, run.fitted()) {
            (Err(error), _) => Told::Refused(error.into()),
            (Ok(()), Some(fitted)) => Told::Fitted(Box::new(fitted.clone())),
            (Ok(()), None) if self.computed < COMPUTED_PER_ANSWER => return None,
            (Ok(()), None) => Told::Progress(run.share()),
        };
        self.computed = Duration::ZERO;
        if !matches!(told, Told::Progress(_)) {
            self.work = None;
        }
        Some((number, told))
    }
}

impl Craft for Fitting {
    fn take(&mut self, order: &[u8]) {
        (self.work, self.refused, self.computed) = (None, None, Duration::ZERO);
        let Ok(order) = postcard::from_bytes::<FitOrder>(order) else { return };
        match self.begin(&order) {
            Ok(run) => self.work = Some((order.number, Box::new(run))),
            Err(why) => self.refused = Some((order.number, why)),
        }
    }

    fn is_busy(&self) -> bool {
        self.work.is_some() || self.refused.is_some()
    }

    fn go_on(&mut self, budget: Duration) -> Option<Vec<u8>> {
        let refused = self.refused.take().map(|(number, why)| (number, Told::Refused(why)));
        let (number, told) = refused.or_else(|| self.slice(budget))?;
        postcard::to_allocvec(&FitAnswer { number, told }).ok()
    }
}

type Values = Option<Vec<f64>>;

/// Lets cooks go on until a time, each on a thread of its own where there are threads.
#[cfg(not(target_arch = "wasm32"))]
fn cook_until(cooks: &mut [&mut Predicting], until: Instant) -> Result<Vec<Values>, FitError> {
    let Some((first, others)) = cooks.split_first_mut() else { return Ok(Vec::new()) };
    std::thread::scope(|scope| {
        let others: Vec<_> = others.iter_mut().map(|cook| scope.spawn(move || seconds_until(cook, until))).collect();
        let first = seconds_until(first, until);
        let others = others.into_iter().map(|t| t.join().unwrap_or_else(|panic| std::panic::resume_unwind(panic)));
        std::iter::once(first).chain(others).collect()
    })
}

/// Lets cooks go on until a time, one after the other.
#[cfg(target_arch = "wasm32")]
fn cook_until(cooks: &mut [&mut Predicting], until: Instant) -> Result<Vec<Values>, FitError> {
    cooks.iter_mut().map(|cook| seconds_until(cook, until)).collect()
}

/// Lets a cook go on until a time; at least a second of it.
fn seconds_until(cook: &mut Predicting, until: Instant) -> Result<Values, FitError> {
    loop {
        if let Some(values) = cook.second()? {
            return Ok(Some(values));
        }
        if Instant::now() >= until {
            return Ok(None);
        }
    }
}
