//! glTF 2.0 files.

mod buffers;
mod container;
mod document;
mod elements;
mod extensions;
mod placement;
mod reference;
mod scene;

use crate::{Body, ReadError};

/// Returns the bodies of a file's default scene, rotated so that z points up.
///
/// # Errors
/// [`ReadError`] if the file is not valid, a buffer is missing or too short, the geometry uses an unsupported feature, or
/// the file or its body is too large.
pub fn read(bytes: &[u8], sibling: impl Fn(&str) -> Option<Vec<u8>>) -> Result<Vec<Body>, ReadError> {
    let container = container::open(bytes)?;
    let document = document::parse(&container)?;
    extensions::check(&document.extensions_required)?;
    let buffers = buffers::read(&document, container.binary, sibling)?;
    scene::bodies(&document, &buffers)
}
