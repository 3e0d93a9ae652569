//! The legend of the present view.

use egui::{Align2, Color32, FontId, Rect, Sense, Ui, pos2, vec2};

use crate::app::SauteApp;
use crate::colour_map::ColourMap;
use crate::theme;
use crate::view::View;
use saute_kitchen::food::Class;

/// Temperatures worth a mark in a kitchen [°C].
const TICKS: [f64; 8] = [0.0, 50.0, 60.0, 70.0, 100.0, 140.0, 180.0, 220.0];

/// Shows what the colours mean: nothing for the natural look.
pub fn show(app: &mut SauteApp, ui: &mut Ui) {
    match app.settings.view {
        View::Look => {}
        View::Temperature => {
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
        View::Doneness => classes(ui),
    }
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

fn classes(ui: &mut Ui) {
    for (class, name) in Class::ALL.into_iter().zip(super::doneness_bar::NAMES) {
        let (rect, _) = ui.allocate_exact_size(vec2(16.0, 16.0), Sense::hover());
        super::doneness_bar::swatch(ui.painter(), rect, class);
        ui.label(egui::RichText::new(name).size(13.0));
    }
}
