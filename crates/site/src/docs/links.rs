//! Where the links of a guide lead in the site.

use std::path::{Component, Path, PathBuf};

use super::guide::Guide;
use crate::error::SiteError;

const PICTURES: [&str; 4] = ["png", "jpg", "svg", "webp"];

/// What the site needs because a guide links to it.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Needed {
    /// A list of the guides in a folder.
    Folder(PathBuf),
    /// A copy.
    Picture(PathBuf),
    /// A page that shows the text.
    Text(PathBuf),
}

impl Needed {
    /// Path in the repository.
    pub fn path(&self) -> &Path {
        match self {
            Self::Folder(path) | Self::Picture(path) | Self::Text(path) => path,
        }
    }

    /// Path in the site.
    pub fn site_path(&self) -> PathBuf {
        match self {
            Self::Folder(path) => path.join("index.html"),
            Self::Picture(path) => path.clone(),
            Self::Text(path) => PathBuf::from(format!("{}.html", path.display())),
        }
    }

    /// Returns true for a folder.
    pub fn is_folder(&self) -> bool {
        matches!(self, Self::Folder(_))
    }
}

/// What links may lead to.
pub struct Links<'a> {
    /// The repository.
    pub root: &'a Path,
    /// Its guides.
    pub guides: &'a [Guide],
}

impl Links<'_> {
    /// Returns the address to write in place of a target, relative to the page, and what the site needs for it.
    pub fn resolve(&self, page: &Path, target: &str) -> Result<(String, Option<Needed>), SiteError> {
        if target.starts_with('#') || target.contains("://") || target.starts_with("mailto:") {
            return Ok((target.to_owned(), None));
        }
        let (file, fragment) = target.split_once('#').map_or((target, None), |(file, part)| (file, Some(part)));
        let path = normal(&page.parent().unwrap_or(Path::new("")).join(file));
        let nowhere = || SiteError::Link { page: page.to_owned(), target: target.to_owned() };
        let (to, needed) = self.place(path).ok_or_else(nowhere)?;
        let address = relative(page, &to);
        Ok((fragment.map_or(address.clone(), |part| format!("{address}#{part}")), needed))
    }

    fn place(&self, path: PathBuf) -> Option<(PathBuf, Option<Needed>)> {
        if let Some(guide) = self.guides.iter().find(|guide| guide.path == path) {
            return Some((guide.site_path(), None));
        }
        let is_picture = path.extension().is_some_and(|end| PICTURES.iter().any(|known| end == *known));
        let needed = match self.root.join(&path) {
            folder if folder.is_dir() => Needed::Folder(path),
            file if !file.is_file() => return None,
            _ if is_picture => Needed::Picture(path),
            _ => Needed::Text(path),
        };
        Some((needed.site_path(), Some(needed)))
    }
}

/// A path without `.` and `..`.
fn normal(path: &Path) -> PathBuf {
    let mut normal = PathBuf::new();
    for part in path.components() {
        match part {
            Component::ParentDir => drop(normal.pop()),
            Component::Normal(name) => normal.push(name),
            _ => {}
        }
    }
    normal
}

/// The address of a file of the site as seen from a page at another path of it.
pub fn relative(page: &Path, to: &Path) -> String {
    let up = "../".repeat(page.components().count().saturating_sub(1));
    let names: Vec<_> = to.components().map(|part| part.as_os_str().to_string_lossy()).collect();
    format!("{up}{}", names.join("/"))
}
