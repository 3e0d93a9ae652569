//! Faces through which a body meets the outside.

use saute_heat::SweptMesh;

/// Which face a patch belongs to, named by the path of the mesh.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Face {
    /// Level 0 of the mesh.
    Bottom,
    /// The last level.
    Top,
    /// The swept boundary of the section.
    Side,
}

/// The part of a face that belongs to one node.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Patch {
    /// The node.
    pub node: u32,
    /// Its face.
    pub face: Face,
    /// Which of the surroundings' airs lies before it while it is free.
    pub air: usize,
    /// Area of the rest shape [m²].
    pub area: f64,
}

/// Patches of a swept body: bottom, top, side, each face with an air of its own.
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
