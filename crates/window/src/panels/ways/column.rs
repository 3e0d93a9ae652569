//! One way among others: its name, how far it is, its cut and its readings round its pan.

use egui::{Align2, Rect, RichText, Sense, Stroke, StrokeKind, Ui, UiBuilder, vec2};
use saute_kitchen::celsius;

use super::{WaysMemory, within};
use crate::panels::curves::sample;
use crate::panels::ways::look::piece;
use crate::panels::ways::look::style;
use crate::ui::ways_layout::WayColumn;
use crate::ui::{fingers, theme};
use saute_controls::act::{Act, Acts, TimeAct, ViewAct};
use saute_controls::context::PanelContext;
use saute_controls::input::grab::ORBIT_PER_POINT;
use saute_controls::ways_state::WaysState;
use saute_session::timeline::{Stand, WayBeside};
use saute_words::clock::clock;
use saute_words::piece_words::doneness;

/// Height of the picture of the cut at most, as a share of its place [-] (chosen: a line of readings below it).
const CUT_SHARE: f32 = 0.7;
/// Height of the button over the pan [points], and of those beside the name.
const BUTTON: f32 = 30.0;
const SMALL_BUTTON: f32 = 22.0;

/// Shows a way in its column.
pub(super) fn show(
    state: &WaysState,
    way: &WayBeside,
    memory: &mut WaysMemory,
    ui: &mut Ui,
    acts: &mut Acts,
    column: &WayColumn,
) {
    let (palette, name) = (theme::of(ui), state.way_name(way));
    let is_live = way.place.is_none();
    let (words, buttons) = head_places(ui, column.head, way, memory);
    within(ui, words, &format!("way-{}", way.way.slot), |ui| head(state, way, memory, ui, name));
    if let Some(place) = buttons {
        within(ui, place, &format!("pages-{}", way.way.slot), |ui| {
            ui.horizontal(|ui| pages(state, way, memory, ui)).inner
        });
    }
    let edge = Stroke::new(if is_live { 3.0 } else { 1.5 }, palette.way(way.way.slot));
    ui.painter().rect_stroke(column.picture, 0.0, edge, StrokeKind::Outside);
    if let Some(place) = way.place {
        beside(state, place, ui, acts, column.picture, name);
    }
    within(ui, column.cut, &format!("cut-{}", way.way.slot), |ui| cut(state, way, memory, ui, name));
}

/// Where a way's words are, and beside them, for fingers, the buttons to other ways: those of a mouse are next to its name.
fn head_places(ui: &Ui, head: Rect, way: &WayBeside, memory: &WaysMemory) -> (Rect, Option<Rect>) {
    if !fingers::are_used(ui.ctx()) || way.place.is_none() || !memory.pages {
        return (head, None);
    }
    let width = 2.0 * theme::TOUCH + ui.spacing().item_spacing.x;
    let (words, buttons) = head.split_left_right_at_x(head.right() - width);
    (words, Some(buttons))
}

fn head(state: &WaysState, way: &WayBeside, memory: &mut WaysMemory, ui: &mut Ui, name: &str) {
    ui.spacing_mut().item_spacing = vec2(5.0, 1.0);
    (ui.spacing_mut().interact_size.y, ui.spacing_mut().button_padding.y) = (SMALL_BUTTON, 0.0);
    ui.horizontal(|ui| {
        sample(ui, theme::of(ui).way(way.way.slot), style(way.way.slot), 2.4);
        let is_all_shown = way.place.is_none() || !memory.pages || fingers::are_used(ui.ctx());
        let room = if is_all_shown { 0.0 } else { 2.0 * (SMALL_BUTTON + 5.0) };
        let size = vec2(ui.available_width() - room, SMALL_BUTTON);
        ui.allocate_ui_with_layout(size, egui::Layout::left_to_right(egui::Align::Center), |ui| {
            let text = RichText::new(name).size(15.0).strong();
            ui.add(egui::Label::new(text).truncate()).on_hover_text(name);
        });
        if !is_all_shown {
            pages(state, way, memory, ui);
        }
    });
    let (text, is_urgent) = stand(state, way);
    let colour = if is_urgent { theme::of(ui).accent } else { theme::of(ui).quiet };
    ui.add(egui::Label::new(RichText::new(&text).size(12.5).color(colour)).truncate()).on_hover_text(&text);
}

