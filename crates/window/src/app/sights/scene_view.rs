//! The scene in the window: drawing, and the handle of the cut.

use crate::app::SauteApp;
use crate::app::on_host::OnHost;
use crate::host::Host;
use crate::paint::scene::SceneCallback;
use crate::ui::layout::{Layout, Pane};
use crate::ui::scene_view::{meet_height, ndc, on_screen};
use crate::ui::theme;
use egui::{Pos2, Rect, Sense, Stroke, Ui, vec2};
use glam::{Mat4, Vec3};
use saute_kitchen::Piece;
use saute_picture::seen_point::Ray;
use saute_picture::split;
use saute_picture::stage::{Pose, StageOptions, half_length};
use saute_recipe::probe::SeenPoint;
use saute_scene::input::SceneInput;

/// Height of the cut's knob above the steak [m] (chosen: clear of the crust, near enough to belong to it).
const KNOB_HEIGHT: f32 = 0.028;

impl SauteApp {
    /// The point of a piece that a place in a picture of the scene shows, as the scene is drawn in this frame.
    pub fn seen_point(&self, at: Pos2, rect: Rect) -> Option<SeenPoint> {
        let input = self.sights.scene.shown.as_deref()?;
        let (origin, direction) = self.eye().ray(ndc(at, rect), rect.width() / rect.height());
        self.sights.stage.seen_point(&self.session.kitchen, input, self.sights.slice, Ray { origin, direction })
    }

    /// Draws the scene over the whole window, or split in two, and takes the mouse there.
    pub(crate) fn show_scene(&mut self, ui: &mut Ui, layout: &Layout) {
        let panes = layout.panes(self.settings.is_split());
        self.sights.camera.shift = panes[0].lens_shift();
        self.sights.scene.pane = Some(panes[0]);
        let seen = layout.ways.map_or(layout.whole, |ways| ways.live_picture());
        let response = ui.interact(seen, ui.scope_id().with("scene"), Sense::click_and_drag());
        let l = self.settings.language;
        response.widget_info(|| egui::WidgetInfo::labeled(egui::accesskit::Role::Canvas, true, l.text("scene.spoken")));
        let rect = self.used_pane(ui, &panes).rect;
        let placed = self.sights.scene.placing && response.clicked();
        if !placed {
            self.take_mouse(ui, &response, rect);
        }
        self.draw_scene(ui, layout, &panes);
        if self.sights.scene.placing {
            ui.ctx().set_cursor_icon(egui::CursorIcon::Crosshair);
        }
        let read = self.sights.scene.reads_at.filter(|_| self.sights.scene.hovered.is_some());
        self.sights.scene.pointed = read.and_then(|(at, _)| self.seen_point(at, rect));
        if let (true, Some(at)) = (placed, response.interact_pointer_pos()) {
            match self.seen_point(at, rect) {
                Some(point) => self.place_probe_at(point),
                None => self.sights.scene.placing = false,
            }
        }
        for pane in &panes {
            self.show_slice_handle(ui, pane);
            self.show_probes(ui, pane);
            self.show_strings(ui, pane);
        }
    }

    /// The pane that the pointer is in, or was when it was pressed.
    fn used_pane(&self, ui: &Ui, panes: &[Pane]) -> Pane {
        let at = ui.input(|i| i.pointer.press_origin().or(i.pointer.latest_pos()));
        let used = panes.iter().find(|pane| at.is_some_and(|at| pane.rect.contains(at)));
        *used.unwrap_or(&panes[panes.len() - 1])
    }

    fn draw_scene(&mut self, ui: &Ui, layout: &Layout, panes: &[Pane]) {
        let options = StageOptions {
            camera: self.sights.camera.clone(),
            view: self.settings.view,
            map: self.settings.map,
            scales: self.session.scales(&self.settings.scale),
            slice: self.sights.slice,
            cut: self.session.shown_piece().map(|p| p.id.clone()),
            white_balance: self.settings.white_balance,
            light: self.settings.light,
            photo: self.host.photo().unwrap_or_default(),
            flat: false,
        };
        self.sights.stage.look_every(self.look_ticks());
        let input = self.sights.stage.scene(&self.session.kitchen, &options, &self.places());
        let input = SceneInput { strings: self.string_looks(), ..input };
        let scenes = split::scenes(input, panes.len() > 1);
        self.sights.scene.shown = scenes.last().cloned();
        self.sights.scene.drawn_size = self.scene_pixels(layout.whole, ui.ctx().pixels_per_point());
        let fineness = self.sights.scene.drawn_size[0] as f32 / layout.whole.width();
        if !self.drawable() {
            ui.painter().rect_filled(layout.whole, 0.0, theme::of(ui).sunken);
            return;
        }
        self.sights.scene.rest.begin();
        for (place, (pane, input)) in panes.iter().zip(scenes).enumerate() {
            let size = [pane.rect.width(), pane.rect.height()].map(|v| (v * fineness).round().max(1.0) as u32);
            let rest = self.sights.scene.rest.clone();
            let callback =
                SceneCallback { input, size, quality: self.quality(), samples: self.samples(), pane: place, rest };
            ui.painter().add(egui_wgpu::Callback::new_paint_callback(pane.rect, callback));
        }
        self.draw_ways(ui, layout, &options, fineness);
        if let [_, field] = panes {
            let line = [field.free.left_top(), field.free.left_bottom()];
            ui.painter().line_segment(line, Stroke::new(2.0, theme::of(ui).solid));
        }
    }

