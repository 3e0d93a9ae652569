//! The alarm at the goal: a band over the scene at the moment to take the food out.

use egui::{Align2, Area, Id, RichText, Ui, vec2};

use crate::act::{Act, Acts, CookAct};
use crate::panels::window_state::WindowState;
use crate::ui::layout::Layout;
use crate::ui::theme;

/// Shows the band while the coach is on, the goal is reached and the food is still in the pan.
pub fn show(state: &WindowState, ui: &Ui, acts: &mut Acts, layout: &Layout) {
    if !state.alarm || layout.ways.is_some() {
        return;
    }
    let (l, palette) = (state.settings.language, theme::of(ui));
    // Clear of notices, of the legend and of the buttons of the eye.
    let (at, pivot) = match layout.narrow {
        true => (layout.free.center_top() + vec2(0.0, layout.eye.height() + 12.0), Align2::CENTER_TOP),
        false => (layout.free.center_bottom() - vec2(0.0, 12.0), Align2::CENTER_BOTTOM),
    };
    Area::new(Id::unique("goal-alarm")).fixed_pos(at).pivot(pivot).show(ui.ctx(), |ui| {
        egui::Frame::new().fill(palette.accent).corner_radius(theme::CORNER).inner_margin(8).show(ui, |ui| {
            ui.horizontal(|ui| {
                ui.label(RichText::new(l.text("coach.goal_reached")).size(17.0).strong().color(palette.on_accent));
                let words = RichText::new(l.text("hob.take_out")).size(15.0).strong().color(palette.accent);
                let button = egui::Button::new(words).fill(palette.on_accent);
                let response = ui.add(button.min_size(vec2(theme::TOUCH, theme::TOUCH)));
                let spoken = l.text("coach.take_out_spoken");
                response.widget_info(|| egui::WidgetInfo::labeled(egui::accesskit::Role::Button, true, spoken));
                if response.clicked() {
                    acts.push(Act::Cook(CookAct::Out));
                }
            });
        });
    });
}
