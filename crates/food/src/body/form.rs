//! Forms of pieces and the meaning of their dimensions.

use schemars::JsonSchema;
use serde::Deserialize;

/// Form of a piece.
#[derive(Clone, Copy, Debug, Deserialize, JsonSchema, PartialEq, Eq)]
#[serde(rename_all = "kebab-case")]
pub enum Form {
    /// A superellipse outline times an uneven thickness; fibres run through the thickness.
    Steak,
    /// A round disc pressed by hand, of uneven thickness.
    Patty,
    /// A round slice across a root; its fibres run through the thickness.
    Coin,
    /// A round slice across a shaft of sheaths.
    Ring,
    /// A bar with rounded edges; fibres run along it.
    Stick,
    /// A tapering body on a curved spine with a tail fan; it lies on its side, and fibres run along it.
    Shrimp,
    /// What runs over the pan's floor before it sets; its size is that of what lies on a level floor.
    Poured,
    /// The inside of a closed surface from the user's own file.
    Mesh,
}

impl Form {
    /// Names of the dimensions of the form.
    pub fn dimensions(self) -> &'static [&'static str] {
        match self {
            Self::Steak | Self::Stick => &["length", "width", "thickness"],
            Self::Coin | Self::Ring | Self::Patty => &["diameter", "thickness"],
            Self::Poured => &["diameter", "mean thickness"],
            Self::Shrimp => &["curve length", "thickest diameter"],
            Self::Mesh => &["longest edge"],
        }
    }

    /// Returns length, width and thickness from the dimensions, in their unit, or none if their number is wrong.
    ///
    /// ```
    /// use saute_food::Form;
    /// // A coin 24 mm across and 8 mm thick.
    /// assert_eq!(Form::Coin.extent(&[24.0, 8.0]), Some([24.0, 24.0, 8.0]));
    /// assert_eq!(Form::Coin.extent(&[24.0]), None);
    /// ```
    pub fn extent(self, size: &[f64]) -> Option<[f64; 3]> {
        match (self, size) {
            (Self::Steak | Self::Stick, &[length, width, thickness]) => Some([length, width, thickness]),
            (Self::Coin | Self::Ring | Self::Patty | Self::Poured, &[diameter, thickness]) => {
                Some([diameter, diameter, thickness])
            }
            (Self::Shrimp, &[length, diameter]) => Some([length, diameter, diameter]),
            (Self::Mesh, &[longest]) => Some([longest; 3]),
            _ => None,
        }
    }

    /// Returns the dimensions of an extent of length, width and thickness: the inverse of [`Self::extent`].
    pub fn dimensions_of(self, [length, width, thickness]: [f64; 3]) -> Vec<f64> {
        match self {
            Self::Steak | Self::Stick => vec![length, width, thickness],
            Self::Coin | Self::Ring | Self::Patty | Self::Poured => vec![length, thickness],
            Self::Shrimp => vec![length, width],
            Self::Mesh => vec![length],
        }
    }

    /// Name of the dimension that length (0), width (1) or thickness (2) comes from.
    pub fn dimension_of(self, axis: usize) -> &'static str {
        let names = self.dimensions();
        match self {
            Self::Coin | Self::Ring | Self::Patty | Self::Poured => names[axis / 2],
            Self::Shrimp => names[axis.min(1)],
            Self::Mesh => names[0],
            Self::Steak | Self::Stick => names[axis],
        }
    }

    /// Name of the form in files.
    pub fn name(self) -> &'static str {
        match self {
            Self::Steak => "steak",
            Self::Patty => "patty",
            Self::Coin => "coin",
            Self::Ring => "ring",
            Self::Stick => "stick",
            Self::Shrimp => "shrimp",
            Self::Poured => "poured",
            Self::Mesh => "mesh",
        }
    }

    /// Axis of the body frame along which a root or shaft grew: 0 (lengthwise) in sticks, 2 (through the thickness) in slices.
    pub fn grown_along(self) -> usize {
        if matches!(self, Self::Stick | Self::Shrimp) { 0 } else { 2 }
    }
}
