//! Whether a site is already made of what is in the repository now.

use std::fs;
use std::path::{Path, PathBuf};

use crate::error::{SiteError, at};

/// Is next to the site, not in it.
fn path(site: &Path) -> PathBuf {
    site.with_extension("stamp")
}

/// A number of everything that goes into the site: files, this program, whether wasm-opt is there, brotli's quality, its address.
pub fn of(inputs: &[PathBuf], optimised: bool, brotli: i32, address: Option<&str>) -> Result<String, SiteError> {
    let mut hasher = crc32fast::Hasher::new();
    hasher.update(&[u8::from(optimised), brotli as u8]);
    hasher.update(address.unwrap_or_default().as_bytes());
    let program = std::env::current_exe().map_err(at(Path::new("saute-site")))?;
    for input in inputs.iter().chain([&program]) {
        hasher.update(input.as_os_str().as_encoded_bytes());
        hasher.update(&fs::read(input).map_err(at(input))?);
    }
    Ok(format!("{:08x}", hasher.finalize()))
}

/// Returns true if a site bears this stamp.
pub fn is_on(site: &Path, stamp: &str) -> bool {
    site.is_dir() && fs::read_to_string(path(site)).is_ok_and(|found| found == stamp)
}

/// Stamps a site that is complete.
pub fn put(site: &Path, stamp: &str) -> Result<(), SiteError> {
    fs::write(path(site), stamp).map_err(at(&path(site)))
}
