//! Every file of the site a second and a third time: `.br` and `.gz`, for hosts that send them, and for the loader.

use std::fs;
use std::io::{self, Write};
use std::path::{Path, PathBuf};

use crate::error::{SiteError, at};

/// Pictures are compressed already.
const ENDINGS: [&str; 10] = ["wasm", "js", "html", "css", "svg", "otf", "txt", "json", "toml", "webmanifest"];
/// brotli's best quality, and its usual window (16 MB).
pub const BEST: i32 = 11;
const WINDOW: i32 = 24;

/// All files of a site that compress.
pub fn compressible(folder: &Path) -> Result<Vec<PathBuf>, SiteError> {
    let mut found = Vec::new();
    for entry in fs::read_dir(folder).map_err(at(folder))?.flatten() {
        let path = entry.path();
        if path.is_dir() {
            found.extend(compressible(&path)?);
        } else if path.extension().is_some_and(|end| ENDINGS.iter().any(|known| end == *known)) {
            found.push(path);
        }
    }
    found.sort();
    Ok(found)
}

/// Writes both next to each file of a site, with a quality of brotli.
pub fn compress(site: &Path, quality: i32) -> Result<(), SiteError> {
    for path in compressible(site)? {
        let bytes = fs::read(&path).map_err(at(&path))?;
        write(&path, "br", brotli(&bytes, quality))?;
        write(&path, "gz", gzip(&bytes))?;
    }
    Ok(())
}

/// The name of a compressed file: `saute_web.js.br`.
pub fn name(path: &Path, ending: &str) -> PathBuf {
    let mut name = path.as_os_str().to_owned();
    name.push(".");
    name.push(ending);
    name.into()
}

fn write(path: &Path, ending: &str, bytes: io::Result<Vec<u8>>) -> Result<(), SiteError> {
    let path = name(path, ending);
    bytes.and_then(|bytes| fs::write(&path, bytes)).map_err(at(&path))
}

fn brotli(bytes: &[u8], quality: i32) -> io::Result<Vec<u8>> {
    let params = brotli::enc::BrotliEncoderParams { quality, lgwin: WINDOW, ..Default::default() };
    let mut out = Vec::new();
    brotli::BrotliCompress(&mut &*bytes, &mut out, &params)?;
    Ok(out)
}

fn gzip(bytes: &[u8]) -> io::Result<Vec<u8>> {
    let mut encoder = flate2::write::GzEncoder::new(Vec::new(), flate2::Compression::best());
    encoder.write_all(bytes)?;
    encoder.finish()
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use std::io::Read;

    use super::*;

    /// Promise: both forms hold the same bytes as the file, and pictures have none.
    #[test]
    fn both_forms_unpack_to_the_file() {
        let site = tempfile::tempdir().unwrap();
        let text = "steak ".repeat(1000);
        std::fs::create_dir(site.path().join("inner")).unwrap();
        let file = site.path().join("inner/a.js");
        std::fs::write(&file, &text).unwrap();
        std::fs::write(site.path().join("a.png"), &text).unwrap();
        compress(site.path(), 5).unwrap();
        let (mut gzip, mut brotli) = (String::new(), Vec::new());
        flate2::read::GzDecoder::new(&*fs::read(name(&file, "gz")).unwrap()).read_to_string(&mut gzip).unwrap();
        brotli::BrotliDecompress(&mut &*fs::read(name(&file, "br")).unwrap(), &mut brotli).unwrap();
        assert!(gzip == text && brotli == text.as_bytes());
        assert!(!site.path().join("a.png.gz").exists());
    }
}
