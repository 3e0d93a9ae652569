//! View chips and the switches of the picture.

use egui::Ui;
use saute_picture::view::View;

use crate::bindings::hint;
use crate::panels::cook::speaker_switch;
use crate::panels::now::control_place;
use crate::ui::{fingers, theme};
use saute_controls::act::{Act, Acts, AppAct, Card, ViewAct};
use saute_controls::context::PanelContext;
use saute_controls::reads_context;
use saute_controls::spoken::view_words::ViewWords;
use saute_session::permits::Permit;

/// Height of a chip [points]: two rows of them fit above a narrow scene.
const HEIGHT: f32 = 34.0;
/// Room that the menu of what there is to learn needs [points].
const LEARN: f32 = 64.0;
/// Room that the way to a plan needs [points].
const PLAN: f32 = 56.0;
/// Width of the speech bubble [points].
const BUBBLE: f32 = 36.0;

/// What the chips read.
pub struct TopState<'a> {
    /// What every panel reads.
    pub context: PanelContext<'a>,
    /// The card that is open.
    pub card: Option<Card>,
    /// True while the food is shown cut.
    pub is_cut: bool,
}

reads_context!(TopState);

/// Shows the chips of the views, the switches of cut and split, and what is at the right.
pub fn show(state: &TopState, ui: &mut Ui, acts: &mut Acts, narrow: bool) {
    if narrow {
        ui.horizontal_wrapped(|ui| {
            views(state, ui, acts, 6.0);
            speaker_switch::show(state, ui, acts, HEIGHT);
        });
        return;
    }
    ui.horizontal_centered(|ui| {
        views(state, ui, acts, 5.0);
        help_and_settings(state, ui, acts);
    });
}

/// Shows the ways to all controls and to a plan, the settings and the help: what a first cook has on top.
pub fn few(state: &TopState, ui: &mut Ui, acts: &mut Acts) {
    ui.with_layout(egui::Layout::right_to_left(egui::Align::Center), |ui| {
        help(state, ui, acts);
        gear(state, ui, acts);
        speaker_switch::show(state, ui, acts, HEIGHT);
        messages(state, ui, acts);
        chip(state, ui, acts, state.settings.language.text("top.all"), false, Act::View(ViewAct::More));
        if ui.available_width() >= PLAN {
            plan(state, ui, acts);
        }
    });
}

/// Shows what there is to learn, the help among it, the settings and, where there is room, the notices, from the right.
pub fn learn_and_settings(state: &TopState, ui: &mut Ui, acts: &mut Acts) {
    ui.with_layout(egui::Layout::right_to_left(egui::Align::Center), |ui| {
        // A study leads: what there is to learn is locked, the help is not.
        if !state.permits().allow(&[Permit::Leaving]) {
            help(state, ui, acts);
        } else {
            learn(state, ui, acts);
        }
        gear(state, ui, acts);
        if ui.available_width() >= BUBBLE {
            messages(state, ui, acts);
        }
    });
}

fn learn(state: &TopState, ui: &mut Ui, acts: &mut Acts) {
    let name = state.settings.language.text("learn.title");
    chip(state, ui, acts, name, state.card == Some(Card::Learn), Act::App(AppAct::Open(Card::Learn)));
}

fn plan(state: &TopState, ui: &mut Ui, acts: &mut Acts) {
    let name = state.settings.language.text("top.plan");
    chip(state, ui, acts, name, state.card == Some(Card::Plan), Act::App(AppAct::Open(Card::Plan)));
}

fn files(state: &TopState, ui: &mut Ui, acts: &mut Acts) {
    let name = state.settings.language.text("top.files");
    chip(state, ui, acts, name, state.card == Some(Card::Files), Act::App(AppAct::Open(Card::Files)));
}

fn help(state: &TopState, ui: &mut Ui, acts: &mut Acts) {
    chip(state, ui, acts, "?", state.card == Some(Card::Help), Act::App(AppAct::Help));
}

fn views(state: &TopState, ui: &mut Ui, acts: &mut Acts, padding: f32) {
    ui.spacing_mut().item_spacing = egui::vec2(4.0, 5.0);
    ui.spacing_mut().button_padding.x = padding;
    let l = state.settings.language;
    let temperature = Act::View(ViewAct::View(View::Temperature));
    if state.hides(&temperature) {
        // One view is no choice.
        return;
    }
    for view in View::ALL {
        chip(state, ui, acts, view.name(l), state.settings.view == view, Act::View(ViewAct::View(view)));
    }
    chip(state, ui, acts, l.text("top.cut"), state.is_cut, Act::View(ViewAct::Slice));
    chip(state, ui, acts, l.text("top.split"), state.settings.is_split(), Act::View(ViewAct::Split));
}

