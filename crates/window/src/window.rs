//! The native window.

use crate::app::{SauteApp, Start};
use crate::ui::stored_zoom;

/// What a start says about the world around the window.
pub(crate) struct Surroundings {
    pub(crate) hands: crate::hand::HandsStart,
    /// True if the cook is kept: a recipe or a session that is named is what the person wants.
    pub(crate) keeps: bool,
}

impl Surroundings {
    pub fn of(start: &Start, remembers: bool) -> Self {
        let keeps = remembers && start.recipe.is_none() && start.recorded.is_none();
        let keeps = keeps && start.study.is_none() && start.lesson.is_none();
        Self { hands: start.hands.clone(), keeps }
    }
}

/// A window has no address.
pub(crate) fn page_address() -> Option<String> {
    None
}

/// Without an address there is nothing to copy.
pub(crate) fn copy_text(_: &SauteApp, _: String) {}

/// The time of day [ISO 8601, UTC].
pub(crate) fn time_of_day() -> String {
    let since = std::time::SystemTime::now().duration_since(std::time::UNIX_EPOCH).unwrap_or_default().as_secs();
    let (day, second) = (since / 86_400, since % 86_400);
    let [year, month, date] = calendar(day);
    format!("{year:04}-{month:02}-{date:02}T{:02}:{:02}:{:02}Z", second / 3600, second / 60 % 60, second % 60)
}

/// Year, month and date of a day since 1970-01-01 (Gregorian calendar; years begin in March here, so that the leap day is the last).
fn calendar(day: u64) -> [u64; 3] {
    let from_year_0 = day + 719_468;
    let (era, of_era) = (from_year_0 / 146_097, from_year_0 % 146_097);
    let year = (of_era - of_era / 1460 + of_era / 36_524 - of_era / 146_096) / 365;
    let of_year = of_era - (365 * year + year / 4 - year / 100);
    let month = (5 * of_year + 2) / 153;
    let date = of_year - (153 * month + 2) / 5 + 1;
    let month = if month < 10 { month + 3 } else { month - 9 };
    [era * 400 + year + u64::from(month <= 2), month, date]
}

/// Name of the program, after which eframe names the folder of its settings.
pub(crate) const NAME: &str = "saute";

/// Opens the window and stays until it is closed.
pub fn run(start: Start) -> eframe::Result {
    if let Some(folder) = eframe::storage_dir(NAME) {
        stored_zoom::mend(&folder);
    }
    let options = eframe::NativeOptions {
        viewport: egui::ViewportBuilder::default()
            .with_title(NAME)
            .with_app_id(NAME)
            .with_inner_size([1280.0, 720.0])
            .with_min_inner_size([360.0, 560.0]),
        renderer: eframe::Renderer::Wgpu,
        // The scene dithers itself and the panels are flat: on a software rasteriser egui's own costs frames.
        dithering: false,
        ..Default::default()
    };
    eframe::run_native(NAME, options, Box::new(|cc| Ok(Box::new(SauteApp::new(cc, start)?))))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn days_are_dates() {
        for (day, date) in [(0, [1970, 1, 1]), (59, [1970, 3, 1]), (11_016, [2000, 2, 29]), (20_781, [2026, 11, 24])] {
            assert_eq!(calendar(day), date);
        }
    }
}
