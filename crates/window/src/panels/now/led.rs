//! The leads other than the advice: a plan, the tutorial, a lesson or a study. While one leads, its words are on the line; what else it
//! shows is below the line.

use egui::Ui;
use saute_kitchen::advice::Advice;

use super::guide::Guide;
use super::taught;
use saute_controls::act::{Act, Acts, GuidedAct, LearnAct};
use saute_controls::context::PanelContext;
use saute_controls::now::now_state::NowState;
use saute_controls::now::now_words::{Deed, NowWords};
use saute_controls::tutorial::{Step, Tutorial};
use saute_session::guided::Guided;
use saute_words::language::Language;

/// A lead other than the advice.
pub(super) enum Lead<'a> {
    /// The guide of a cook that follows a plan.
    Plan(Guide<'a>),
    /// The tutorial.
    Tutorial(&'a Tutorial),
    /// A lesson or a study whose food is out.
    Guided(&'a Guided),
}

impl<'a> Lead<'a> {
    /// The present lead.
    pub fn of(state: &NowState<'a>) -> Option<Self> {
        let guide = state.live.filter(|live| !live.is_closed()).map(|live| Self::Plan(Guide::of(live, state)));
        guide.or(state.tutorial.map(Self::Tutorial)).or_else(|| state.waits_to_end().map(Self::Guided))
    }

    /// Its words, unless the line shows the advice: what is dangerous is always shown, and who has left a plan is advised again.
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
            Self::Guided(guided) => Some(end(guided, state.settings.language)),
        }
    }

    /// The control that is meant where no button of the line does it.
    pub fn control(&self, state: &NowState) -> Option<Act> {
        match self {
            Self::Plan(_) | Self::Guided(_) => None,
            Self::Tutorial(tutorial) => taught::control(tutorial, state),
        }
    }

    /// Height of what it shows below a line of a width [points]; none where that is nothing.
    pub fn height(&self, ui: &Ui, width: f32) -> Option<f32> {
        match self {
            Self::Plan(_) => Some(Guide::height(ui, width)),
            Self::Tutorial(_) => Some(taught::height(ui)),
            Self::Guided(_) => None,
        }
    }

    /// Shows what is below the line; `has_word` is true while the line shows its words.
    pub fn show(&self, has_word: bool, state: &PanelContext, ui: &mut Ui, acts: &mut Acts) {
        match self {
            Self::Plan(guide) => guide.show(has_word, state, ui, acts),
            Self::Tutorial(tutorial) => taught::show(tutorial, state, ui, acts),
            Self::Guided(_) => {}
        }
    }
}

/// The food is out: the button that ends the lesson or the trial.
fn end(guided: &Guided, l: Language) -> NowWords {
    let (why, act) = match guided {
        Guided::Lesson(_) => ("lesson.finish_why", GuidedAct::EndLesson),
        Guided::Study(_) => ("study.finish_why", GuidedAct::EndTrial),
    };
    let finish = Deed::called(l.text("guided.finish"), Act::Learn(LearnAct::Guided(act)), false);
    NowWords::told(l.text("guided.is_out").to_owned(), l.text(why).to_owned(), Some(finish), false, l)
}
