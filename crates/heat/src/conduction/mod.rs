//! Heat conduction on lumped control volumes: edge graphs, product meshes, and time integration.

pub mod axis;
pub mod boundary;
pub mod column;
pub mod edge_conduction;
pub mod graph;
pub mod product;
pub mod rule;
pub mod super_step;
pub mod tensor;

pub use edge_conduction::Conduction;
pub use graph::Graph;
