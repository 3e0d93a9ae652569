//! The few controls of a first cook: the hob, the three things that hands do, and time.

use egui::{Align, Layout, RichText, Ui};
use saute_kitchen::Place;

use crate::panels::cook::act_button::button;
use crate::panels::cook::cook_state::CookState;
use crate::panels::cook::{hob_bar, hob_slider, time_strip};
use crate::ui::theme::{self, TOUCH};
use saute_controls::act::{Act, Acts, CookAct};
use saute_controls::context::PanelContext;

/// Shows them in one row.
pub fn row(state: &CookState, ui: &mut Ui, acts: &mut Acts) {
    ui.spacing_mut().item_spacing.x = 8.0;
    ui.spacing_mut().interact_size.y = 36.0;
    ui.horizontal_centered(|ui| {
        ui.label(RichText::new(state.settings.language.text("hob.hob")).color(theme::of(ui).quiet));
        hob_slider::show(state, ui, acts);
        hands(state, ui, acts);
        ui.with_layout(Layout::right_to_left(Align::Center), |ui| hob_bar::time_right_to_left(state, ui, acts));
    });
}

/// Shows them in rows for fingers.
pub fn rows(state: &CookState, ui: &mut Ui, acts: &mut Acts) {
    ui.spacing_mut().interact_size.y = TOUCH;
    (ui.spacing_mut().item_spacing, ui.spacing_mut().button_padding.x) = (egui::vec2(6.0, 6.0), 9.0);
    ui.horizontal_wrapped(|ui| hands(state, ui, acts));
    ui.horizontal_wrapped(|ui| hob_slider::show(state, ui, acts));
    ui.horizontal_wrapped(|ui| hob_bar::time(state, ui, acts));
}

fn hands(state: &PanelContext, ui: &mut Ui, acts: &mut Acts) {
    let l = state.settings.language;
    let in_pan = state.session.shown_piece().is_some_and(|piece| matches!(piece.place, Place::Pan(_)));
    hob_bar::put_button(state, ui, acts);
    button(state, ui, acts, l.text("hob.flip"), false, in_pan, Act::Cook(CookAct::Flip));
    button(state, ui, acts, l.text("hob.take_out"), false, in_pan, Act::Cook(CookAct::Out));
    time_strip::undo(state, ui, acts);
}
