//! Errors of building a piece, and the checks of size and composition.

use saute_heat::{CellMeshError, MeshError};

use crate::description::{FoodDescription, NoSuchChange};
use crate::piece_spec::PieceSpec;

/// Error of building a piece.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum BuildError {
    /// A size is out of range.
    #[error("{which} {got} mm is out of range: use {low} to {high} mm")]
    Size {
        /// Name of the dimension.
        which: &'static str,
        /// Requested size [mm].
        got: f64,
        /// Smallest allowed [mm].
        low: f64,
        /// Largest allowed [mm].
        high: f64,
    },
    /// The mass fractions of a tissue do not add up to 1.
    #[error("the mass fractions of the {which} tissue add up to {total:.4}; they must add up to 1 (± 0.005)")]
    Composition {
        /// Name of the tissue.
        which: &'static str,
        /// Sum of the mass fractions [-].
        total: f64,
    },
    /// The form needs a table that the file lacks.
    #[error("the form \"{form}\" needs a table [{table}]: see the shipped foods of that form")]
    Missing {
        /// Name of the form.
        form: &'static str,
        /// Name of the table.
        table: &'static str,
    },
    /// Meshing of a swept body failed.
    #[error(transparent)]
    Mesh(#[from] MeshError),
    /// Meshing inside a closed surface failed.
    #[error(transparent)]
    Cells(#[from] CellMeshError),
    /// The numbers of the food make no finite mass or heat.
    #[error("the numbers of this food make no finite mass or heat: use values near those of the shipped foods")]
    NotFinite,
    /// Thin parts need so many steps that no cook would end.
    #[error(
        "its thinnest parts need {steps} steps in each tick of {nodes} nodes: use a thicker body without slivers, or values near those \
         of the shipped foods"
    )]
    Slow {
        /// Steps in a tick [-].
        steps: u32,
        /// Nodes of its mesh [-].
        nodes: usize,
    },
    /// A table names a change that the kinetics do not contain.
    #[error(transparent)]
    Change(#[from] NoSuchChange),
}

pub(crate) fn check_size(description: &FoodDescription, piece: &PieceSpec) -> Result<(), BuildError> {
    let (form, range) = (description.form, &description.size);
    let bounds = [&range.min_mm, &range.max_mm].map(|mm| form.extent(mm).unwrap_or_default());
    for (axis, (&low, &high)) in bounds[0].iter().zip(&bounds[1]).enumerate() {
        let got = piece.size[axis] * 1e3;
        if !(got >= low - 1e-9 && got <= high + 1e-9) {
            return Err(BuildError::Size { which: form.dimension_of(axis), got, low, high });
        }
    }
    Ok(())
}

pub(crate) fn check_composition(which: &'static str, total: f64) -> Result<(), BuildError> {
    if (total - 1.0).abs() > 0.005 { Err(BuildError::Composition { which, total }) } else { Ok(()) }
}
