//! The zoom of the interface in egui's stored memory.
//!
//! eframe restores that memory and creates its window with this zoom before any code of ours runs. A damaged file must not
//! stop the window from opening, so a zoom that is no usable number is replaced in the file.

use std::ops::RangeInclusive;
use std::path::Path;

/// Name of the value in the stored text.
const NAME: &str = "zoom_factor:";
/// Zooms with which a window can be used [-] (egui's own limits).
const USABLE: RangeInclusive<f32> = 0.2..=5.0;
/// Larger files are not read [bytes] (chosen: a usual one has a few kilobytes).
const LARGEST: u64 = 16 << 20;

/// Replaces an unusable zoom in eframe's file in a folder. A file that cannot be read or written stays as it is.
pub fn mend(folder: &Path) {
    let path = folder.join("app.ron");
    if !path.metadata().is_ok_and(|data| data.is_file() && data.len() <= LARGEST) {
        return;
    }
    if let Some(text) = std::fs::read_to_string(&path).ok().and_then(|text| mended(&text)) {
        // Without the mended file the window may not open; there is no other place for the settings.
        let _ = std::fs::write(&path, text);
    }
}

/// Returns a text with every unusable zoom replaced by 1; `None` if all are usable.
pub fn mended(text: &str) -> Option<String> {
    let mut parts = text.split(NAME);
    let mut result = parts.next().unwrap_or_default().to_owned();
    let mut is_changed = false;
    for part in parts {
        let end = part.find([',', ')', '\n']).unwrap_or(part.len());
        let (value, rest) = part.split_at(end);
        let is_usable = value.trim().parse().is_ok_and(|zoom: f32| USABLE.contains(&zoom));
        is_changed |= !is_usable;
        result += NAME;
        result += if is_usable { value } else { "1.0" };
        result += rest;
    }
    is_changed.then_some(result)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn stored(zoom: &str) -> String {
        format!(
            "{{\n    \"egui\": \"(options:(zoom_factor:{zoom},line_scroll_speed:40.0))\",\n    \"settings\": \"{{}}\"\n}}"
        )
    }

    #[test]
    fn a_zoom_that_is_no_usable_number_becomes_one_and_the_rest_stays() {
        for zoom in ["NaN", "inf", "-inf", "0.0", "-1.0", "1e30", "", "x"] {
            assert_eq!(mended(&stored(zoom)), Some(stored("1.0")), "{zoom}");
        }
        for zoom in ["1.0", "0.75", "1.5"] {
            assert_eq!(mended(&stored(zoom)), None, "{zoom}");
        }
        assert_eq!(mended("no zoom"), None);
    }
}
