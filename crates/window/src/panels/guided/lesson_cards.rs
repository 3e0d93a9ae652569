//! The cards of a lesson: what it is about, questions, and the result.

use egui::{Grid, Rect, RichText, Slider, Ui};
use saute_study::Measures;
use saute_study::class::rest::Rest;
use saute_study::class::{Ask, Lesson, ResultRow};

use super::ribbon::titled;
use super::{Entries, button, card};
use crate::ui::aloud::spoken_value;
use crate::ui::theme;
use saute_controls::act::GuidedAct;
use saute_controls::act::{Act, Acts, LearnAct};
use saute_controls::context::PanelContext;
use saute_session::guided::LessonDesk;
use saute_words::doneness_words;
use saute_words::guided_words;

/// Shows the card that is due; returns false while the cook runs.
pub(super) fn show(
    state: &PanelContext,
    desk: &LessonDesk,
    entries: &mut Entries,
    ui: &Ui,
    acts: &mut Acts,
    whole: Rect,
) -> bool {
    let Some(lesson) = &state.session.lesson else { return false };
    if let Some((row, measures)) = desk.result() {
        result(state, desk, lesson, (row, measures), ui, acts, whole);
    } else if let Some(rest) = desk.rest() {
        cooked_on(state, desk, rest, ui, whole);
    } else if !desk.has_begun() {
        intro(state, desk, ui, acts, whole);
    } else if let Some(place) = desk.shown() {
        truth(state, lesson, place, ui, acts, whole);
    } else if let Some(place) = lesson.waiting() {
        question(state, lesson, place, entries, ui, acts, whole);
    } else {
        return false;
    }
    true
}

fn intro(state: &PanelContext, desk: &LessonDesk, ui: &Ui, acts: &mut Acts, whole: Rect) {
    let (l, scenario) = (state.settings.language, desk.scenario());
    let content = |ui: &mut Ui| {
        ui.label(scenario.intro.of(l.code()));
        ui.add_space(4.0);
        let goal = l.named("goal", &scenario.goal.goal.name, &scenario.goal.goal.names);
        ui.label(RichText::new(l.fill("study.goal", &[("goal", &goal)])).strong());
        let locked = guided_words::locked(&scenario.locked, l);
        if !locked.is_empty() {
            ui.label(
                RichText::new(l.fill("lesson.locked", &[("what", &locked)])).size(13.0).color(theme::of(ui).quiet),
            );
        }
    };
    card(ui, ("intro", &titled(desk, l)), whole, content, |ui| {
        if button(ui, l.text("lesson.begin"), true) {
            acts.push(Act::Learn(LearnAct::Guided(GuidedAct::BeginLesson)));
        }
        leave(state, desk, ui, acts);
    });
}

fn leave(state: &PanelContext, desk: &LessonDesk, ui: &mut Ui, acts: &mut Acts) {
    if !desk.is_locked() && button(ui, state.settings.language.text("lesson.leave"), false) {
        acts.push(Act::Learn(LearnAct::Guided(GuidedAct::Leave)));
    }
}

fn question(
    state: &PanelContext,
    lesson: &Lesson,
    place: usize,
    entries: &mut Entries,
    ui: &Ui,
    acts: &mut Acts,
    whole: Rect,
) {
    let l = state.settings.language;
    let predict = &lesson.scenario.predictions[place];
    let answer = std::cell::Cell::new(None);
    let content = |ui: &mut Ui| {
        let before = predict.text.of(l.code());
        if !before.is_empty() {
            ui.label(before);
        }
        ui.label(RichText::new(guided_words::question(predict.ask, l)).size(17.0).strong());
        answer.set(match predict.ask.range() {
            Some(range) => slider(state, ui, predict.ask, range, entries),
            None => classes(state, ui, lesson, entries),
        });
    };
    card(ui, ("question", l.text("lesson.foresee")), whole, content, |ui| {
        let given = answer.get();
        let response = ui.add_enabled(given.is_some(), theme::of(ui).button(l.text("lesson.answer"), given.is_some()));
        if let Some(value) = given.filter(|_| response.clicked()) {
            acts.push(Act::Learn(LearnAct::Guided(GuidedAct::Predict(value))));
        }
    });
}

