//! The mouse in the scene: it turns the eye, grabs pieces and the pan, and leads them by force.

use glam::Vec3;

/// What the mouse is doing in the scene.
#[derive(Clone, Debug, Default, PartialEq)]
pub enum Hold {
    /// Nothing.
    #[default]
    Nothing,
    /// It turns the eye.
    Eye,
    /// A finger that was held still shows what is under it.
    Asks,
    /// It carries a piece that waits on the board.
    Waiting(String),
    /// It leads the tongs that hold a piece.
    Piece(String),
    /// It leads the turner.
    Turner,
    /// It holds the pan: from the pointer's place in a level plane to the pan's middle [m].
    Pan {
        /// From pointer to middle.
        offset: Vec3,
        /// Height of the plane.
        plane: f32,
    },
}

/// Radians a point of drag (chosen: half a turn across a window).
pub const ORBIT_PER_POINT: f32 = 0.005;
