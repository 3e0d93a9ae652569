//! The window's side of a search: the request, its progress and the plan.

use saute_kitchen::Library;
use saute_plan::schedule::Plan;
use saute_plan::schedule::asked::Asked;
use saute_plan::schedule::search::{PlanData, SearchProgress};

use web_time::Instant;

use super::job::{PlanAnswer, PlanOrder, PlanProgress, Reply};
use super::why_not::WhyNoPlan;
use crate::work::Helper;

/// Status of a search.
#[derive(Clone, Debug, Default, PartialEq)]
pub enum SearchStatus {
    /// Nothing was requested.
    #[default]
    Idle,
    /// It goes on; no number of candidates is known at first.
    Searching(Option<SearchProgress>),
    /// A plan was found.
    Found(Box<Plan>),
    /// It could not be searched for, and why.
    Refused(WhyNoPlan),
}

/// The search for a plan.
#[derive(Default)]
pub struct Planning {
    helper: Option<Box<dyn Helper>>,
    number: u64,
    asked: Option<Asked>,
    /// When the search began.
    begun: Option<Instant>,
    /// The best plan of the search so far.
    so_far: Option<Box<PlanData>>,
    standing: SearchStatus,
}

/// Share of a search from which its pace shows how long it takes [-] (chosen: the first jobs are the shortest).
const PACE_SHARE: f64 = 0.1;

impl Planning {
    /// Status of the search.
    pub fn standing(&self) -> &SearchStatus {
        &self.standing
    }

    /// The last request.
    pub fn asked(&self) -> Option<&Asked> {
        self.asked.as_ref()
    }

    /// The plan, once it is found.
    pub fn plan(&self) -> Option<&Plan> {
        if let SearchStatus::Found(plan) = &self.standing { Some(plan) } else { None }
    }

    /// Returns true while frames are to be drawn for the search.
    pub fn needs_frames(&self) -> bool {
        self.helper.as_ref().is_some_and(|helper| helper.needs_frames())
    }

    /// About how long the search still takes at the pace of its candidates so far [wall s]; none before it has a pace.
    pub fn left_s(&self) -> Option<f64> {
        let SearchStatus::Searching(Some(progress)) = &self.standing else { return None };
        let passed_s = self.begun?.elapsed().as_secs_f64();
        left_s(progress.share, passed_s)
    }

    /// Returns true while it searches.
    pub fn is_searching(&self) -> bool {
        matches!(self.standing, SearchStatus::Searching(_))
    }

    /// Returns true if there is a helper that takes requests.
    pub fn has_helper(&self) -> bool {
        self.helper.is_some()
    }

    /// Requests a plan in a kitchen at home, in place of the request before; a new helper if one was hired.
    pub fn ask(&mut self, asked: Asked, home: Option<String>, hired: Option<Box<dyn Helper>>) {
        self.helper = hired.or(self.helper.take());
        let Some(helper) = &mut self.helper else { return };
        self.number += 1;
        let order = PlanOrder { number: self.number, home, asked: asked.clone() };
        let order = postcard::to_allocvec(&order).expect("an order has no kind that postcard lacks");
        helper.ask(order);
        (self.asked, self.so_far, self.standing) = (Some(asked), None, SearchStatus::Searching(None));
        self.begun = Some(Instant::now());
    }

    /// Returns true if a stop keeps a plan.
    pub fn has_so_far(&self) -> bool {
        self.so_far.is_some()
    }

    /// Ends the search; the best plan so far is kept.
    pub fn stop(&mut self, library: &Library) {
        if let Some(helper) = self.helper.as_mut().filter(|_| matches!(self.standing, SearchStatus::Searching(_))) {
            helper.ask(Vec::new());
            self.standing = match (self.so_far.take(), &self.asked) {
                (Some(data), Some(asked)) => found(data, asked, library),
                _ => SearchStatus::Idle,
            };
        }
    }

    /// A helper with other data is hired for the next search, and no plan of the old data is shown.
    pub fn forget(&mut self) {
        (self.helper, self.standing) = (None, SearchStatus::Idle);
    }

    /// Takes what the helper has answered.
    pub fn take_answers(&mut self, library: &Library) {
        let Some(helper) = &mut self.helper else { return };
        match helper.answers() {
            Some(answers) => answers.iter().for_each(|bytes| self.take(bytes, library)),
            None => {
                self.helper = None;
                if self.is_searching() {
                    self.standing = SearchStatus::Idle;
                }
            }
        }
    }

    fn take(&mut self, bytes: &[u8], library: &Library) {
        let Ok(PlanAnswer { number, reply }) = postcard::from_bytes(bytes) else { return };
        if number != self.number || !self.is_searching() {
            return;
        }
        let Some(asked) = &self.asked else { return };
        self.standing = match reply {
            Reply::Progress(PlanProgress { search, so_far }) => {
                self.so_far = so_far;
                SearchStatus::Searching(Some(search))
            }
            Reply::Refused(why) => SearchStatus::Refused(why),
            Reply::Found(data) => found(data, asked, library),
        };
    }
}

/// A plan that answers the request.
fn found(data: Box<PlanData>, asked: &Asked, library: &Library) -> SearchStatus {
    match asked.order(library) {
        Ok(order) => SearchStatus::Found(Box::new(data.plan(order))),
        Err(error) => SearchStatus::Refused(error.into()),
    }
}

/// What is left of a work of which a share [-] took a time [s].
fn left_s(share: f64, passed_s: f64) -> Option<f64> {
    (share >= PACE_SHARE).then(|| passed_s * (1.0 - share) / share)
}

#[cfg(test)]
mod tests {
    use super::left_s;

    #[test]
    fn what_is_left_follows_the_pace_and_corrects_itself() {
        assert_eq!(left_s(0.05, 3.0), None);
        assert_eq!(left_s(0.25, 10.0), Some(30.0));
        // Slower than it began: more is left than was reported.
        assert_eq!(left_s(0.5, 60.0), Some(60.0));
    }
}
