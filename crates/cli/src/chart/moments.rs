//! Named moments on a horizontal axis.

use std::fmt::Write;

use super::escaped::escaped;
use super::scale::Scale;

/// Width of a letter [px] (chosen: wide enough for every usual font of 12 px).
const LETTER: f64 = 7.4;

/// One named moment.
#[derive(Clone, Debug)]
pub struct Moment {
    /// Where on the axis.
    pub at: f64,
    /// Short name above the line.
    pub name: String,
    /// Full text of the tooltip.
    pub tooltip: String,
}

/// Returns vertical lines from `top` to `bottom` at moments; a name that would overlap the one before is left out.
pub fn moments(x: Scale, right: f64, [top, bottom]: [f64; 2], moments: &[Moment]) -> String {
    let mut svg = String::new();
    let mut free_from = f64::NEG_INFINITY;
    for Moment { at, name, tooltip } in moments {
        let (at, name, tooltip) = (x.at(*at), escaped(name), escaped(tooltip));
        // Writing to a string cannot fail.
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
