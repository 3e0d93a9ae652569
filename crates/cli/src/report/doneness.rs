//! Doneness bars: colour, pattern and number say the same.

use saute_app::colour_map::Tone;
use saute_kitchen::food::Scale;
use saute_recipe::Summary;
use saute_recipe::summary::{ClassShares, FoodSummary};

use super::markup::escaped;
use crate::wording;

/// Narrower parts have no room for their number [%].
const ROOM_FOR_NUMBER: f64 = 15.0;

/// Class of a tone in the style sheet.
fn css(tone: Tone) -> &'static str {
    match tone {
        Tone::Raw => "raw",
        Tone::Rare => "rare",
        Tone::MediumRare => "medium-rare",
        Tone::Medium => "medium",
        Tone::WellDone => "well-done",
    }
}

/// The app's colours of the classes, for the style sheet.
pub fn style() -> String {
    let rule = |tone: &Tone| {
        let [r, g, b] = tone.colour();
        format!(".{} {{ background-color: rgb({r} {g} {b}); }}\n", css(*tone))
    };
    Tone::of_scale(saute_kitchen::food::doneness::MOST_CLASSES).iter().map(rule).collect()
}

/// Bars of all foods about which the scale says anything; of a group the means.
pub fn section(summary: &Summary, scale: &Scale) -> String {
    let bars: String = summary.told().iter().map(|t| bars(t.food, scale)).collect();
    if bars.is_empty() {
        return String::new();
    }
    format!(
        "<section><h2>Doneness</h2><p>By the highest temperature that each point has reached, on the scale of {}.</p>{bars}</section>",
        escaped(&scale.name)
    )
}

fn bars(food: &FoodSummary, scale: &Scale) -> String {
    let Some(reading) = food.doneness.get(&scale.id) else { return String::new() };
    let (id, label, class) = (escaped(&food.id), escaped(&reading.label), escaped(&reading.class));
    let section = format!("Cross-section of {id}, by area (scale: {label}); core: {class}");
    let volume = format!("All of {id}, by volume (scale: {label})");
    bar(&section, &reading.section_pct, scale) + &bar(&volume, &reading.volume_pct, scale)
}

fn bar(title: &str, shares: &ClassShares, scale: &Scale) -> String {
    let (mut parts, mut keys) = (String::new(), String::new());
    for (place, (name, share)) in shares.0.iter().enumerate() {
        let tone = css(Tone::of(scale, place));
        let number =
            if *share >= ROOM_FOR_NUMBER { format!("<b class=\"{tone}\">{share:.0} %</b>") } else { String::new() };
        parts += &format!("<span class=\"pattern {tone}\" style=\"flex-grow:{share:.3}\">{number}</span>");
        let (name, range) = (escaped(name), escaped(&wording::class_range(scale, place)));
        keys += &format!("<li><i class=\"pattern {tone}\"></i><b>{share:.1} %</b> {name} {range}</li>");
    }
    format!(
        "<figure class=\"doneness\"><figcaption>{title}</figcaption><div class=\"bar\" aria-hidden=\"true\">{parts}</div><ul>{keys}</ul></figure>"
    )
}