/// Shows the help, the settings and, where there is room, the switches of the panels at the left, from the right.
fn help_and_settings(state: &TopState, ui: &mut Ui, acts: &mut Acts) {
    let l = state.settings.language;
    ui.with_layout(egui::Layout::right_to_left(egui::Align::Center), |ui| {
        help(state, ui, acts);
        gear(state, ui, acts);
        speaker_switch::show(state, ui, acts, HEIGHT);
        if ui.available_width() >= LEARN {
            learn(state, ui, acts);
        }
        if ui.available_width() >= PLAN {
            plan(state, ui, acts);
        }
        if ui.available_width() >= PLAN {
            files(state, ui, acts);
        }
        if ui.available_width() >= BUBBLE {
            messages(state, ui, acts);
        }
        if ui.available_width() > 90.0 {
            let food = l.fill("top.more", &[("what", &l.text("top.food"))]);
            chip(state, ui, acts, &food, state.settings.pantry_open, Act::View(ViewAct::Pantry));
        }
        if ui.available_width() > 76.0 {
            chip(state, ui, acts, l.text("top.pieces"), state.settings.pieces_open, Act::View(ViewAct::Pieces));
        }
    });
}

/// A button with a drawing, which needs no language, in place of words.
struct Drawn {
    /// Key of its name for screen readers.
    name: &'static str,
    width: f32,
    is_on: bool,
    act: Act,
    paint: fn(&egui::Painter, egui::Pos2, egui::Color32),
}

impl Drawn {
    fn show(self, state: &PanelContext, ui: &mut Ui, acts: &mut Acts) {
        let l = state.settings.language;
        let palette = theme::of(ui);
        let size = egui::vec2(self.width, fingers::height(ui, HEIGHT));
        let response = ui.add(palette.button("", self.is_on).min_size(size));
        let name = l.text(self.name);
        response.widget_info(|| egui::WidgetInfo::labeled(egui::accesskit::Role::Button, true, name));
        let ink = if self.is_on { palette.on_chosen } else { palette.text };
        (self.paint)(ui.painter(), response.rect.center(), ink);
        if response.on_hover_text(hint(&self.act, l)).clicked() {
            acts.push(self.act);
        }
    }
}

/// A speech bubble: the list of notices.
fn messages(state: &TopState, ui: &mut Ui, acts: &mut Acts) {
    let act = Act::App(AppAct::Messages);
    Drawn {
        name: "messages.title",
        width: BUBBLE,
        is_on: state.card == Some(Card::Messages),
        act,
        paint: paint_bubble,
    }
    .show(state, ui, acts);
}

/// A rounded box with three dots and a tail.
fn paint_bubble(painter: &egui::Painter, at: egui::Pos2, ink: egui::Color32) {
    let body = egui::Rect::from_center_size(at - egui::vec2(0.0, 1.5), egui::vec2(18.0, 12.0));
    painter.rect_stroke(body, 4.0, egui::Stroke::new(1.8, ink), egui::StrokeKind::Middle);
    let tail = [at + egui::vec2(-4.0, 4.5), at + egui::vec2(-5.0, 9.0), at + egui::vec2(1.0, 4.5)];
    painter.add(egui::Shape::convex_polygon(tail.to_vec(), ink, egui::Stroke::NONE));
    for x in [-4.5, 0.0, 4.5] {
        painter.circle_filled(body.center() + egui::vec2(x, 0.0), 1.3, ink);
    }
}

/// A gear: the settings.
fn gear(state: &TopState, ui: &mut Ui, acts: &mut Acts) {
    let act = Act::App(AppAct::Settings);
    Drawn { name: "settings.title", width: 38.0, is_on: state.card == Some(Card::Settings), act, paint: paint_gear }
        .show(state, ui, acts);
}

/// Eight teeth round a ring.
fn paint_gear(painter: &egui::Painter, at: egui::Pos2, ink: egui::Color32) {
    painter.circle_stroke(at, 5.5, egui::Stroke::new(2.6, ink));
    for tooth in 0..8u8 {
        let along = egui::Vec2::angled(std::f32::consts::TAU * f32::from(tooth) / 8.0);
        painter.line_segment([at + 6.0 * along, at + 9.0 * along], egui::Stroke::new(2.6, ink));
    }
}

fn chip(state: &PanelContext, ui: &mut Ui, acts: &mut Acts, text: &str, on: bool, act: Act) {
    if state.hides(&act) {
        return;
    }
    let size = egui::vec2(38.0, fingers::height(ui, HEIGHT));
    let palette = theme::of(ui);
    let words = egui::RichText::new(text).size(15.0).strikethrough().color(palette.quiet);
    // What skill mode hides can still be clicked: it states why it is off.
    let button = if is_off(state, &act) { egui::Button::new(words) } else { palette.button(text, on) };
    let response = ui.add_enabled(!state.forbids(&act), button.min_size(size));
    control_place::note(ui, &act, response.rect);
    let response = response.on_hover_text(explained(state, &act));
    if response.clicked() {
        acts.push(act);
    }
}

/// True of a view that skill mode hides.
fn is_off(state: &PanelContext, act: &Act) -> bool {
    act.traits().reads && !state.reads_out()
}

/// What a chip does and its key; of a view also what its colours mean.
fn explained(state: &PanelContext, act: &Act) -> String {
    let hint = hint(act, state.settings.language);
    match act {
        Act::View(ViewAct::View(_)) | Act::View(ViewAct::Slice) | Act::View(ViewAct::Split) if is_off(state, act) => {
            state.settings.language.text("skill.off").to_owned()
        }
        Act::View(ViewAct::View(view)) => format!("{hint}\n{}", view.meaning(state.settings.speech())),
        Act::App(AppAct::Open(Card::Learn)) => state.settings.language.text("learn.hint").to_owned(),
        _ => hint,
    }
}
