//! A curve of a plot.

use egui::Color32;
use egui_plot::{Line, LineStyle, PlotPoints};

/// One curve: minutes and degrees in the chosen unit.
pub(crate) struct Curve {
    pub(crate) name: String,
    /// Label at its end; empty for curves that the legend distinguishes.
    pub(crate) mark: String,
    pub(crate) colour: Color32,
    pub(crate) style: LineStyle,
    pub(crate) width: f32,
    pub(crate) points: Vec<[f64; 2]>,
}

impl Curve {
    /// A part of it that is drawn as a line.
    pub(crate) fn line<'a>(&self, points: &[[f64; 2]], colour: Color32) -> Line<'a> {
        let line = Line::new(self.name.clone(), PlotPoints::from(points.to_vec()));
        line.color(colour).style(self.style).width(self.width)
    }
}
