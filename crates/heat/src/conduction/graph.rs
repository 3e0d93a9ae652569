//! The graph on which heat is conducted: lumped control volumes joined by edges.

/// The geometry of a body for conduction: node volumes [m³] and edge shapes [m].
///
/// It is the result of linear shape functions with lumped mass: the stiffness matrix is a sum over edges, the mass matrix
/// is diagonal.
#[derive(Clone, Debug, Default)]
pub struct Graph {
    /// Lumped volume of each node's control volume [m³].
    pub volume: Vec<f64>,
    /// Both nodes of each edge.
    pub ends: Vec<[u32; 2]>,
    /// Shape factor of each edge, face area ÷ length, ≥ 0 [m].
    pub shape: Vec<f64>,
}

impl Graph {
    /// Adds an edge between nodes `a` and `b` with the given shape factor [m].
    pub fn push(&mut self, a: u32, b: u32, shape: f64) {
        self.ends.push([a, b]);
        self.shape.push(shape);
    }
}
