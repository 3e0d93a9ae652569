//! What goes into the pan and onto it: oil, butter, water, the lid; and which tool is in the hand.

use egui::{Label, RichText, Ui};
use saute_kitchen::dynamics::Tool;

use crate::act::{Act, ROLL_STEP, TOOL_STEP};
use crate::app::SauteApp;
use crate::panels::hob_bar::button;
use crate::pouring::{Pourable, danger, in_the_pan};
use crate::theme;

/// Shows the controls and what is in the pan.
pub fn show(app: &mut SauteApp, ui: &mut Ui) {
    let lid = app.session.kitchen.pan_state().lid.is_some();
    for what in Pourable::ALL {
        let text = format!("{} {:.0} g", what.name(), app.portion.grams(what));
        button(app, ui, &text, false, true, Act::Pour(what));
    }
    let portion = app.portion.name();
    button(app, ui, portion, false, true, Act::Portion);
    button(app, ui, "Lid", lid, true, Act::Lid);
    let tool = match app.tool_hand.tool {
        Tool::Tongs => "Tongs",
        Tool::Turner => "Turner",
    };
    button(app, ui, tool, app.tool_hand.turner.is_some(), true, Act::Tool);
    if app.tool_hand.turner.is_some() {
        // Fingers have no wheel and no right button.
        let by_hand = [
            ("Up", Act::ToolBy(TOOL_STEP)),
            ("Down", Act::ToolBy(-TOOL_STEP)),
            ("Roll", Act::RollBy(ROLL_STEP)),
            ("Put away", Act::PutAway),
        ];
        by_hand.into_iter().for_each(|(text, act)| button(app, ui, text, false, true, act));
    }
    match danger(&app.session.kitchen) {
        Some(text) => line(ui, RichText::new(text).color(theme::ACCENT).strong()),
        None => {
            line(ui, RichText::new(format!("In the pan: {}", in_the_pan(&app.session.kitchen))).color(theme::QUIET))
        }
    }
}

fn line(ui: &mut Ui, text: RichText) {
    ui.add(Label::new(text.size(13.0)).truncate());
}
