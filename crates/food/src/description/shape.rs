//! Shape tables of a food file: sizes, outline, surface file and spine.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::description::Confidence;
use crate::sourced_table;

/// Outline of a piece: as it grew and was cut, or plain.
#[derive(Clone, Copy, Debug, Default, Deserialize, PartialEq, Eq, Serialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub enum OutlineKind {
    /// With the natural form of its food, where its file states one; each seed gives another piece of the same volume.
    #[default]
    Natural,
    /// The plain outline: no natural form and no fat cap.
    Plain,
    /// As natural, and each seed gives a piece that differs from the mean of its food, as its file states the spread.
    Individual,
}

sourced_table! {
    /// Allowed sizes of a piece, in the order of the form's dimensions.
    SizeRange {
        /// Default size [mm].
        #[schemars(length(min = 1, max = 3), inner(range(min = 2.0, max = 300.0)), extend("examples" = [[120.0, 80.0, 25.0]]))]
        default_mm: Vec<f64>,
        /// Smallest size [mm].
        #[schemars(length(min = 1, max = 3), inner(range(min = 2.0, max = 300.0)), extend("examples" = [[30.0, 30.0, 10.0]]))]
        min_mm: Vec<f64>,
        /// Largest size [mm].
        #[schemars(length(min = 1, max = 3), inner(range(min = 2.0, max = 300.0)), extend("examples" = [[190.0, 190.0, 60.0]]))]
        max_mm: Vec<f64>,
    }
}

sourced_table! {
    /// Outline of the cross-section.
    OutlineShape {
        /// Superellipse exponent [-]; 2 is an ellipse.
        #[schemars(range(min = 2.0, max = 20.0), example = 2.5)]
        exponent: f64,
        /// Amplitude of the natural waviness relative to the radius [-].
        #[schemars(range(min = 0.0, max = 0.1), example = 0.02)]
        ripple: f64,
        /// Corners of an outline of its own, counter-clockwise, which are stretched to length and width [-]; it takes the place
        /// of exponent and ripple in a steak.
        #[serde(default)]
        #[schemars(length(max = 200), inner(inner(range(min = -1.0, max = 1.0))), extend("examples" = [[[-1.0, -1.0], [1.0, -1.0], [0.0, 1.0]]]))]
        corners: Vec<[f64; 2]>,
        /// Length of the waves that a thin slice throws where its streaks contract differently, from crest to crest [mm]; absent in
        /// foods that lie flat.
        #[serde(default)]
        #[schemars(range(min = 15.0, max = 150.0), example = 45.0)]
        waves_mm: Option<f64>,
        /// Largest difference of the thickness between two ends, relative to its mean [-].
        #[serde(default)]
        #[schemars(range(min = 0.0, max = 0.3), example = 0.05)]
        wedge: f64,
        /// Amplitude of the gentle bumps of a cut, relative to the mean thickness [-].
        #[serde(default)]
        #[schemars(range(min = 0.0, max = 0.1), example = 0.01)]
        bumps: f64,
    }
}

sourced_table! {
    /// Natural form: what the seed of a piece changes of the plain outline; the volume stays. Absent in foods without it.
    NaturalForm {
        /// Largest deviation of the outline of a slice, relative to its radius [-].
        #[serde(default)]
        #[schemars(range(min = 0.0, max = 0.15), example = 0.06)]
        deviation: f64,
        /// Largest narrowing towards one end, relative to the mean width [-].
        #[serde(default)]
        #[schemars(range(min = 0.0, max = 0.3), example = 0.12)]
        taper: f64,
        /// Largest bend of the long axis, relative to the width [-].
        #[serde(default)]
        #[schemars(range(min = 0.0, max = 0.3), example = 0.05)]
        bend: f64,
        /// Largest stretch of a round slice into an ellipse [-].
        #[serde(default)]
        #[schemars(range(min = 0.0, max = 0.2), example = 0.05)]
        ellipse: f64,
        /// Largest further difference of the thickness between two ends, relative to its mean [-].
        #[serde(default)]
        #[schemars(range(min = 0.0, max = 0.3), example = 0.1)]
        wedge: f64,
        /// Height of the middle of the upper face above its rim, relative to the mean thickness [-].
        #[serde(default)]
        #[schemars(range(min = 0.0, max = 0.2), example = 0.07)]
        dome: f64,
        /// Width of the rounded shoulder between the upper face and the side [mm]; absent in foods with a sharp rim.
        #[serde(default)]
        #[schemars(range(min = 0.0, max = 15.0), example = 8.0)]
        shoulder_mm: f64,
        /// How much thinner the rim is than the face beyond the shoulder [mm]; at most 9 % of the thickness count.
        #[serde(default)]
        #[schemars(range(min = 0.0, max = 5.0), example = 3.0)]
        rim_thinner_mm: f64,
        /// How far a piece is turned about the vertical when it is laid down, either way, at most [°].
        #[serde(default)]
        #[schemars(range(min = 0.0, max = 180.0), example = 25.0)]
        turned_deg: f64,
        /// Largest number of cracks at the rim [-].
        #[serde(default)]
        #[schemars(range(min = 0, max = 12), example = 6)]
        cracks: u32,
        /// Depth of the deepest crack [mm].
        #[serde(default)]
        #[schemars(range(min = 0.0, max = 8.0), example = 4.0)]
        crack_mm: f64,
        /// Largest bulge and slant of the side wall [mm]; drawn, while heat sees a vertical wall.
        #[serde(default)]
        #[schemars(range(min = 0.0, max = 1.0), example = 1.0)]
        bulge_mm: f64,
        /// Slip of the inner sheaths of a shaft [mm]; drawn, while heat sees them flush.
        #[serde(default)]
        #[schemars(range(min = 0.0, max = 3.0), example = 1.0)]
        slip_mm: f64,
        /// Angles of the turn from end to end among which the seed picks that of a shrimp [°].
        #[serde(default)]
        #[schemars(length(max = 8), inner(range(min = 0.0, max = 240.0)), extend("examples" = [[115.0, 165.0, 200.0]]))]
        turns_deg: Vec<f64>,
        /// Largest deviation of the length of a shrimp [-]; a longer one is as much thinner.
        #[serde(default)]
        #[schemars(range(min = 0.0, max = 0.2), example = 0.06)]
        slender: f64,
    }
}

