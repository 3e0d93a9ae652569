//! The panels around the scene.

pub mod ahead;
pub mod alarm;
pub mod at_home;
pub mod badge;
pub mod cards;
pub mod cook;
pub mod curve;
pub mod curves;
pub mod cut_picture;
pub mod doneness_bar;
pub mod eye_bar;
pub mod guided;
pub(crate) mod here;
pub mod inside;
pub mod learn;
pub mod legend;
pub mod memory;
pub mod now;
pub mod pantry;
pub mod pieces;
pub mod plan;
pub mod probes;
pub mod read_out;
pub mod section_read;
pub mod still;
pub mod top;
pub mod ways;
pub mod window_state;

use egui::{Rect, ScrollArea, Ui, UiBuilder};

use crate::act::{Acts, Card};
use crate::paint::ground::GroundCallback;
use crate::panels::cards::{first_steps, goals, help, learn as learn_card, lessons, messages, result, unfinished};
use crate::panels::cook::{few_controls, hob_bar, pour, time_strip};
use crate::panels::memory::{Drawer, PanelMemory};
use crate::panels::window_state::WindowState;
use crate::system::IS_PAGE;
use crate::ui::aloud::name_panel;
use crate::ui::layout::{GAP, Layout};
use crate::ui::{fingers, theme};

/// Space within a panel of controls for a mouse, and within one for fingers [points].
const MARGIN: i8 = 6;
const WIDE_MARGIN: i8 = 12;

/// Height of the strip of time in the drawer [points].
const STRIP_HEIGHT: f32 = 28.0;

/// Shows all panels, what is said over the scene, and the card that is open.
pub fn show_all(state: &WindowState, memory: &mut PanelMemory, ui: &mut Ui, acts: &mut Acts, layout: &Layout) {
    if here::show_instead(state, ui, acts, layout) {
        return here::devices(state, ui, acts, layout);
    }
    if let Some(ways) = &layout.ways {
        ways::show(state, &mut memory.ways, ui, acts, (layout.whole, ways));
    }
    if !state.settings.hides_panels() {
        show(state, memory, ui, acts, layout);
    }
    let whole = layout.whole;
    if state.reads_out() {
        read_out::show(state, ui, whole);
    }
    // What is due at the goal, and what a plan says, is said with the panels hidden, too; to a class all of it is.
    if !state.settings.panels_hidden || state.alarm || state.is_led() {
        now::show(state, &mut memory.now, ui, acts, layout);
    }
    badge::show(state, ui, acts, layout);
    alarm::show(state, ui, acts, whole);
    here::devices(state, ui, acts, layout);
    if guided::show(state, &mut memory.answers, ui, acts, layout) {
        return;
    }
    if let Some(time_s) = state.unfinished_s {
        return unfinished::show(state, time_s, ui, acts, whole);
    }
    match state.card {
        None => {}
        Some(Card::Help) => help::show(state, &mut memory.search, ui, acts, whole),
        Some(Card::Messages) => messages::show(state, ui, acts, whole),
        Some(Card::Settings) => cards::settings::show(state, &mut memory.here, ui, acts, whole),
        Some(Card::Mirror) => cards::mirror::show(state, ui, acts, whole),
        Some(Card::FirstSteps) => first_steps::show(state, ui, acts, whole),
        Some(Card::Learn) => learn_card::show(state, ui, acts, whole),
        Some(Card::Lessons) => lessons::show(state, ui, acts, whole),
        Some(Card::Goals) => goals::show(state, ui, acts, whole),
        Some(Card::Result) => result::show(state, &mut memory.result, ui, acts, whole),
        Some(Card::Plan) => plan::card::show(state, ui, acts, whole),
        Some(Card::AtHome) => at_home::card::show(state, ui, acts, whole),
    }
}

/// Shows all panels.
fn show(state: &WindowState, memory: &mut PanelMemory, ui: &mut Ui, acts: &mut Acts, layout: &Layout) {
    if layout.eye.is_positive() {
        eye_bar::show(state, ui, acts, layout.eye);
    }
    let (margin, l) = (if layout.narrow { WIDE_MARGIN } else { MARGIN }, state.settings.language);
    floating(ui, layout.top, (0, margin), ("views", l.text("panel.views")), |ui| match state.settings.few {
        true => top::few(state, ui, acts),
        false => top::show(state, ui, acts, layout.narrow),
    });
    if layout.narrow {
        floating(ui, layout.bottom, (1, WIDE_MARGIN), ("drawer", l.text("panel.cook")), |ui| {
            match state.settings.few {
                true => few_drawer(state, memory, ui, acts),
                false => drawer(state, memory, ui, acts),
            }
        });
        return;
    }
    if state.settings.few {
        return floating(ui, layout.bottom, (3, WIDE_MARGIN), ("cook", l.text("panel.cook")), |ui| {
            few_controls::row(state, ui, acts)
        });
    }
    if layout.right.is_positive() {
        floating(ui, layout.right, (2, 10), ("inside", l.text("panel.inside")), |ui| {
            scrolled(ui, |ui| inside::show(state, &mut memory.inside, ui, acts))
        });
    }
    floating(ui, layout.bottom, (3, MARGIN), ("cook", l.text("panel.cook")), |ui| {
        hob_bar::show(state, ui, acts, false)
    });
    turner_strip(state, ui, acts, layout);
    let Some(left) = layout.left else { return };
    floating(ui, left, (4, WIDE_MARGIN), ("left", l.text("panel.food")), |ui| {
        scrolled(ui, |ui| {
            if state.settings.pieces_open {
                pieces::show(state, &mut memory.unfolded, ui, acts);
            } else {
                pantry::show(state, &mut memory.pantry, ui, acts);
            }
        });
    });
}