/// A slider; there is no answer until it was moved. Returns the answer in the unit of the question.
fn slider(state: &PanelContext, ui: &mut Ui, ask: Ask, [low, high]: [f64; 2], entries: &mut Entries) -> Option<f64> {
    let settings = state.settings;
    let is_temperature = ask != Ask::UndersideBrown;
    let shown = |value: f64| if is_temperature { settings.degrees(value) } else { value };
    let unit = if is_temperature { format!(" {}", settings.unit()) } else { " %".to_owned() };
    let mut value = shown(entries.slider.unwrap_or(low));
    ui.spacing_mut().slider_width = (ui.available_width() - 110.0).max(120.0);
    let slider = Slider::new(&mut value, shown(low)..=shown(high)).step_by(1.0).max_decimals(0).suffix(&unit);
    let response = ui.add(slider);
    let name = guided_words::question(ask, settings.language);
    response.widget_info(|| egui::WidgetInfo::slider(true, value, &name));
    spoken_value(ui, &response, format!("{value:.0}{unit}"));
    if response.changed() {
        entries.slider = Some(if is_temperature { settings.celsius(value) } else { value });
    }
    entries.slider
}

fn classes(state: &PanelContext, ui: &mut Ui, lesson: &Lesson, entries: &mut Entries) -> Option<f64> {
    ui.horizontal_wrapped(|ui| {
        let scale = &lesson.scenario.goal.scale;
        for (place, class) in scale.class.iter().enumerate() {
            let on = entries.slider == Some(place as f64);
            let name = doneness_words::class(scale, &class.name, state.settings.language);
            if ui.add(theme::of(ui).button(name, on)).clicked() {
                entries.slider = Some(place as f64);
            }
        }
    });
    entries.slider
}

fn truth(state: &PanelContext, lesson: &Lesson, place: usize, ui: &Ui, acts: &mut Acts, whole: Rect) {
    let l = state.settings.language;
    let content = |ui: &mut Ui| {
        ui.label(guided_words::question(lesson.scenario.predictions[place].ask, l));
        ui.label(RichText::new(guided_words::truth(lesson, place, state.settings.speech())).size(17.0).strong());
    };
    card(ui, ("truth", l.text("lesson.foresee")), whole, content, |ui| {
        if button(ui, l.text("lesson.go_on"), true) {
            acts.push(Act::Learn(LearnAct::Guided(GuidedAct::GoOn)));
        }
    });
}

/// The food rests, and waiting for it is not necessary.
fn cooked_on(state: &PanelContext, desk: &LessonDesk, rest: &Rest, ui: &Ui, whole: Rect) {
    let l = state.settings.language;
    let content = |ui: &mut Ui| {
        ui.label(l.text("lesson.cooked_on"));
        let passed = saute_words::clock::clock(rest.lasted_s());
        ui.label(RichText::new(l.fill("lesson.cooked_on_s", &[("time", &passed)])).size(17.0).strong());
    };
    card(ui, ("cooked-on", desk.scenario().title.of(l.code())), whole, content, |_| {});
}

fn result(
    state: &PanelContext,
    desk: &LessonDesk,
    lesson: &Lesson,
    (_, measures): (&ResultRow, &Measures),
    ui: &Ui,
    acts: &mut Acts,
    whole: Rect,
) {
    let l = state.settings.language;
    let content = |ui: &mut Ui| {
        ui.label(RichText::new(guided_words::outcome(measures, state.settings.speech())).size(16.0));
        ui.add_space(4.0);
        foreseen(state, lesson, ui);
        if lesson.asked().iter().any(|asked| asked.answer.is_some() && asked.truth.is_none()) {
            ui.label(RichText::new(l.text("lesson.not_shown")).size(13.0).color(theme::of(ui).quiet));
        }
        ui.add_space(4.0);
        ui.label(RichText::new(l.text("lesson.hand_in")).size(13.0).color(theme::of(ui).quiet));
    };
    card(ui, ("result", &titled(desk, l)), whole, content, |ui| {
        for (key, act, first) in [
            ("lesson.save", GuidedAct::SaveResult, true),
            ("lesson.copy", GuidedAct::CopyResult, false),
            ("lesson.again", GuidedAct::AgainLesson, false),
        ] {
            if button(ui, l.text(key), first) {
                acts.push(Act::Learn(LearnAct::Guided(act)));
            }
        }
        leave(state, desk, ui, acts);
    });
}

/// What was foreseen next to what came.
fn foreseen(state: &PanelContext, lesson: &Lesson, ui: &mut Ui) {
    let l = state.settings.language;
    if lesson.asked().is_empty() {
        return;
    }
    Grid::new("foreseen").num_columns(3).spacing(egui::vec2(14.0, 4.0)).show(ui, |ui| {
        for head in ["lesson.question", "lesson.you_said", "lesson.it_was"] {
            ui.label(RichText::new(l.text(head)).size(12.5).color(theme::of(ui).quiet));
        }
        ui.end_row();
        for (asked, predict) in lesson.asked().iter().zip(&lesson.scenario.predictions) {
            ui.label(guided_words::short_question(predict.ask, l));
            for value in [asked.answer, asked.truth] {
                ui.label(guided_words::value(predict.ask, value, lesson, state.settings.speech()));
            }
            ui.end_row();
        }
    });
}
