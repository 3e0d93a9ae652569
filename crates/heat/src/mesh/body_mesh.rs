//! The mesh of a body, whichever way it was made, and the queries that every mesh answers.

use crate::conduction::graph::Graph;
use crate::mesh::cells::CellMesh;
use crate::mesh::path::Station;
use crate::mesh::probe::Probe;
use crate::mesh::swept::SweptMesh;

/// Mesh of a body: a cross-section swept along a path, or cells inside a closed surface.
#[derive(Clone, Debug)]
pub enum BodyMesh {
    /// A cross-section carried along a path in layers.
    Swept(SweptMesh),
    /// Cells inside a closed surface.
    Cells(CellMesh),
}

/// The three layouts of a body mesh, borrowed; a `match` handles every one.
#[derive(Clone, Copy, Debug)]
pub enum Layout<'a> {
    /// A section carried straight up: a slice.
    Upright(&'a SweptMesh),
    /// A section carried along stations.
    Along(&'a SweptMesh, &'a [Station]),
    /// Cells inside a closed surface.
    Cells(&'a CellMesh),
}

impl BodyMesh {
    /// The layout of the mesh.
    #[inline]
    pub fn layout(&self) -> Layout<'_> {
        match self {
            Self::Swept(mesh) => mesh.stations().map_or(Layout::Upright(mesh), |s| Layout::Along(mesh, s)),
            Self::Cells(cells) => Layout::Cells(cells),
        }
    }

    /// The swept mesh; none where the body is made of cells.
    #[inline]
    pub fn swept(&self) -> Option<&SweptMesh> {
        match self {
            Self::Swept(mesh) => Some(mesh),
            Self::Cells(_) => None,
        }
    }

    /// The cells; none where the body is swept.
    #[inline]
    pub fn cells(&self) -> Option<&CellMesh> {
        match self {
            Self::Swept(_) => None,
            Self::Cells(cells) => Some(cells),
        }
    }

    /// Returns true if the body is a slice: its section carried straight up.
    #[inline]
    pub fn is_slice(&self) -> bool {
        matches!(self.layout(), Layout::Upright(_))
    }

    /// Lumped volumes and edge shapes.
    #[inline]
    pub fn graph(&self) -> &Graph {
        match self {
            Self::Swept(mesh) => &mesh.graph,
            Self::Cells(cells) => &cells.graph,
        }
    }

    /// Lumped volumes and edge shapes, to be changed where a border or a cut lowers a conductance.
    #[inline]
    pub fn graph_mut(&mut self) -> &mut Graph {
        match self {
            Self::Swept(mesh) => &mut mesh.graph,
            Self::Cells(cells) => &mut cells.graph,
        }
    }

    /// Lumped volume of each node [m³].
    #[inline]
    pub fn volumes(&self) -> &[f64] {
        &self.graph().volume
    }

    /// Number of nodes.
    #[inline]
    pub fn node_count(&self) -> usize {
        match self {
            Self::Swept(mesh) => mesh.node_count(),
            Self::Cells(cells) => cells.node_count(),
        }
    }

    /// Position of a node [m]: of a slice from the bottom centre, else about the centre of the body.
    #[inline]
    pub fn position(&self, node: usize) -> [f64; 3] {
        match self {
            Self::Swept(mesh) => mesh.position(node),
            Self::Cells(cells) => cells.positions[node],
        }
    }

    /// Depth of a node: below the nearer face of a slice, else below the skin [m].
    pub fn depth(&self, node: usize) -> f64 {
        match self {
            Self::Swept(mesh) => mesh.depth(node),
            Self::Cells(cells) => cells.depth[node],
        }
    }

    /// Distance of the first nodes below the surface from it [m].
    pub fn first_layer(&self) -> f64 {
        match self {
            Self::Swept(mesh) => mesh.first_layer(),
            Self::Cells(cells) => cells.fineness.first,
        }
    }

    /// Returns true if the edge between two nodes runs along the path, or within 45° of the inward normal among cells.
    #[inline]
    pub fn is_along(&self, a: usize, b: usize) -> bool {
        match self {
            Self::Swept(mesh) => mesh.is_along(a, b),
            Self::Cells(cells) => cells.is_inward(a, b),
        }
    }

    /// Returns the probe at a point of the mesh's frame [m], or none outside the body.
    pub fn probe(&self, p: [f64; 3]) -> Option<Probe> {
        match self {
            Self::Swept(mesh) => mesh.place_of(p).map(|(found, z)| mesh.probe_at(&found, z)),
            Self::Cells(cells) => cells.contains(p).then(|| Probe::Cells(cells.weights(p))),
        }
    }

    /// Returns the value of a node field at a point of the mesh's frame [m], or none outside the body; in the unit of
    /// the field.
    pub fn at(&self, field: &[f64], p: [f64; 3]) -> Option<f64> {
        self.probe(p).map(|probe| probe.read(field))
    }
}

impl From<SweptMesh> for BodyMesh {
    fn from(mesh: SweptMesh) -> Self {
        Self::Swept(mesh)
    }
}

impl From<CellMesh> for BodyMesh {
    fn from(cells: CellMesh) -> Self {
        Self::Cells(cells)
    }
}
