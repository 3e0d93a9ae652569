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
const ENDINGS: [&str; 5] = ["html", "css", "js", "svg", "webmanifest"];
/// Keeps the page for use without a network; it names the files of its version.
const SERVICE_WORKER: &str = "service_worker.js";

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
    let (bytes, files) = (bytes.to_string(), versioned_files(site)?);
    for file in [index, site.join(SERVICE_WORKER)] {
        let text = fs::read_to_string(&file).map_err(at(&file))?;
        let filled = [("{{version}}", &version), ("{{module_bytes}}", &bytes), ("{{files}}", &files)]
            .iter()
            .fold(text, |text, (name, value)| text.replace(name, value));
        fs::write(&file, filled).map_err(at(&file))?;
    }
    Ok(())
}

/// Names of the files that the page loads with its version, as JSON; their names hold no quotes.
fn versioned_files(site: &Path) -> Result<String, SiteError> {
    let names = files_of(site)?.into_iter().filter_map(|path| Some(path.file_name()?.to_str()?.to_owned()));
    let is_loaded = |name: &String| !name.ends_with(".html") && name != SERVICE_WORKER;
    let quoted: Vec<String> = names.filter(is_loaded).map(|name| format!("\"{name}\"")).collect();
    Ok(format!("[{}]", quoted.join(",")))
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use super::*;

    #[test]
    fn the_service_worker_names_every_file_that_the_page_loads_and_its_version() {
        let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
        let site = tempfile::tempdir().unwrap();
        let read = |name: &str| fs::read_to_string(site.path().join(name)).unwrap();
        let versions = [b"module 1", b"module 2"].map(|module| {
            fs::write(site.path().join(MODULE), module).unwrap();
            fs::write(site.path().join(SCRIPT), "export default 1;").unwrap();
            add(&root, site.path()).unwrap();
            let worker = read(SERVICE_WORKER);
            assert!(!worker.contains("{{") && !read(INDEX).contains("{{"));
            for file in [MODULE, SCRIPT, "loader.js", "style.css", "icon.svg"] {
                assert!(worker.contains(&format!("\"{file}\"")), "{file}");
            }
            assert!(!worker.contains("index.html\","), "the page itself carries no version");
            worker.split("const VERSION = \"").nth(1).unwrap()[..8].to_owned()
        });
        assert_ne!(versions[0], versions[1], "another module is another version");
    }
}
