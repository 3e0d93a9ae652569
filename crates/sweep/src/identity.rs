//! Which sweep it is: a hash of all that its rows follow from.

use std::hash::Hasher;

use siphasher::sip::SipHasher13;

use crate::documents::Documents;
use crate::sweep::Base;

/// Returns the hash of what the rows follow from.
pub(crate) fn hash(text: &str, base: &Base, documents: &Documents) -> u64 {
    let mut hasher = SipHasher13::new();
    let mut add = |bytes: &[u8]| {
        hasher.write(&(bytes.len() as u64).to_le_bytes());
        hasher.write(bytes);
    };
    // Comments and line ends change no row.
    let canonical =
        |text: &str| text.parse().ok().and_then(|t: toml::Table| toml::to_string(&t).ok()).unwrap_or_default();
    add(env!("CARGO_PKG_VERSION").as_bytes());
    add(canonical(text).as_bytes());
    add(canonical(&base.recipe).as_bytes());
    for (path, text) in &documents.data {
        add(path.as_bytes());
        add(text.replace('\r', "").as_bytes());
    }
    for (path, soup) in &base.own.surfaces {
        add(path.as_bytes());
        let corners: Vec<u8> = soup.vertices.iter().flatten().flat_map(|v| v.to_le_bytes()).collect();
        let triangles: Vec<u8> = soup.triangles.iter().flatten().flat_map(|i| i.to_le_bytes()).collect();
        add(&corners);
        add(&triangles);
        add(&soup.unit_mm.to_le_bytes());
    }
    hasher.finish()
}
