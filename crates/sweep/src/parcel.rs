//! A sweep as bytes, for a machine that has none of its files.

use std::collections::{BTreeMap, BTreeSet};

use saute_kitchen::OwnFiles;
use saute_kitchen::heat::Soup;
use saute_schema::InputError;
use serde::{Deserialize, Serialize};

use crate::sweep::{Base, Sweep};

/// Corners, triangles and unit of a surface.
type Surface = (Vec<[f64; 3]>, Vec<[u32; 3]>, f64);

/// All that a sweep is made of.
#[derive(Deserialize, Serialize)]
struct Parcel {
    text: String,
    file: String,
    recipe: String,
    recipe_file: String,
    texts: BTreeMap<String, String>,
    surfaces: BTreeMap<String, Surface>,
    unreadable: BTreeSet<String>,
}

impl Sweep {
    /// Returns all that the sweep is made of as bytes: specification, recipe and the user's data files.
    pub fn to_bytes(&self) -> Vec<u8> {
        let Base { recipe, file: recipe_file, own } = self.base().clone();
        let surfaces = own.surfaces.into_iter().map(|(path, s)| (path, (s.vertices, s.triangles, s.unit_mm))).collect();
        let (texts, unreadable) = (own.texts, own.unreadable);
        let (text, file) = (self.text().to_owned(), self.file().to_owned());
        // Texts, numbers and lists of them always have bytes.
        postcard::to_allocvec(&Parcel { text, file, recipe, recipe_file, texts, surfaces, unreadable })
            .unwrap_or_default()
    }

    /// Makes a sweep from its bytes; none if they are not those of one of this version.
    pub fn from_bytes(bytes: &[u8]) -> Option<Result<Self, InputError>> {
        let Parcel { text, file, recipe, recipe_file, texts, surfaces, unreadable } =
            postcard::from_bytes(bytes).ok()?;
        let soup = |(vertices, triangles, unit_mm)| Soup { vertices, triangles, unit_mm };
        let surfaces = surfaces.into_iter().map(|(path, surface)| (path, soup(surface))).collect();
        let own = OwnFiles { texts, surfaces, unreadable };
        Some(Self::new(&text, &file, Base { recipe, file: recipe_file, own }))
    }
}
