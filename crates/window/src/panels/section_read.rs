//! The section of the piece that the panels show, and what was read with it.

use crate::panels::cut_picture::CutPicture;
use egui::Ui;
use saute_controls::context::PanelContext;
use saute_kitchen::Piece;
use saute_kitchen::food::{Scale, Shares};

/// What the panel keeps between frames.
#[derive(Default)]
pub struct Inside {
    pub(crate) cut: CutPicture,
    /// Doneness of the section, in the words of the food.
    pub(crate) shares: Shares,
    /// Names and mean shares of what heat has changed.
    pub(crate) changed: Vec<(String, f64)>,
    /// Hardness over that of the raw food [-] and juiciness [%].
    pub(crate) bite: [f64; 2],
}

impl Inside {
    /// Reads everything again where the cut, which is at a place (−1…1), is painted again.
    pub(crate) fn refresh(&mut self, state: &PanelContext, piece: &Piece, cut_at: f64, ui: &Ui) {
        if self.cut.refresh(state, piece, cut_at, ui) {
            self.read(piece, state.scale().as_deref());
        }
    }

    pub(crate) fn read(&mut self, piece: &Piece, scale: Option<&Scale>) {
        let (model, now) = (&piece.model, &piece.state);
        let means = now.changed.iter().map(|field| model.volume_mean(field));
        self.shares = scale.map(|s| model.cut_shares(now, &model.cut_across(0.0), s)).unwrap_or_default();
        self.changed = model.kinetics().names().into_iter().map(str::to_owned).zip(means).collect();
        self.bite = [model.hardness_index(now), model.juiciness_pct(now)];
    }
}
