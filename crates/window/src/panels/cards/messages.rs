//! The list of notices, the last first.

use egui::{Rect, RichText, ScrollArea, Ui};

use crate::panels::cards::frame::Framed;
use crate::panels::host_panels::file_button;
use crate::ui::theme;
use saute_controls::act::{Acts, Card};
use saute_controls::context::PanelContext;
use saute_controls::spoken::notice::Notice;
use saute_words::clock::clock;

/// Width of the card at most [points].
const WIDTH: f32 = 560.0;

/// Shows the list over everything; Esc, the button or a click beside it closes it.
pub fn show(state: &PanelContext, said: &Notice, ui: &Ui, acts: &mut Acts, whole: Rect) {
    let framed = Framed { card: Card::Messages, id: "messages", title: "messages.title", width: WIDTH };
    framed.show(state, ui, acts, whole, |ui, acts| {
        ScrollArea::vertical().max_height(whole.height() - 140.0).show(ui, |ui| lines(state, said, ui, acts));
    });
}

fn lines(state: &PanelContext, said: &Notice, ui: &mut Ui, acts: &mut Acts) {
    let l = state.settings.language;
    let all = said.all();
    if all.is_empty() {
        ui.label(l.text("messages.none"));
    }
    for said in all {
        let ago = l.fill("messages.ago", &[("time", &clock(f64::from(said.ago_s())))]);
        ui.label(RichText::new(ago).size(12.5).color(theme::of(ui).quiet));
        ui.horizontal_wrapped(|ui| {
            ui.label(&said.text);
            file_button(state, ui, acts, &said);
        });
        ui.add_space(4.0);
    }
}
