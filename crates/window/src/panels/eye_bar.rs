//! Buttons that send the eye to a view, and the one that opens the photo mode.

use egui::{Rect, RichText, Ui, UiBuilder, vec2};

use crate::bindings::hint;
use crate::system::IS_PAGE;
use crate::ui::theme;
use saute_controls::act::{Act, Acts, AppAct, ViewAct};
use saute_controls::context::PanelContext;
use saute_controls::eye::EyeView;

/// Shows a button for each view.
pub fn show(state: &PanelContext, ui: &mut Ui, acts: &mut Acts, rect: Rect) {
    let l = state.settings.language;
    let mut child = ui.new_child(UiBuilder::new().id_salt("eye").max_rect(rect));
    child.horizontal(|ui| {
        ui.spacing_mut().item_spacing.x = 3.0;
        ui.spacing_mut().button_padding.x = 4.0;
        let mut all: Vec<(&str, String, Act)> = EyeView::ALL
            .map(|view| {
                let (name, explained) = words(view);
                (name, l.text(explained).to_owned(), Act::View(ViewAct::Eye(view)))
            })
            .into();
        // A page takes the picture at once: it has no photo mode.
        let photo = if IS_PAGE { Act::App(AppAct::Picture) } else { Act::App(AppAct::Photo) };
        all.push(("photo.open", hint(&photo, l), photo));
        all.retain(|(_, _, act)| !state.hides(act));
        let width = (rect.width() - (all.len() - 1) as f32 * 3.0) / all.len() as f32;
        for (name, explained, act) in all {
            let text = RichText::new(l.text(name)).size(13.0);
            let button = egui::Button::new(text).fill(theme::of(ui).ground).min_size(vec2(width, rect.height()));
            if ui.add_enabled(!state.forbids(&act), button).on_hover_text(explained).clicked() {
                acts.push(act);
            }
        }
    });
}

/// Keys of a view's name and of what it is for.
fn words(view: EyeView) -> (&'static str, &'static str) {
    match view {
        EyeView::Front => ("seen_from.front", "seen_from.front_hint"),
        EyeView::Above => ("seen_from.above", "seen_from.above_hint"),
        EyeView::Food => ("seen_from.food", "seen_from.food_hint"),
    }
}
