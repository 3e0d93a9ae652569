//! Curves of the model with expected values as rings and expected ranges as bars, in a separate file.

use super::axis::{Panel, Ticks};
use super::bars;
use super::escaped::escaped;
use super::picture::{COLOURS, EDGES, picture};
use super::points;
use super::scale::{Scale, nice_range, nice_step};

/// A named curve.
pub struct Curve {
    /// Name in the legend.
    pub name: String,
    /// Points.
    pub series: Vec<[f64; 2]>,
    /// True for a dashed line.
    pub dashed: bool,
    /// Index of the colour.
    pub colour: usize,
}

/// Curves with what is expected of them.
pub struct CurveChart<'a> {
    /// Title.
    pub title: &'a str,
    /// Quantities with their units: across, upwards.
    pub axes: [&'a str; 2],
    /// Where the horizontal axis starts.
    pub from: f64,
    /// Curves.
    pub curves: Vec<Curve>,
    /// Expected values.
    pub rings: Vec<[f64; 2]>,
    /// Expected ranges: where, lowest, highest.
    pub ranges: Vec<[f64; 3]>,
}

impl CurveChart<'_> {
    /// Draws it.
    pub fn svg(&self) -> String {
        let (panel, range, [step, x_step], end) = self.panel();
        let [x_title, y_title] = self.axes;
        let ticks = Ticks { range: [self.from, end], step: x_step };
        let mut svg = panel.y_axis(range, step, y_title) + &panel.x_axis(ticks, |value| value.to_string(), x_title);
        let top = EDGES[2];
        for (row, curve) in self.curves.iter().enumerate() {
            svg += &curve_with_legend(&panel, curve, top + 18.0 * row as f64);
        }
        for [x, low, high] in &self.ranges {
            svg += &bars::range(panel.x.at(*x), [*low, *high].map(|v| panel.y.at(v)));
        }
        self.rings.iter().for_each(|[x, y]| svg += &points::ring([panel.x.at(*x), panel.y.at(*y)]));
        svg += &self.expected_in_legend(top + 18.0 * self.curves.len() as f64);
        picture(self.title, &svg)
    }

    /// Returns the panel, the range of its vertical axis, the steps upwards and across, and the right end.
    fn panel(&self) -> (Panel, [f64; 2], [f64; 2], f64) {
        let ends = self.ranges.iter().flat_map(|[x, low, high]| [[*x, *low], [*x, *high]]);
        let points = || self.curves.iter().flat_map(|c| &c.series).chain(&self.rings).copied();
        let all: Vec<[f64; 2]> = points().chain(ends).collect();
        let end = all.iter().map(|v| v[0]).fold(self.from, f64::max);
        let (low, high) = all.iter().fold((f64::MAX, f64::MIN), |(l, h), v| (l.min(v[1]), h.max(v[1])));
        let (range, step) = nice_range(low, high, 6.0);
        let [left, right, top, bottom] = EDGES;
        let x = Scale::new([self.from, end], [left, right]);
        let panel = Panel { x, y: Scale::new(range, [bottom, top]), edges: EDGES };
        (panel, range, [step, nice_step(end - self.from, 6.0)], end)
    }

    /// Returns what rings and bars are, from a height [px] on.
    fn expected_in_legend(&self, y: f64) -> String {
        let x = EDGES[1] + 24.0;
        let name = |name, y: f64| name_in_legend([x + 18.0, y + 4.0], name);
        let mut svg = String::new();
        let mut below = y;
        if !self.rings.is_empty() {
            svg += &(points::ring([x, y]) + &name("expected", y));
            below += 18.0;
        }
        if !self.ranges.is_empty() {
            svg += &(bars::range(x, [below + 7.0, below - 7.0]) + &name("expected range", below));
        }
        svg
    }
}

/// Draws a curve and its entry in the legend at the height `y` [px].
fn curve_with_legend(panel: &Panel, curve: &Curve, y: f64) -> String {
    let colour = COLOURS[curve.colour % COLOURS.len()];
    let dashes = if curve.dashed { " stroke-dasharray=\"6 4\"" } else { "" };
    let path = panel.curve("", curve.series.iter().map(|p| (p[0], p[1])));
    let right = EDGES[1];
    let sign = format!("<path class=\"curve\" d=\"M{:.0} {y:.0}h24\"/>", right + 12.0);
    format!("<g stroke=\"{colour}\"{dashes}>{path}{sign}</g>") + &name_in_legend([right + 42.0, y + 4.0], &curve.name)
}

fn name_in_legend([x, y]: [f64; 2], name: &str) -> String {
    format!("<text x=\"{x:.0}\" y=\"{y:.0}\">{}</text>", escaped(name))
}
