//! Plots as SVG: axes, curves, marks. Colours come from the style sheet of the page.

use std::fmt::Write;

use maud::html;

/// Returns a text with the characters escaped that HTML and SVG read as markup.
pub fn escaped(text: &str) -> String {
    html! { (text) }.into_string()
}

/// A linear map from values to pixels [px].
#[derive(Clone, Copy, Debug)]
pub struct Scale {
    from: [f64; 2],
    to: [f64; 2],
}

impl Scale {
    /// Returns the map of the range `from` onto the range `to` [px].
    pub fn new(from: [f64; 2], to: [f64; 2]) -> Self {
        Self { from, to }
    }

    /// Returns the position of a value [px].
    pub fn at(&self, value: f64) -> f64 {
        let span = (self.from[1] - self.from[0]).max(f64::MIN_POSITIVE);
        self.to[0] + (value - self.from[0]) / span * (self.to[1] - self.to[0])
    }
}

/// Returns the smallest step of 1, 2 or 5 times a power of ten that divides a span into at most `most` parts.
pub fn nice_step(span: f64, most: f64) -> f64 {
    let rough = (span / most).max(1e-9);
    let power = 10_f64.powf(rough.log10().floor());
    [1.0, 2.0, 5.0, 10.0].into_iter().map(|m| m * power).find(|s| *s >= rough * (1.0 - 1e-9)).unwrap_or(10.0 * power)
}

/// Returns the smallest range that contains both values and ends on steps, with the step; steps are whole numbers, as the
/// labels are.
pub fn nice_range(low: f64, high: f64, most: f64) -> ([f64; 2], f64) {
    let step = nice_step(high - low, most).max(1.0);
    let from = (low / step + 1e-9).floor() * step;
    let to = (high / step - 1e-9).ceil() * step;
    ([from, to.max(from + step)], step)
}

/// One coordinate system within a picture.
#[derive(Clone, Debug)]
pub struct Panel {
    /// Horizontal scale.
    pub x: Scale,
    /// Vertical scale.
    pub y: Scale,
    /// Left, right, top, bottom [px].
    pub edges: [f64; 4],
}

impl Panel {
    /// Returns horizontal grid lines with their values at the left and the quantity above them.
    pub fn y_axis(&self, range: [f64; 2], step: f64, title: &str) -> String {
        let [left, right, top, _] = self.edges;
        let mut svg = format!("<text class=\"quantity\" x=\"{left:.0}\" y=\"{:.1}\">{title}</text>", top - 7.0);
        let count = ((range[1] - range[0]) / step).round() as usize;
        for i in 0..=count {
            let value = range[0] + i as f64 * step;
            let y = self.y.at(value);
            let _ = write!(svg, "<path class=\"grid\" d=\"M{left:.1} {y:.1}H{right:.1}\"/>");
            let _ = write!(
                svg,
                "<text class=\"tick\" text-anchor=\"end\" x=\"{:.1}\" y=\"{:.1}\">{value:.0}</text>",
                left - 6.0,
                y + 4.0
            );
        }
        svg
    }

    /// Returns the tick labels below the panel and the quantity below them.
    pub fn x_axis(&self, [from, to]: [f64; 2], step: f64, per_label: f64, title: &str) -> String {
        let [_, right, _, bottom] = self.edges;
        let mut svg = String::new();
        let count = ((to - from) / step + 1e-9).floor() as usize;
        for i in 0..=count {
            let value = from + i as f64 * step;
            let x = self.x.at(value);
            let _ = write!(svg, "<path class=\"grid\" d=\"M{x:.1} {bottom:.1}v4\"/>");
            let _ = write!(
                svg,
                "<text class=\"tick\" text-anchor=\"middle\" x=\"{x:.1}\" y=\"{:.1}\">{}</text>",
                bottom + 17.0,
                value / per_label
            );
        }
        let _ = write!(
            svg,
            "<text class=\"tick\" text-anchor=\"end\" x=\"{right:.1}\" y=\"{:.1}\">{title}</text>",
            bottom + 33.0
        );
        svg
    }

    /// Returns a curve through points.
    pub fn curve(&self, class: &str, points: impl Iterator<Item = (f64, f64)>) -> String {
        let mut path = String::new();
        for (x, y) in points {
            let _ = write!(path, "{}{:.1} {:.1}", if path.is_empty() { "M" } else { "L" }, self.x.at(x), self.y.at(y));
        }
        format!("<path class=\"curve {class}\" d=\"{path}\"/>")
    }
}

/// Width of a letter [px] (chosen: wide enough for every usual font of 12 px).
const LETTER: f64 = 7.4;

/// One named moment on the time axis.
#[derive(Clone, Debug)]
pub struct Mark {
    /// When [s].
    pub time_s: f64,
    /// Short name above the line.
    pub name: String,
    /// Full text of the tooltip.
    pub tooltip: String,
}

/// Returns vertical lines from `top` to `bottom` at moments; a name that would overlap the one before is left out.
pub fn marks(x: Scale, right: f64, [top, bottom]: [f64; 2], moments: &[Mark]) -> String {
    let mut svg = String::new();
    let mut free_from = f64::NEG_INFINITY;
    for Mark { time_s, name, tooltip } in moments {
        let (at, name, tooltip) = (x.at(*time_s), escaped(name), escaped(tooltip));
        let _ = write!(svg, "<path class=\"mark\" d=\"M{at:.1} {top:.1}V{bottom:.1}\"><title>{tooltip}</title></path>");
        let width = LETTER * name.chars().count() as f64;
        let left = (at - width / 2.0).min(right - 1.0 - width);
        if left > free_from {
            let _ = write!(svg, "<text class=\"mark-name\" x=\"{left:.1}\" y=\"{:.1}\">{name}</text>", top - 5.0);
            free_from = left + width + 5.0;
        }
    }
    svg
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_title_cannot_smuggle_markup_into_the_page() {
        assert_eq!(escaped("<b>\"A & B\"</b>"), "&lt;b&gt;&quot;A &amp; B&quot;&lt;/b&gt;");
    }

    #[test]
    fn an_axis_ends_on_its_steps_and_holds_every_value() {
        for (low, high) in [(0.0, 219.6), (5.0, 58.2), (179.8, 213.8), (20.0, 20.0), (0.0, 3500.0)] {
            let (range, step) = nice_range(low, high, 5.0);
            assert!(range[0] <= low && range[1] >= high, "{low} {high}: {range:?}");
            let pieces = (range[1] - range[0]) / step;
            assert!(
                (pieces - pieces.round()).abs() < 1e-9 && step >= 1.0 && (1.0..=7.0).contains(&pieces),
                "{range:?} by {step}"
            );
        }
    }
}
