//! Voronoi meshes inside closed surfaces: each node's control volume is its Voronoi cell, cut off at the surface.
//!
//! Nodes are on the surface, in layers below it, and on a lattice inside. A Voronoi face is perpendicular to the line
//! between its two nodes. The two-point flux with face area ÷ distance is therefore exact for linear fields and never has a
//! negative weight, so explicit steps obey the maximum principle.
//!
//! A cube of 20 mm, given as loose triangles in millimetres:
//!
//! ```
//! use saute_heat::{CellMesh, Fineness, Soup, Surface};
//!
//! let corner = |k: u32| [k & 1, k >> 1 & 1, k >> 2].map(|bit| 20.0 * f64::from(bit));
//! let sides = [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]];
//! let triangles = sides.iter().flat_map(|&[a, b, c, d]| [[a, b, c], [a, c, d]]).collect();
//! let soup = Soup { vertices: (0..8).map(corner).collect(), triangles, ..Soup::default() };
//!
//! let surface = Surface::close(&soup, 1e-3)?.centred(1.0);
//! let fineness = Fineness::of(&surface, 2.0);
//! let mesh = CellMesh::new(surface, fineness)?;
//! let volume_m3: f64 = mesh.graph.volume.iter().sum();
//! assert!((volume_m3 - 8e-6).abs() < 1e-15, "{volume_m3} m³");
//!
//! let field_k: Vec<f64> = mesh.positions.iter().map(|p| 300.0 + 1000.0 * p[2]).collect();
//! let at_k = mesh.at(&field_k, [0.001, 0.002, 0.003]);
//! assert!((at_k - 303.0).abs() < 1e-6, "{at_k} K");
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod cell;
mod cell_mesh;
mod layer;
mod point_grid;
mod sample;
mod sites;
mod skin;
mod slice;
mod weights;

pub use cell_mesh::{CellMesh, CellMeshError, CellPatch, Fineness};
pub use skin::Skin;
pub use slice::CellSlice;
pub use weights::Weights;
