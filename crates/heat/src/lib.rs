//! Meshes and heat conduction on them; knows no food.
//!
//! A body is a cross-section carried along a path in layers ([`SweptMesh`]), or cells inside a closed surface
//! ([`CellMesh`]). Linear shape functions give every
//! edge a conductance and every node a lumped volume, so a time step is a sum over edges ([`Conduction`]), exact
//! about energy and, within [`Conduction::stable_step`], free of undershoot.

pub mod conduction;
pub mod mesh;
pub mod vector;

pub use conduction::boundary::Boundary;
pub use conduction::rule::Rule;
pub use conduction::{Conduction, Graph};
pub use mesh::cells::{CellMesh, CellMeshError, Fineness};
pub use mesh::cut::{Cut, CutPoint};
pub use mesh::levels::graded_levels;
pub use mesh::locate::{Located, Locator};
pub use mesh::outline::Outline;
pub use mesh::path::{Path, Station};
pub use mesh::section::{MeshError, Section};
pub use mesh::surface::{Defect, Soup, Surface};
pub use mesh::swept::SweptMesh;

pub use conduction::{axis, boundary, column, product, rule, super_step, tensor};
pub use mesh::{cells as voronoi, cut, levels, locate, outline, path, section, surface, swept};
