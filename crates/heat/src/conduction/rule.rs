//! The two rules that turn a mesh into conductances.

/// How the edges of a mesh conduct.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Rule {
    /// Linear shape functions: area over length of the cells that meet at the edge; converges at second order.
    #[default]
    ShapeFunctions,
    /// A rod along every edge of the mesh with a cross-section of V^(2/3), V the mean of both nodes' volumes: right on a
    /// lattice of cubes alone, kept for comparison. Heat enters at the vertices that lie on the face (our meshes have
    /// none close below it, so any distance up to the first spacing is the same), each by its share of the area.
    Segments,
}

/// Shape of an edge under [`Rule::Segments`]: V^(2/3) over length, V the mean of both ends' volumes [m].
pub fn segment_shape(volumes: [f64; 2], length: f64) -> f64 {
    let root = libm::cbrt(0.5 * (volumes[0] + volumes[1]));
    root * root / length
}
