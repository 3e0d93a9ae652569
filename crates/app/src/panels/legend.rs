//! The legend of the present view.

use egui::{Align2, Color32, FontId, Rect, Sense, Ui, pos2, vec2};
use saute_kitchen::food::Scale;

use crate::app::SauteApp;
use crate::colour_map::{ColourMap, Tone};
use crate::theme;
use crate::view::View;

/// Temperatures worth a mark in a kitchen [°C].
const TICKS: [f64; 8] = [0.0, 50.0, 60.0, 70.0, 100.0, 140.0, 180.0, 220.0];

/// Shows what the colours mean: nothing for the natural look.
pub fn show(app: &mut SauteApp, ui: &mut Ui) {
    match app.settings.view {
        View::Look => {}
        View::Doneness => {
            if let Some(scale) = app.scale() {
                classes(ui, &scale);
            } else {
                ui.label(egui::RichText::new("highest\nso far").size(12.5).color(theme::QUIET));
                temperatures(app, ui);
            }
        }
        View::Temperature => temperatures(app, ui),
    }
}

fn temperatures(app: &mut SauteApp, ui: &mut Ui) {
    let map = app.settings.map.map();
    let (rect, response) = ui.allocate_exact_size(vec2(250.0, 36.0), Sense::click());
    response.widget_info(|| {
        egui::WidgetInfo::labeled(
            egui::accesskit::Role::Button,
            true,
            "Legend of temperatures; click for the other colour map",
        )
    });
    if response.on_hover_text("Click for the other colour map (M)").clicked() {
        app.act(crate::act::Act::Map, &ui.ctx().clone());
    }
    scale(app, ui, rect, &map);
}

fn scale(app: &SauteApp, ui: &Ui, rect: Rect, map: &ColourMap) {
    let bar = Rect::from_min_max(rect.min, pos2(rect.right(), rect.top() + 14.0));
    let painter = ui.painter();
    let columns = bar.width() as usize;
    for i in 0..columns {
        let celsius = map.from_c + (map.to_c - map.from_c) * i as f64 / columns as f64;
        let [r, g, b] = map.colour(celsius);
        let left = bar.left() + i as f32;
        painter.rect_filled(
            Rect::from_min_max(pos2(left, bar.top()), pos2(left + 1.5, bar.bottom())),
            0.0,
            Color32::from_rgb(r, g, b),
        );
    }
    let mut free_from = bar.left() - 20.0;
    for tick in TICKS.into_iter().filter(|t| (map.from_c..=map.to_c).contains(t)) {
        let x = bar.left() + map.coordinate(tick) * bar.width();
        painter
            .line_segment([pos2(x, bar.bottom()), pos2(x, bar.bottom() + 4.0)], egui::Stroke::new(1.0, theme::QUIET));
        if x - free_from >= 20.0 {
            let text = format!("{:.0}", app.settings.degrees(tick));
            painter.text(
                pos2(x, bar.bottom() + 4.0),
                Align2::CENTER_TOP,
                text,
                FontId::proportional(11.5),
                theme::TEXT,
            );
            free_from = x + 8.0;
        }
    }
    painter.text(
        rect.right_bottom() + vec2(2.0, 1.0),
        Align2::RIGHT_BOTTOM,
        app.settings.unit(),
        FontId::proportional(11.5),
        theme::QUIET,
    );
}

/// The classes of a scale under its label.
pub fn classes(ui: &mut Ui, scale: &Scale) {
    ui.vertical(|ui| {
        ui.spacing_mut().item_spacing.y = 2.0;
        let label = egui::RichText::new(format!("doneness by {}", scale.name)).size(12.0).color(theme::QUIET);
        ui.label(label);
        ui.horizontal(|ui| {
            ui.spacing_mut().item_spacing.x = 5.0;
            for (place, class) in scale.class.iter().enumerate() {
                let (rect, _) = ui.allocate_exact_size(vec2(15.0, 15.0), Sense::hover());
                super::doneness_bar::swatch(ui.painter(), rect, Tone::of(scale, place));
                ui.label(egui::RichText::new(&class.name).size(12.5));
            }
        });
    });
}
