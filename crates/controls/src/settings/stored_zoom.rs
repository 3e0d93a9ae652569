//! The zoom of the interface in egui's stored memory.
//!
//! eframe restores that memory and creates its window with this zoom before any code of ours runs. A damaged file must not
//! stop the window from opening, so a zoom that is no usable number is replaced in the file.

use std::ops::RangeInclusive;
use std::path::Path;

use saute_files::regular_file::{self, Unread};
use saute_files::write_whole;

/// Name of the value in the stored text.
const NAME: &str = "zoom_factor:";
/// Zooms with which a window can be used [-] (egui's own limits).
const USABLE: RangeInclusive<f32> = 0.2..=5.0;
/// Larger files are not read [MiB] (chosen: a usual one has a few kilobytes).
const LARGEST_MIB: u64 = 16;
/// New name of what is no file of settings.
const SET_ASIDE: &str = "app.ron.set-aside";

/// Replaces an unusable zoom in eframe's file in a folder. What is no file, or a far too large one, gets another name: eframe would
/// wait for a pipe, or read without end. A file that cannot be read or written stays as it is.
pub fn mend(folder: &Path) {
    let path = folder.join("app.ron");
    // Without the mended file the window may not open; there is no other place for the settings.
    match regular_file::read_text(&path, LARGEST_MIB) {
        Ok(text) => drop(mended(&text).map(|text| write_whole(&path, text.as_bytes()))),
        Err(Unread::NoFile | Unread::Large(_)) => drop(std::fs::rename(&path, folder.join(SET_ASIDE))),
        Err(Unread::Folder | Unread::NoText | Unread::Io(_)) => {}
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

    #[cfg(unix)]
    #[test]
    fn a_pipe_or_an_endless_file_of_settings_is_set_aside_and_the_window_opens_without_it() {
        let folder = std::env::temp_dir().join(format!("saute-settings-{}", std::process::id()));
        std::fs::create_dir_all(&folder).expect("a folder");
        let path = folder.join("app.ron");
        std::os::unix::fs::symlink("/dev/zero", &path).expect("links");
        mend(&folder);
        assert!(!path.exists() && folder.join(SET_ASIDE).exists());
        std::fs::write(&path, stored("NaN")).expect("writes");
        mend(&folder);
        assert_eq!(std::fs::read_to_string(&path).expect("reads"), stored("1.0"));
        std::fs::remove_dir_all(folder).expect("removes");
    }
}
