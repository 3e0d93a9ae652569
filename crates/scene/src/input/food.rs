//! A food as the renderer's input: mesh, state of the vertices, cut and seared lines.

use std::sync::Arc;

use glam::{Mat4, Vec3};

/// One food.
#[derive(Clone, Debug)]
pub struct FoodLook {
    /// Shape and what never changes.
    pub mesh: Arc<FoodMesh>,
    /// State of every vertex of `mesh`; the same allocation as long as nothing in it has changed.
    pub vertices: Arc<Vec<FoodVertex>>,
    /// Pose: maps the rest frame (origin at the rest shape's centroid) to the world.
    pub world_from_rest: Mat4,
    /// A cut that shows the inside; the food stays whole for everything else.
    pub slice: Option<SliceLook>,
    /// Lines that ridges seared into the lower and the upper face of the rest shape, the strongest first.
    pub sear: [[Option<SearLook>; SEAR_SETS]; 2],
    /// Steam that leaves it [g/s]; bubbles round its foot follow it.
    pub steam_g_s: f32,
    /// Juice that lies round it on the board [g].
    pub juice_g: f32,
}

/// Sets of seared lines that are drawn on each face (chosen: crossed lines).
pub const SEAR_SETS: usize = 2;

/// Parallel lines on which a face browned ahead of the rest, in the rest frame.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SearLook {
    /// Unit vector along the lines.
    pub direction: glam::Vec2,
    /// Distance across, towards (d_y, −d_x), of the middle of one line from the origin [m].
    pub phase: f32,
    /// From line to line [m].
    pub pitch: f32,
    /// Width of a line [m].
    pub width: f32,
    /// Share of the face's browning that came while it lay on these ridges.
    pub share: f32,
    /// Browning that came then, on the lines and between them.
    pub browning: [f32; 2],
    /// Charring, in the same way.
    pub charring: [f32; 2],
}

/// The rest shape of a food; shared between frames.
#[derive(Clone, Debug)]
pub struct FoodMesh {
    /// Changes when the mesh or what grew in it changes; renderers cache by it.
    pub key: u64,
    /// Triangles, counter-clockwise seen from outside.
    pub triangles: Vec<[u32; 3]>,
    /// Texture of the flesh, finer than the mesh.
    pub texture: FleshTexture,
    /// Its place in the texture, so that no two pieces look alike [m].
    pub texture_place: Vec3,
    /// True if it grew along x rather than z: a stick of a root.
    pub grew_along_x: bool,
    /// Colours that browning goes through.
    pub palette: BrowningPalette,
    /// Fat, second tissue and borders in the flesh on a regular grid over the rest box.
    pub grain: GrainVolume,
}

/// Texture of flesh, finer than the mesh.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum FleshTexture {
    /// Muscle whose fibres run along z.
    Muscle,
    /// Ground meat: strands pressed together.
    Ground,
    /// A root: core, cortex and rays between.
    Root,
    /// A shaft of sheaths, one in the other.
    Sheaths,
    /// The segments of a shrimp.
    Shrimp,
    /// Flakes of fish with pale sheets between them, across x.
    Flakes,
    /// Even flesh.
    Plain,
    /// A slice of a mushroom: skin round its cap, gills beside its stem.
    Mushroom,
    /// White and yolk of an egg.
    Egg,
    /// Layers of an onion, with veins along them.
    Layers,
    /// The wall of a pod: smooth skin, ribbed flesh.
    Pod,
}

/// Colours that browning goes through, L*a*b*.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct BrowningPalette {
    /// Lean flesh at `golden_at`.
    pub golden: [f32; 3],
    /// Browning at which lean flesh is golden (0–1).
    pub golden_at: f32,
    /// Lean flesh wholly browned.
    pub crust: [f32; 3],
    /// Charred.
    pub char: [f32; 3],
    /// Fat wholly browned.
    pub fat_brown: [f32; 3],
    /// What the second tissue adds to flesh that has not browned.
    pub second: [f32; 3],
}

/// Structure of the flesh on a regular grid.
#[derive(Clone, Debug)]
pub struct GrainVolume {
    /// Cells along x, y, z.
    pub size: [u32; 3],
    /// Lowest corner in the rest frame [m].
    pub origin: Vec3,
    /// Extent in the rest frame [m].
    pub extent: Vec3,
    /// Four bytes a cell, x fastest: depth within a seam of fat (see [`WITHIN_RANGE`]), share of the second tissue
    /// (255 = all), distance from the nearest border of a tissue (see [`BORDER_RANGE`]), a free tone of its sheath.
    pub cells: Vec<[u8; 4]>,
}

