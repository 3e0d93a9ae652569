//! The jobs of a round, done second by second in one place, or shared with a twin that has the same round.

use serde::{Deserialize, Serialize};

/// From which end of a round jobs are begun.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum End {
    /// From the first job on.
    Front,
    /// From the last job back: for the second of two who share a round.
    Back,
}

/// The result of a job, for a twin that has the same round.
#[derive(Clone, Debug, Deserialize, PartialEq, Serialize)]
pub struct Shared<R> {
    /// Number of the round [-].
    round: u64,
    /// Place of the job in the round [-].
    job: usize,
    /// What came of it.
    result: R,
}

/// A job of a round.
#[derive(Clone, Debug)]
enum Slot<J, C, R> {
    Open(Box<J>),
    Begun(Box<C>),
    Done(Box<R>),
}

impl<J, C, R> Slot<J, C, R> {
    fn is_done(&self) -> bool {
        matches!(self, Self::Done(_))
    }

    fn begun(&mut self) -> Option<&mut C> {
        if let Self::Begun(cooking) = self { Some(cooking) } else { None }
    }
}

/// A round of jobs `J`, which are cooked as `C` and give `R`.
#[derive(Clone, Debug)]
pub(crate) struct Round<J, C, R> {
    number: u64,
    end: End,
    slots: Vec<Slot<J, C, R>>,
    /// Own results that a twin does not have yet.
    own: Vec<Shared<R>>,
}

impl<J, C, R: Clone> Round<J, C, R> {
    /// A round without jobs.
    pub(crate) fn new(end: End) -> Self {
        Self { number: 0, end, slots: Vec::new(), own: Vec::new() }
    }

    /// Returns true if it has no job.
    pub(crate) fn is_empty(&self) -> bool {
        self.slots.is_empty()
    }

    /// Begins the next round.
    pub(crate) fn begin(&mut self, jobs: Vec<J>) {
        self.number += 1;
        self.slots = jobs.into_iter().map(|job| Slot::Open(Box::new(job))).collect();
    }

    /// Number of jobs that are done, and of all [-].
    pub(crate) fn done(&self) -> (usize, usize) {
        (self.slots.iter().filter(|slot| slot.is_done()).count(), self.slots.len())
    }

    /// Goes on with the first jobs that are not done, at most so many at once, as seen from the end at which it works. `cook` returns
    /// the results of those that are over, in their order.
    pub(crate) fn go_on<B, E: From<B>>(
        &mut self,
        at_once: usize,
        begin: impl Fn(&J) -> Result<C, B>,
        cook: impl FnOnce(&mut [&mut C]) -> Result<Vec<Option<R>>, E>,
    ) -> Result<(), E> {
        let mut open: Vec<_> = self.slots.iter_mut().enumerate().filter(|(_, slot)| !slot.is_done()).collect();
        if self.end == End::Back {
            open.reverse();
        }
        open.truncate(at_once);
        for (_, slot) in &mut open {
            if let Slot::Open(job) = &**slot {
                **slot = Slot::Begun(Box::new(begin(job)?));
            }
        }
        let mut cookings: Vec<&mut C> = open.iter_mut().filter_map(|(_, slot)| slot.begun()).collect();
        let results = cook(&mut cookings)?;
        for ((job, slot), result) in open.into_iter().zip(results) {
            if let Some(result) = result {
                self.own.push(Shared { round: self.number, job, result: result.clone() });
                *slot = Slot::Done(Box::new(result));
            }
        }
        Ok(())
    }

    /// Returns the results once all jobs are done, and ends the round.
    pub(crate) fn end(&mut self) -> Option<Vec<R>> {
        let is_done = !self.is_empty() && self.slots.iter().all(Slot::is_done);
        let result = |slot| if let Slot::Done(result) = slot { Some(*result) } else { None };
        is_done.then(|| std::mem::take(&mut self.slots).into_iter().filter_map(result).collect())
    }

    /// Takes the own results since the last call, for a twin.
    pub(crate) fn shares(&mut self) -> Vec<Shared<R>> {
        std::mem::take(&mut self.own)
    }

    /// Takes a result of a twin; one of another round, or of a job that is done, changes nothing.
    pub(crate) fn take(&mut self, Shared { round, job, result }: Shared<R>) {
        if let Some(slot) = self.slots.get_mut(job).filter(|slot| round == self.number && !slot.is_done()) {
            *slot = Slot::Done(Box::new(result));
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A cook of some seconds that gives its number.
    type Cook = (u32, u32);

    fn second(cooks: &mut [&mut Cook]) -> Result<Vec<Option<u32>>, ()> {
        let pass = |cook: &mut &mut Cook| {
            cook.1 -= 1;
            (cook.1 == 0).then_some(cook.0)
        };
        Ok(cooks.iter_mut().map(pass).collect())
    }

    fn go_on(round: &mut Round<u32, Cook, u32>, cooked: &mut u32) {
        *cooked += 1;
        round.go_on(1, |&job| Ok::<_, ()>((job, 3 + job % 4)), second).expect("cooks");
    }

    #[test]
    fn two_share_a_round_and_both_have_all_results_in_their_order() {
        let jobs: Vec<u32> = (0..9).collect();
        let mut alone = Round::new(End::Front);
        let mut twins = [Round::new(End::Front), Round::new(End::Back)];
        let mut cooked = [0; 3];
        for round in 0..3u32 {
            let of_round: Vec<u32> = jobs.iter().map(|job| job + round).collect();
            alone.begin(of_round.clone());
            let whole = loop {
                go_on(&mut alone, &mut cooked[2]);
                if let Some(results) = alone.end() {
                    break results;
                }
            };
            assert_eq!(whole, of_round);
            twins.iter_mut().for_each(|twin| twin.begin(of_round.clone()));
            let mut results = [None, None];
            while results.iter().any(Option::is_none) {
                for me in 0..2 {
                    if results[me].is_none() {
                        go_on(&mut twins[me], &mut cooked[me]);
                    }
                    for shared in twins[me].shares() {
                        twins[1 - me].take(shared);
                    }
                    results[me] = results[me].take().or_else(|| twins[me].end());
                }
            }
            assert_eq!(results, [Some(whole.clone()), Some(whole)]);
        }
        let most = cooked[0].max(cooked[1]);
        assert!(2 * most < cooked[2] + 3 * 8, "each does half, and at most the last job of a round twice: {cooked:?}");
    }

    #[test]
    fn what_belongs_to_another_round_changes_nothing() {
        let mut round: Round<u32, Cook, u32> = Round::new(End::Front);
        round.begin(vec![7]);
        for (of, job) in [(0, 0), (2, 0), (1, 1)] {
            round.take(Shared { round: of, job, result: 5 });
        }
        assert_eq!((round.done(), round.end()), ((0, 1), None));
        round.take(Shared { round: 1, job: 0, result: 5 });
        round.take(Shared { round: 1, job: 0, result: 6 });
        assert_eq!(round.end(), Some(vec![5]), "what came first counts");
    }
}
