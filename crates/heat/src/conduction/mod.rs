//! Heat conduction on lumped nodes: graphs of edges, products of axes, and time steps.

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
