//! What goes into the pan and onto it: oil, butter, water, the lid; and which tool is in the hand.

use egui::Ui;
use saute_kitchen::Piece;
use saute_kitchen::dynamics::Tool;

use crate::bindings::{ROLL_STEP, TOOL_STEP};
use crate::panels::cook::act_button::button;
use crate::panels::cook::cook_state::CookState;
use crate::panels::host_panels;
use saute_controls::act::{Act, Acts, CookAct};
use saute_controls::context::PanelContext;
use saute_controls::input::pouring::Pourable;

/// Shows the controls.
pub fn show(state: &CookState, ui: &mut Ui, acts: &mut Acts) {
    let l = state.settings.language;
    let lid = state.session.kitchen.pan_state().lid.is_some();
    for what in Pourable::ALL {
        let grams = format!("{:.0}", state.portion.grams(what));
        let text = l.fill("pour.portion_of", &[("what", &what.name(l)), ("grams", &grams)]);
        button(state, ui, acts, &text, false, true, Act::Cook(CookAct::Pour(what)));
    }
    let portion = state.portion.name(l);
    button(state, ui, acts, portion, false, true, Act::Cook(CookAct::Portion));
    button(state, ui, acts, l.text("pour.lid"), lid, true, Act::Cook(CookAct::Lid));
    let holds = state.session.kitchen.pieces().iter().any(Piece::in_pan);
    button(state, ui, acts, l.text("pour.baste"), false, holds, Act::Cook(CookAct::Baste));
    let is_empty = !holds;
    button(state, ui, acts, l.text("pour.wipe"), false, is_empty, Act::Cook(CookAct::Wipe));
    let tool = match state.tool {
        Tool::Tongs => "pour.tongs",
        Tool::Turner => "pour.turner",
    };
    button(state, ui, acts, l.text(tool), state.turner_in_hand, true, Act::Cook(CookAct::Tool));
    host_panels::tilt_button(state, state.host, ui, acts);
}

/// What moves the turner in the hand: fingers have no wheel and no right button.
pub fn turner(state: &PanelContext, ui: &mut Ui, acts: &mut Acts) {
    let by_hand = [
        ("pour.up", Act::Cook(CookAct::ToolBy(TOOL_STEP))),
        ("pour.down", Act::Cook(CookAct::ToolBy(-TOOL_STEP))),
        ("pour.roll", Act::Cook(CookAct::RollBy(ROLL_STEP))),
        ("pour.put_away", Act::Cook(CookAct::PutAway)),
    ];
    let l = state.settings.language;
    by_hand.into_iter().for_each(|(key, act)| button(state, ui, acts, l.text(key), false, true, act));
}
