//! The cooked foods as coloured surfaces in a file.

use saute_formats::gltf::{Surface, glb};
use saute_kitchen::{Kitchen, celsius};
use saute_picture::painted::{Painted, painted};

/// Name of the file.
pub const FILE: &str = "cooked.glb";

/// Returns the foods of a kitchen as they lie, with their colours, as binary glTF.
pub fn cooked(kitchen: &Kitchen) -> Vec<u8> {
    let all = painted(kitchen);
    let halves = |piece: usize| all.iter().filter(|other| other.piece == piece).count() > 1;
    let mut surfaces = Vec::with_capacity(all.len());
    for (index, part) in all.iter().enumerate() {
        let id = &kitchen.pieces()[part.piece].id;
        let second = index > 0 && all[index - 1].piece == part.piece;
        let name = match (halves(part.piece), second) {
            (false, _) => id.clone(),
            (true, false) => format!("{id}, first half"),
            (true, true) => format!("{id}, second half"),
        };
        surfaces.push(surface(kitchen, part, name));
    }
    glb(&surfaces)
}

fn surface(kitchen: &Kitchen, part: &Painted, name: String) -> Surface {
    let piece = &kitchen.pieces()[part.piece];
    Surface {
        name,
        position: part.pose.position.as_dvec3().to_array(),
        rotation: part.pose.rotation.as_dquat().to_array(),
        points: part.points.clone(),
        normals: part.normals.clone(),
        colours: part.colours.clone(),
        triangles: part.triangles.clone(),
        roughness: f64::from(part.roughness),
        extras: serde_json::json!({
            "food": piece.id,
            "kind": piece.kind,
            "place": piece.place.name(),
            "time_s": kitchen.time_s(),
            "core_c": celsius(piece.core()),
            "mass_g": 1e3 * piece.mass(),
        }),
    }
}
