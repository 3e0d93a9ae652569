//! The mesh of a body of either kind, with the queries that both kinds answer.

use crate::conduction::graph::Graph;
use crate::mesh::cells::CellMesh;
use crate::mesh::path::Station;
use crate::mesh::probe::Probe;
use crate::mesh::swept::SweptMesh;

/// The mesh of a body: a swept cross-section, or Voronoi cells inside a closed surface.
#[expect(clippy::large_enum_variant, reason = "a model holds one mesh; the swept kind needs no indirection")]
#[derive(Clone, Debug)]
pub enum BodyMesh {
    /// A cross-section swept along a path in levels.
    Swept(SweptMesh),
    /// Voronoi cells inside a closed surface.
    Cells(Box<CellMesh>),
}

/// A borrowed body mesh by its layout.
#[derive(Clone, Copy, Debug)]
pub enum Layout<'a> {
    /// A section swept straight up: a slice.
    Upright(&'a SweptMesh),
    /// A section swept along stations.
    Along(&'a SweptMesh, &'a [Station]),
    /// Voronoi cells inside a closed surface.
    Cells(&'a CellMesh),
}

impl BodyMesh {
    /// Returns the layout of the mesh.
    #[inline]
    pub fn layout(&self) -> Layout<'_> {
        match self {
            Self::Swept(mesh) => mesh.stations().map_or(Layout::Upright(mesh), |s| Layout::Along(mesh, s)),
            Self::Cells(cells) => Layout::Cells(cells),
        }
    }

    /// Returns the swept mesh, or `None` for a body of cells.
    #[inline]
    pub fn swept(&self) -> Option<&SweptMesh> {
        match self {
            Self::Swept(mesh) => Some(mesh),
            Self::Cells(_) => None,
        }
    }

    /// Returns the cell mesh, or `None` for a swept body.
    #[inline]
    pub fn cells(&self) -> Option<&CellMesh> {
        match self {
            Self::Swept(_) => None,
            Self::Cells(cells) => Some(cells),
        }
    }

    /// Returns true if the body is a slice: a section swept straight up.
    #[inline]
    pub fn is_slice(&self) -> bool {
        matches!(self.layout(), Layout::Upright(_))
    }

    /// Returns the lumped volumes [m³] and edge shapes [m].
    #[inline]
    pub fn graph(&self) -> &Graph {
        match self {
            Self::Swept(mesh) => &mesh.graph,
            Self::Cells(cells) => &cells.graph,
        }
    }

    /// Returns the lumped volumes [m³] and edge shapes [m] for modification, as where a cut lowers a conductance.
    #[inline]
    pub fn graph_mut(&mut self) -> &mut Graph {
        match self {
            Self::Swept(mesh) => &mut mesh.graph,
            Self::Cells(cells) => &mut cells.graph,
        }
    }

    /// Returns the lumped volume of each node [m³].
    #[inline]
    pub fn volumes(&self) -> &[f64] {
        &self.graph().volume
    }

    /// Returns the number of nodes.
    #[inline]
    pub fn node_count(&self) -> usize {
        match self {
            Self::Swept(mesh) => mesh.node_count(),
            Self::Cells(cells) => cells.node_count(),
        }
    }

    /// Returns the position of a node [m].
    ///
    /// The origin is the bottom centre of a slice, otherwise the centre of the body.
    #[inline]
    pub fn position(&self, node: usize) -> [f64; 3] {
        match self {
            Self::Swept(mesh) => mesh.position(node),
            Self::Cells(cells) => cells.positions[node],
        }
    }

    /// Returns the depth of each node below the nearer face of a slice, otherwise below the surface [m].
    pub fn depths(&self) -> Vec<f64> {
        match self {
            Self::Swept(mesh) => mesh.depths(),
            Self::Cells(cells) => cells.depth.clone(),
        }
    }

    /// Returns the depth of the first nodes below the surface [m].
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

    /// Returns the probe at a point of the mesh's frame [m], or `None` outside the body.
    pub fn probe(&self, p: [f64; 3]) -> Option<Probe> {
        match self {
            Self::Swept(mesh) => mesh.place_of(p).map(|(found, z)| mesh.probe_at(&found, z)),
            Self::Cells(cells) => cells.contains(p).then(|| Probe::Cells(cells.weights(p))),
        }
    }

    /// Returns the value of a node field at a point of the mesh's frame, in the unit of the field; `None` outside the body.
    ///
    /// ```
    /// use saute_heat::{BodyMesh, Outline, Section, SweptMesh, graded_levels};
    ///
    /// let section = Section::mesh(&Outline::circle(0.04), 4e-3, 2e-3)?;
    /// let steak = BodyMesh::from(SweptMesh::new(section, graded_levels(0.02, 1e-3, 1.4, 4e-3)));
    /// let field_c: Vec<f64> = (0..steak.node_count()).map(|n| 20.0 + 2000.0 * steak.position(n)[2]).collect();
    /// let at_c = steak.at(&field_c, [0.01, 0.0, 0.005]).unwrap();
    /// assert!((at_c - 30.0).abs() < 1e-9, "{at_c} °C");
    /// assert_eq!(steak.at(&field_c, [0.05, 0.0, 0.005]), None);
    /// # Ok::<(), saute_heat::MeshError>(())
    /// ```
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
        Self::Cells(Box::new(cells))
    }
}
