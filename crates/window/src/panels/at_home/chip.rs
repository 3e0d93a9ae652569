//! The word beside the choice of the pan: in which kitchen later cooks are, and the ways to another.

use egui::{RichText, Ui};

use crate::ui::theme;
use saute_controls::act::{Act, Acts, AppAct, Card, LearnAct};
use saute_controls::at_home::AtHomeAct;
use saute_controls::context::PanelContext;

/// Shows the kitchen, and the ways to another one.
pub fn show(state: &PanelContext, ui: &mut Ui, acts: &mut Acts) {
    let l = state.settings.language;
    ui.horizontal_wrapped(|ui| {
        ui.spacing_mut().item_spacing.x = 6.0;
        if let Some(kept) = &state.settings.kitchen {
            let mut choice = |text: &str, on: bool, act: AtHomeAct| {
                let response = ui.add(theme::of(ui).button(text, on));
                response.widget_info(|| egui::WidgetInfo::selected(egui::accesskit::Role::RadioButton, true, on, text));
                if response.clicked() && !on {
                    acts.push(Act::Learn(LearnAct::AtHome(act)));
                }
            };
            choice(l.text("athome.mine"), kept.is_used, AtHomeAct::Use(true));
            choice(l.text("athome.typical"), !kept.is_used, AtHomeAct::Use(false));
        } else {
            ui.label(RichText::new(l.text("athome.is_typical")).size(13.0).color(theme::of(ui).quiet));
            let button = theme::of(ui).button(l.text("athome.fit_mine"), false);
            if ui.add(button).on_hover_text(l.text("learn.athome")).clicked() {
                acts.push(Act::App(AppAct::Open(Card::AtHome)));
            }
        }
    });
}
