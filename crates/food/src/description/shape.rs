//! Shape tables of a food file: sizes, outline, surface file and spine.

use crate::description::Confidence;
use crate::sourced_table;

sourced_table! {
    /// Sizes that a piece may have, in the order of the form's dimensions.
    SizeRange {
        /// Unless told otherwise [mm].
        default_mm: Vec<f64>,
        /// Smallest [mm].
        min_mm: Vec<f64>,
        /// Largest [mm].
        max_mm: Vec<f64>,
    }
}

sourced_table! {
    /// Outline of the cross-section.
    OutlineShape {
        /// Superellipse exponent [-]; 2 is an ellipse.
        exponent: f64,
        /// Amplitude of the natural waviness over the radius [-].
        ripple: f64,
        /// How much the thickness may differ from one end to the other, over its mean [-].
        #[serde(default)]
        wedge: f64,
        /// Amplitude of the gentle bumps of a cut over the mean thickness [-].
        #[serde(default)]
        bumps: f64,
    }
}

sourced_table! {
    /// A file that holds a closed surface.
    SurfaceFile {
        /// Path beside the food's own file.
        file: String,
        /// Millimetres in one unit of that file [mm].
        scale_mm: Option<f64>,
        /// Direction of the fibres, along which juice moves; it takes the shortest way to the skin unless told [-].
        fibres: Option<[f64; 3]>,
    }
}

impl SizeRange {
    /// No sizes: the file does not give them.
    pub(super) fn unset() -> Self {
        let source = String::new();
        Self { default_mm: Vec::new(), min_mm: Vec::new(), max_mm: Vec::new(), source, confidence: Confidence::Low }
    }

    /// Whether the file gives sizes.
    pub fn is_set(&self) -> bool {
        !self.default_mm.is_empty()
    }
}

impl OutlineShape {
    /// No outline: the file does not give one.
    pub(super) fn unset() -> Self {
        Self { exponent: 2.0, ripple: 0.0, wedge: 0.0, bumps: 0.0, source: String::new(), confidence: Confidence::Low }
    }

    /// Whether the file gives an outline.
    pub fn is_set(&self) -> bool {
        !self.source.is_empty()
    }
}

sourced_table! {
    /// The curve of a shrimp.
    Spine {
        /// Angle through which it turns from end to end [°].
        turn_deg: f64,
        /// How much that differs between pieces [°].
        turn_varies_deg: f64,
        /// Breadth over depth of the body [-].
        flattening: f64,
    }
}
