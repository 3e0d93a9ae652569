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

use egui::{Rect, ScrollArea, Ui, UiBuilder};

use crate::app::SauteApp;
use crate::paint::ground::GroundCallback;
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

    fn name(self, app: &SauteApp) -> &'static str {
        match self {
            Self::Cook => app.settings.language.text("drawer.cook"),
            Self::Inside => app.settings.language.text("drawer.inside"),
            Self::Food => top::food_word(app),
            Self::Pieces => app.settings.language.text("top.pieces"),
        }
    }
}

/// Shows all panels.
pub fn show(app: &mut SauteApp, ui: &mut Ui, layout: &Layout) {
    floating(ui, layout.top, 0, "views", |ui| top::show(app, ui, layout.narrow));
    if layout.narrow {
        floating(ui, layout.bottom, 1, "drawer", |ui| drawer(app, ui));
        return;
    }
    floating(ui, layout.right, 2, "inside", |ui| scrolled(ui, |ui| inside::show(app, ui)));
    floating(ui, layout.bottom, 3, "cook", |ui| hob_bar::show(app, ui, false));
    if let Some(left) = layout.left {
        if app.settings.pieces_open {
            floating(ui, left, 4, "pieces", |ui| scrolled(ui, |ui| pieces::show(app, ui)));
        } else {
            floating(ui, left, 4, "food", |ui| scrolled(ui, |ui| pantry::show(app, ui)));
        }
    }
}

fn drawer(app: &mut SauteApp, ui: &mut Ui) {
    ui.horizontal(|ui| {
        (ui.spacing_mut().item_spacing.x, ui.spacing_mut().button_padding.x) = (5.0, 7.0);
        for part in Drawer::ALL {
            if ui.add(theme::of(ui).button(part.name(app), app.drawer == part)).clicked() {
                app.drawer = part;
            }
        }
        top::help_and_settings(app, ui);
    });
    ui.separator();
    scrolled(ui, |ui| match app.drawer {
        Drawer::Cook => hob_bar::show(app, ui, true),
        Drawer::Inside => inside::show(app, ui),
        Drawer::Food => pantry::show(app, ui),
        Drawer::Pieces => pieces::show(app, ui),
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
