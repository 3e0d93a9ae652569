//! The guides of the repository as HTML: every Markdown file of its root and of `docs/`, and whatever they link to.

mod guide;
mod layout;
mod links;
mod markdown;

use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};

use crate::error::{SiteError, at};
use guide::Guide;
use links::{Links, Needed};

/// The stylesheet of the guides, in the repository and in the site.
const STYLE: (&str, &str) = ("web/docs/docs.css", "docs/docs.css");

/// The files that the guides are made of.
pub fn inputs(root: &Path) -> Result<Vec<PathBuf>, SiteError> {
    let mut inputs = vec![root.join(STYLE.0)];
    inputs.extend(guide::all(root)?.iter().map(|guide| root.join(&guide.path)));
    inputs.extend(needed(root)?.iter().filter(|needed| !needed.is_folder()).map(|needed| root.join(needed.path())));
    Ok(inputs)
}

/// Adds the guides to a site.
pub fn add(root: &Path, site: &Path) -> Result<(), SiteError> {
    let guides = guide::all(root)?;
    let links = Links { root, guides: &guides };
    let mut all_needed: BTreeSet<Needed> = [Needed::Folder(PathBuf::from("docs"))].into();
    for guide in &guides {
        let (html, needed) = markdown::html(&guide.text, |target| links.resolve(&guide.path, target))?;
        all_needed.extend(needed);
        let page = layout::page(&guides, &guide.site_path(), &guide.title, &html);
        write(site, &guide.site_path(), page.as_bytes())?;
    }
    for needed in &all_needed {
        add_needed(root, site, &guides, needed)?;
    }
    let style = root.join(STYLE.0);
    write(site, Path::new(STYLE.1), &fs::read(&style).map_err(at(&style))?)
}

/// Everything that the guides link to besides each other.
fn needed(root: &Path) -> Result<BTreeSet<Needed>, SiteError> {
    let guides = guide::all(root)?;
    let links = Links { root, guides: &guides };
    let mut all = BTreeSet::new();
    for guide in &guides {
        all.extend(markdown::html(&guide.text, |target| links.resolve(&guide.path, target))?.1);
    }
    Ok(all)
}

fn add_needed(root: &Path, site: &Path, guides: &[Guide], needed: &Needed) -> Result<(), SiteError> {
    let path = root.join(needed.path());
    let page = |text: &str| layout::page(guides, &needed.site_path(), &needed.path().display().to_string(), text);
    let bytes = match needed {
        Needed::Folder(folder) => page(&layout::list(guides, folder)).into_bytes(),
        Needed::Picture(_) => fs::read(&path).map_err(at(&path))?,
        Needed::Text(_) => page(&layout::source(&fs::read_to_string(&path).map_err(at(&path))?)).into_bytes(),
    };
    write(site, &needed.site_path(), &bytes)
}

fn write(site: &Path, path: &Path, bytes: &[u8]) -> Result<(), SiteError> {
    let path = site.join(path);
    if let Some(folder) = path.parent() {
        fs::create_dir_all(folder).map_err(at(folder))?;
    }
    fs::write(&path, bytes).map_err(at(&path))
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests;
