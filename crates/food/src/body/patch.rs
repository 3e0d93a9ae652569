//! Patches: the parts of a body's faces that belong to single nodes.

use saute_heat::SweptMesh;

/// Face of a body, named by the path of its mesh.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Face {
    /// Level 0 of the mesh.
    Bottom,
    /// The last level.
    Top,
    /// The swept boundary of the section.
    Side,
}

/// Part of a face that belongs to one node.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Patch {
    /// The node.
    pub node: u32,
    /// The face.
    pub face: Face,
    /// Index of the air zone in front of the patch, used while it has no contact.
    pub air: usize,
    /// Area of the rest shape [m²].
    pub area: f64,
}

/// Returns the patches of a swept body in the order bottom, top, side; each face has its own air zone.
pub fn patches(mesh: &SweptMesh) -> Vec<Patch> {
    let (n, last) = (mesh.nodes_per_level(), mesh.levels.len() - 1);
    let mut all = Vec::with_capacity(2 * n);
    for (face, level) in [(Face::Bottom, 0), (Face::Top, last)] {
        let areas = mesh.section_at(level).areas.iter().enumerate();
        all.extend(areas.map(|(i, &area)| Patch { node: mesh.node(level, i) as u32, face, air: face as usize, area }));
    }
    let sides = mesh.side_areas().into_iter().enumerate().filter(|(_, area)| *area > 0.0);
    all.extend(sides.map(|(node, area)| Patch { node: node as u32, face: Face::Side, air: Face::Side as usize, area }));
    all
}
