//! Meshes of bodies and heat conduction on them, independent of food.
//!
//! A body is a cross-section swept along a path in levels ([`SweptMesh`]), Voronoi cells inside a closed surface
//! ([`CellMesh`]), either of both ([`BodyMesh`]), or a product of axes ([`conduction::tensor::TensorBody`]). Linear
//! shape functions with lumped mass give every edge a conductance and every node a control volume, so a time step is a
//! sum over edges ([`Conduction`]). It conserves energy to rounding and satisfies the maximum principle up to
//! [`Conduction::stable_step`]. All quantities are in SI units.
//!
//! A slab between two temperatures, compared with the exact series:
//!
//! ```
//! use saute_heat::Boundary;
//! use saute_heat::conduction::axis::{Axis, End};
//! use saute_heat::conduction::product::{Constants, ProductOperator};
//! use saute_heat::conduction::super_step::SuperStep;
//! use saute_heat::conduction::tensor::TensorBody;
//!
//! // Meat, 20 mm thick, at 283 K; both faces jump to 373 K.
//! let slab = TensorBody::new(vec![Axis::straight((0..=40).map(|i| 0.5e-3 * f64::from(i)).collect())]);
//! let meat = Constants { conductivity: 0.48, capacity: 3.7e6 };
//! let faces = [(0, End::Low, Boundary::Fixed(373.0)), (0, End::High, Boundary::Fixed(373.0))];
//! let operator = ProductOperator::new(&slab, &[meat], &faces);
//! let mut temperature_k = vec![283.0; slab.node_count()];
//! (temperature_k[0], temperature_k[40]) = (373.0, 373.0);
//!
//! // 240 s in steps of 2 s, each longer than an explicit step may be.
//! let stages = SuperStep::stages_for(2.0, operator.stable_step());
//! let mut step = SuperStep::new(slab.node_count());
//! (0..120).for_each(|_| step.advance(&mut temperature_k, 2.0, stages, &operator));
//!
//! // Carslaw & Jaeger (1959), section 3.3, with the Fourier number of the half-thickness.
//! let fourier = 0.48 / 3.7e6 * 240.0 / (0.01 * 0.01);
//! let excess: f64 = (0..20)
//!     .map(|n| (f64::from(n) + 0.5) * std::f64::consts::PI)
//!     .map(|zeta| 2.0 * zeta.sin() / zeta * (-zeta * zeta * fourier).exp())
//!     .sum();
//! let exact_k = 373.0 - 90.0 * excess;
//! assert!((temperature_k[20] - exact_k).abs() < 0.05, "{} K, exact {exact_k} K", temperature_k[20]);
//! ```

pub mod conduction;
pub mod mesh;
pub mod sorted;
pub mod vector;

pub use conduction::boundary::Boundary;
pub use conduction::rule::Rule;
pub use conduction::{Conduction, Graph, Layers};
pub use mesh::body_mesh::{BodyMesh, Layout};
pub use mesh::cells::{CellMesh, CellMeshError, Fineness};
pub use mesh::coarsening::Coarsening;
pub use mesh::cut::{Cut, CutPoint};
pub use mesh::levels::graded_levels;
pub use mesh::locate::{Located, Locator};
pub use mesh::outline::Outline;
pub use mesh::path::{Path, Station};
pub use mesh::probe::Probe;
pub use mesh::section::{MeshError, Section};
pub use mesh::surface::{Defect, Soup, Surface};
pub use mesh::swept::SweptMesh;
