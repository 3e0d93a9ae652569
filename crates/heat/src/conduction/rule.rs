//! The two discretisations that turn a mesh into edge conductances.

/// The discretisation of conduction on a mesh.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Rule {
    /// Linear shape functions (cotangent weights): face area ÷ length; second-order accurate in space.
    #[default]
    ShapeFunctions,
    /// A rod of cross-section V^(2/3) along every edge, with V the mean volume of its two nodes.
    ///
    /// Exact only on a lattice of cubes; kept for comparison with the method of the literature. Heat enters at the nodes
    /// on the face, each with its share of the face area.
    Segments,
}

/// Returns the shape factor of an edge under [`Rule::Segments`] [m].
///
/// shape = V^(2/3) ÷ `length`, with V the mean of the two nodes' `volumes` [m³].
pub fn segment_shape(volumes: [f64; 2], length: f64) -> f64 {
    let root = libm::cbrt(0.5 * (volumes[0] + volumes[1]));
    root * root / length
}
