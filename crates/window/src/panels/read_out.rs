//! Read-out next to the pointer: the state of the piece under it, and the value at its point.

use egui::{Align2, Area, Id, Order, Rect, RichText, Ui, Vec2, vec2};
use saute_kitchen::food::change::doneness::Measure;
use saute_kitchen::{Piece, celsius};

use crate::ui::scene_view::SceneView;
use crate::ui::theme;
use saute_controls::context::PanelContext;
use saute_controls::spoken::view_words::ViewWords;
use saute_words::piece_words::{doneness, grams, place};

/// How far it is below a mouse, and above a finger [points].
const BY_MOUSE: Vec2 = vec2(18.0, 14.0);
const BY_FINGER: Vec2 = vec2(0.0, 48.0);

/// Shows the read-out while the pointer rests on a piece, or a finger is held on it.
pub fn show(state: &PanelContext, scene: &SceneView, ui: &Ui, whole: Rect) {
    let piece = scene.hovered.as_ref().and_then(|id| state.session.kitchen.piece(id));
    let (Some(piece), Some((at, by_finger))) = (piece, scene.reads_at) else { return };
    // A hand covers what is below its finger.
    let (at, pivot) =
        if by_finger { (at - BY_FINGER, Align2::CENTER_BOTTOM) } else { (at + BY_MOUSE, Align2::LEFT_TOP) };
    let l = state.settings.language;
    let shown = |kelvin: f64| state.settings.temperature(celsius(kelvin));
    let (above, below) = (shown(piece.face(false)), shown(piece.face(true)));
    let lines = [
        l.fill("piece.core", &[("core", &shown(piece.core()))]),
        l.fill("piece.surface", &[("above", &above), ("below", &below)]),
        format!("{} · {}", grams(piece), doneness(state.scale_of(piece).as_deref(), piece, l)),
        place(piece, l).to_owned(),
    ];
    let area = Area::new(Id::unique("read-out")).order(Order::Tooltip).interactable(false);
    area.fixed_pos(at).pivot(pivot).constrain_to(whole.shrink(6.0)).show(ui.ctx(), |ui| {
        theme::of(ui).panel().fill(theme::of(ui).solid).inner_margin(9).show(ui, |ui| {
            ui.spacing_mut().item_spacing.y = 2.0;
            ui.label(RichText::new(state.session.name_of(&piece.id, l)).size(14.5).strong().color(theme::of(ui).text));
            if let Some(here) = here(state, scene, piece) {
                ui.add(egui::Label::new(RichText::new(here).size(14.5).strong()).extend());
            }
            for line in lines {
                ui.add(egui::Label::new(RichText::new(line).size(13.0)).extend());
            }
        });
    });
}

/// The value of the view at the point under the pointer, with its unit.
fn here(state: &PanelContext, scene: &SceneView, piece: &Piece) -> Option<String> {
    let point = scene.pointed.as_ref().filter(|p| p.piece == piece.id)?;
    let piece = point.piece(&state.session.kitchen)?;
    let view = state.settings.view;
    let scale = state.scale_of(piece);
    let change = scale.as_ref().filter(|s| s.measure() == Measure::Share).map(|s| s.for_change.as_str());
    let value = point.shares.read(|node| view.value(&piece.model, &piece.state, node, change));
    Some(
        state
            .settings
            .language
            .fill("value.here", &[("value", &view.words(value, state.settings.speech(), scale.as_deref()))]),
    )
}
