//! The list of all validation cases that there are or were, and the check that none was removed silently.

use std::collections::BTreeMap;

use serde::Serialize;

/// Name of the list in the folder of the cases.
pub const LIST: &str = "index.txt";

/// Differences between the list and the files.
#[derive(Debug, Default, PartialEq, Eq, Serialize)]
pub struct Differences {
    /// Listed cases without a file that the changelog does not name.
    pub removed: Vec<String>,
    /// Files that are not in the list.
    pub unlisted: Vec<String>,
}

impl Differences {
    /// Compares the files with the list. `list` has one name a line; lines that start with # are comments.
    pub fn of(cases: &BTreeMap<String, String>, list: &str, changelog: &str) -> Self {
        let names = || list.lines().map(str::trim).filter(|line| !line.is_empty() && !line.starts_with('#'));
        let removed = names().filter(|name| !cases.contains_key(*name) && !is_named(name, changelog));
        let unlisted = cases.keys().filter(|id| names().all(|name| name != id.as_str()));
        Self { removed: removed.map(str::to_owned).collect(), unlisted: unlisted.cloned().collect() }
    }

    /// Returns what is wrong, each with file and remedy.
    pub fn messages(&self, folder: &str) -> Vec<String> {
        let removed = self.removed.iter().map(|name| {
            format!(
                "{folder}/{name}.toml: this case was removed: {folder}/{LIST} lists it, and CHANGELOG.md does not name it\n  \
                 remedy: restore the file, or write into CHANGELOG.md why `{name}` was removed"
            )
        });
        let unlisted = self.unlisted.iter().map(|id| {
            format!(
                "{folder}/{id}.toml: this case is not in {folder}/{LIST}, so its removal would not be noticed\n  \
                 remedy: add the line {id} to {folder}/{LIST}"
            )
        });
        removed.chain(unlisted).collect()
    }
}

/// Returns true if a changelog names a case as `` `name` `` or by its file.
fn is_named(name: &str, changelog: &str) -> bool {
    changelog.contains(&format!("`{name}`")) || changelog.contains(&format!("/{name}.toml"))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn differences(changelog: &str) -> Differences {
        let cases = ["slab", "sphere"].map(|id| (id.to_owned(), String::new())).into();
        Differences::of(&cases, "# comment\nslab\n\nslab-2\n", changelog)
    }

    #[test]
    fn a_listed_case_without_a_file_is_removed_unless_the_changelog_names_it() {
        assert_eq!(differences("").removed, ["slab-2"]);
        // Neither a longer name nor the plain words are an entry.
        assert_eq!(differences("`slab-20`, slab-2").removed, ["slab-2"]);
        assert!(differences("- `slab-2` was wrong").removed.is_empty());
        assert!(differences("- removed validation/slab-2.toml").removed.is_empty());
    }

    #[test]
    fn a_file_that_is_not_listed_is_reported() {
        let found = differences("");
        assert_eq!(found.unlisted, ["sphere"]);
        let messages = found.messages("validation");
        assert!(
            messages[0].starts_with("validation/slab-2.toml: ") && messages[0].contains("remedy: "),
            "{messages:?}"
        );
        assert!(messages[1].contains("add the line sphere to validation/index.txt"), "{messages:?}");
    }
}
