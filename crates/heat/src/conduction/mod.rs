//! Heat conduction on lumped control volumes: edge graphs, product meshes, and time integration.
//!
//! Product meshes: a body with constant properties is a product of one-dimensional meshes on straight, cylindrical or
//! spherical axes. Every weight belongs to one axis and nothing is stored per edge. A second-order
//! Runge–Kutta–Legendre scheme integrates it in time.

pub mod axis;
pub mod boundary;
pub mod column;
pub mod edge_conduction;
pub mod graph;
pub mod layers;
pub mod product;
pub mod rule;
pub mod super_step;
pub mod tensor;

pub use edge_conduction::Conduction;
pub use graph::Graph;
pub use layers::Layers;