/// What moves the turner, over the scene: no row of the panels jumps when it is taken.
fn turner_strip(state: &WindowState, ui: &Ui, acts: &mut Acts, layout: &Layout) {
    if !state.turner_in_hand {
        return;
    }
    let at = layout.eye.left_bottom() - egui::vec2(GAP, 0.0);
    let area = egui::Area::new(egui::Id::unique("turner")).fixed_pos(at).pivot(egui::Align2::RIGHT_BOTTOM);
    area.show(ui.ctx(), |ui| {
        theme::of(ui).panel().inner_margin(MARGIN).show(ui, |ui| ui.horizontal(|ui| pour::turner(state, ui, acts)));
    });
}

/// The drawer of a first cook: what to do now, and the few controls.
fn few_drawer(state: &WindowState, memory: &mut PanelMemory, ui: &mut Ui, acts: &mut Acts) {
    now::in_drawer(state, &mut memory.now, ui, acts);
    ui.add_space(6.0);
    scrolled(ui, |ui| few_controls::rows(state, ui, acts));
}

fn drawer(state: &WindowState, memory: &mut PanelMemory, ui: &mut Ui, acts: &mut Acts) {
    ui.horizontal(|ui| {
        // Narrow enough for all of them and what there is to learn, in one row of a phone.
        (ui.spacing_mut().item_spacing.x, ui.spacing_mut().button_padding.x) = (4.0, 5.0);
        for part in Drawer::ALL.into_iter().filter(|part| part.is_offered(state)) {
            if ui.add(theme::of(ui).button(part.name(state), memory.drawer == part)).clicked() {
                memory.drawer = part;
            }
        }
        top::learn_and_settings(state, ui, acts);
    });
    ui.horizontal(|ui| {
        (ui.spacing_mut().item_spacing.x, ui.spacing_mut().button_padding.x) = (5.0, 7.0);
        let height = fingers::height(ui, STRIP_HEIGHT);
        ui.spacing_mut().interact_size.y = height;
        time_strip::undo_and_redo(state, ui, acts);
        time_strip::branches(state, ui, acts);
        let width = ui.available_width();
        time_strip::show(state, ui, acts, egui::vec2(width, height));
    });
    now::in_drawer(state, &mut memory.now, ui, acts);
    ui.add_space(6.0);
    let part = if memory.drawer.is_offered(state) { memory.drawer } else { Drawer::Cook };
    scrolled(ui, |ui| match part {
        Drawer::Cook => hob_bar::show(state, ui, acts, true),
        Drawer::Inside => {
            ways::curves_in_drawer(state, &mut memory.ways, ui);
            inside::show(state, &mut memory.inside, ui, acts);
        }
        Drawer::Food => pantry::show(state, &mut memory.pantry, ui, acts),
        Drawer::Pieces if !state.reads_out() => inside::show(state, &mut memory.inside, ui, acts),
        Drawer::Pieces => pieces::show(state, &mut memory.unfolded, ui, acts),
    });
}

/// A panel at a fixed place; it takes the mouse so that the scene below does not.
fn floating(
    ui: &mut Ui,
    rect: Rect,
    (index, margin): (u32, i8),
    (name, spoken): (&str, &str),
    content: impl FnOnce(&mut Ui),
) {
    ui.interact(rect, ui.scope_id().with(("ground", name)), egui::Sense::click_and_drag());
    let points = ui.ctx().pixels_per_point();
    let ground = GroundCallback {
        index,
        colour: theme::of(ui).ground.to_normalized_gamma_f32(),
        size: [rect.width() * points, rect.height() * points],
        radius: f32::from(theme::CORNER) * points,
    };
    ui.painter().add(egui_wgpu::Callback::new_paint_callback(rect, ground));
    let mut child = ui.new_child(UiBuilder::new().id_salt(name).max_rect(rect));
    theme::of(ui).panel().fill(egui::Color32::TRANSPARENT).inner_margin(margin).show(&mut child, |ui| {
        let inner = ui.available_size();
        ui.set_min_size(inner);
        ui.set_max_size(inner);
        ui.set_clip_rect(rect);
        content(ui);
    });
    if IS_PAGE {
        name_panel(&child, spoken);
    }
}

fn scrolled(ui: &mut Ui, content: impl FnOnce(&mut Ui)) {
    ScrollArea::vertical().auto_shrink([false, false]).show(ui, content);
}
