//! Shape tables of a food file: sizes, outline, surface file and spine.

use crate::description::Confidence;
use crate::sourced_table;

sourced_table! {
    /// Sizes that a piece may have, in the order of the form's dimensions.
    SizeRange {
        /// Unless told otherwise [mm].
        #[schemars(length(min = 1, max = 3), inner(range(min = 2.0, max = 300.0)), extend("examples" = [[120.0, 80.0, 25.0]]))]
        default_mm: Vec<f64>,
        /// Smallest [mm].
        #[schemars(length(min = 1, max = 3), inner(range(min = 2.0, max = 300.0)), extend("examples" = [[30.0, 30.0, 10.0]]))]
        min_mm: Vec<f64>,
        /// Largest [mm].
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
        /// Amplitude of the natural waviness over the radius [-].
        #[schemars(range(min = 0.0, max = 0.1), example = 0.02)]
        ripple: f64,
        /// How much the thickness may differ from one end to the other, over its mean [-].
        #[serde(default)]
        #[schemars(range(min = 0.0, max = 0.3), example = 0.05)]
        wedge: f64,
        /// Amplitude of the gentle bumps of a cut over the mean thickness [-].
        #[serde(default)]
        #[schemars(range(min = 0.0, max = 0.1), example = 0.01)]
        bumps: f64,
    }
}

sourced_table! {
    /// A file that holds a closed surface.
    SurfaceFile {
        /// Path beside the food's own file.
        #[schemars(example = &"my-piece.obj")]
        file: String,
        /// Millimetres in one unit of that file [mm].
        #[schemars(range(min = 1e-6, max = 1e6), example = 1.0)]
        scale_mm: Option<f64>,
        /// Direction of the fibres, along which juice moves; it takes the shortest way to the skin unless told [-].
        #[schemars(inner(range(min = -1e6, max = 1e6)), extend("examples" = [[0.0, 0.0, 1.0]]))]
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
        #[schemars(range(min = 0.0, max = 200.0), example = 125.0)]
        turn_deg: f64,
        /// How much that differs between pieces [°].
        #[schemars(range(min = 0.0, max = 60.0), example = 20.0)]
        turn_varies_deg: f64,
        /// Breadth over depth of the body [-].
        #[schemars(range(min = 0.5, max = 1.5), example = 0.9)]
        flattening: f64,
    }
}
