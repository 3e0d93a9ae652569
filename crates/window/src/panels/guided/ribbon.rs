//! The ribbon over the scene: where one is in a study or a lesson, the goal, and the way out of a lesson. What ends it is a button of the
//! Now line.

use egui::{Align2, Area, Id, RichText, Ui, vec2};
use saute_study::Stage;

use crate::ui::layout::{GAP, Layout};
use crate::ui::theme;
use saute_controls::act::GuidedAct;
use saute_controls::act::{Act, Acts, LearnAct};
use saute_controls::context::PanelContext;
use saute_session::guided::{LessonDesk, StudyDesk};
use saute_words::language::Language;

/// Names phase and trial; it never states which condition applies.
pub(super) fn of_study(state: &PanelContext, desk: &StudyDesk, ui: &Ui, layout: &Layout) {
    let Some(simulate) = desk.study().simulate() else { return };
    let Stage::Trial { phase, trial } = desk.study().stage() else { return };
    let l = state.settings.language;
    let title = &desk.study().protocol().phases[phase].title;
    let at: [(&str, &dyn std::fmt::Display); 2] = [("trial", &trial), ("trials", &simulate.trials)];
    let where_ = format!("{title} · {}", l.fill("study.trial", &at));
    let goal = l.named("goal", &simulate.goal.goal.name, &simulate.goal.goal.names).to_owned();
    ribbon(ui, layout, (&where_, &goal), |_| {});
}

/// Names the lesson and its goal, and leaves it where that is allowed.
pub(super) fn of_lesson(state: &PanelContext, desk: &LessonDesk, ui: &Ui, acts: &mut Acts, layout: &Layout) {
    if !desk.has_begun() || desk.rest().is_some() || desk.result().is_some() {
        return;
    }
    let l = state.settings.language;
    let title = titled(desk, l);
    let goal = l.named("goal", &desk.scenario().goal.goal.name, &desk.scenario().goal.goal.names).to_owned();
    ribbon(ui, layout, (&title, &goal), |ui| {
        let leave = theme::of(ui).button(l.text("lesson.leave_short"), false);
        if !desk.is_locked() && ui.add(leave).on_hover_text(l.text("lesson.leave")).clicked() {
            acts.push(Act::Learn(LearnAct::Guided(GuidedAct::Leave)));
        }
    });
}

/// Title of the lesson, with the code of the student.
pub(super) fn titled(desk: &LessonDesk, l: Language) -> String {
    let title = desk.scenario().title.of(l.code());
    desk.start().student.as_ref().map_or(title.to_owned(), |student| format!("{title} · {}", student.code()))
}

fn ribbon(ui: &Ui, layout: &Layout, (first, second): (&str, &str), buttons: impl FnOnce(&mut Ui)) {
    // On a narrow window the upper edge belongs to the views of the eye.
    let (at, pivot) = if layout.narrow {
        (layout.free.center_bottom() - vec2(0.0, GAP), Align2::CENTER_BOTTOM)
    } else {
        (layout.free.center_top() + vec2(0.0, 0.4 * layout.top.height() + GAP), Align2::CENTER_TOP)
    };
    Area::new(Id::unique("ribbon")).fixed_pos(at).pivot(pivot).show(ui.ctx(), |ui| {
        theme::of(ui).panel().inner_margin(8).show(ui, |ui| {
            ui.horizontal(|ui| {
                ui.vertical(|ui| {
                    ui.spacing_mut().item_spacing.y = 1.0;
                    ui.set_max_width((layout.free.width() - 230.0).max(140.0));
                    ui.label(RichText::new(first).size(14.5).strong());
                    ui.label(RichText::new(second).size(12.5).color(theme::of(ui).quiet));
                });
                buttons(ui);
            });
        });
    });
}