/// Buttons to the way before and after, where there is room for one next to the one that goes on.
fn pages(state: &WaysState, way: &WayBeside, memory: &mut WaysMemory, ui: &mut Ui) {
    let others: Vec<u64> = state.ways.iter().filter(|way| way.place.is_some()).map(|way| way.way.id).collect();
    let here = others.iter().position(|id| *id == way.way.id).unwrap_or(0);
    let l = state.settings.language;
    for (sign, key, by) in [("<", "ways.before", others.len() - 1), (">", "ways.after", 1)] {
        let side = fingers::height(ui, SMALL_BUTTON);
        let button = egui::Button::new(sign).min_size(vec2(side, side));
        let response = ui.add(button);
        response.widget_info(|| egui::WidgetInfo::labeled(egui::accesskit::Role::Button, true, l.text(key)));
        if response.clicked() {
            memory.other = others.get((here + by) % others.len()).copied();
        }
    }
}

/// How far a way is, and true if the words are in the accent.
fn stand(state: &PanelContext, way: &WayBeside) -> (String, bool) {
    let l = state.settings.language;
    let at = |key, time_s: f64| l.fill(key, &[("time", &clock(time_s))]);
    match way.stand {
        Stand::Live => (l.text("ways.live").to_owned(), true),
        Stand::Same(until_s) => (at("ways.same", until_s), false),
        Stand::Here => (at("ways.here", state.session.shown_s()), false),
        Stand::CatchingUp(at_s) => (at("ways.catching_up", at_s), true),
        Stand::Ended(at_s) => (at("ways.ended", at_s), false),
    }
}

/// The pan of a way next to the one that goes on: it is turned as that one is; a button goes over to it.
fn beside(state: &PanelContext, place: usize, ui: &mut Ui, acts: &mut Acts, picture: Rect, name: &str) {
    let l = state.settings.language;
    let response = ui.interact(picture, ui.scope_id().with(("way-pan", place)), Sense::drag());
    response.widget_info(|| {
        egui::WidgetInfo::labeled(egui::accesskit::Role::Image, true, l.fill("ways.spoken", &[("way", &name)]))
    });
    if response.dragged() {
        let delta = response.drag_delta();
        acts.push(Act::View(ViewAct::Orbit(-ORBIT_PER_POINT * delta.x, ORBIT_PER_POINT * delta.y)));
    }
    let text = RichText::new(l.text("ways.go")).size(13.0);
    let height = fingers::height(ui, BUTTON);
    let button = egui::Button::new(text).fill(theme::of(ui).ground).min_size(vec2(0.0, height));
    let corner = Align2::RIGHT_BOTTOM.align_size_within_rect(vec2(picture.width(), height), picture.shrink(4.0));
    let mut child = ui.new_child(
        UiBuilder::new()
            .max_rect(corner)
            .layout(egui::Layout::right_to_left(egui::Align::Center))
            .id_salt(("go", place)),
    );
    if child.add(button).on_hover_text(l.text("ways.go_hint")).clicked() {
        acts.push(Act::Time(TimeAct::Branch(place)));
    }
}

fn cut(state: &WaysState, way: &WayBeside, memory: &mut WaysMemory, ui: &mut Ui, name: &str) {
    let l = state.settings.language;
    let Some(piece) = piece(state, way) else {
        ui.label(RichText::new(l.text("inside.no_food")).size(12.5));
        return;
    };
    let picture = memory.cuts.entry(way.way.id).or_default();
    picture.refresh(state, piece, state.cut_at, ui);
    let room = vec2(ui.available_width(), CUT_SHARE * ui.available_height());
    let (rect, _) = ui.allocate_exact_size(room, Sense::hover());
    ui.spacing_mut().item_spacing.y = 1.0;
    if let Some(texture) = picture.texture() {
        let size = texture.size_vec2();
        let size = size * (room.x / size.x).min((room.y - 10.0) / size.y);
        let alt = l.fill("ways.cut", &[("way", &name)]);
        let image = egui::Image::new((texture.id(), size)).corner_radius(4).alt_text(alt);
        ui.put(Rect::from_center_size(rect.center() + vec2(0.0, 3.0), size), image);
    }
    let core = l.fill("piece.core", &[("core", &state.settings.temperature(celsius(piece.core())))]);
    let text = format!("{core} · {}", doneness(state.scale_of(piece).as_deref(), piece, l));
    ui.add(egui::Label::new(RichText::new(&text).size(13.0)).truncate()).on_hover_text(&text);
}
