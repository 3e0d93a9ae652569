//! A chart in a separate file, with its own style.

use super::escaped::escaped;

/// Size of a picture [px].
pub const SIZE: [f64; 2] = [720.0, 400.0];
/// Edges of the panel next to a legend: left, right, top, bottom [px].
pub const EDGES: [f64; 4] = [52.0, 470.0, 46.0, 350.0];
/// Colours of curves that colour-blind readers can distinguish (source: Okabe & Ito 2008 `[@okabe-ito-2008]`).
pub const COLOURS: [&str; 6] = ["#0072b2", "#d55e00", "#009e73", "#cc79a7", "#e69f00", "#56b4e9"];
/// Style sheet of a picture.
const STYLE: &str = "text{font:12px sans-serif;fill:#222}.grid{stroke:#ddd;fill:none}.curve{fill:none;stroke-width:1.6}\
     .title{font-weight:bold}.bound{stroke:#999;stroke-dasharray:4 3;fill:none}";

/// Returns a picture with a title.
pub fn picture(title: &str, inside: &str) -> String {
    let [width, height] = SIZE;
    let title = escaped(title);
    format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {width} {height}\" width=\"{width}\" height=\"{height}\" role=\"img\" \
         aria-label=\"{title}\"><style>{STYLE}</style><rect width=\"100%\" height=\"100%\" fill=\"#fff\"/>\
         <text class=\"title\" x=\"16\" y=\"20\">{title}</text>{inside}</svg>\n"
    )
}
