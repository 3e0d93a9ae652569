//! A chart: curves of the model with expected values as rings and expected ranges as bars.

use std::fmt::Write;

use crate::report::plot::{Panel, Scale, escaped, nice_range, nice_step};

/// Size of a picture [px].
pub const SIZE: [f64; 2] = [720.0, 400.0];
/// Edges of the panel: left, right, top, bottom [px].
pub const EDGES: [f64; 4] = [52.0, 470.0, 46.0, 350.0];
/// Colours of curves that colour-blind readers can distinguish (source: Okabe & Ito 2008 `[@okabe-ito-2008]`).
pub const COLOURS: [&str; 6] = ["#0072b2", "#d55e00", "#009e73", "#cc79a7", "#e69f00", "#56b4e9"];
/// Style sheet of a picture.
const STYLE: &str = "text{font:12px sans-serif;fill:#222}.grid{stroke:#ddd;fill:none}.curve{fill:none;stroke-width:1.6}\
     .title{font-weight:bold}.bound{stroke:#999;stroke-dasharray:4 3;fill:none}";

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

/// A chart.
pub struct Chart<'a> {
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

impl Chart<'_> {
    /// Draws it.
    pub fn svg(&self) -> String {
        let (panel, range, [step, x_step], end) = self.panel();
        let [x_title, y_title] = self.axes;
        let mut svg = panel.y_axis(range, step, y_title) + &panel.x_axis([self.from, end], x_step, 1.0, x_title);
        let top = EDGES[2];
        for (row, curve) in self.curves.iter().enumerate() {
            svg += &curve_with_legend(&panel, curve, top + 18.0 * row as f64);
        }
        self.ranges
            .iter()
            .for_each(|bar| range_bar(&mut svg, panel.x.at(bar[0]), [bar[1], bar[2]].map(|v| panel.y.at(v))));
        self.rings.iter().for_each(|[x, y]| ring(&mut svg, panel.x.at(*x), panel.y.at(*y)));
        self.expected_in_legend(&mut svg, top + 18.0 * self.curves.len() as f64);
        page(self.title, &svg)
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

    /// Adds what rings and bars are.
    fn expected_in_legend(&self, svg: &mut String, mut y: f64) {
        let x = EDGES[1] + 24.0;
        for (is_there, name) in [(!self.rings.is_empty(), "expected"), (!self.ranges.is_empty(), "expected range")] {
            if !is_there {
                continue;
            }
            if name == "expected" {
                ring(svg, x, y)
            } else {
                range_bar(svg, x, [y + 7.0, y - 7.0])
            }
            let _ = write!(svg, "<text x=\"{:.0}\" y=\"{:.0}\">{name}</text>", x + 18.0, y + 4.0);
            y += 18.0;
        }
    }
}

fn ring(svg: &mut String, x: f64, y: f64) {
    let _ = write!(svg, "<circle cx=\"{x:.1}\" cy=\"{y:.1}\" r=\"4\" fill=\"none\" stroke=\"#222\"/>");
}

fn range_bar(svg: &mut String, x: f64, [low, high]: [f64; 2]) {
    let _ = write!(
        svg,
        "<path stroke=\"#222\" fill=\"none\" d=\"M{x:.1} {low:.1}V{high:.1}M{0:.1} {low:.1}h8M{0:.1} {high:.1}h8\"/>",
        x - 4.0
    );
}

/// Draws a curve and its entry in the legend at the height `y` [px].
fn curve_with_legend(panel: &Panel, curve: &Curve, y: f64) -> String {
    let colour = COLOURS[curve.colour % COLOURS.len()];
    let dashes = if curve.dashed { " stroke-dasharray=\"6 4\"" } else { "" };
    let path = panel.curve("", curve.series.iter().map(|p| (p[0], p[1])));
    let right = EDGES[1];
    format!(
        "<g stroke=\"{colour}\"{dashes}>{path}<path class=\"curve\" d=\"M{:.0} {y:.0}h24\"/></g><text x=\"{:.0}\" y=\"{:.0}\">{}</text>",
        right + 12.0,
        right + 42.0,
        y + 4.0,
        escaped(&curve.name)
    )
}

/// Returns a picture with a title.
pub fn page(title: &str, inside: &str) -> String {
    let [width, height] = SIZE;
    let title = escaped(title);
    format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {width} {height}\" width=\"{width}\" height=\"{height}\" role=\"img\" \
         aria-label=\"{title}\"><style>{STYLE}</style><rect width=\"100%\" height=\"100%\" fill=\"#fff\"/>\
         <text class=\"title\" x=\"16\" y=\"20\">{title}</text>{inside}</svg>\n"
    )
}
