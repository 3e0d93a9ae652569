//! Work of many cooks that states how far it is while it goes on: a search for a plan, the fit of a kitchen.

use std::sync::Arc;

use saute_kitchen::Library;
use saute_plan::End;
use serde::de::DeserializeOwned;
use serde::{Deserialize, Serialize};
use web_time::{Duration, Instant};

use super::worker::Worker;

/// Cooks at once [-] (chosen: two where there are threads; the picture needs the rest of the machine).
pub const AT_ONCE: usize = if cfg!(target_arch = "wasm32") { 1 } else { 2 };
/// Computing time between two answers (chosen: a bar that moves a few times a second).
const COMPUTED_PER_ANSWER: Duration = Duration::from_millis(250);

/// Work that ends with something found.
pub trait Job: Sized {
    /// The order.
    type Order: DeserializeOwned;
    /// How far it is.
    type Progress: Serialize;
    /// What it ends with.
    type Found: Serialize;
    /// Why it cannot be done.
    type WhyNot: Serialize;
    /// A part of the work that a twin needs not do again.
    type Shared: DeserializeOwned + Serialize;

    /// The number of an order, by which its answers are known.
    fn number(order: &Self::Order) -> u64;

    /// Begins an order, at one end if it is shared with a twin.
    ///
    /// # Errors
    /// If it cannot be done.
    fn begin(order: Self::Order, library: &Library, end: End) -> Result<Self, Self::WhyNot>;

    /// Goes on until a time.
    ///
    /// # Errors
    /// If it cannot be done.
    fn go_on(&mut self, until: Instant) -> Result<(), Self::WhyNot>;

    /// What was done here since the last call.
    fn shares(&mut self) -> Vec<Self::Shared>;

    /// Takes what a twin has done.
    fn take(&mut self, shared: Self::Shared);

    /// What was found, once it is over.
    fn found(&self) -> Option<Self::Found>;

    /// How far it is.
    fn progress(&self) -> Self::Progress;
}

/// What comes back.
#[derive(Debug, Deserialize, Serialize)]
pub struct JobAnswer<T> {
    /// The number of the order.
    pub number: u64,
    /// How far it is.
    pub reply: T,
}

/// How far a job is.
#[derive(Debug, Deserialize, Serialize)]
pub enum Reply<Progress, Found, WhyNot> {
    /// It goes on.
    Progress(Progress),
    /// It is over.
    Found(Found),
    /// It cannot be done, and why.
    Refused(WhyNot),
}

type ReplyOf<U> = Reply<<U as Job>::Progress, <U as Job>::Found, <U as Job>::WhyNot>;

/// A job off the frame: orders and answers as bytes, the work in slices.
pub struct JobWorker<U: Job> {
    library: Arc<Library>,
    end: End,
    work: Option<(u64, Box<U>)>,
    /// Why the order that came last cannot be done.
    refused: Option<(u64, U::WhyNot)>,
    /// What the twin does not have yet of an order that is over.
    last: Option<Vec<u8>>,
    computed: Duration,
}

impl<U: Job> JobWorker<U> {
    /// Without an order; one of two that share each order works from the back.
    pub fn new(library: Arc<Library>, end: End) -> Self {
        Self { library, end, work: None, refused: None, last: None, computed: Duration::ZERO }
    }

    /// What was done of the order since the last call, for a twin.
    fn shares(&mut self) -> Option<Vec<u8>> {
        let (number, work) = self.work.as_mut()?;
        let shares = work.shares();
        (!shares.is_empty()).then(|| postcard::to_allocvec(&(*number, shares)).ok())?
    }

    /// Works on; returns the progress where that is to be reported.
    fn slice(&mut self, budget: Duration) -> Option<(u64, ReplyOf<U>)> {
        let (number, work) = self.work.as_mut()?;
        let (number, begun) = (*number, Instant::now());
        let done = work.go_on(begun + budget);
        self.computed += begun.elapsed();
        let reply = match (done, work.found()) {
            (Err(why), _) => Reply::Refused(why),
            (Ok(()), Some(found)) => Reply::Found(found),
            (Ok(()), None) if self.computed < COMPUTED_PER_ANSWER => return None,
            (Ok(()), None) => Reply::Progress(work.progress()),
        };
        self.computed = Duration::ZERO;
        if !matches!(reply, Reply::Progress(_)) {
            self.last = self.shares();
            self.work = None;
        }
        Some((number, reply))
    }
}

impl<U: Job> Worker for JobWorker<U> {
    fn take(&mut self, order: &[u8]) {
        (self.work, self.refused, self.last, self.computed) = (None, None, None, Duration::ZERO);
        let Ok(order) = postcard::from_bytes::<U::Order>(order) else { return };
        let number = U::number(&order);
        match U::begin(order, &self.library, self.end) {
            Ok(work) => self.work = Some((number, Box::new(work))),
            Err(why) => self.refused = Some((number, why)),
        }
    }

    fn is_busy(&self) -> bool {
        self.work.is_some() || self.refused.is_some()
    }

    fn go_on(&mut self, budget: Duration) -> Option<Vec<u8>> {
        let refused = self.refused.take().map(|(number, why)| (number, Reply::Refused(why)));
        let (number, reply) = refused.or_else(|| self.slice(budget))?;
        postcard::to_allocvec(&JobAnswer { number, reply }).ok()
    }

    fn share(&mut self) -> Option<Vec<u8>> {
        self.last.take().or_else(|| self.shares())
    }

    fn take_shared(&mut self, shares: &[u8]) {
        let Ok((of, shares)) = postcard::from_bytes::<(u64, Vec<U::Shared>)>(shares) else { return };
        if let Some((_, work)) = self.work.as_mut().filter(|(number, _)| *number == of) {
            shares.into_iter().for_each(|shared| work.take(shared));
        }
    }
}

/// Lets cooks go on until a time, each on its own thread where there are threads; `second` lets a second of one pass and returns its
/// result once it is over.
///
/// # Errors
/// The first one of a cook.
#[cfg(not(target_arch = "wasm32"))]
pub fn all_until<C: Send, R: Send, E: Send>(
    cooks: &mut [&mut C],
    until: Instant,
    second: fn(&mut C) -> Result<Option<R>, E>,
) -> Result<Vec<Option<R>>, E> {
    let Some((first, others)) = cooks.split_first_mut() else { return Ok(Vec::new()) };
    std::thread::scope(|scope| {
        let others: Vec<_> =
            others.iter_mut().map(|cook| scope.spawn(move || one_until(*cook, until, second))).collect();
        let first = one_until(*first, until, second);
        let others = others.into_iter().map(|t| t.join().unwrap_or_else(|panic| std::panic::resume_unwind(panic)));
        std::iter::once(first).chain(others).collect()
    })
}

/// Lets cooks go on until a time, one after the other; `second` lets a second of one pass and returns its result once it is over.
///
/// # Errors
/// The first one of a cook.
#[cfg(target_arch = "wasm32")]
pub fn all_until<C, R, E>(
    cooks: &mut [&mut C],
    until: Instant,
    second: fn(&mut C) -> Result<Option<R>, E>,
) -> Result<Vec<Option<R>>, E> {
    cooks.iter_mut().map(|cook| one_until(*cook, until, second)).collect()
}

/// Lets a cook go on until a time; at least a second of it.
fn one_until<C, R, E>(
    cook: &mut C,
    until: Instant,
    second: fn(&mut C) -> Result<Option<R>, E>,
) -> Result<Option<R>, E> {
    loop {
        if let Some(result) = second(cook)? {
            return Ok(Some(result));
        }
        if Instant::now() >= until {
            return Ok(None);
        }
    }
}
