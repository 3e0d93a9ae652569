//! Probes in the scene: put where the pointer is, shown as numbered markers, dragged.

use crate::app::SauteApp;
use crate::ui::layout::Pane;
use crate::ui::theme;
use egui::{Align2, FontId, Pos2, Rect, Sense, Stroke, Ui, Vec2, vec2};
use saute_recipe::probe::SeenPoint;
use saute_recipe::probe::{MOST_PROBES, NoProbeLeft};

/// From the point of a probe to its number [points] (chosen: neither finger nor number hides the point).
const NUMBER_AT: Vec2 = vec2(15.0, -17.0);

/// Radius of the number's ground and of the point [points].
const NUMBER: f32 = 9.5;

const POINT: f32 = 3.0;

impl SauteApp {
    /// Puts a probe where the pointer is.
    pub(crate) fn place_probe(&mut self) {
        match self.sights.scene.pointed.clone() {
            Some(point) => self.place_probe_at(point),
            None => {
                self.sights.scene.placing = true;
                self.say("probe.point");
            }
        }
    }

    pub(crate) fn place_probe_at(&mut self, point: SeenPoint) {
        self.sights.scene.placing = false;
        let piece = point.piece.clone();
        let l = self.settings.language;
        let named = |number| l.fill("probe.name", &[("number", &number)]);
        match self.session.probes.place(&self.session.kitchen, point, named) {
            Ok(number) => {
                // What a probe is for is its curve.
                self.settings.curves_open = true;
                self.session.select(Some(piece.clone()));
                let food = self.session.name_of(&piece, l);
                self.desk.notice.say(l.fill("probe.is_in", &[("number", &number), ("food", &food)]));
            }
            Err(NoProbeLeft) => self.desk.notice.say(l.fill("probe.none_left", &[("most", &MOST_PROBES)])),
        }
    }

    /// Where the point of a probe and its number appear in a picture of the scene.
    pub fn probe_on_screen(&self, number: usize, rect: Rect) -> Option<[Pos2; 2]> {
        let kitchen = &self.session.kitchen;
        let probes = kitchen.pieces().iter().flat_map(|piece| self.session.probes.of(piece).map(move |p| (piece, p)));
        let (piece, probe) = probes.into_iter().find(|(_, p)| p.number == number)?;
        let pose = self.places().piece(kitchen, piece);
        let point = self.on_screen(pose.matrix().transform_point3(probe.place(piece)), rect)?;
        Some([point, point + NUMBER_AT])
    }

    /// Shows the markers in a pane; they can be dragged, and a click selects.
    pub(crate) fn show_probes(&mut self, ui: &mut Ui, pane: &Pane) {
        let numbers: Vec<usize> = self.session.probes.all().iter().map(|p| p.number).collect();
        for number in numbers {
            let Some([point, at]) = self.probe_on_screen(number, pane.rect) else { continue };
            if !pane.free.expand(NUMBER).contains(at) {
                continue;
            }
            let id = ui.scope_id().with(("probe", number, pane.look));
            let response =
                ui.interact(Rect::from_center_size(at, Vec2::splat(2.6 * NUMBER)), id, Sense::click_and_drag());
            let name = self.settings.language.fill("probe.marker", &[("number", &number)]);
            response.widget_info(|| egui::WidgetInfo::labeled(egui::accesskit::Role::Button, true, &name));
            let dragged = response.interact_pointer_pos().filter(|_| response.dragged());
            if let Some(point) = dragged.and_then(|to| self.seen_point(to - NUMBER_AT, pane.rect)) {
                self.session.probes.shift(&self.session.kitchen, number, point);
            }
            if response.clicked() || response.drag_started() {
                self.session.probes.selected = Some(number);
                let piece = self.session.probes.get(number).map(|p| p.piece.clone());
                self.session.select(piece);
            }
            let chosen = self.session.probes.selected == Some(number) || response.hovered();
            marker(ui, point, number, chosen);
        }
    }
}

/// A point with its number.
fn marker(ui: &Ui, point: Pos2, number: usize, chosen: bool) {
    let (painter, at) = (ui.painter(), point + NUMBER_AT);
    let palette = theme::of(ui);
    let fill = palette.probe(number);
    let rim = if chosen { palette.text } else { palette.on_accent };
    painter.line_segment([point, at], Stroke::new(3.5, palette.on_accent));
    painter.line_segment([point, at], Stroke::new(1.5, fill));
    painter.circle(point, POINT, fill, Stroke::new(1.2, palette.on_accent));
    painter.circle(at, NUMBER, fill, Stroke::new(if chosen { 2.0 } else { 1.2 }, rim));
    painter.text(at, Align2::CENTER_CENTER, number.to_string(), FontId::proportional(13.0), palette.on_accent);
}
