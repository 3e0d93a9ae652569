//! Surface files: read, closed, filled with cells and fried.

use saute_kitchen::data::library::surface_file;

use crate::kitchen_files::library_with;
use crate::ten_ticks::fry;

/// A food whose body comes from a surface.
const FOOD: &str = include_str!("../../../fuzz/seeds/food/from-a-surface.toml");

/// STL, binary or ASCII.
pub fn stl(bytes: &[u8]) {
    cook("piece.stl", bytes);
}

/// Wavefront OBJ.
pub fn obj(bytes: &[u8]) {
    cook("piece.obj", bytes);
}

/// glTF, JSON or binary; every file that it names is the input again.
pub fn gltf(bytes: &[u8]) {
    cook("piece.gltf", bytes);
}

fn cook(name: &str, bytes: &[u8]) {
    debug_assert!(surface_file(FOOD).is_some(), "the food has a surface");
    let Ok(soup) = saute_surface::read(name, bytes, |_| Some(bytes.to_vec())) else { return };
    if let Some(library) = library_with("foods/attacked.toml", FOOD, Some(soup)) {
        fry(&library, "attacked");
    }
}
