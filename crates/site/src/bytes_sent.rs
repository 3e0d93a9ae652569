//! How much the page sends before the first interaction, and the budget for it.

use std::fs;
use std::path::{Path, PathBuf};

use crate::compress::name;
use crate::error::{SiteError, at};
use crate::page::{MODULE, files_of};
use crate::sound::AFTER_TOUCH;

/// 4 MB with brotli: half a minute at 1 Mbit/s.
pub const BUDGET: u64 = 4_000_000;
/// What a first visit loads; guides, the Japanese font and what sounds after the first touch it does not.
const ENDINGS: [&str; 6] = ["wasm", "js", "html", "css", "svg", "webp"];

/// Sizes of one file: as it is, with gzip, with brotli.
struct Sizes {
    name: String,
    bytes: [u64; 3],
}

/// Prints a table of what the first interaction needs; an error if it is more than `most` bytes with brotli.
pub fn check(site: &Path, most: u64) -> Result<(), SiteError> {
    let rows = first(site)?.iter().map(|path| sizes(path)).collect::<Result<Vec<_>, _>>()?;
    let sum = rows.iter().fold([0; 3], |sum, row| [0, 1, 2].map(|i| sum[i] + row.bytes[i]));
    println!("{:<28}{:>12}{:>12}{:>12}", "sent before the first touch", "bytes", "gzip", "brotli");
    for row in rows.iter().chain([&Sizes { name: "together".to_owned(), bytes: sum }]) {
        println!("{:<28}{:>12}{:>12}{:>12}", row.name, row.bytes[0], row.bytes[1], row.bytes[2]);
    }
    let font = sizes(&site.join("fonts/japanese.otf"))?;
    println!("{:<28}{:>12}{:>12}{:>12}", "with Japanese, besides", font.bytes[0], font.bytes[1], font.bytes[2]);
    if sum[2] > most { Err(SiteError::TooLarge { sent: sum[2], most }) } else { Ok(()) }
}

/// The files that a first visit loads: those in the site's root, and snippets of the module's crates.
fn first(site: &Path) -> Result<Vec<PathBuf>, SiteError> {
    let mut files = files_of(site)?;
    let snippets = site.join("snippets");
    if snippets.is_dir() {
        for entry in fs::read_dir(&snippets).map_err(at(&snippets))?.flatten().filter(|entry| entry.path().is_dir()) {
            files.extend(files_of(&entry.path())?);
        }
    }
    let is_guide = |path: &PathBuf| path.extension().is_some_and(|e| e == "html") && !path.ends_with("index.html");
    files.retain(|path| path.extension().is_some_and(|end| ENDINGS.iter().any(|known| end == *known)));
    files.retain(|path| !is_guide(path) && !AFTER_TOUCH.iter().any(|name| path.ends_with(name)));
    files.sort_by_key(|path| !path.ends_with(MODULE));
    Ok(files)
}

fn sizes(path: &Path) -> Result<Sizes, SiteError> {
    let size = |path: PathBuf| fs::metadata(&path).map(|data| data.len()).map_err(at(&path));
    // Pictures are compressed already.
    let sent =
        |ending: &str| Some(name(path, ending)).filter(|packed| packed.exists()).unwrap_or_else(|| path.to_owned());
    let bytes = [size(path.to_owned())?, size(sent("gz"))?, size(sent("br"))?];
    Ok(Sizes { name: path.file_name().unwrap_or_default().to_string_lossy().into_owned(), bytes })
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use super::*;

    /// A site whose compressed files have a size each.
    fn site(bytes: u64) -> tempfile::TempDir {
        let site = tempfile::tempdir().unwrap();
        std::fs::create_dir(site.path().join("fonts")).unwrap();
        for file in ["index.html", MODULE, "README.html", "fonts/japanese.otf", "sound_player.wasm"] {
            for ending in ["", ".br", ".gz"] {
                let file = fs::File::create(site.path().join(format!("{file}{ending}"))).unwrap();
                file.set_len(bytes).unwrap();
            }
        }
        site
    }

    /// Promise: a page that sends more than 4 MB before the first interaction is not made; guides, font and sound do not count.
    #[test]
    fn a_page_over_the_budget_is_an_error() {
        assert!(check(site(BUDGET / 2).path(), BUDGET).is_ok());
        let error = check(site(BUDGET / 2 + 1).path(), BUDGET).unwrap_err();
        assert_eq!(
            error.to_string(),
            "the page sends 4000002 bytes before the first interaction; at most 4000000 are allowed"
        );
    }
}
