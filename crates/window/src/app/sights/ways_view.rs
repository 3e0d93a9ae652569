//! Ways side by side: when they are shown, and the pans of those next to the one that goes on.

use crate::app::SauteApp;
use crate::app::frame::step_budget;
use crate::paint::scene::SceneCallback;
use crate::panels::memory::Drawer;
use crate::panels::ways::displayed;
use crate::ui::layout::Layout;
use egui::Ui;
use saute_picture::stage::{Places, StageOptions};
use std::sync::Arc;
use web_time::Duration;

/// Longest that a frame may spend on the ways next to the one that goes on while that one is computed too [ms] (chosen: a frame stays
/// below a twentieth of a second).
const BESIDE_MS: u64 = 8;

impl SauteApp {
    /// Returns true while ways are shown side by side.
    pub fn shows_ways(&self) -> bool {
        self.sights.ways.on && self.session.has_branches() && !self.photo_is_open()
    }

    /// Shows all ways side by side, or the one that goes on alone.
    pub(crate) fn toggle_ways(&mut self) {
        if !self.session.has_branches() {
            self.sights.ways.on = false;
            return self.say("ways.none");
        }
        self.sights.ways.on = !self.sights.ways.on;
        if self.sights.ways.on {
            // A narrow window has the curves there.
            self.desk.memory.drawer = Drawer::Inside;
        }
    }

    /// Lets the ways next to the one that goes on follow it, for a part of a frame.
    pub(crate) fn keep_ways_beside(&mut self, wall_s: f64) {
        self.follow_way();
        if !self.shows_ways() {
            self.session.forget_beside();
            self.sights.ways.catch_up = false;
            return;
        }
        let is_idle = self.session.paused && !self.session.is_travelling();
        let budget = if is_idle { step_budget(wall_s, false) } else { Duration::from_millis(BESIDE_MS) };
        self.sights.ways.catch_up = self.session.keep_beside(budget);
    }

    /// The skins of the window's own stage are those of the way that goes on.
    fn follow_way(&mut self) {
        let ids: Vec<u64> = self.session.all_ways().map(|way| way.id).collect();
        let live = self.session.way().id;
        if live != self.sights.ways.live {
            let before = std::mem::replace(&mut self.sights.ways.live, live);
            // A new way begins where the last one is left: it looks the same.
            let own = self.sights.ways.stages.remove(&live).unwrap_or_else(|| self.sights.stage.clone());
            self.sights.ways.stages.insert(before, std::mem::replace(&mut self.sights.stage, own));
        }
        self.sights.ways.stages.retain(|id, _| ids.contains(id) && *id != live);
    }

    /// Gives ways side by side their places.
    pub(crate) fn lay_out_ways(&self, layout: Layout) -> Layout {
        if !self.shows_ways() || layout.tiny {
            return layout;
        }
        let live = self.session.way();
        let before = self.session.all_ways().filter(|way| way.slot < live.slot).count();
        layout.with_ways(self.session.all_ways().count(), before)
    }

    /// Draws the pans of the ways next to the one that goes on.
    pub(crate) fn draw_ways(&mut self, ui: &Ui, layout: &Layout, options: &StageOptions, fineness: f32) {
        let Some(places) = &layout.ways else { return };
        let quality = self.quality();
        let ways = self.session.ways();
        let shown = displayed(&ways, &self.desk.memory.ways, places.columns().len());
        let beside = shown.iter().zip(places.columns()).filter(|(way, _)| way.place.is_some());
        for (pane, (way, column)) in (1..).zip(beside) {
            let stage = self.sights.ways.stages.entry(way.way.id).or_default();
            let input = Arc::new(stage.scene(way.kitchen, options, &Places::default()));
            let size = [column.picture.width(), column.picture.height()];
            let size = size.map(|points| (points * fineness).round().max(1.0) as u32);
            let callback =
                SceneCallback { input, size, quality, samples: 1, pane, rest: self.sights.scene.rest.clone() };
            ui.painter().add(egui_wgpu::Callback::new_paint_callback(column.picture, callback));
        }
    }
}
