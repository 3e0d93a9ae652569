//! The shapes that pieces are cut to, and what their sizes mean.

use schemars::JsonSchema;
use serde::Deserialize;

/// The shapes that can be built.
#[derive(Clone, Copy, Debug, Deserialize, JsonSchema, PartialEq, Eq)]
#[serde(rename_all = "kebab-case")]
pub enum Form {
    /// A superellipse outline times an uneven thickness; fibres run through the thickness.
    Steak,
    /// A round disc that is pressed by hand: of uneven thickness.
    Patty,
    /// A round slice across a root; its fibres run through the thickness.
    Coin,
    /// A round slice across a shaft of sheaths.
    Ring,
    /// A bar with rounded edges; fibres run along it.
    Stick,
    /// A tapering body on a curved spine that ends in a tail fan; it lies on its side, fibres run along it.
    Shrimp,
    /// Whatever a closed surface of the user's encloses.
    Mesh,
}

impl Form {
    /// Names of its dimensions.
    pub fn dimensions(self) -> &'static [&'static str] {
        match self {
            Self::Steak | Self::Stick => &["length", "width", "thickness"],
            Self::Coin | Self::Ring | Self::Patty => &["diameter", "thickness"],
            Self::Shrimp => &["curve length", "thickest diameter"],
            Self::Mesh => &["longest edge"],
        }
    }

    /// Length, width and thickness from its dimensions, in their unit; none where their number is wrong.
    pub fn extent(self, size: &[f64]) -> Option<[f64; 3]> {
        match (self, size) {
            (Self::Steak | Self::Stick, &[length, width, thickness]) => Some([length, width, thickness]),
            (Self::Coin | Self::Ring | Self::Patty, &[diameter, thickness]) => Some([diameter, diameter, thickness]),
            (Self::Shrimp, &[length, diameter]) => Some([length, diameter, diameter]),
            (Self::Mesh, &[longest]) => Some([longest; 3]),
            _ => None,
        }
    }

    /// Which dimension each of length, width and thickness comes from.
    pub fn dimension_of(self, axis: usize) -> &'static str {
        let names = self.dimensions();
        match self {
            Self::Coin | Self::Ring | Self::Patty => names[axis / 2],
            Self::Shrimp => names[axis.min(1)],
            Self::Mesh => names[0],
            Self::Steak | Self::Stick => names[axis],
        }
    }

    /// Its name in files.
    pub fn name(self) -> &'static str {
        match self {
            Self::Steak => "steak",
            Self::Patty => "patty",
            Self::Coin => "coin",
            Self::Ring => "ring",
            Self::Stick => "stick",
            Self::Shrimp => "shrimp",
            Self::Mesh => "mesh",
        }
    }

    /// Axis of the body frame along which a root or shaft grew: along sticks, through slices.
    pub fn grown_along(self) -> usize {
        if matches!(self, Self::Stick | Self::Shrimp) { 0 } else { 2 }
    }
}
