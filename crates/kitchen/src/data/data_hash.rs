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
        // Line ends of another system do not change the content of a file.
        let text = text.replace('\r', "");
        let text = if path.starts_with("foods/") { without_words(&text) } else { text };
        hash_of([text.as_bytes(), &surface])
    };
    files.iter().map(|(path, text)| (path.clone(), hash(path, text))).collect()
}

/// Tables of a food's file that no piece is built from: what it is called, and in whose words its doneness is.
const WORDS: [&str; 2] = ["words", "doneness"];

/// Returns the text of a food's file without the tables that no piece is built from: a cook that was kept before a food got
/// another name goes on after it.
fn without_words(text: &str) -> String {
    let head = |line: &str| {
        let name = line.trim_start_matches('[').split(['.', ']']).next().unwrap_or_default().trim();
        line.starts_with('[').then(|| WORDS.contains(&name))
    };
    let mut is_of_words = false;
    let is_kept = |line: &&str| {
        is_of_words = head(line).unwrap_or(is_of_words);
        !is_of_words
    };
    text.split_inclusive('\n').filter(is_kept).collect()
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

#[cfg(test)]
mod tests {
    use super::*;

    const FOOD: &str = "name = \"Tofu\"\nform = \"steak\"\n\n[size]\nmin_mm = 3\n\n[natural]\nwedge = 0.1\n";
    const WORDS: &str = "[words.en]\nnoun = \"tofu\"\n\n[words.ja]\nname = \"豆腐\"\n\n[doneness]\nid = \"tofu\"\n\n";

    fn hash(path: &str, text: &str) -> u64 {
        file_hashes(&[(path.to_owned(), text.to_owned())].into(), &BTreeMap::new())[path]
    }

    #[test]
    fn what_a_food_is_called_does_not_change_what_it_is() {
        let (words_first, words_last) = (FOOD.replace("[size]", &format!("{WORDS}[size]")), format!("{FOOD}{WORDS}"));
        for named in [words_first, words_last] {
            assert_eq!(without_words(&named), FOOD);
            assert_eq!(hash("foods/tofu.toml", &named), hash("foods/tofu.toml", FOOD));
            let thicker = named.replace("0.1", "0.2");
            assert_ne!(hash("foods/tofu.toml", &thicker), hash("foods/tofu.toml", FOOD));
        }
        assert_ne!(hash("pans/tofu.toml", WORDS), hash("pans/tofu.toml", ""), "of foods alone");
    }

    /// Kept cooks of foods that had no words in their files yet go on.
    #[test]
    fn the_shipped_foods_are_what_they_were_without_words() {
        let foods: BTreeMap<String, String> =
            Library::embedded_files().into_iter().filter(|(path, _)| path.starts_with("foods/")).collect();
        assert!(foods.len() >= 7);
        for (path, text) in foods {
            let rest = without_words(&text);
            assert!(text.contains("[words.en]") && !rest.contains("[words") && !rest.contains("\n\n\n"), "{path}");
        }
    }
}
