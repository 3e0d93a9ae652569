//! Lines in a panel: curves, and levels that bound them.

use std::fmt::Write;

use super::axis::Panel;

impl Panel {
    /// Returns a curve through points.
    pub fn curve(&self, class: &str, points: impl Iterator<Item = (f64, f64)>) -> String {
        let mut path = String::new();
        for (x, y) in points {
            // Writing to a string cannot fail.
            let _ = write!(path, "{}{:.1} {:.1}", if path.is_empty() { "M" } else { "L" }, self.x.at(x), self.y.at(y));
        }
        format!("<path class=\"curve {class}\" d=\"{path}\"/>")
    }

    /// Returns a dashed line at a value, from edge to edge.
    pub fn bound(&self, value: f64) -> String {
        let [left, right, ..] = self.edges;
        format!("<path class=\"bound\" d=\"M{left:.0} {:.1}H{right:.0}\"/>", self.y.at(value))
    }
}
