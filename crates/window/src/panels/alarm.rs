//! The alarm when the oil burns: over everything, across the window, with the three things to do.

use egui::{Align2, Area, Color32, Id, Order, Rect, RichText, Ui, vec2};

use crate::ui::theme;
use saute_controls::act::{Act, Acts, CookAct};
use saute_controls::context::PanelContext;

/// Ground of the alarm: red, white on which has a contrast of 6.5 [-] (chosen, as the stop of the hands).
const RED: Color32 = Color32::from_rgb(178, 24, 24);

/// Shows the alarm while the oil burns, whatever else is shown or hidden.
pub fn show(state: &PanelContext, ui: &Ui, acts: &mut Acts, whole: Rect) {
    let kitchen = &state.session.kitchen;
    if !kitchen.pan_state().liquids.smoke.burning {
        return;
    }
    let l = state.settings.language;
    Area::new(Id::unique("fire")).order(Order::Foreground).fixed_pos(whole.min).pivot(Align2::LEFT_TOP).show(
        ui.ctx(),
        |ui| {
            egui::Frame::new().fill(RED).inner_margin(12).show(ui, |ui| {
                ui.set_width(whole.width() - 24.0);
                ui.horizontal_wrapped(|ui| {
                    ui.spacing_mut().item_spacing = vec2(14.0, 6.0);
                    ui.label(words(l.text("alarm.fire")).size(22.0));
                    let lidded = kitchen.pan_state().lid.is_some();
                    deed(ui, l.text("alarm.lid"), lidded, acts, Act::Cook(CookAct::Lid));
                    deed(ui, l.text("alarm.hob"), kitchen.hob_w() == 0.0, acts, Act::Cook(CookAct::HobSet(0.0)));
                    ui.label(words(l.text("alarm.water")).size(18.0));
                });
            });
        },
    );
}

fn words(text: &str) -> RichText {
    RichText::new(text).strong().color(Color32::WHITE)
}

/// A thing to do, struck out once it is done.
fn deed(ui: &mut Ui, text: &str, done: bool, acts: &mut Acts, act: Act) {
    if done {
        ui.label(words(text).size(18.0).strikethrough());
        return;
    }
    let button = egui::Button::new(RichText::new(text).size(18.0).strong().color(RED));
    if ui.add(button.fill(Color32::WHITE).min_size(vec2(theme::TOUCH, theme::TOUCH))).clicked() {
        acts.push(act);
    }
}
