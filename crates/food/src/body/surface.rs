//! The surface of a swept body: triangles over its nodes, and the patches at their corners.

use saute_heat::SweptMesh;

use crate::body::patch::{Face, Patch};

/// Triangles over the nodes of a surface, counter-clockwise seen from outside.
#[derive(Clone, Debug, Default)]
pub struct Surface {
    /// Nodes at the corners of each triangle.
    pub triangles: Vec<[u32; 3]>,
    /// Patches at the corners of each triangle.
    pub patches: Vec<[u32; 3]>,
}

impl Surface {
    /// The faces of a swept body; empty if its section has no triangles, as in a product mesh.
    pub(crate) fn of(mesh: &SweptMesh, patches: &[Patch]) -> Self {
        let mut surface = Self::default();
        let mut patch_of = vec![u32::MAX; mesh.node_count()];
        for (face, triangles) in [
            (Face::Bottom, mesh.end_triangles(false)),
            (Face::Top, mesh.end_triangles(true)),
            (Face::Side, mesh.side_triangles()),
        ] {
            patch_of.fill(u32::MAX);
            let of_face = patches.iter().enumerate().filter(|(_, p)| p.face == face);
            of_face.for_each(|(index, p)| patch_of[p.node as usize] = index as u32);
            for t in triangles {
                let corners = t.map(|node| patch_of[node as usize]);
                if corners.iter().all(|p| *p != u32::MAX) {
                    surface.triangles.push(t);
                    surface.patches.push(corners);
                }
            }
        }
        surface
    }
}
