//! Charts as SVG: scales, axes and what is drawn on them. A chart of a page takes its colours from the style of the page; a chart
//! in a separate file has its own style.

pub mod axis;
pub mod bars;
pub mod curve_chart;
pub mod escaped;
pub mod figure;
pub mod line;
pub mod moments;
pub mod picture;
pub mod points;
pub mod scale;
