//! The graph on which heat is conducted: lumped nodes and edges.

/// Geometry of a body for conduction: what linear shape functions leave of it.
#[derive(Clone, Debug, Default)]
pub struct Graph {
    /// Lumped volume of each node [m³].
    pub volume: Vec<f64>,
    /// Both ends of each edge.
    pub ends: Vec<[u32; 2]>,
    /// Shape of each edge: area over length, ≥ 0 [m].
    pub shape: Vec<f64>,
}

impl Graph {
    /// Adds an edge of the given shape [m].
    pub fn push(&mut self, a: u32, b: u32, shape: f64) {
        self.ends.push([a, b]);
        self.shape.push(shape);
    }
}
