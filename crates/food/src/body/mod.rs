//! The body of a piece: each form's mesh, outline and faces, and its present shape.
//!
//! Bodies: slices (steak, patty, coin, ring) are columns of uneven height on their section; sticks and shrimps are
//! swept along stations; a closed surface is filled with cells. The layers of a slice are 0.35 mm thick at the faces
//! and 2 mm inside, which gives about 9800 nodes for a steak. Conductances are assembled once on the undeformed mesh.
//! The state has stretches (one across the fibres, one along them at each node, and a dome) that scale conductances
//! and areas, never capacities.

mod cells;
pub mod form;
mod free_edge;
pub mod halving;
pub mod limp;
mod natural;
pub mod patch;
pub mod patch_pose;
pub mod poured;
pub mod present_shape;
mod probing;
pub(crate) mod rest_shape;
pub mod rounded;
pub mod shrimp;
pub mod shrink;
mod slice;
pub mod solid;
mod stick;
pub mod surface;
mod waves;

use saute_heat::{BodyMesh, Outline, Rule, SweptMesh};

use crate::body::patch::patches;
use crate::body::pool::Pool;
use crate::build_error::BuildError;
use crate::build_error::check_size;
use crate::description::FoodDescription;
use crate::paper_2013::{MeshSize, Rings, Rules};
use crate::piece_spec::PieceSpec;
use crate::tissue::noise::uniform;

pub use form::Form;
pub use patch::{Face, Patch};
pub use patch_pose::{PatchGeometry, PatchPose};
pub use poured::pool;
pub use solid::{Capsule, Solid};
pub use surface::Surface;
pub use waves::Waves;

/// A meshed body before it is filled with food: mesh, faces and outline.
#[derive(Clone, Debug)]
pub struct Body {
    /// Length, width, thickness; of a curved body along its curve, across it in its plane, and its height [m].
    pub size: [f64; 3],
    /// Rest mesh.
    pub mesh: BodyMesh,
    /// Outline seen from above.
    pub outline: Outline,
    /// Faces towards the outside.
    pub patches: Vec<Patch>,
    /// True if the body contracts when heated; a slice then also bends as a plate.
    pub contracts: bool,
    /// True if the body has the natural form of its food; false if it is plain.
    pub natural: bool,
    /// How a poured food lies; none in other forms.
    pub pool: Option<Pool>,
    /// Where the waves of a thin slice are; none in other foods.
    pub waves: Option<Waves>,
}

impl Body {
    /// Cuts and meshes a piece of the form that its food describes.
    ///
    /// # Errors
    /// If a table of the form is missing, or if meshing fails.
    pub fn cut(description: &FoodDescription, piece: &PieceSpec) -> Result<Self, BuildError> {
        let body = match description.form {
            Form::Steak | Form::Patty | Form::Coin | Form::Ring => Self::slice(description, piece),
            Form::Stick => Self::stick(description, piece),
            Form::Shrimp => Self::shrimp(description, piece),
            Form::Poured => Self::poured(description, piece),
            Form::Mesh => Self::inside_surface(description, piece),
        };
        Ok(Self { natural: piece.natural(description).is_some(), ..body? })
    }

    /// Estimated number of nodes of a piece, before it is cut and meshed [-].
    ///
    /// # Errors
    /// If a size is out of range, or if a table of the form is missing.
    pub fn estimated_nodes(description: &FoodDescription, piece: &PieceSpec) -> Result<f64, BuildError> {
        check_size(description, piece)?;
        if let (Some((rings, levels)), false) = (paper_mesh(description, piece), description.form == Form::Mesh) {
            return Ok((rounded::node_count(rings) * levels) as f64);
        }
        match description.form {
            Form::Steak | Form::Patty | Form::Coin | Form::Ring | Form::Poured => Ok(slice::nodes(description, piece)),
            Form::Stick => Ok(stick::nodes(piece)),
            Form::Shrimp => shrimp::nodes(description, piece),
            Form::Mesh => cells::cell_body::nodes(description, piece),
        }
    }

    pub(crate) fn swept(size: [f64; 3], mesh: SweptMesh, outline: Outline) -> Self {
        let patches = patches(&mesh);
        let mesh = BodyMesh::Swept(mesh);
        Self { size, patches, mesh, outline, contracts: true, natural: false, pool: None, waves: None }
    }
}

/// The rule by which conductances follow from the mesh.
pub(crate) fn rule(piece: &PieceSpec) -> Rule {
    rule_of(piece.rules)
}

/// The rule of conductances that belongs to physical rules.
pub(crate) fn rule_of(rules: Rules) -> Rule {
    if rules == Rules::Paper2013 { Rule::Segments } else { Rule::ShapeFunctions }
}

/// Rings and levels of the mesh of 2013; none for the default mesh.
pub(crate) fn paper_mesh(description: &FoodDescription, piece: &PieceSpec) -> Option<(Rings, usize)> {
    (piece.mesh == MeshSize::Paper2013).then(|| crate::paper_2013::mesh_of(description))
}

/// Levels at even distances.
pub(crate) fn even_levels(length: f64, count: usize) -> Vec<f64> {
    let last = (count - 1) as f64;
    (0..count).map(|i| length * i as f64 / last).collect()
}

/// Seeded natural waviness of the outline in harmonics 2 to 5: order, amplitude [-] and phase [rad].
pub(crate) fn harmonics(description: &FoodDescription, piece: &PieceSpec) -> Vec<(u32, f64, f64)> {
    let harmonic = |m: u32| {
        let amplitude = description.outline.ripple * (0.4 + 0.6 * uniform(piece.seed, u64::from(m))) / f64::from(m - 1);
        (m, amplitude, core::f64::consts::TAU * uniform(piece.seed, 100 + u64::from(m)))
    };
    (2..=5).map(harmonic).collect()
}
