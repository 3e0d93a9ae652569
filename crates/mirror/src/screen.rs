//! The screen of a rig: a flat panel, or a projector and the board that it lights.

use glam::{DVec2, DVec3};

use crate::lens::Lens;
use crate::optics::Plane;

/// A device with pixels, and where in the rig they are seen.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Screen {
    /// Pixels of a flat panel.
    Panel(Panel),
    /// Pixels that a projector throws on a flat board.
    Projector(Projector),
}

/// A flat panel.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Panel {
    /// Width and height [pixels].
    pub pixels: DVec2,
    /// The outer corner of the first pixel [m].
    pub first: DVec3,
    /// From there to the end of the first row [m].
    pub row: DVec3,
    /// From there to the beginning of the last row [m].
    pub column: DVec3,
}

/// A projector and its board.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Projector {
    /// Width and height [pixels].
    pub pixels: DVec2,
    /// Centre of projection [m].
    pub position: DVec3,
    /// Unit vector along the optical axis.
    pub axis: DVec3,
    /// Unit vector along the rows, perpendicular to the axis.
    pub right: DVec3,
    /// Focal length [pixels].
    pub focal: f64,
    /// The lens; its centre is the principal point, its unit the focal length.
    pub lens: Lens,
    /// The board that the picture is thrown on.
    pub board: Plane,
}

impl Screen {
    /// Width and height [pixels].
    pub fn pixels(&self) -> DVec2 {
        match self {
            Self::Panel(panel) => panel.pixels,
            Self::Projector(projector) => projector.pixels,
        }
    }

    /// The plane on which the picture appears.
    pub fn plane(&self) -> Plane {
        match self {
            Self::Panel(p) => Plane { point: p.first, normal: p.row.cross(p.column).normalize() },
            Self::Projector(projector) => projector.board,
        }
    }

    /// Where a pixel's light appears on the plane [m]; none for one that the board does not catch.
    pub fn point(&self, pixel: DVec2) -> Option<DVec3> {
        match self {
            Self::Panel(p) => {
                let share = pixel / p.pixels;
                Some(p.first + share.x * p.row + share.y * p.column)
            }
            Self::Projector(p) => p.point(pixel),
        }
    }

    /// The lens between pixels and plane.
    pub fn lens(&self) -> Lens {
        match self {
            Self::Panel(panel) => Lens::none(panel.pixels),
            Self::Projector(projector) => projector.lens.in_unit(0.5 * projector.pixels.length()),
        }
    }
}

impl Projector {
    fn point(&self, pixel: DVec2) -> Option<DVec3> {
        let from = (self.lens.undistorted(pixel) - self.lens.centre) / self.focal;
        let down = self.axis.cross(self.right);
        let ray = self.axis + from.x * self.right + from.y * down;
        let point = self.board.met_by(self.position, self.position + ray)?;
        ((point - self.position).dot(ray) > 0.0).then_some(point)
    }
}
