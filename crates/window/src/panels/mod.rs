//! The panels around the scene.

pub mod badge;
pub mod curves;
pub mod doneness_bar;
pub mod first_steps;
pub mod help;
pub mod hob_bar;
pub mod inside;
pub mod language;
pub mod legend;
pub mod mirror_card;
pub mod pantry;
pub mod pieces;
pub mod pour;
pub mod probes;
pub mod read_out;
pub mod settings_card;
pub mod top;
pub mod window_state;

use egui::{Rect, ScrollArea, Ui, UiBuilder};

use crate::act::Acts;
use crate::paint::ground::GroundCallback;
use crate::panels::window_state::{PanelMemory, WindowState};
use crate::ui::layout::Layout;
use crate::ui::theme;

/// Which part of the drawer is open on a narrow window.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Drawer {
    /// Hob, hands, time.
    #[default]
    Cook,
    /// What is inside.
    Inside,
    /// Food and pan.
    Food,
    /// List of the pieces.
    Pieces,
}

impl Drawer {
    const ALL: [Self; 4] = [Self::Cook, Self::Inside, Self::Food, Self::Pieces];

    fn name(self, state: &WindowState) -> &'static str {
        match self {
            Self::Cook => state.settings.language.text("drawer.cook"),
            Self::Inside => state.settings.language.text("drawer.inside"),
            Self::Food => top::food_word(state),
            Self::Pieces => state.settings.language.text("top.pieces"),
        }
    }
}

/// Shows all panels, what is said over the scene, and the card that is open.
pub fn show_all(state: &WindowState, memory: &mut PanelMemory, ui: &mut Ui, acts: &mut Acts, layout: &Layout) {
    if !state.settings.panels_hidden {
        show(state, memory, ui, acts, layout);
    }
    let whole = layout.whole;
    read_out::show(state, ui, whole);
    badge::show(state, ui, acts, layout);
    #[cfg(not(target_arch = "wasm32"))]
    crate::hand::show(state, ui, acts, layout);
    if state.help {
        help::show(state, ui, acts, whole);
    } else if state.settings_open {
        settings_card::show(state, memory, ui, acts, whole);
    } else if state.mirror.card {
        mirror_card::show(state, ui, acts, whole);
    } else if state.first_steps {
        first_steps::show(state, ui, acts, whole);
    }
}

/// Shows all panels.
fn show(state: &WindowState, memory: &mut PanelMemory, ui: &mut Ui, acts: &mut Acts, layout: &Layout) {
    floating(ui, layout.top, 0, "views", |ui| top::show(state, ui, acts, layout.narrow));
    if layout.narrow {
        floating(ui, layout.bottom, 1, "drawer", |ui| drawer(state, memory, ui, acts));
        return;
    }
    floating(ui, layout.right, 2, "inside", |ui| scrolled(ui, |ui| inside::show(state, &mut memory.inside, ui, acts)));
    floating(ui, layout.bottom, 3, "cook", |ui| hob_bar::show(state, ui, acts, false));
    if let Some(left) = layout.left {
        if state.settings.pieces_open {
            floating(ui, left, 4, "pieces", |ui| {
                scrolled(ui, |ui| pieces::show(state, &mut memory.unfolded, ui, acts))
            });
        } else {
            floating(ui, left, 4, "food", |ui| scrolled(ui, |ui| pantry::show(state, &mut memory.count, ui, acts)));
        }
    }
}

fn drawer(state: &WindowState, memory: &mut PanelMemory, ui: &mut Ui, acts: &mut Acts) {
    ui.horizontal(|ui| {
        (ui.spacing_mut().item_spacing.x, ui.spacing_mut().button_padding.x) = (5.0, 7.0);
        for part in Drawer::ALL {
            if ui.add(theme::of(ui).button(part.name(state), memory.drawer == part)).clicked() {
                memory.drawer = part;
            }
        }
        top::help_and_settings(state, ui, acts);
    });
    ui.separator();
    scrolled(ui, |ui| match memory.drawer {
        Drawer::Cook => hob_bar::show(state, ui, acts, true),
        Drawer::Inside => inside::show(state, &mut memory.inside, ui, acts),
        Drawer::Food => pantry::show(state, &mut memory.count, ui, acts),
        Drawer::Pieces => pieces::show(state, &mut memory.unfolded, ui, acts),
    });
}

/// A panel at a fixed place; it takes the mouse so that the scene below does not.
fn floating(ui: &mut Ui, rect: Rect, index: u32, name: &str, content: impl FnOnce(&mut Ui)) {
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
    theme::of(ui).panel().fill(egui::Color32::TRANSPARENT).show(&mut child, |ui| {
        let inner = ui.available_size();
        ui.set_min_size(inner);
        ui.set_max_size(inner);
        ui.set_clip_rect(rect);
        content(ui);
    });
}

fn scrolled(ui: &mut Ui, content: impl FnOnce(&mut Ui)) {
    ScrollArea::vertical().auto_shrink([false, false]).show(ui, content);
}
