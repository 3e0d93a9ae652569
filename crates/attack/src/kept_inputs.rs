//! Inputs that are kept in `fuzz/`: valid ones to start from, and every one that once broke a reader.

use std::path::{Path, PathBuf};

use crate::Target;

/// A kept input.
#[derive(Clone, Debug)]
pub struct Input {
    /// Path of its file.
    pub path: PathBuf,
    /// Its bytes.
    pub bytes: Vec<u8>,
}

/// Returns the folder of the kept inputs of a kind ("seeds" or "found") for a target.
pub fn folder(kind: &str, target: &Target) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../fuzz").join(kind).join(target.name)
}

/// Returns the kept inputs of a kind ("seeds" or "found") for a target, by name; none without a folder.
pub fn kept(kind: &str, target: &Target) -> Vec<Input> {
    in_folder(&folder(kind, target))
}

/// Returns the files of a folder, by name; none if it cannot be read.
pub fn in_folder(folder: &Path) -> Vec<Input> {
    let entries = std::fs::read_dir(folder).into_iter().flatten().flatten();
    let mut paths: Vec<PathBuf> = entries.map(|entry| entry.path()).collect();
    paths.sort();
    let read = |path: PathBuf| Some(Input { bytes: std::fs::read(&path).ok()?, path });
    paths.into_iter().filter_map(read).collect()
}
