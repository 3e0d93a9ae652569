//! Meshes: cross-sections swept along a path, Voronoi cells inside a closed surface, and closed surfaces.
//!
//! Swept meshes: a Delaunay cross-section is carried along a path in layers. On a prism, linear shape functions give
//! in-plane cotangent weights times the layer height, and along the path area over spacing. Conductances are
//! non-negative by construction; `Section::clamped_edges` counts exceptions, and the shipped outlines have none.
//! Volumes are lumped at the nodes. Between stations they are those of frusta, so a cone is exact.
//!
//! Cell meshes: the nodes are samples on a closed surface, copies of them in layers inwards (0.35 mm first, growing
//! 1.4-fold), and a body-centred lattice inside; each node has a Voronoi cell. Facet area over distance is
//! non-negative and exact for linear fields. Next to sharp edges samples are in mirrored pairs, so that cells end
//! where faces do.
//!
//! A steak of 120 × 80 × 25 mm with a rippled outline and fine levels at both faces:
//!
//! ```
//! use saute_heat::{Outline, Section, SweptMesh, graded_levels};
//!
//! let outline = Outline::superellipse(0.120, 0.080, 2.6, &[(3, 0.02, 1.0)]);
//! let section = Section::mesh(&outline, 4.5e-3, 1.5e-3)?;
//! let steak = SweptMesh::new(section, graded_levels(0.025, 0.5e-3, 1.4, 2.5e-3));
//! let volume_m3: f64 = steak.graph.volume.iter().sum();
//! assert!((volume_m3 - 0.025 * outline.area()).abs() < 0.01 * volume_m3);
//! assert!((volume_m3 - 205e-6).abs() < 5e-6, "{volume_m3} m³");
//! # Ok::<(), saute_heat::MeshError>(())
//! ```

pub mod body_mesh;
mod bounds;
pub mod cells;
pub mod coarsening;
pub mod cut;
pub mod levels;
pub mod locate;
pub mod outline;
pub mod outline_bands;
pub mod path;
pub mod probe;
pub mod section;
pub mod surface;
pub mod swept;
mod swept_probe;
mod swept_surface;
