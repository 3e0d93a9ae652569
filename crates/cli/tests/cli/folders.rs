//! Promise: a folder of sources is short enough to read: at most twenty files.

use std::path::Path;

const MOST: usize = 20;
const SOURCES: [&str; 2] = ["rs", "wgsl"];

fn check(folder: &Path) -> usize {
    let paths: Vec<_> = std::fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path()).collect();
    let (folders, files): (Vec<_>, Vec<_>) = paths.into_iter().partition(|path| path.is_dir());
    let is_source = |path: &&std::path::PathBuf| path.extension().is_some_and(|e| SOURCES.iter().any(|s| e == *s));
    let count = files.iter().filter(is_source).count();
    assert!(count <= MOST, "{} has {count} source files", folder.display());
    count + folders.iter().map(|inner| check(inner)).sum::<usize>()
}

#[test]
fn no_folder_has_more_than_twenty_source_files() {
    let found = check(&Path::new(env!("CARGO_MANIFEST_DIR")).join(".."));
    assert!(found > 300, "only {found} source files were found");
}
