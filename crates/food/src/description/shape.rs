//! Shape tables of a food file: sizes, outline, surface file and spine.

use crate::description::Confidence;
use crate::sourced_table;

sourced_table! {
    /// Allowed sizes of a piece, in the order of the form's dimensions.
    SizeRange {
        /// Default size [mm].
        default_mm: Vec<f64>,
        /// Smallest size [mm].
        min_mm: Vec<f64>,
        /// Largest size [mm].
        max_mm: Vec<f64>,
    }
}

sourced_table! {
    /// Outline of the cross-section.
    OutlineShape {
        /// Superellipse exponent [-]; 2 is an ellipse.
        exponent: f64,
        /// Amplitude of the natural waviness relative to the radius [-].
        ripple: f64,
        /// Largest difference of the thickness between two ends, relative to its mean [-].
        #[serde(default)]
        wedge: f64,
        /// Amplitude of the gentle bumps of a cut, relative to the mean thickness [-].
        #[serde(default)]
        bumps: f64,
    }
}

sourced_table! {
    /// Reference to a file with a closed surface.
    SurfaceFile {
        /// Path of the file, relative to the food's own file.
        file: String,
        /// Length of one unit of the file [mm].
        scale_mm: Option<f64>,
        /// Direction of the fibres, along which juice moves [-]; without it juice takes the shortest way to the skin.
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
        Self { exponent: 2.0, ripple: 0.0, wedge: 0.0, bumps: 0.0, source: String::new(), confidence: Confidence::Low }
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
        turn_deg: f64,
        /// Largest deviation of that angle between pieces [°].
        turn_varies_deg: f64,
        /// Breadth over depth of the body [-].
        flattening: f64,
    }
}
