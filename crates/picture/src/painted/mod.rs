//! The foods as coloured surfaces: the drawn skins with the colour of the flesh at every vertex, for files that hold no
//! textures.
//!
//! A colour is that of the core's palette, with seams of fat and second tissues where they are and with lines that ridges
//! seared. What the renderer adds (grain, gloss, light) is not in it. Skins are refined until a seam spans several vertices.

mod mesh;
mod paint;

use glam::Vec3;
use saute_kitchen::heat::Layout;
use saute_kitchen::{Kitchen, Piece};
use saute_scene::input::{FoodLook, FoodVertex};

use crate::painted::mesh::Mesh;
use crate::painted::paint::Paint;
use crate::pose::{Places, Pose};
use crate::stage::{Stage, StageOptions};

/// Shortest edge that is halved [m] (chosen: seams of fat are wider).
const FINEST: f32 = 1.0e-3;
/// About the number of vertices of all surfaces together at most [-] (chosen: a file of 10 MB).
const MOST_VERTICES: f32 = 200_000.0;
/// Roughness of a dry surface, and what wetness takes off it [-] (chosen: crust is matt, raw flesh shines).
const ROUGHNESS: [f32; 2] = [0.8, 0.45];

/// A coloured surface in its pose: a food, or a half of one that was halved, with its cut face.
#[derive(Clone, Debug, PartialEq)]
pub struct Painted {
    /// Index of the piece in the kitchen.
    pub piece: usize,
    /// Where it lies.
    pub pose: Pose,
    /// Points in its frame [m].
    pub points: Vec<[f32; 3]>,
    /// Outward unit normals in its frame [-].
    pub normals: Vec<[f32; 3]>,
    /// Colours in linear sRGB, 0 to 1 [-].
    pub colours: Vec<[f32; 3]>,
    /// Triangles, counter-clockwise seen from outside.
    pub triangles: Vec<[u32; 3]>,
    /// Roughness, 0 to 1 [-].
    pub roughness: f32,
}

/// Returns the surfaces of all foods of a kitchen, as they lie in the picture.
pub fn painted(kitchen: &Kitchen) -> Vec<Painted> {
    let mut stage = Stage::default();
    let looks = stage.looks(kitchen, &StageOptions::default(), &Places::default());
    let area: f32 = looks.iter().flat_map(|(_, look)| parts(look)).map(|mesh| mesh.area()).sum();
    // Halved edges are on average three quarters as long as the longest: two vertices on its square.
    let longest = (2.0 * area / MOST_VERTICES).sqrt().max(FINEST);
    looks.iter().map(|(piece, look)| surface(*piece, &kitchen.pieces()[*piece], look, longest)).collect()
}

/// The skin on the side of a cut that is seen, and the cut face.
fn parts(look: &FoodLook) -> Vec<Mesh> {
    let skin = Mesh::new(look.vertices.to_vec(), look.mesh.triangles.clone());
    let Some(cut) = &look.slice else { return vec![skin] };
    // On a cut face these two have another meaning: see `SliceLook`.
    let face = cut.vertices.iter().map(|v| FoodVertex { seared: 0.0, juice: 0.0, ..*v }).collect();
    vec![skin.clipped(cut.point, cut.normal), Mesh::new(face, cut.triangles.clone())]
}

fn surface(index: usize, piece: &Piece, look: &FoodLook, longest: f32) -> Painted {
    let (_, rotation, position) = look.world_from_rest.to_scale_rotation_translation();
    let mut painted = Painted {
        piece: index,
        pose: Pose { position, rotation: rotation.normalize() },
        points: Vec::new(),
        normals: Vec::new(),
        colours: Vec::new(),
        triangles: Vec::new(),
        roughness: roughness(&look.vertices),
    };
    let paint = Paint::of(&piece.model, look);
    // The normals of the rest shape hold for slices and for what contracts alike in all directions, not for what curls.
    let curls = matches!(piece.model.mesh().layout(), Layout::Along(..));
    for part in parts(look) {
        painted.add(part.refined(longest), &paint, curls);
    }
    painted
}

impl Painted {
    fn add(&mut self, part: Mesh, paint: &Paint, curls: bool) {
        let first = self.points.len() as u32;
        self.points.extend(part.vertices.iter().map(|v| v.position));
        self.normals.extend(if curls { part.present_normals() } else { part.rest_normals() });
        self.colours.extend(part.vertices.iter().map(|v| paint.colour(v)));
        self.triangles.extend(part.triangles.iter().map(|t| t.map(|corner| first + corner)));
    }
}

fn roughness(vertices: &[FoodVertex]) -> f32 {
    let wet: f32 = vertices.iter().map(|v| v.wetness).sum::<f32>() / vertices.len().max(1) as f32;
    ROUGHNESS[0] - ROUGHNESS[1] * wet
}

/// A vector of unit length, or up if it has none.
fn unit(v: Vec3) -> [f32; 3] {
    v.normalize_or(Vec3::Z).to_array()
}
