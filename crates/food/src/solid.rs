//! The solid as which a piece collides.

/// A rounded rod.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Capsule {
    /// Middles of its round ends [m].
    pub ends: [[f64; 3]; 2],
    /// Radius [m].
    pub radius: f64,
}

/// The solid as which a piece collides, in its present shape and its body's frame [m].
#[derive(Clone, Debug, PartialEq)]
pub enum Solid {
    /// A disc; its axis is z.
    Cylinder {
        /// Radius [m].
        radius: f64,
        /// Half its height [m].
        half_height: f64,
    },
    /// A box.
    Cuboid {
        /// Half its edges [m].
        half: [f64; 3],
    },
    /// Rounded rods along a bent body.
    Capsules(Vec<Capsule>),
    /// Convex hulls of points.
    Hulls(Vec<Vec<[f64; 3]>>),
}
