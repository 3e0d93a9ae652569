//! The page of the gallery: figures with captions and the numbers of every panel.

use std::fmt::Write;

use saute_recipe::summary::FoodSummary;

use super::figure::{Book, Figure, Panel};
use super::moment::Moment;
use super::plate::moment_of;

/// Returns the page of a book as Markdown.
pub fn page(book: &Book, figures: &[&Figure], moments: &[Moment]) -> String {
    let mut text = book.opening.to_owned();
    for (number, figure) in figures.iter().enumerate() {
        let _ = write!(
            text,
            "\n## {}. {}\n\n![{}]({}.png)\n\n{}\n\n",
            number + 1,
            figure.title,
            figure.title,
            figure.name,
            figure.caption
        );
        table(&mut text, figure, moments);
    }
    text
}

fn table(text: &mut String, figure: &Figure, moments: &[Moment]) {
    text.push_str("| | cook | time | food | core °C | top °C | bottom °C | browned top, bottom % | L\\*a\\*b\\* top | mass lost % |\n");
    text.push_str("|---|---|---|---|---|---|---|---|---|---|\n");
    for (index, panel) in figure.panels.iter().enumerate() {
        let Some(moment) = moment_of(panel, moments) else { continue };
        // Panels of the same moment share their numbers.
        if figure.panels[..index].iter().any(|p| same_moment(p, panel)) {
            continue;
        }
        let letters: String =
            figure.panels.iter().zip('a'..).filter(|(p, _)| same_moment(p, panel)).map(|(_, letter)| letter).collect();
        for food in shown(moment) {
            row(text, &letters, moment, food);
        }
    }
}

fn same_moment(a: &Panel, b: &Panel) -> bool {
    a.cook == b.cook && a.after_s == b.after_s
}

/// Returns the means of the groups and the foods outside groups.
fn shown(moment: &Moment) -> impl Iterator<Item = &FoodSummary> {
    let alone = moment.summary.foods.iter().filter(|food| food.group.is_none());
    moment.summary.groups.iter().map(|group| &group.mean).chain(alone)
}

fn row(text: &mut String, letters: &str, moment: &Moment, food: &FoodSummary) {
    let [top, bottom] = [&food.surfaces.top, &food.surfaces.bottom];
    let [l, a, b] = top.lab;
    let _ = writeln!(
        text,
        "| {letters} | {} | {:.0} s | {} | {:.1} | {:.0} | {:.0} | {:.0}, {:.0} | {l:.0} {a:.0} {b:.0} | {:.1} |",
        moment.cook,
        moment.after_s,
        food.id,
        food.core_c.end,
        top.temperature_c,
        bottom.temperature_c,
        top.browned_pct,
        bottom.browned_pct,
        // Rounding must not print a minus before zero.
        food.lost_pct.max(0.0) + 0.0
    );
}
