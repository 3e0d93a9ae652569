//! A slice on a coarse mesh: the same food with the same physics, in a few per cent of the time.
//!
//! A forecast computes how a piece develops from its present state. Through its thickness a slice needs every layer, as heat
//! enters at the faces; along its faces the state varies slowly, so that a few columns do. [`Reduction`] is the slice on
//! a section of concentric rings with all layers of the full mesh, and carries states from the full mesh to it.
//!
//! The restriction is the adjoint of linear interpolation, balanced so that every coarse column contains exactly its volume
//! and every full one is handed out exactly: masses, heat and water are conserved, and the diffusivity is that of the food.

mod restriction;

use std::sync::Arc;

use saute_heat::{Coarsening, Layout, MeshError, Section, SweptMesh};

use crate::body::rest_shape::RestShape;
use crate::body::{Body, rule_of};
use crate::build_error::BuildError;
use crate::model::FoodModel;
use crate::paper_2013::Rings;
use crate::water::WaterTransport;

/// Rings of the section: nodes and share of the radius (chosen: the core has its own column, and the rim is narrow;
/// `docs/forecast.md` states what they cost and how far they are from the full mesh).
const RINGS: Rings = &[(14, 1.0), (10, 0.72), (6, 0.36), (1, 0.0)];

/// A slice on a coarse mesh, and the way of states to it.
#[derive(Clone, Debug)]
pub struct Reduction {
    model: Arc<FoodModel>,
    columns: Coarsening,
}

impl Reduction {
    /// Returns the slice on a coarse mesh; none of a body that is no slice, whose own mesh is small.
    ///
    /// # Errors
    /// If meshing or halving fails.
    pub fn of(fine: &FoodModel) -> Result<Option<Self>, BuildError> {
        let Layout::Upright(mesh) = fine.shape.mesh.layout() else { return Ok(None) };
        let coarse = coarse_mesh(fine, mesh)?;
        let columns = Coarsening::between(
            (&mesh.section.points, &column_volumes(mesh)),
            (&coarse.section, &column_volumes(&coarse)),
            |_, _| true,
        );
        let model = Self::filled(fine, coarse, &columns)?;
        let model = match fine.halved_at() {
            Some(cut) => model.halved(cut.at).unwrap_or(model),
            None => model,
        };
        Ok(Some(Self { model: Arc::new(model), columns }))
    }

    /// Returns the model on the coarse mesh.
    pub fn model(&self) -> &Arc<FoodModel> {
        &self.model
    }

    /// Returns the means of the values of the full section's columns over those of the coarse one, by area.
    pub fn column_means(&self, fine: &FoodModel, values: &[f64]) -> Vec<f64> {
        let areas = fine.shape.mesh.swept().map_or(&[][..], |mesh| &mesh.section.areas);
        self.columns.means(values, areas)
    }

    fn filled(fine: &FoodModel, coarse: SweptMesh, columns: &Coarsening) -> Result<FoodModel, BuildError> {
        let shape = &fine.shape;
        let body = Body {
            contracts: shape.contracts,
            natural: shape.natural,
            pool: shape.pool,
            ..Body::swept(shape.size, coarse, shape.outline.clone())
        };
        let mut shape = RestShape::new(body, fine.rules);
        let mut tissue = fine.tissue.clone();
        let volumes = fine.shape.mesh.volumes();
        let masses =
            [&mut tissue.initial_water, &mut tissue.lean_solids, &mut tissue.initial_fat, &mut tissue.raw_film];
        for field in masses {
            *field = columns.sums(field);
        }
        for field in [&mut tissue.adipose, &mut tissue.second] {
            *field = columns.means(field, volumes);
        }
        tissue.part_sheaths(&mut shape.mesh);
        Ok(FoodModel {
            water: WaterTransport::new(&fine.description, &fine.kinetics, fine.rules, &shape)?,
            response: fine.response.clone(),
            properties: fine.properties.clone(),
            shape,
            tissue,
            ..fine.clone()
        })
    }
}

/// The coarse mesh of a slice: rings of the area of its section, its layers, and the mean height of the full columns that each of its
/// own stands for.
fn coarse_mesh(fine: &FoodModel, mesh: &SweptMesh) -> Result<SweptMesh, MeshError> {
    let outline = &fine.shape.outline;
    let narrow = Section::concentric(outline, RINGS)?;
    // The polygon of the rim is within the outline: it is widened to the area of the section.
    let wider = libm::sqrt(mesh.section.area() / narrow.area());
    let rings: Vec<(usize, f64)> = RINGS.iter().map(|(count, share)| (*count, share * wider)).collect();
    let section = Section::concentric(outline, &rings)?;
    let areas = &mesh.section.areas;
    let columns = Coarsening::between((&mesh.section.points, areas), (&section, &section.areas), |_, _| true);
    let heights: Vec<f64> = (0..areas.len()).map(|i| mesh.path.column(i)).collect();
    let means = columns.means(&heights, areas);
    let places = section.points.clone();
    let height = |p: [f64; 2]| places.iter().position(|place| *place == p).map_or(1.0, |i| means[i]);
    Ok(SweptMesh::uneven(section, mesh.levels.clone(), height, rule_of(fine.rules)))
}

/// Volume of each column over the mean height of the slice [m²].
fn column_volumes(mesh: &SweptMesh) -> Vec<f64> {
    mesh.section.areas.iter().enumerate().map(|(i, area)| area * mesh.path.column(i)).collect()
}
