//! The page itself: the files of `web/` and the font, with what the build knows filled in.

use std::fs;
use std::path::{Path, PathBuf};

use crate::error::{SiteError, at};

/// The module in the site.
pub const MODULE: &str = "saute_web_bg.wasm";
/// Its JavaScript.
pub const SCRIPT: &str = "saute_web.js";
/// The page.
pub const INDEX: &str = "index.html";
/// Where the page's own files are in the repository.
pub const SOURCES: &str = "web";
/// Where the Japanese font and its licence are.
const FONTS: &str = "crates/window/fonts";
const ENDINGS: [&str; 4] = ["html", "css", "js", "svg"];

/// The files of `web/` that belong to the site, in the order of their names.
pub fn sources(root: &Path) -> Result<Vec<PathBuf>, SiteError> {
    let mut files = files_of(&root.join(SOURCES))?;
    files.retain(|path| path.extension().is_some_and(|end| ENDINGS.iter().any(|known| end == *known)));
    Ok(files)
}

/// The files of a folder, without its folders.
pub fn files_of(folder: &Path) -> Result<Vec<PathBuf>, SiteError> {
    let entries = fs::read_dir(folder).map_err(at(folder))?;
    let mut files: Vec<PathBuf> = entries.flatten().map(|entry| entry.path()).filter(|path| path.is_file()).collect();
    files.sort();
    Ok(files)
}

/// Adds the page to a site that has the module. The page names the module's size, for the progress bar, and a version, so
/// that a browser never combines files of two versions from its cache.
pub fn add(root: &Path, site: &Path) -> Result<(), SiteError> {
    for source in sources(root)? {
        copy_into(&source, site)?;
    }
    let fonts = site.join("fonts");
    fs::create_dir_all(&fonts).map_err(at(&fonts))?;
    for font in files_of(&root.join(FONTS))? {
        copy_into(&font, &fonts)?;
    }
    fill_in(site)
}

fn copy_into(source: &Path, folder: &Path) -> Result<(), SiteError> {
    let name = source.file_name().unwrap_or_default();
    fs::copy(source, folder.join(name)).map_err(at(source)).map(|_| ())
}

fn fill_in(site: &Path) -> Result<(), SiteError> {
    let (index, module) = (site.join(INDEX), site.join(MODULE));
    let bytes = fs::metadata(&module).map_err(at(&module))?.len();
    let mut hasher = crc32fast::Hasher::new();
    for path in files_of(site)? {
        hasher.update(&fs::read(&path).map_err(at(&path))?);
    }
    let version = format!("{:08x}", hasher.finalize());
    let text = fs::read_to_string(&index).map_err(at(&index))?;
    let filled = text.replace("{{version}}", &version).replace("{{module_bytes}}", &bytes.to_string());
    fs::write(&index, filled).map_err(at(&index))
}
