//! One Markdown file of the repository.

use std::fs;
use std::path::{Path, PathBuf};

use crate::error::{SiteError, at};
use crate::page::files_of;

/// The groups of the navigation: a title, and the folder whose files belong to it.
pub const GROUPS: [(&str, &str); 4] =
    [("Guides", "docs"), ("File formats", "docs/formats"), ("Pictures", "docs/gallery"), ("The project", "")];

/// A page to be.
pub struct Guide {
    /// Path in the repository.
    pub path: PathBuf,
    /// Its first heading.
    pub title: String,
    /// Its Markdown.
    pub text: String,
}

impl Guide {
    fn read(root: &Path, path: &Path) -> Result<Self, SiteError> {
        let text = fs::read_to_string(path).map_err(at(path))?;
        let heading = text.lines().find_map(|line| line.strip_prefix("# "));
        let title = heading.filter(|title| *title != "saute").unwrap_or("About saute").replace('`', "");
        Ok(Self { path: path.strip_prefix(root).unwrap_or(path).to_owned(), title, text })
    }

    /// Path of the page in the site.
    pub fn site_path(&self) -> PathBuf {
        self.path.with_extension("html")
    }

    /// Returns true if the file is in a folder, not in one below it.
    pub fn is_in(&self, folder: &Path) -> bool {
        self.path.parent() == Some(folder)
    }
}

/// All guides, group by group.
pub fn all(root: &Path) -> Result<Vec<Guide>, SiteError> {
    let mut guides = Vec::new();
    for (_, folder) in GROUPS {
        for path in files_of(&root.join(folder))?.iter().filter(|path| path.extension().is_some_and(|end| end == "md"))
        {
            guides.push(Guide::read(root, path)?);
        }
    }
    Ok(guides)
}
