//! The window's side of a fit: the request, its progress and the result.

use saute_plan::fit::observed::Observed;
use saute_plan::fit::run::Fitted;

use super::entered::Entered;
use super::job::{FitAnswer, FitOrder, Reply};
use super::why_not::WhyNoFit;
use crate::work::Helper;

/// Status of a fit.
#[derive(Clone, Debug, Default, PartialEq)]
pub enum FitStatus {
    /// Nothing was requested.
    #[default]
    Idle,
    /// It goes on: the share of the work that is done [-].
    Fitting(f64),
    /// It is over.
    Found(Box<Fitted>),
    /// It could not be done, and why.
    Refused(WhyNoFit),
}

/// What was entered, and the fit to it.
#[derive(Default)]
pub struct AtHome {
    /// What was entered.
    pub entered: Entered,
    helper: Option<Box<dyn Helper>>,
    number: u64,
    /// What the last fit was made to.
    observed: Observed,
    pub(super) standing: FitStatus,
}

impl AtHome {
    /// Status of the fit.
    pub fn standing(&self) -> &FitStatus {
        &self.standing
    }

    /// Nothing can be fitted, and why.
    pub fn refuse(&mut self, why: WhyNoFit) {
        self.standing = FitStatus::Refused(why);
    }

    /// What the last fit was made to.
    pub fn observed(&self) -> &Observed {
        &self.observed
    }

    /// What was found.
    pub fn fitted(&self) -> Option<&Fitted> {
        if let FitStatus::Found(fitted) = &self.standing { Some(fitted) } else { None }
    }

    /// Returns true while it fits.
    pub fn is_fitting(&self) -> bool {
        matches!(self.standing, FitStatus::Fitting(_))
    }

    /// Returns true while frames are to be drawn for the fit.
    pub fn needs_frames(&self) -> bool {
        self.helper.as_ref().is_some_and(|helper| helper.needs_frames())
    }

    /// Returns true if there is a helper that takes requests.
    pub fn has_helper(&self) -> bool {
        self.helper.is_some()
    }

    /// Requests a fit, in place of the one before; a new helper if one was hired.
    pub fn ask(&mut self, recipe: String, home: Option<String>, observed: Observed, hired: Option<Box<dyn Helper>>) {
        self.helper = hired.or(self.helper.take());
        let Some(helper) = &mut self.helper else { return };
        self.number += 1;
        self.observed.clone_from(&observed);
        let order = FitOrder { number: self.number, recipe, home, observed };
        helper.ask(postcard::to_allocvec(&order).expect("an order has no kind that postcard lacks"));
        self.standing = FitStatus::Fitting(0.0);
    }

    /// Ends the fit.
    pub fn cancel(&mut self) {
        let is_fitting = self.is_fitting();
        if let Some(helper) = self.helper.as_mut().filter(|_| is_fitting) {
            helper.ask(Vec::new());
            self.standing = FitStatus::Idle;
        }
    }

    /// Takes what the helper has answered.
    pub fn take_answers(&mut self) {
        let Some(helper) = &mut self.helper else { return };
        match helper.answers() {
            Some(answers) => answers.iter().for_each(|bytes| self.take(bytes)),
            None => {
                self.helper = None;
                if self.is_fitting() {
                    self.standing = FitStatus::Idle;
                }
            }
        }
    }

    fn take(&mut self, bytes: &[u8]) {
        let Ok(FitAnswer { number, reply }) = postcard::from_bytes(bytes) else { return };
        if number != self.number || !self.is_fitting() {
            return;
        }
        self.standing = match reply {
            Reply::Progress(share) => FitStatus::Fitting(share),
            Reply::Found(fitted) => FitStatus::Found(fitted),
            Reply::Refused(why) => FitStatus::Refused(why),
        };
    }
}
