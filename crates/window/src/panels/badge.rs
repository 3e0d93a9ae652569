//! Short messages over the scene: a machine too slow, and the last notice.

use egui::{Align2, Area, FontId, Id, RichText, Ui};
use saute_kitchen::food::Rules;
use saute_picture::view::View;

use crate::panels::host_panels;
use crate::panels::legend;
use crate::ui::layout::{GAP, Layout};
use crate::ui::theme;
use saute_controls::act::{Act, Acts, AppAct};
use saute_controls::context::PanelContext;
use saute_controls::spoken::notice::Said;
use saute_words::clock::clock;

/// Height of the ribbon with its space [points].
const RIBBON: f32 = 66.0;
/// Height of the legend with its space, and of the line about simplified rules [points].
const LEGEND: f32 = 70.0;
const RULES: f32 = 26.0;
/// Name of the message about food that is being set out: it has a button.
const BUILDING: &str = "building";
/// How far below the other messages a notice is alone in a wide window [points].
const NOTICE: f32 = 40.0;

/// Shows the badges where there is something to show: the last notice, and what waits until the instant is reached to which time is
/// turned.
pub fn show(
    state: &PanelContext,
    notice: Option<&Said>,
    waiting: &[String],
    ui: &Ui,
    acts: &mut Acts,
    layout: &Layout,
) {
    standing(state, ui, acts, layout);
    let held: Vec<(&str, String)> = [
        ("behind", behind(state)),
        ("waiting", waits(state, waiting)),
        (BUILDING, state.session.building().map(|[built, all]| building(state, built, all))),
    ]
    .into_iter()
    .filter_map(|(name, text)| Some((name, text?)))
    .collect();
    // Each begins where the one before it ends, however many lines that has.
    let mut drop = 12.0 + clear_of(state, layout);
    for (name, text) in &held {
        let stops = *name == BUILDING;
        let stop = |ui: &mut Ui| {
            if stops && ui.button(state.settings.language.text("waiting.stop")).clicked() {
                acts.push(Act::App(AppAct::Close));
            }
        };
        drop += GAP + message(ui, layout, (name, drop), stops, text, stop);
    }
    if let Some(said) = notice {
        // A click on its button must reach it; through all others it reaches the scene.
        let has_button = host_panels::has_button(said);
        // In a wide window it is clear of what comes and goes above it; over the food of a narrow one there is little room.
        let drop = if layout.narrow || !held.is_empty() { drop } else { drop + NOTICE };
        message(ui, layout, ("notice", drop), has_button, &said.text, |ui| {
            host_panels::file_button(state, ui, acts, said);
        });
    }
}

/// How far the clock is behind the chosen speed.
fn behind(state: &PanelContext) -> Option<String> {
    let behind_s = state.session.behind_s()?;
    let [speed, seconds] = [state.session.speed, behind_s].map(|value| format!("{value:.0}"));
    Some(state.settings.language.fill("scene.behind", &[("speed", &speed), ("seconds", &seconds)]))
}

/// What waits until an instant is reached.
fn waits(state: &PanelContext, waiting: &[String]) -> Option<String> {
    let l = state.settings.language;
    let (what, time) = (waiting.join(l.text("doneness.list_joint")), clock(state.session.bound_for_s()));
    (!waiting.is_empty()).then(|| l.fill("waiting.until", &[("what", &what), ("time", &time)]))
}

/// How many foods are there of those that are set out as soon as all are.
fn building(state: &PanelContext, built: usize, all: usize) -> String {
    state.settings.language.fill("waiting.building", &[("built", &built), ("all", &all)])
}

/// Height of what is at the edge from which messages begin: the ribbon of a study or a lesson, on a narrow window the legend.
fn clear_of(state: &PanelContext, layout: &Layout) -> f32 {
    match (state.guided.is_some(), layout.narrow && says_what_holds(state)) {
        (true, _) => RIBBON,
        (false, true) => LEGEND,
        (false, false) => 0.0,
    }
}

/// What applies all the time: the legend of the view, and simplified rules.
fn standing(state: &PanelContext, ui: &Ui, acts: &mut Acts, layout: &Layout) {
    if layout.ways.is_some() || !says_what_holds(state) {
        return;
    }
    let pane = layout.field_pane(state.settings.is_split());
    let at = pane.free.left_bottom() + egui::vec2(GAP, -GAP);
    let eye = if layout.narrow { layout.free.right() } else { layout.eye.left() };
    let width = pane.free.right().min(eye) - at.x - 2.0 * GAP - 16.0;
    let area = Area::new(Id::unique("standing")).fixed_pos(at).pivot(Align2::LEFT_BOTTOM);
    area.show(ui.ctx(), |ui| {
        theme::of(ui).panel().inner_margin(8).show(ui, |ui| what_holds(state, ui, acts, width));
    });
}

/// Height of what applies all the time, with its space, in a wide window [points]; 0 where there is nothing to say.
pub(crate) fn held_height(state: &PanelContext) -> f32 {
    let rules = state.session.kitchen.rules() == Rules::Paper2013;
    let view = state.settings.view != View::Look;
    (if view { LEGEND } else { 0.0 }) + (if rules { RULES } else { 0.0 }) + if view || rules { GAP } else { 0.0 }
}

fn says_what_holds(state: &PanelContext) -> bool {
    held_height(state) > 0.0
}

/// The legend of the view, and whether rules are simplified, at most `width` points wide.
pub fn what_holds(state: &PanelContext, ui: &mut Ui, acts: &mut Acts, width: f32) {
    legend::show(state, ui, acts, width);
    if state.session.kitchen.rules() == Rules::Paper2013 {
        let text = RichText::new(state.settings.language.text("scene.rules_2013"));
        ui.label(text.size(15.0).strong());
    }
}

/// Where a message is that is so far from the edge of the scene, and which point of it: below the upper edge, on a narrow window above
/// the drawer, where no food lies.
fn place(layout: &Layout, drop: f32) -> (egui::Pos2, Align2) {
    let below = |drop: f32| egui::vec2(0.0, drop);
    match &layout.ways {
        // It covers no pan: it is over the views, or over the curves.
        Some(ways) if layout.narrow => (ways.ground.center_top() - below(drop), Align2::CENTER_BOTTOM),
        Some(ways) => (ways.ground.center_bottom() - below(drop), Align2::CENTER_BOTTOM),
        None if layout.narrow && layout.free.bottom() < layout.whole.bottom() => {
            (layout.free.center_bottom() - below(drop), Align2::CENTER_BOTTOM)
        }
        None => (layout.free.center_top() + below(drop), Align2::CENTER_TOP),
    }
}

/// Shows a message; returns its height [points].
fn message(
    ui: &Ui,
    layout: &Layout,
    (name, drop): (&str, f32),
    clicked: bool,
    text: &str,
    beside: impl FnOnce(&mut Ui),
) -> f32 {
    let (at, pivot) = place(layout, drop);
    let area = Area::new(Id::unique(("message", name))).fixed_pos(at).pivot(pivot);
    let shown = area.interactable(clicked).show(ui.ctx(), |ui| {
        theme::of(ui).panel().show(ui, |ui| {
            ui.set_max_width(layout.free.width() - 40.0);
            ui.horizontal_wrapped(|ui| {
                ui.label(RichText::new(text).font(FontId::proportional(14.5)));
                beside(ui);
            });
        });
    });
    shown.response.rect.height()
}
