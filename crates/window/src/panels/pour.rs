//! What goes into the pan and onto it: oil, butter, water, the lid; and which tool is in the hand.

use egui::{Label, RichText, Ui};
use saute_kitchen::dynamics::Tool;

use crate::act::{Act, ROLL_STEP, TOOL_STEP};
use crate::app::SauteApp;
use crate::input::pouring::{Pourable, danger, in_the_pan};
use crate::panels::hob_bar::button;
use crate::ui::theme;

/// Shows the controls and what is in the pan.
pub fn show(app: &mut SauteApp, ui: &mut Ui) {
    let l = app.settings.language;
    let lid = app.session.kitchen.pan_state().lid.is_some();
    for what in Pourable::ALL {
        let grams = format!("{:.0}", app.portion.grams(what));
        let text = l.fill("pour.portion_of", &[("what", &what.name(l)), ("grams", &grams)]);
        button(app, ui, &text, false, true, Act::Pour(what));
    }
    let portion = app.portion.name(l);
    button(app, ui, portion, false, true, Act::Portion);
    button(app, ui, l.text("pour.lid"), lid, true, Act::Lid);
    let tool = match app.tool_hand.tool {
        Tool::Tongs => "pour.tongs",
        Tool::Turner => "pour.turner",
    };
    button(app, ui, l.text(tool), app.tool_hand.turner.is_some(), true, Act::Tool);
    if app.tool_hand.turner.is_some() {
        // Fingers have no wheel and no right button.
        let by_hand = [
            ("pour.up", Act::ToolBy(TOOL_STEP)),
            ("pour.down", Act::ToolBy(-TOOL_STEP)),
            ("pour.roll", Act::RollBy(ROLL_STEP)),
            ("pour.put_away", Act::PutAway),
        ];
        by_hand.into_iter().for_each(|(key, act)| button(app, ui, l.text(key), false, true, act));
    }
    match danger(&app.session.kitchen, l) {
        Some(text) => line(ui, RichText::new(text).color(theme::of(ui).accent).strong()),
        None => {
            let text = l.fill("pour.in_the_pan", &[("what", &in_the_pan(&app.session.kitchen, l))]);
            line(ui, RichText::new(text).color(theme::of(ui).quiet));
        }
    }
}

fn line(ui: &mut Ui, text: RichText) {
    ui.add(Label::new(text.size(13.0)).truncate());
}
