//! Bars: lengths of values, and intervals.

use super::scale::Scale;

/// Returns a thick bar from zero to a value at a height [px].
pub fn bar(x: Scale, class: &str, value: f64, y: f64) -> String {
    let [from, to] = [0.0, value.max(0.0)].map(|v| x.at(v));
    format!(
        "<path class=\"curve {class}\" style=\"stroke-width:8;stroke-linecap:butt\" d=\"M{from:.1} {y:.1}H{to:.1}\"/>"
    )
}

/// Returns the thin line of an interval over a bar; nothing for one without a width.
pub fn interval(x: Scale, [low, high]: [f64; 2], y: f64) -> String {
    if high > low {
        let [from, to] = [low.max(0.0), high.max(0.0)].map(|v| x.at(v));
        format!("<path class=\"hob\" d=\"M{from:.1} {y:.1}H{to:.1}\"/>")
    } else {
        String::new()
    }
}

/// Returns an upright range with its ends, at a position [px].
pub fn range(x: f64, [low, high]: [f64; 2]) -> String {
    let left = x - 4.0;
    format!(
        "<path stroke=\"#222\" fill=\"none\" d=\"M{x:.1} {low:.1}V{high:.1}M{left:.1} {low:.1}h8M{left:.1} {high:.1}h8\"/>"
    )
}
