//! The module of the page's sound: without names, without imports, small.

use std::fs;
use std::path::Path;

use crate::error::{SiteError, at};

/// The module in the site.
pub const PLAYER: &str = "sound_player.wasm";
/// What the page fetches after the first touch.
pub const AFTER_TOUCH: [&str; 2] = [PLAYER, "sound_worklet.js"];
/// Most bytes of the module.
const MOST: usize = 150_000;
/// Bytes before the first section: "\0asm" and the version.
const HEAD: usize = 8;
/// Numbers of the sections of names and the like, and of imports.
const CUSTOM: u8 = 0;
const IMPORTS: u8 = 2;

/// Adds the module to a site, without its custom sections.
pub fn add(module: &Path, site: &Path) -> Result<(), SiteError> {
    let bytes = fs::read(module).map_err(at(module))?;
    let wrong = |reason: String| SiteError::Sound { path: module.to_owned(), reason };
    let bare = bare(&bytes).map_err(wrong)?;
    if bare.len() > MOST {
        return Err(wrong(format!("has {} bytes; at most {MOST} are allowed", bare.len())));
    }
    let target = site.join(PLAYER);
    fs::write(&target, bare).map_err(at(&target))
}

/// Returns a module without custom sections; an error if it imports something: a worklet has nothing to give.
fn bare(module: &[u8]) -> Result<Vec<u8>, String> {
    let short = || "is no WebAssembly module".to_owned();
    let head = module.get(..HEAD).filter(|head| head.starts_with(b"\0asm")).ok_or_else(short)?;
    let (mut kept, mut rest) = (head.to_vec(), &module[HEAD..]);
    while let Some((&kind, after)) = rest.split_first() {
        let (length, width) = number(after).ok_or_else(short)?;
        let end = 1 + width + length;
        let section = rest.get(..end).ok_or_else(short)?;
        match kind {
            IMPORTS => return Err("imports functions, which a worklet does not have".to_owned()),
            CUSTOM => {}
            _ => kept.extend_from_slice(section),
        }
        rest = &rest[end..];
    }
    Ok(kept)
}

/// Reads a number in LEB128; returns it and its width [byte].
fn number(bytes: &[u8]) -> Option<(usize, usize)> {
    let width = 1 + bytes.iter().take(5).position(|byte| byte & 0x80 == 0)?;
    let sevens = bytes[..width].iter().enumerate();
    Some((sevens.map(|(place, byte)| usize::from(byte & 0x7f) << (7 * place)).sum(), width))
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use super::*;

    /// A module of sections: their kinds and what is in them.
    fn module(sections: &[(u8, &[u8])]) -> Vec<u8> {
        let section = |(kind, content): &(u8, &[u8])| [&[*kind, content.len() as u8], *content].concat();
        [b"\0asm\x01\0\0\0".to_vec(), sections.iter().flat_map(section).collect()].concat()
    }

    /// Promise: the page's sound is a module that any worklet can start: names go, imports and too many bytes are errors.
    #[test]
    fn the_player_is_bare_small_and_imports_nothing() {
        let site = tempfile::tempdir().unwrap();
        let added = |bytes: &[u8]| {
            let file = site.path().join("in.wasm");
            fs::write(&file, bytes).unwrap();
            add(&file, site.path()).map_err(|error| error.to_string())
        };
        added(&module(&[(1, b"type"), (CUSTOM, b"names"), (10, b"code")])).unwrap();
        assert_eq!(fs::read(site.path().join(PLAYER)).unwrap(), module(&[(1, b"type"), (10, b"code")]));
        for (bytes, reason) in [
            (module(&[(1, b"type"), (IMPORTS, b"log")]), "imports functions"),
            (b"MZ".to_vec(), "is no WebAssembly module"),
            (module(&[(1, b"type")])[..12].to_vec(), "is no WebAssembly module"),
            ([module(&[]), vec![10, 0x80, 0x80, 0x0a], vec![0; 163_840]].concat(), "at most 150000"),
        ] {
            assert!(added(&bytes).unwrap_err().contains(reason), "{reason}");
        }
    }
}
