//! Doneness bars: colour, pattern and number say the same.

use saute_app::colour_map::CLASS_COLOURS;
use saute_kitchen::Summary;
use saute_kitchen::summary::Doneness;

use super::markup::escaped;

/// Class in the style sheet, name and range of each doneness.
const CLASSES: [(&str, &str, &str); 4] = [
    ("raw", "raw", "&lt; 50 °C"),
    ("rare", "rare", "50–60 °C"),
    ("medium", "medium", "60–70 °C"),
    ("well-done", "well-done", "&gt; 70 °C"),
];

/// Narrower parts have no room for their number [%].
const ROOM_FOR_NUMBER: f64 = 15.0;

/// The app's colours of the classes, for the style sheet.
pub fn style() -> String {
    let rule = |((name, ..), [r, g, b]): (&(&str, &str, &str), &[u8; 3])| {
        format!(".{name} {{ background-color: rgb({r} {g} {b}); }}\n")
    };
    CLASSES.iter().zip(&CLASS_COLOURS).map(rule).collect()
}

/// Bars of all foods.
pub fn section(summary: &Summary) -> String {
    let bars: String = summary
        .foods
        .iter()
        .flat_map(|f| {
            let id = escaped(&f.id);
            [
                bar(&format!("Cross-section of {id}, by area"), &f.section_pct),
                bar(&format!("All of {id}, by volume"), &f.volume_pct),
            ]
        })
        .collect();
    format!("<section><h2>Doneness</h2><p>By the highest temperature that each point has reached.</p>{bars}</section>")
}

fn bar(title: &str, shares: &Doneness) -> String {
    let values = [shares.raw, shares.rare, shares.medium, shares.well_done];
    let part = |((name, ..), share): (&(&str, &str, &str), &f64)| {
        let number =
            if *share >= ROOM_FOR_NUMBER { format!("<b class=\"{name}\">{share:.0} %</b>") } else { String::new() };
        format!("<span class=\"pattern {name}\" style=\"flex-grow:{share:.3}\">{number}</span>")
    };
    let key = |((name, said, range), share): (&(&str, &str, &str), &f64)| {
        format!("<li><i class=\"pattern {name}\"></i><b>{share:.1} %</b> {said} {range}</li>")
    };
    let parts: String = CLASSES.iter().zip(&values).map(part).collect();
    let keys: String = CLASSES.iter().zip(&values).map(key).collect();
    format!(
        "<figure class=\"doneness\"><figcaption>{title}</figcaption><div class=\"bar\" aria-hidden=\"true\">{parts}</div><ul>{keys}</ul></figure>"
    )
}
