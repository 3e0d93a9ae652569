//! Meshes and heat conduction on them; knows no food.
//!
//! A body is a cross-section carried along a path in layers ([`SweptMesh`]), or cells inside a closed surface
//! ([`CellMesh`]). Linear shape functions give every
//! edge a conductance and every node a lumped volume, so a time step is a sum over edges ([`Conduction`]), exact
//! about energy and, within [`Conduction::stable_step`], free of undershoot.

pub mod axis;
pub mod boundary;
pub mod column;
pub mod conduction;
pub mod cut;
pub mod layers;
pub mod levels;
pub mod locate;
pub mod outline;
pub mod path;
pub mod product;
pub mod rule;
pub mod section;
pub mod super_step;
pub mod surface;
pub mod swept;
pub mod tensor;
pub mod vector;
pub mod voronoi;

pub use boundary::Boundary;
pub use conduction::{Conduction, Graph};
pub use cut::{Cut, CutPoint};
pub use layers::Layers;
pub use levels::graded_levels;
pub use locate::{Located, Locator};
pub use outline::Outline;
pub use path::{Path, Station};
pub use rule::Rule;
pub use section::{MeshError, Section};
pub use surface::{Defect, Soup, Surface};
pub use swept::SweptMesh;
pub use voronoi::{CellMesh, CellMeshError, Fineness};
