//! Who leads besides the advice: a plan or the tutorial. Its words stand on the line while it has the word; what else it shows stands
//! below them.

use egui::Ui;
use saute_kitchen::advice::Advice;

use super::guide::Guide;
use super::taught;
use saute_controls::act::{Act, Acts};
use saute_controls::context::PanelContext;
use saute_controls::now::now_state::NowState;
use saute_controls::now::now_words::NowWords;
use saute_controls::tutorial::{Step, Tutorial};

/// Who leads besides the advice.
pub(super) enum Lead<'a> {
    /// The guide of a cook that follows a plan.
    Plan(Guide<'a>),
    /// The tutorial.
    Tutorial(&'a Tutorial),
}

impl<'a> Lead<'a> {
    /// Who leads now.
    pub fn of(state: &NowState<'a>) -> Option<Self> {
        let guide = state.live.filter(|live| !live.is_closed()).map(|live| Self::Plan(Guide::of(live, state)));
        guide.or(state.tutorial.map(Self::Tutorial))
    }

    /// Its words, unless the advice has the word: what is dangerous is always said, and who has left a plan is advised again.
    pub fn words(&self, advice: Option<Advice>, state: &NowState) -> Option<NowWords> {
        match self {
            Self::Plan(guide) => {
                let leads = (state.guide_leads || guide.is_over()) && !advice.is_some_and(Advice::is_due);
                (leads || advice.is_none()).then(|| guide.words(state))
            }
            Self::Tutorial(tutorial) => {
                let is_meant = !state.alarm || tutorial.step() == Step::TakeOut;
                is_meant.then(|| taught::words(tutorial, state))
            }
        }
    }

    /// The control that is meant where no button of the line stands for it.
    pub fn control(&self, state: &NowState) -> Option<Act> {
        match self {
            Self::Plan(_) => None,
            Self::Tutorial(tutorial) => taught::control(tutorial, state),
        }
    }

    /// Height of what it shows below a line of a width [points].
    pub fn height(&self, ui: &Ui, width: f32) -> f32 {
        match self {
            Self::Plan(_) => Guide::height(ui, width),
            Self::Tutorial(_) => taught::height(ui),
        }
    }

    /// Shows what is below the line; `has_word` is true while the line tells its words.
    pub fn show(&self, has_word: bool, state: &PanelContext, ui: &mut Ui, acts: &mut Acts) {
        match self {
            Self::Plan(guide) => guide.show(has_word, state, ui, acts),
            Self::Tutorial(tutorial) => taught::show(tutorial, state, ui, acts),
        }
    }
}
