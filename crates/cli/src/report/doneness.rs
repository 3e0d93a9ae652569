//! Doneness bars: each class has a colour, a pattern and a number.

use maud::{Markup, html};
use saute_kitchen::doneness::ScaleChoice;
use saute_kitchen::food::Scale;
use saute_kitchen::food::change::doneness::Measure;
use saute_picture::colour::hatch::{DOT, INK, LINE, PERIOD, Pattern};
use saute_picture::colour::map::Tone;
use saute_recipe::Summary;
use saute_recipe::summary::{ClassShares, FoodSummary, ScaleReading};

use crate::wording;

/// Narrower parts of a bar have no room for their number [%].
const ROOM_FOR_NUMBER: f64 = 15.0;

/// Returns the class of a tone in the style sheet.
fn css(tone: Tone) -> &'static str {
    match tone {
        Tone::Raw => "raw",
        Tone::Rare => "rare",
        Tone::MediumRare => "medium-rare",
        Tone::Medium => "medium",
        Tone::WellDone => "well-done",
    }
}

/// Returns the rules of the style sheet for the tones, in the colours and with the patterns of the doneness view.
pub fn style() -> String {
    let rule = |tone: &Tone| {
        let ([r, g, b], name) = (tone.colour(), css(*tone));
        let colour = format!(".{name} {{ background-color: rgb({r} {g} {b}); }}\n");
        format!("{colour}.pattern.{name} {{ {} }}\n", hatch(tone.pattern()))
    };
    Tone::of_scale(saute_kitchen::food::change::doneness::MOST_CLASSES).iter().map(rule).collect()
}

/// Returns a pattern as rules of a style sheet: that of the window's swatches, on the same grid and with the same ink.
fn hatch(pattern: Pattern) -> String {
    let ink = format!("rgb(0 0 0 / {INK})");
    let lines = |degrees: u16, apart: f64| {
        format!("repeating-linear-gradient({degrees}deg, {ink} 0 {LINE}px, transparent {LINE}px {apart:.2}px)")
    };
    let slant = PERIOD / std::f64::consts::SQRT_2;
    let dot =
        |x: f64, y: f64| format!("radial-gradient(circle at {x}px {y}px, {ink} {DOT}px, transparent {}px)", DOT + 0.5);
    match pattern {
        Pattern::Plain => "background-image: none;".to_owned(),
        Pattern::Dots => {
            let dots = [dot(0.25 * PERIOD, 0.375 * PERIOD), dot(0.75 * PERIOD, 1.125 * PERIOD)].join(", ");
            format!("background-image: {dots}; background-size: {PERIOD}px {}px;", 1.5 * PERIOD)
        }
        Pattern::Levels => format!("background-image: {};", lines(180, 0.625 * PERIOD)),
        Pattern::Diagonal => format!("background-image: {};", lines(135, slant)),
        Pattern::Cross => format!("background-image: {}, {};", lines(135, slant), lines(45, slant)),
    }
}

/// Returns bars for all foods that a scale covers, each in its own words, for groups the means; nothing if there is none.
pub fn section(summary: &Summary, scales: &ScaleChoice) -> Markup {
    let entries = summary.foods_and_groups();
    let covered = || entries.iter().filter_map(|t| Some((t.food, spoken(t.food, scales)?)));
    html! {
        @if covered().next().is_some() {
            section {
                h2 { "Doneness" }
                @for (food, (scale, reading)) in covered() {
                    p { (measured(scale)) }
                    (bars(food, reading, scale))
                }
            }
        }
    }
}

/// Returns the scale in whose words a food is spoken of, with the reading by it.
fn spoken<'a>(food: &'a FoodSummary, scales: &'a ScaleChoice) -> Option<(&'a Scale, &'a ScaleReading)> {
    let (id, reading) = food.doneness.in_words_of(scales.chosen())?;
    Some((scales.by_id(id)?, reading))
}

/// Returns what a scale measures.
fn measured(scale: &Scale) -> String {
    match scale.measure() {
        Measure::Peak => {
            format!("By the highest temperature that each point has reached, on the scale of {}.", scale.name)
        }
        Measure::Share => {
            format!("By how far the {} of each point has changed, on the scale of {}.", scale.for_change, scale.name)
        }
    }
}

fn bars(food: &FoodSummary, reading: &ScaleReading, scale: &Scale) -> Markup {
    html! {
        (bar(html! { "Cross-section of " (food.id) ", by area (scale: " (reading.label) "); core: " (reading.class) }, &reading.section_pct, scale))
        (bar(html! { "All of " (food.id) ", by volume (scale: " (reading.label) ")" }, &reading.volume_pct, scale))
    }
}

fn bar(title: Markup, shares: &ClassShares, scale: &Scale) -> Markup {
    let parts = || shares.0.iter().enumerate().map(|(place, part)| (place, css(Tone::of(scale, place)), part));
    html! {
        figure.doneness {
            figcaption { (title) }
            div.bar aria-hidden="true" {
                @for (_, tone, (_, share)) in parts() {
                    span class={ "pattern " (tone) } style=(format!("flex-grow:{share:.3}")) {
                        @if *share >= ROOM_FOR_NUMBER { b class=(tone) { (format!("{share:.0} %")) } }
                    }
                }
            }
            ul {
                @for (place, tone, (name, share)) in parts() {
                    li {
                        i class={ "pattern " (tone) } {}
                        b { (format!("{share:.1} %")) } " " (name) " " (wording::class_range(scale, place))
                    }
                }
            }
        }
    }
}