/// Depth within a seam of fat that the bytes 0 and 255 encode, below and above its edge, in widths of the edge
/// (chosen).
pub const WITHIN_RANGE: f32 = 3.0;
/// Distance from a border that byte 255 encodes [m] (chosen: half of a thick sheath).
pub const BORDER_RANGE: f32 = 1.5e-3;

/// A vertical cut through a food.
#[derive(Clone, Debug, PartialEq)]
pub struct SliceLook {
    /// A point of the plane, rest frame [m].
    pub point: Vec3,
    /// Unit normal, rest frame; the side it points to is hidden (ghosted).
    pub normal: Vec3,
    /// Vertices of the cut face. Of an upright slice `along` and `dorsal` are the browning of the upper and the lower
    /// face, `juice` and `seared` the depths below them [m].
    pub vertices: Vec<FoodVertex>,
    /// Triangles of the cut face, facing along `normal`.
    pub triangles: Vec<[u32; 3]>,
    /// True if the hidden side is drawn as a ghost; false where a knife has halved the food.
    pub ghost: bool,
}

/// State of one vertex of a food; the colours before browning come from the core (L*a*b* over 100).
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq, bytemuck::Pod, bytemuck::Zeroable)]
pub struct FoodVertex {
    /// Position in the rest shape, where the solid textures are sampled [m].
    pub rest: [f32; 3],
    /// Outward unit normal in the rest frame.
    pub normal: [f32; 3],
    /// Colour of lean flesh of the first tissue before it browns.
    pub lean: [f32; 3],
    /// Colour of fat before it browns.
    pub fat: [f32; 3],
    /// Browning (0–1).
    pub browning: f32,
    /// Charring (0–1).
    pub charring: f32,
    /// Liquid on the surface (0 dry crust – 1 glistening).
    pub wetness: f32,
    /// How far it is cooked (0 raw – 1 done): opaque, matt.
    pub cooked: f32,
    /// Coordinate into the colour table (0–1), linear between vertices.
    pub field: f32,
    /// Place along the body (0–1), where that matters: a shrimp's segments.
    pub along: f32,
    /// Belly (−1) to back (1), in the same way.
    pub dorsal: f32,
    /// How dark seared lines are here over their mean on the face.
    pub seared: f32,
    /// Position in the present shape, in the same frame [m].
    pub position: [f32; 3],
    /// Juice that lies on the face over the most that stays there (0–1): it is in beads.
    pub juice: f32,
}

impl FoodVertex {
    /// Returns the mean of vertices by weights.
    pub fn mean<const N: usize>(corners: [(&Self, f32); N]) -> Self {
        let mut sum = [0.0f32; VERTEX_NUMBERS];
        for (corner, weight) in corners {
            let numbers: &[f32; VERTEX_NUMBERS] = bytemuck::cast_ref(corner);
            sum.iter_mut().zip(numbers).for_each(|(sum, number)| *sum += weight * number);
        }
        bytemuck::cast(sum)
    }

    /// Returns the state at a share of the way to another vertex.
    pub fn lerp(&self, other: &Self, share: f32) -> Self {
        let numbers = |v: &Self| -> [f32; VERTEX_NUMBERS] { bytemuck::cast(*v) };
        let (from, to) = (numbers(self), numbers(other));
        bytemuck::cast(std::array::from_fn::<f32, VERTEX_NUMBERS, _>(|k| from[k] + share * (to[k] - from[k])))
    }
}

/// Numbers in a vertex.
const VERTEX_NUMBERS: usize = size_of::<FoodVertex>() / size_of::<f32>();

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_mean_of_vertices_is_the_mean_of_all_their_numbers() {
        let vertex = |first: f32| -> FoodVertex {
            bytemuck::cast(std::array::from_fn::<f32, VERTEX_NUMBERS, _>(|k| first + k as f32))
        };
        let [a, b, c] = [1.0, 3.0, 9.0].map(vertex);
        assert_eq!(FoodVertex::mean([(&a, 0.75), (&b, 0.25)]), a.lerp(&b, 0.25));
        assert_eq!(FoodVertex::mean([(&a, 0.25), (&b, 0.5), (&c, 0.25)]), vertex(4.0));
    }
}
