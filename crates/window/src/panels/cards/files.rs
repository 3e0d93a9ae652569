//! The card of files: a cook, a recipe or a log is opened, what was cooked is saved, and its link is copied.

use egui::{Rect, RichText, Ui, vec2};

use crate::panels::cards::frame::{Framed, list};
use crate::panels::host_panels;
use crate::ui::{fingers, theme};
use saute_controls::act::{Act, Acts, AppAct, Card};
use saute_controls::context::PanelContext;
use saute_session::export::Export;

/// Width of the card at most [points].
const WIDTH: f32 = 460.0;
/// Height of a button [points].
const HEIGHT: f32 = 34.0;

/// Shows the card over everything; Esc, the button or a click beside it closes it.
pub fn show(state: &PanelContext, ui: &Ui, acts: &mut Acts, whole: Rect) {
    let framed = Framed { card: Card::Files, id: "files", title: "files.title", width: WIDTH };
    framed.show(state, ui, acts, whole, |ui, acts| {
        list(ui, whole, |ui| rows(state, ui, acts));
    });
}

fn rows(state: &PanelContext, ui: &mut Ui, acts: &mut Acts) {
    let l = state.settings.language;
    row(state, ui, acts, "pantry.choose_file", Act::App(AppAct::ChooseFile));
    ui.label(RichText::new(l.text("pantry.drop")).size(13.0).color(theme::of(ui).quiet));
    host_panels::recent_files(state, ui, acts);
    ui.separator();
    for what in Export::ALL {
        row(state, ui, acts, what.words(), Act::App(AppAct::Export(what)));
    }
    if crate::system::page_address().is_some() {
        row(state, ui, acts, "link.copy", Act::App(AppAct::CopyLink));
    }
}

/// A button over the whole width; what was asked for closes the card.
fn row(state: &PanelContext, ui: &mut Ui, acts: &mut Acts, key: &'static str, act: Act) {
    let size = vec2(ui.available_width(), fingers::height(ui, HEIGHT));
    let button = theme::of(ui).button(state.settings.language.text(key), false).min_size(size);
    if ui.add_enabled(!state.forbids(&act), button).clicked() {
        acts.extend([Act::App(AppAct::Shut(Card::Files)), act]);
    }
}