    pub(crate) fn shown_pose(&self) -> Option<(Pose, &Piece)> {
        let piece = self.session.shown_piece()?;
        let pose = self.places().piece(&self.session.kitchen, piece);
        Some((pose, piece))
    }

    /// Where the middle of the piece of the panels appears in a window.
    pub fn shown_on_screen(&self, window: Rect) -> Option<Pos2> {
        self.on_screen(self.shown_pose()?.0.position, window)
    }

    /// Where the middle of a piece appears in a window.
    pub fn piece_on_screen(&self, id: &str, window: Rect) -> Option<Pos2> {
        let kitchen = &self.session.kitchen;
        self.on_screen(self.places().piece(kitchen, kitchen.piece(id)?).position, window)
    }

    /// Where a point of the scene appears in a window [m].
    pub fn on_screen(&self, point: Vec3, window: Rect) -> Option<Pos2> {
        let ndc = self.eye().project(point, window.width() / window.height())?;
        Some(on_screen(ndc, window))
    }

    /// Where the foot and the knob of the cut's handle appear in a window.
    pub fn cut_handle_on_screen(&self, window: Rect) -> Option<[Pos2; 2]> {
        let (slice, (pose, piece)) = (self.sights.slice?, self.shown_pose()?);
        let lengthwise = piece.model.size()[0] >= piece.model.size()[1];
        let height = 0.5 * piece.model.thickness(&piece.state) as f32;
        let place = along(&pose.matrix(), lengthwise, slice as f32 * half_length(piece) as f32) + Vec3::Z * height;
        let aspect = window.width() / window.height();
        let foot = self.eye().project(place, aspect)?;
        let knob = self.eye().project(place + Vec3::Z * KNOB_HEIGHT, aspect)?;
        Some([on_screen(foot, window), on_screen(knob, window)])
    }

    /// The cut's handle: a knob above the cut that is dragged along the steak.
    fn show_slice_handle(&mut self, ui: &mut Ui, pane: &Pane) {
        let rect = pane.rect;
        let (Some(slice), Some([foot, knob])) = (self.sights.slice, self.cut_handle_on_screen(rect)) else { return };
        let response = ui.interact(
            Rect::from_center_size(knob, vec2(44.0, 44.0)),
            ui.scope_id().with(("cut", pane.look)),
            Sense::click_and_drag(),
        );
        response.widget_info(|| egui::WidgetInfo::slider(true, slice, self.settings.language.text("scene.cut")));
        if let (true, Some(at)) = (response.dragged(), response.interact_pointer_pos()) {
            self.drag_cut(at, rect);
        }
        let fill = if response.hovered() || response.dragged() { theme::of(ui).accent } else { theme::of(ui).text };
        ui.painter().line_segment([foot, knob], Stroke::new(2.0, fill));
        ui.painter().circle(knob, 11.0, fill, Stroke::new(2.0, theme::of(ui).ground));
        for side in [-1.0, 1.0] {
            let tip = knob + vec2(side * 6.0, 0.0);
            let back = |dy: f32| knob + vec2(side * 2.0, dy);
            ui.painter().line_segment([tip, back(-3.5)], Stroke::new(1.5, theme::of(ui).on_accent));
            ui.painter().line_segment([tip, back(3.5)], Stroke::new(1.5, theme::of(ui).on_accent));
        }
    }
}

impl SauteApp {
    fn drag_cut(&mut self, at: Pos2, rect: Rect) {
        let Some((pose, piece)) = self.shown_pose() else { return };
        let (origin, direction) = self.eye().ray(ndc(at, rect), rect.width() / rect.height());
        let height = pose.position.z + 0.5 * piece.model.thickness(&piece.state) as f32 + KNOB_HEIGHT;
        let Some(hit) = meet_height(origin, direction, height) else { return };
        let local = pose.matrix().inverse().transform_point3(hit);
        let lengthwise = piece.model.size()[0] >= piece.model.size()[1];
        let s = if lengthwise { local.x } else { local.y } / half_length(piece) as f32;
        self.sights.slice = Some(f64::from(s.clamp(-0.95, 0.95)));
    }
}

fn along(world: &Mat4, lengthwise: bool, distance: f32) -> Vec3 {
    world.transform_point3(if lengthwise { Vec3::X * distance } else { Vec3::Y * distance })
}