sourced_table! {
    /// Spread of the pieces of a food about its mean piece: standard deviations. It counts where a recipe wants individual pieces; a food
    /// without it has none but mean ones.
    PieceSpread {
        /// Of the share of fat in the lean flesh [-]; it displaces everything else in proportion.
        #[serde(default)]
        #[schemars(range(min = 0.0, max = 0.1), example = 0.012)]
        fat: f64,
        /// Of the share of water, at the same fat [-].
        #[serde(default)]
        #[schemars(range(min = 0.0, max = 0.1), example = 0.010)]
        water: f64,
        /// Of the angle between the fibres and the thickness [°].
        #[serde(default)]
        #[schemars(range(min = 0.0, max = 60.0), example = 15.0)]
        fibre_deg: f64,
        /// Of the mean thickness as cut, relative to the one that was ordered [-].
        #[serde(default)]
        #[schemars(range(min = 0.0, max = 0.1), example = 0.03)]
        thickness: f64,
        /// Of the further difference of the thickness between two ends, relative to its mean [-].
        #[serde(default)]
        #[schemars(range(min = 0.0, max = 0.1), example = 0.03)]
        wedge: f64,
        /// Of the water that heating releases, relative to its mean [-].
        #[serde(default)]
        #[schemars(range(min = 0.0, max = 0.3), example = 0.1)]
        released: f64,
    }
}

sourced_table! {
    /// Reference to a file with a closed surface.
    SurfaceFile {
        /// Path of the file, relative to the food's own file.
        #[schemars(example = &"my-piece.obj")]
        file: String,
        /// Length of one unit of the file [mm].
        #[schemars(range(min = 1e-6, max = 1e6), example = 1.0)]
        scale_mm: Option<f64>,
        /// Direction of the fibres, along which juice moves [-]; without it juice takes the shortest way to the skin.
        #[schemars(inner(range(min = -1e6, max = 1e6)), extend("examples" = [[0.0, 0.0, 1.0]]))]
        fibres: Option<[f64; 3]>,
    }
}

impl SizeRange {
    /// No sizes: the file does not state them.
    pub(super) fn unset() -> Self {
        let source = String::new();
        Self { default_mm: Vec::new(), min_mm: Vec::new(), max_mm: Vec::new(), source, confidence: Confidence::Low }
    }

    /// Returns true if the file states sizes.
    pub fn is_set(&self) -> bool {
        !self.default_mm.is_empty()
    }
}

impl OutlineShape {
    /// No outline: the file does not state one.
    pub(super) fn unset() -> Self {
        Self {
            exponent: 2.0,
            ripple: 0.0,
            waves_mm: None,
            corners: Vec::new(),
            wedge: 0.0,
            bumps: 0.0,
            source: String::new(),
            confidence: Confidence::Low,
        }
    }

    /// Returns true if the file states an outline.
    pub fn is_set(&self) -> bool {
        !self.source.is_empty()
    }
}

sourced_table! {
    /// The curve of a shrimp.
    Spine {
        /// Angle of the turn from end to end [°].
        #[schemars(range(min = 0.0, max = 200.0), example = 125.0)]
        turn_deg: f64,
        /// Largest deviation of that angle between pieces [°].
        #[schemars(range(min = 0.0, max = 60.0), example = 20.0)]
        turn_varies_deg: f64,
        /// Breadth over depth of the body [-].
        #[schemars(range(min = 0.5, max = 1.5), example = 0.9)]
        flattening: f64,
    }
}
