//! A chart in a page: its legend, and the drawing for a desktop and for a phone.

use maud::{Markup, PreEscaped, html};

/// Widths of the drawing on a desktop and on a phone [px]: letters of one scaled drawing would be too small to read.
const WIDTHS: [(&str, f64); 2] = [("wide", 760.0), ("narrow", 350.0)];

/// What a chart shows.
#[derive(Debug)]
pub struct Figure<'a> {
    /// Class in the style sheet and name of each entry of the legend.
    pub legend: &'a [(&'a str, String)],
    /// What a screen reader reads in place of the drawing.
    pub label: &'a str,
    /// Description in the drawing, which a pointer over it shows.
    pub title: Option<String>,
    /// Height of the drawing [px].
    pub height: f64,
}

impl Figure<'_> {
    /// Returns the chart with the elements that `inside` draws for a width [px]; a caption may follow.
    pub fn markup(&self, inside: impl Fn(f64) -> String, caption: Option<&str>) -> Markup {
        html! {
            figure.plot {
                ul.legend { @for (class, name) in self.legend { (entry(class, name)) } }
                @for (class, width) in WIDTHS {
                    svg class=(class) viewBox={ "0 0 " (width) " " (self.height) } role="img" aria-label=(self.label) {
                        @if let Some(title) = &self.title { title { (title) } }
                        (PreEscaped(inside(width)))
                    }
                }
                @if let Some(caption) = caption { figcaption { (caption) } }
            }
        }
    }
}

fn entry(class: &str, name: &str) -> Markup {
    html! {
        li {
            svg viewBox="0 0 28 8" aria-hidden="true" { path class={ "curve " (class) } d="M1 4H27" {} }
            (name)
        }
    }
}
