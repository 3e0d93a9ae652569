//! The cards of a study: consent, trials, the cook at a real stove, questions, the end.

use egui::{Rect, RichText, Ui};
use saute_study::protocol_file::Entered;
use saute_study::{Answering, Answers, CookForReal, Measures, Pace, Questionnaire, Simulate, Stage};

use super::{Entries, answers, button, card};
use crate::system::IS_PAGE;
use crate::ui::theme;
use saute_controls::act::GuidedAct;
use saute_controls::act::{Act, Acts, LearnAct};
use saute_controls::context::PanelContext;
use saute_session::guided::{Readiness, StudyDesk, TrialRun};
use saute_words::guided_words;

/// Shows the card of the stage.
pub(super) fn show(
    state: &PanelContext,
    desk: &StudyDesk,
    entries: &mut Entries,
    ui: &Ui,
    acts: &mut Acts,
    whole: Rect,
) {
    let study = desk.study();
    if desk.has_declined() {
        return the_end(state, desk, "study.declined", ui, acts, whole);
    }
    match desk.readiness() {
        Readiness::Untried | Readiness::NotNeeded | Readiness::Holds(_) => {}
        Readiness::Tried(run) => return tried(state, desk, run, ui, whole),
        Readiness::TooSlow(pace) => return too_slow(state, desk, *pace, ui, acts, whole),
    }
    match study.stage() {
        Stage::Consent => consent(state, desk, ui, acts, whole),
        Stage::Trial { trial, .. } => {
            if let Some(simulate) = study.simulate() {
                next_trial(state, desk, (simulate, trial), ui, acts, whole);
            }
        }
        Stage::CookForReal { .. } => {
            if let Some(real) = study.cook_for_real() {
                cook_for_real(state, desk, real, entries, ui, acts, whole);
            }
        }
        Stage::Questionnaire { .. } => {
            if let Some(asked) = study.questionnaire() {
                questions(state, desk, asked, entries, ui, acts, whole);
            }
        }
        Stage::Over => the_end(state, desk, "study.over", ui, acts, whole),
    }
}

fn title(desk: &StudyDesk) -> &str {
    desk.study().phase().map_or(desk.study().protocol().title.as_str(), |phase| phase.title.as_str())
}

/// The machine is tried, before anything is agreed to.
fn tried(state: &PanelContext, desk: &StudyDesk, run: &TrialRun, ui: &Ui, whole: Rect) {
    let content = |ui: &mut Ui| {
        ui.label(state.settings.language.fill("study.tried", &[("speed", &run.speed())]));
    };
    card(ui, ("tried", &desk.study().protocol().title), whole, content, |_| {});
}

fn too_slow(state: &PanelContext, desk: &StudyDesk, pace: Pace, ui: &Ui, acts: &mut Acts, whole: Rect) {
    let l = state.settings.language;
    let held = format!("{:.1}", pace.held_median);
    let content = |ui: &mut Ui| {
        ui.label(l.fill("study.too_slow", &[("speed", &pace.set), ("held", &held)]));
        ui.label(l.text("study.too_slow_remedy"));
    };
    card(ui, ("too-slow", &desk.study().protocol().title), whole, content, |ui| {
        if button(ui, l.text("study.try_again"), true) {
            acts.push(Act::Learn(LearnAct::Guided(GuidedAct::TryMachine)));
        }
        if !IS_PAGE && button(ui, l.text("study.close"), false) {
            acts.push(Act::Learn(LearnAct::Guided(GuidedAct::CloseWindow)));
        }
    });
}

fn consent(state: &PanelContext, desk: &StudyDesk, ui: &Ui, acts: &mut Acts, whole: Rect) {
    let l = state.settings.language;
    let protocol = desk.study().protocol();
    let content = |ui: &mut Ui| {
        ui.label(protocol.consent.trim());
        ui.add_space(6.0);
        ui.label(quiet(ui, &l.fill("study.code", &[("code", desk.study().participant())])));
    };
    card(ui, ("consent", &protocol.title), whole, content, |ui| {
        if button(ui, l.text("study.agree"), true) {
            acts.push(Act::Learn(LearnAct::Guided(GuidedAct::Agree)));
        }
        if button(ui, l.text("study.decline"), false) {
            acts.push(Act::Learn(LearnAct::Guided(GuidedAct::Decline)));
        }
    });
}

fn next_trial(
    state: &PanelContext,
    desk: &StudyDesk,
    (simulate, trial): (&Simulate, u32),
    ui: &Ui,
    acts: &mut Acts,
    whole: Rect,
) {
    let l = state.settings.language;
    let content = |ui: &mut Ui| {
        told(state, desk.told(), ui);
        ui.label(RichText::new(l.fill("study.trial", &[("trial", &trial), ("trials", &simulate.trials)])).strong());
        let goal = l.named("goal", &simulate.goal.goal.name, &simulate.goal.goal.names);
        ui.label(l.fill("study.goal", &[("goal", &goal)]));
        ui.label(l.fill("study.speed", &[("speed", &simulate.speed)]));
        if let Readiness::Holds(pace) = desk.readiness() {
            let held = format!("{:.1}", pace.held_median);
            ui.label(quiet(ui, &l.fill("study.holds", &[("held", &held)])));
        }
        ui.label(quiet(ui, l.text("study.how_it_ends")));
    };
    card(ui, ("trial", title(desk)), whole, content, |ui| {
        begin_unless_in_trouble(state, desk, ui, acts, "study.begin_trial", GuidedAct::BeginTrial);
    });
}

