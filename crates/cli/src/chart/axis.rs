//! The axes of a panel: grid, labels and the names of the quantities.

use std::fmt::Write;

use super::escaped::escaped;
use super::scale::Scale;

/// One coordinate system within a chart.
#[derive(Clone, Debug)]
pub struct Panel {
    /// Horizontal scale.
    pub x: Scale,
    /// Vertical scale.
    pub y: Scale,
    /// Left, right, top, bottom [px].
    pub edges: [f64; 4],
}

/// Where a horizontal axis has its labels.
#[derive(Clone, Copy, Debug)]
pub struct Ticks {
    /// First and last value.
    pub range: [f64; 2],
    /// From label to label.
    pub step: f64,
}

impl Panel {
    /// Returns horizontal grid lines with their values at the left and the quantity above them.
    pub fn y_axis(&self, range: [f64; 2], step: f64, title: &str) -> String {
        let [left, right, top, _] = self.edges;
        let mut svg = quantity([left, top - 7.0], title);
        let count = ((range[1] - range[0]) / step).round() as usize;
        for i in 0..=count {
            let value = range[0] + i as f64 * step;
            let y = self.y.at(value);
            // Writing to a string cannot fail.
            let _ = write!(svg, "<path class=\"grid\" d=\"M{left:.1} {y:.1}H{right:.1}\"/>");
            svg += &label("end", [left - 6.0, y + 4.0], &format!("{value:.0}"));
        }
        svg
    }

    /// Returns the labels below the panel, worded by `word`, and the quantity below them.
    pub fn x_axis(
        &self,
        Ticks { range: [from, to], step }: Ticks,
        word: impl Fn(f64) -> String,
        title: &str,
    ) -> String {
        let [_, right, _, bottom] = self.edges;
        let mut svg = String::new();
        let count = ((to - from) / step + 1e-9).floor() as usize;
        for i in 0..=count {
            let value = from + i as f64 * step;
            let x = self.x.at(value);
            // Writing to a string cannot fail.
            let _ = write!(svg, "<path class=\"grid\" d=\"M{x:.1} {bottom:.1}v4\"/>");
            svg += &label("middle", [x, bottom + 17.0], &word(value));
        }
        svg + &label("end", [right, bottom + 33.0], title)
    }
}

/// Returns the name of a quantity, whose text begins at a position [px].
pub fn quantity([x, y]: [f64; 2], name: &str) -> String {
    format!("<text class=\"quantity\" x=\"{x:.0}\" y=\"{y:.1}\">{}</text>", escaped(name))
}

/// Returns a label whose start, middle or end is at a position [px].
fn label(anchor: &str, [x, y]: [f64; 2], text: &str) -> String {
    format!("<text class=\"tick\" text-anchor=\"{anchor}\" x=\"{x:.1}\" y=\"{y:.1}\">{}</text>", escaped(text))
}
