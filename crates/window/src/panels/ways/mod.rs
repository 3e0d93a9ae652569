//! Ways side by side: for each its name, how far it is, its pan, its cut and its readings; their curves in one plot.

mod column;
mod look;
pub mod memory;
mod plot;

use egui::{Rect, Ui, pos2};

use crate::panels::badge;
use crate::ui::theme;
use crate::ui::ways_layout::WaysLayout;
use saute_controls::act::Acts;
use saute_session::timeline::{BranchName, WayBeside};
use saute_words::act_words::act_words;
use saute_words::language::Language;

use crate::panels::ways::memory::{WaysMemory, within};
use saute_controls::ways_state::WaysState;

/// Height of the curves in the drawer of a narrow window [points].
const DRAWER_CURVES: f32 = 150.0;

/// Shows all of it but the pans, which are drawn with the scene.
pub fn show(
    state: &WaysState,
    memory: &mut WaysMemory,
    ui: &mut Ui,
    acts: &mut Acts,
    (whole, layout): (Rect, &WaysLayout),
) {
    ground(ui, whole, layout);
    memory.cuts.retain(|id, _| state.ways.iter().any(|way| way.way.id == *id));
    memory.pages = state.ways.len() > layout.columns().len();
    let shown: Vec<&WayBeside> = displayed(&state.ways, memory, layout.columns().len());
    for (way, column) in shown.into_iter().zip(layout.columns()) {
        column::show(state, way, memory, ui, acts, column);
    }
    let Some(curves) = layout.curves else { return };
    within(ui, curves, "ways-curves", |ui| plot::show(state, memory.quantity, ui, curves.height()));
    within(ui, layout.beside, "ways-legend", |ui| {
        plot::legend(state, &mut memory.quantity, ui);
        badge::what_holds(state, ui, acts, layout.beside.width());
    });
}

/// Shows the curves in the drawer of a narrow window.
pub fn curves_in_drawer(state: &WaysState, memory: &mut WaysMemory, ui: &mut Ui) {
    if state.ways.is_empty() {
        return;
    }
    plot::legend(state, &mut memory.quantity, ui);
    plot::show(state, memory.quantity, ui, DRAWER_CURVES);
    ui.separator();
}

/// The ways for which there are columns: all of them, or the one that goes on and one next to it.
pub(crate) fn displayed<'a, 'b>(
    ways: &'b [WayBeside<'a>],
    memory: &WaysMemory,
    columns: usize,
) -> Vec<&'b WayBeside<'a>> {
    if ways.len() <= columns {
        return ways.iter().collect();
    }
    let live = ways.iter().filter(|way| way.place.is_none());
    let others: Vec<&WayBeside> = ways.iter().filter(|way| way.place.is_some()).collect();
    let chosen = others.iter().position(|way| Some(way.way.id) == memory.other).unwrap_or(0);
    live.chain(others.into_iter().skip(chosen)).take(columns).collect()
}

/// What a way is called: what was done differently in it, and when.
pub(crate) fn way_words(name: &BranchName, l: Language) -> String {
    let time = saute_words::clock::clock(name.at_s);
    match &name.done {
        Some(done) => {
            let parts: [(&str, &dyn std::fmt::Display); 2] = [("what", &act_words(done, l)), ("time", &time)];
            l.fill("strip.way", &parts)
        }
        None => l.fill("strip.way_without", &[("time", &time)]),
    }
}

/// The ground round the pans, over the whole window. It covers no pan: those are drawn before all panels.
fn ground(ui: &Ui, all: Rect, layout: &WaysLayout) {
    let columns = layout.columns();
    let Some(first) = columns.first().map(|column| column.picture) else { return };
    let fill = |from: egui::Pos2, to: egui::Pos2| {
        ui.painter().rect_filled(Rect::from_min_max(from, to), 0.0, theme::of(ui).sunken);
    };
    fill(all.min, pos2(all.right(), first.top()));
    fill(pos2(all.left(), first.bottom()), all.max);
    let mut left = all.left();
    for picture in columns.iter().map(|column| column.picture) {
        fill(pos2(left, first.top()), picture.left_bottom());
        left = picture.right();
    }
    fill(pos2(left, first.top()), pos2(all.right(), first.bottom()));
}