/// What came of the trial before, if the participant is informed.
fn told(state: &PanelContext, last: Option<&Measures>, ui: &mut Ui) {
    if let Some(measures) = last {
        ui.label(guided_words::outcome(measures, state.settings.speech()));
        ui.separator();
    }
}

fn cook_for_real(
    state: &PanelContext,
    desk: &StudyDesk,
    real: &CookForReal,
    entries: &mut Entries,
    ui: &Ui,
    acts: &mut Acts,
    whole: Rect,
) {
    let l = state.settings.language;
    let content = |ui: &mut Ui, found: &mut Answers| {
        told(state, desk.told(), ui);
        ui.label(real.instructions.trim());
        ui.separator();
        for entered in &real.enter {
            let answering = answering(*entered, real);
            let words = guided_words::entered(*entered, l);
            found.extend(
                answers::item(state, ui, (entered.id(), words), &answering, entries)
                    .map(|answer| (entered.id().to_owned(), answer)),
            );
        }
    };
    hand_in(state, desk, ("real", title(desk)), (ui, acts, whole), content, real.enter.len());
}

fn answering(entered: Entered, real: &CookForReal) -> Answering {
    match entered.range() {
        Some(range) => Answering::Number(range, entered.unit().to_owned()),
        None => Answering::Choice(real.goal.classes()),
    }
}

fn questions(
    state: &PanelContext,
    desk: &StudyDesk,
    asked: &Questionnaire,
    entries: &mut Entries,
    ui: &Ui,
    acts: &mut Acts,
    whole: Rect,
) {
    let content = |ui: &mut Ui, found: &mut Answers| {
        told(state, desk.told(), ui);
        if !asked.intro.is_empty() {
            ui.label(&asked.intro);
            ui.add_space(6.0);
        }
        for item in &asked.items {
            let answer = answers::item(state, ui, (&item.id, &item.text), &item.answer, entries);
            found.extend(answer.map(|answer| (item.id.clone(), answer)));
        }
    };
    hand_in(state, desk, ("questions", title(desk)), (ui, acts, whole), content, asked.items.len());
}

/// A card with fields, and a button that hands them in once all have an answer.
fn hand_in(
    state: &PanelContext,
    desk: &StudyDesk,
    heading: (&str, &str),
    (ui, acts, whole): (&Ui, &mut Acts, Rect),
    content: impl FnOnce(&mut Ui, &mut Answers),
    wanted: usize,
) {
    let l = state.settings.language;
    let found = std::cell::RefCell::new(Answers::new());
    card(
        ui,
        heading,
        whole,
        |ui| content(ui, &mut found.borrow_mut()),
        |ui| {
            let is_whole = found.borrow().len() == wanted;
            let done = theme::of(ui).button(l.text("study.hand_in"), is_whole);
            let response = ui.add_enabled(is_whole, done).on_disabled_hover_text(l.text("study.answer_all"));
            if response.clicked() {
                acts.push(Act::Learn(LearnAct::Guided(GuidedAct::Answer(found.take()))));
            }
            trouble(state, desk, ui, acts);
        },
    );
}

/// A button that goes on only if all rows are kept.
fn begin_unless_in_trouble(
    state: &PanelContext,
    desk: &StudyDesk,
    ui: &mut Ui,
    acts: &mut Acts,
    key: &'static str,
    act: GuidedAct,
) {
    if desk.trouble().is_none() && button(ui, state.settings.language.text(key), true) {
        acts.push(Act::Learn(LearnAct::Guided(act)));
    }
    trouble(state, desk, ui, acts);
}

/// Why rows could not be written, and a button that tries again.
fn trouble(state: &PanelContext, desk: &StudyDesk, ui: &mut Ui, acts: &mut Acts) {
    let l = state.settings.language;
    if desk.offers_download() && button(ui, l.text("study.save_log"), false) {
        acts.push(Act::Learn(LearnAct::Guided(GuidedAct::SaveLog)));
    }
    let Some(trouble) = desk.trouble() else { return };
    if button(ui, l.text("study.write_again"), true) {
        acts.push(Act::Learn(LearnAct::Guided(GuidedAct::KeepRows)));
    }
    ui.label(RichText::new(l.fill("study.not_written", &[("error", &trouble)])).color(theme::of(ui).accent));
}

fn the_end(state: &PanelContext, desk: &StudyDesk, key: &'static str, ui: &Ui, acts: &mut Acts, whole: Rect) {
    let l = state.settings.language;
    let content = |ui: &mut Ui| {
        told(state, desk.told(), ui);
        ui.label(l.text(key));
    };
    card(ui, ("end", &desk.study().protocol().title), whole, content, |ui| {
        trouble(state, desk, ui, acts);
        let can_close = !IS_PAGE && desk.trouble().is_none();
        if can_close && button(ui, l.text("study.close"), !desk.offers_download()) {
            acts.push(Act::Learn(LearnAct::Guided(GuidedAct::CloseWindow)));
        }
    });
}

fn quiet(ui: &Ui, text: &str) -> RichText {
    RichText::new(text).size(13.0).color(theme::of(ui).quiet)
}
