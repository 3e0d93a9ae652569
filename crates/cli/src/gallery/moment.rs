//! A cook of the gallery at one time: kitchen and numbers.

use saute_kitchen::{Kitchen, Library, Piece, TICK_S};
use saute_picture::still::shot::ShotError;
use saute_recipe::summary::Summary;
use saute_recipe::{Cook, Recipe};

use super::figure::Book;

/// A kitchen at a time after the first food was put in, with its numbers.
pub struct Moment {
    /// Name of the cook.
    pub cook: &'static str,
    /// Time after the first food was put in [s].
    pub after_s: f64,
    /// The kitchen.
    pub kitchen: Kitchen,
    /// Its numbers.
    pub summary: Summary,
}

/// Plays a cook of a book once and keeps every moment that a figure shows.
pub fn moments(book: &Book, cook: &'static str, library: &Library) -> Result<Vec<Moment>, ShotError> {
    let panels = book.figures.iter().flat_map(|figure| figure.panels.iter());
    let mut times: Vec<f64> = panels.filter(|panel| panel.cook == cook).map(|panel| panel.after_s).collect();
    times.sort_by(f64::total_cmp);
    times.dedup();
    let text = book.cooks.iter().find(|(name, _)| *name == cook).map_or("", |(_, text)| text);
    let file = format!("{}/{cook}.toml", book.folder);
    let mut playing = Cook::new(Recipe::parse(text, &file, library)?, library)?;
    let (mut first_put, mut kept) = (None, Vec::new());
    while kept.len() < times.len() {
        playing.advance()?;
        let now = playing.kitchen.time_s();
        if first_put.is_none() && playing.kitchen.pieces().iter().any(Piece::in_pan) {
            first_put = Some(now);
        }
        let since = first_put.map_or(f64::NEG_INFINITY, |put| now - put);
        if since >= times[kept.len()] - 0.5 * TICK_S {
            let (kitchen, summary) = (playing.kitchen.clone(), playing.summary(0.0));
            kept.push(Moment { cook, after_s: times[kept.len()], kitchen, summary });
        } else if playing.stopped().is_some() {
            let line = playing.runner.recipe().steps.last().map_or(1, |step| step.line);
            let at_s = first_put.unwrap_or(0.0) + times[kept.len()];
            return Err(ShotError::PastTheEnd { file, line, at_s, end_s: now });
        }
    }
    Ok(kept)
}
