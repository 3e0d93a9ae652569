//! The two rules that turn a mesh into conductances.

/// How the edges of a mesh conduct.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Rule {
    /// Linear shape functions: area over length of the cells that meet at the edge; converges at second order.
    #[default]
    ShapeFunctions,
    /// A rod along every edge of the mesh with a cross-section of V^(2/3), V the mean of both nodes' volumes: right on a
    /// lattice of cubes alone, kept for comparison. Heat enters at the vertices within [`SEGMENTS_REACH`] of a face.
    Segments,
}

/// Vertices this close to a face take its heat under [`Rule::Segments`] [m] (chosen: our meshes have nodes on their
/// faces, and none so close below them).
pub const SEGMENTS_REACH: f64 = 1e-6;

/// Shape of an edge under [`Rule::Segments`]: V^(2/3) over length, V the mean of both ends' volumes [m].
pub fn segment_shape(volumes: [f64; 2], length: f64) -> f64 {
    let root = libm::cbrt(0.5 * (volumes[0] + volumes[1]));
    root * root / length
}
