//! The page itself: the files of `web/` and the font, with values from the build filled in.

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
/// Where the texts of the program are, a file for each language.
const TEXTS: &str = "crates/words/texts";
const ENDINGS: [&str; 7] = ["html", "css", "js", "svg", "webmanifest", "webp", "jpg"];
/// The picture of the page where its address is shared; no visitor loads it.
const PICTURE: &str = "social.jpg";
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

/// Adds the page to a site that has the module. The page names the languages, the module's size, for the progress bar, and a version, so
/// that a browser never combines files of two versions from its cache.
pub fn add(root: &Path, site: &Path, address: Option<&str>) -> Result<(), SiteError> {
    for source in sources(root)? {
        copy_into(&source, site)?;
    }
    let fonts = site.join("fonts");
    fs::create_dir_all(&fonts).map_err(at(&fonts))?;
    for font in files_of(&root.join(FONTS))? {
        copy_into(&font, &fonts)?;
    }
    fill_in(site, address, &languages(root)?)
}

/// The address at which a site will be, with a slash at its end, from what was typed.
pub fn address(typed: &str) -> Result<String, String> {
    let is_plain = |rest: &str| !rest.is_empty() && !rest.contains(['"', '<', '>', '?', '#', ' ']);
    let rest = ["https://", "http://"].iter().find_map(|scheme| typed.strip_prefix(scheme));
    match rest {
        Some(rest) if is_plain(rest) => Ok(format!("{}/", typed.trim_end_matches('/'))),
        _ => Err("write the whole address of the page, such as https://example.org/pan/".to_owned()),
    }
}

/// What shows the page with a picture where its address is shared. Only a whole address leads there.
fn social(address: Option<&str>) -> String {
    address.map_or_else(String::new, |address| {
        let tag = |name: &str, value: &str| format!("<meta property=\"og:{name}\" content=\"{address}{value}\">");
        let alt = "<meta property=\"og:image:alt\" content=\"A steak in a frying pan, simulated\">";
        [tag("url", ""), tag("image", PICTURE), alt.to_owned()].join("\n")
    })
}

fn copy_into(source: &Path, folder: &Path) -> Result<(), SiteError> {
    let name = source.file_name().unwrap_or_default();
    fs::copy(source, folder.join(name)).map_err(at(source)).map(|_| ())
}

fn fill_in(site: &Path, address: Option<&str>, languages: &str) -> Result<(), SiteError> {
    let (index, module) = (site.join(INDEX), site.join(MODULE));
    let bytes = fs::metadata(&module).map_err(at(&module))?.len();
    let mut hasher = crc32fast::Hasher::new();
    for path in files_of(site)? {
        hasher.update(&fs::read(&path).map_err(at(&path))?);
    }
    let version = format!("{:08x}", hasher.finalize());
    let (bytes, files, social) = (bytes.to_string(), versioned_files(site)?, social(address));
    let known: [(&str, &str); 5] = [
        ("{{version}}", &version),
        ("{{module_bytes}}", &bytes),
        ("{{files}}", &files),
        ("{{social}}", &social),
        ("{{languages}}", languages),
    ];
    for file in [index, site.join(SERVICE_WORKER)] {
        let text = fs::read_to_string(&file).map_err(at(&file))?;
        let filled = known.iter().fold(text, |text, (name, value)| text.replace(name, value));
        fs::write(&file, filled).map_err(at(&file))?;
    }
    Ok(())
}

/// Codes of the languages of the program, which are the names of the files with its texts.
fn languages(root: &Path) -> Result<String, SiteError> {
    let files = files_of(&root.join(TEXTS))?;
    let codes: Vec<&str> = files.iter().filter_map(|path| path.file_stem()?.to_str()).collect();
    Ok(codes.join(" "))
}

/// Names of the files that the page loads with its version, as JSON; their names hold no quotes.
fn versioned_files(site: &Path) -> Result<String, SiteError> {
    let names = files_of(site)?.into_iter().filter_map(|path| Some(path.file_name()?.to_str()?.to_owned()));
    let is_loaded = |name: &String| !name.ends_with(".html") && name != SERVICE_WORKER && name != PICTURE;
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
            add(&root, site.path(), None).unwrap();
            let worker = read(SERVICE_WORKER);
            assert!(!worker.contains("{{") && !read(INDEX).contains("{{"));
            assert!(read(INDEX).contains(" data-languages=\"en ja\""), "the languages that the program speaks");
            for file in [MODULE, SCRIPT, "loader.js", "style.css", "icon.svg"] {
                assert!(worker.contains(&format!("\"{file}\"")), "{file}");
            }
            assert!(!worker.contains("index.html\","), "the page itself carries no version");
            assert!(!worker.contains(PICTURE), "no visitor needs it");
            worker.split("const VERSION = \"").nth(1).unwrap()[..8].to_owned()
        });
        assert_ne!(versions[0], versions[1], "another module is another version");
    }
    /// Promise: a shared address shows a picture that is in the site, by a whole address; without one no picture is promised.
    #[test]
    fn the_picture_of_a_shared_page_has_a_whole_address_and_is_there() {
        let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
        let read = |address: Option<&str>| {
            let site = tempfile::tempdir().unwrap();
            fs::write(site.path().join(MODULE), b"module").unwrap();
            add(&root, site.path(), address).unwrap();
            assert!(site.path().join(PICTURE).exists());
            fs::read_to_string(site.path().join(INDEX)).unwrap()
        };
        let given = address("https://example.org/pan").unwrap();
        assert!(read(Some(&given)).contains("property=\"og:image\" content=\"https://example.org/pan/social.jpg\""));
        assert!(!read(None).contains("og:image"));
        for wrong in ["example.org", "https://", "https://example.org/\"><script>", "ftp://example.org/"] {
            assert!(address(wrong).is_err(), "{wrong}");
        }
    }
}
