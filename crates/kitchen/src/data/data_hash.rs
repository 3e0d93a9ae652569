//! Hashes of data files: what a kitchen is built from.

use std::collections::BTreeMap;

use saute_food::FoodDescription;
use saute_heat::Soup;

use crate::bytes::hash_of;
use crate::data::library::Library;

/// Files that every kitchen is built from.
const OF_EVERY_KITCHEN: [&str; 4] = ["components.toml", "fond.toml", "kitchen-at-home.toml", "kitchen.toml"];

/// Returns the hash of every data file by path; that of a food with a surface includes the surface.
pub(crate) fn file_hashes(
    files: &BTreeMap<String, String>,
    surfaces: &BTreeMap<String, Soup>,
) -> BTreeMap<String, u64> {
    let hash = |path: &String, text: &String| {
        let surface = surfaces.get(path).map(surface_bytes).unwrap_or_default();
        // Line ends of another system do not change what a file says.
        hash_of([text.replace('\r', "").as_bytes(), &surface])
    };
    files.iter().map(|(path, text)| (path.clone(), hash(path, text))).collect()
}

fn surface_bytes(soup: &Soup) -> Vec<u8> {
    let numbers = soup.vertices.iter().flatten().chain([&soup.unit_mm]).flat_map(|v| v.to_le_bytes());
    numbers.chain(soup.triangles.iter().flatten().flat_map(|corner| corner.to_le_bytes())).collect()
}

impl Library {
    /// Hash of all data that a kitchen with a pan is built from, apart from its foods.
    pub fn pan_hash(&self, pan: &str) -> u64 {
        let of_pan = |path: &str| path.strip_prefix("pans/").is_some_and(|file| is_of_pan(file, pan));
        let of_coating = |path: &str| {
            let id = path.strip_prefix("coatings/").and_then(|file| file.strip_suffix(".toml"));
            id.is_some_and(|id| pan.ends_with(id))
        };
        let hob = format!("hobs/{}.toml", self.at_home.hob);
        self.hash_where(|path| {
            let of_every = path == hob || OF_EVERY_KITCHEN.contains(&path) || path.starts_with("oils/");
            of_every || of_pan(path) || of_coating(path)
        })
    }

    /// Hash of all data that a piece of a food is built from.
    pub fn food_hash(&self, id: &str, food: &FoodDescription) -> u64 {
        let paths = [format!("foods/{id}.toml"), format!("kinetics/{}.toml", food.kinetics), "components.toml".into()];
        self.hash_where(|path| paths.iter().any(|own| own == path))
    }

    fn hash_where(&self, is_meant: impl Fn(&str) -> bool) -> u64 {
        let meant = self.hashes.iter().filter(|(path, _)| is_meant(path));
        let parts: Vec<(&String, [u8; 8])> = meant.map(|(path, hash)| (path, hash.to_le_bytes())).collect();
        hash_of(parts.iter().flat_map(|(path, hash)| [path.as_bytes(), hash]))
    }
}

/// Returns true if a file describes a pan, or the bare pan of a coated one.
fn is_of_pan(file: &str, pan: &str) -> bool {
    let Some(id) = file.strip_suffix(".toml") else { return false };
    pan.strip_prefix(id).is_some_and(|rest| rest.is_empty() || rest.starts_with('-'))
}
