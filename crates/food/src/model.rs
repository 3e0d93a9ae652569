//! The model of a piece of food: everything that heating does not change.
//!
//! State: enthalpy, water and temperature per node. Enthalpy is conserved; temperature follows from it by Newton's
//! method on tables of the components' enthalpies `[@choi-okos-1986]`.

use saute_heat::{BodyMesh, Outline};

use crate::Lab;
use crate::body::pool::Pool;
use crate::body::rest_shape::RestShape;
use crate::body::{Body, Patch, Surface};
use crate::build_error::{BuildError, check_composition, check_size};
use crate::change::browning::Browning;
use crate::change::colour::{Appearance, Palette};
use crate::change::response::HeatResponse;
use crate::components::{Components, Masses, Properties};
use crate::description::{FoodDescription, Kinetics, NaturalForm};
use crate::individual::{as_cut, individual};
use crate::paper_2013::{Rules, simplified};
use crate::piece_spec::PieceSpec;
use crate::state::FoodState;
use crate::tissue::noise::uniform;
use crate::tissue::{MarblingVolume, NodeTissue, TissueField};
use crate::water::WaterTransport;

/// Index of the draw of how far a piece is turned (chosen: used by nothing else).
const TURN: u64 = 620;

/// A piece of food: rest shape, tissue, properties and rates; immutable after it is built.
#[derive(Clone, Debug)]
pub struct FoodModel {
    pub(crate) shape: RestShape,
    pub(crate) tissue: NodeTissue,
    /// Thermal properties of water, lean solids and fat.
    pub(crate) properties: Properties,
    pub(crate) water: WaterTransport,
    pub(crate) response: HeatResponse,
    pub(crate) rules: Rules,
    pub(crate) seed: u64,
    pub(crate) description: FoodDescription,
    pub(crate) kinetics: Kinetics,
}

impl FoodModel {
    /// Builds a piece: cuts its form, meshes it and fills it with food.
    ///
    /// # Errors
    /// If a size is out of range, if mass fractions do not add up to 1, if a table is missing, if a table names an unknown
    /// change, or if meshing fails.
    pub fn build(
        description: &FoodDescription,
        kinetics: &Kinetics,
        components: &Components,
        piece: &PieceSpec,
    ) -> Result<Self, BuildError> {
        check_size(description, piece)?;
        let spread = description.spread.as_ref().filter(|_| piece.is_individual());
        let own = spread.map(|spread| individual(description, spread, kinetics, piece));
        let (description, kinetics, piece) =
            own.as_ref().map_or((description, kinetics, piece), |(food, kinetics, piece)| (food, kinetics, piece));
        let body = Body::cut(description, piece)?;
        Self::fill_body(description, kinetics, components, body, piece.seed, piece.rules)
    }

    /// Fills a meshed body with food.
    ///
    /// # Errors
    /// As [`Self::build`], apart from the size.
    pub fn fill_body(
        description: &FoodDescription,
        kinetics: &Kinetics,
        components: &Components,
        body: Body,
        seed: u64,
        rules: Rules,
    ) -> Result<Self, BuildError> {
        check_composition("lean", description.lean.total())?;
        description.adipose.iter().try_for_each(|a| check_composition("adipose", a.total()))?;
        check_composition("second", description.second_tissue().total())?;
        if let Some(pour) = &description.pour {
            kinetics.in_order("pour.sets_by", &[(pour.sets_by.clone(), 1.0)].into())?;
        }
        let simple = (rules == Rules::Paper2013).then(|| simplified(description, kinetics, components));
        let (description, kinetics) = simple.as_ref().map_or((description, kinetics), |(d, k)| (d, k));
        let mut shape = RestShape::new(body, rules);
        let properties =
            Properties::new(components, &description.lean, &description.fat_melting, description.freezing.as_ref());
        let tissue = NodeTissue::new(description, &properties, &shape, seed);
        tissue.part_sheaths(&mut shape.mesh);
        let mut model = Self {
            water: WaterTransport::new(description, kinetics, rules, &shape)?,
            response: HeatResponse::new(description, kinetics)?,
            shape,
            tissue,
            properties,
            rules,
            seed,
            description: description.clone(),
            kinetics: kinetics.clone(),
        };
        model.wet_faces();
        Ok(model)
    }

    /// Returns the same poured piece as it lies now; `piece` is what it was built from, with its present pool.
    ///
    /// # Errors
    /// If meshing fails.
    pub fn poured_as(&self, piece: &PieceSpec) -> Result<Self, BuildError> {
        let piece = as_cut(&self.description, piece);
        let shape = RestShape::new(Body::cut(&self.description, &piece)?, self.rules);
        let tissue = NodeTissue::new(&self.description, &self.properties, &shape, self.seed);
        let mut model = Self {
            water: WaterTransport::new(&self.description, &self.kinetics, self.rules, &shape)?,
            shape,
            tissue,
            ..self.clone()
        };
        model.wet_faces();
        Ok(model)
    }

    /// How a poured piece lies; none of other foods.
    pub fn pool(&self) -> Option<&Pool> {
        self.shape.pool.as_ref()
    }

    /// Present masses of water, lean solids and fat of a node [kg].
    #[inline]
    pub fn masses(&self, state: &FoodState, node: usize) -> Masses {
        [state.water[node], self.tissue.lean_solids[node], state.fat[node]]
    }

    /// Share of the second tissue (a root's core, a shaft's green) at a point of the rest mesh's frame [-].
    pub fn tissue_at(&self, p: [f64; 3]) -> f64 {
        self.tissue.field.at(p)
    }

    /// Returns the colours of lean flesh and of fat with a given appearance.
    pub fn colours(&self, appearance: Appearance) -> (Lab, Lab) {
        (self.response.palette.lean(appearance), self.response.palette.fat(appearance))
    }
}

/// Access to the members of a model.
impl FoodModel {
    /// Rest mesh; of a slice z goes from 0 to the thickness, with the origin at the outline's centroid.
    #[inline]
    pub fn mesh(&self) -> &BodyMesh {
        &self.shape.mesh
    }

    /// Length, width, thickness; of a curved body along its curve, across it in its plane, and its height [m].
    #[inline]
    pub fn size(&self) -> [f64; 3] {
        self.shape.size
    }

    /// Outline of the rest shape seen from above.
    pub fn outline(&self) -> &Outline {
        &self.shape.outline
    }

    /// Faces towards the outside: those of both ends of the path in the order of the section's nodes, then those of the
    /// side; the fresh faces of a cut come last.
    #[inline]
    pub fn patches(&self) -> &[Patch] {
        &self.shape.patches
    }

    /// Triangles over the nodes of the surface of a swept body.
    pub fn surface(&self) -> &Surface {
        &self.shape.surface
    }

    /// Outward normal of each patch of the rest shape, in the body frame [-].
    #[inline]
    pub fn rest_normals(&self) -> &[[f64; 3]] {
        &self.shape.rest_normals
    }

    /// Returns true if the piece contracts and bends as it is heated.
    pub fn contracts(&self) -> bool {
        self.shape.contracts
    }

    /// Returns true if the lower end of the path is no face, as the centre of a ball is not.
    pub fn closed_below(&self) -> bool {
        self.shape.closed_below
    }

    /// Raw water of the flesh of each node [kg].
    #[inline]
    pub fn initial_water(&self) -> &[f64] {
        &self.tissue.initial_water
    }

    /// Lean solids of each node [kg].
    #[inline]
    pub fn lean_solids(&self) -> &[f64] {
        &self.tissue.lean_solids
    }

    /// Raw fat of each node [kg].
    #[inline]
    pub fn initial_fat(&self) -> &[f64] {
        &self.tissue.initial_fat
    }

    /// Raw mass, with the film of juice on its faces [kg].
    pub fn raw_mass(&self) -> f64 {
        self.tissue.raw_mass
    }

    /// Raw share of adipose tissue of each node [-].
    #[inline]
    pub fn adipose(&self) -> &[f64] {
        &self.tissue.adipose
    }

    /// Share of the second tissue of each node [-].
    #[inline]
    pub fn second_tissue(&self) -> &[f64] {
        &self.tissue.second
    }

    /// Fat seams as a volume of cells.
    pub fn marbling(&self) -> &MarblingVolume {
        &self.tissue.marbling
    }

    /// Field of the second tissue: a root's core or the sheaths of a shaft.
    pub fn tissue_field(&self) -> &TissueField {
        &self.tissue.field
    }

    /// Thermal properties of water, lean solids and fat.
    #[inline]
    pub fn properties(&self) -> &Properties {
        &self.properties
    }

    /// Number of first-order changes of the flesh [-].
    pub fn change_count(&self) -> usize {
        self.response.rates.count()
    }

    /// Rates of browning and charring.
    #[inline]
    pub fn browning(&self) -> &Browning {
        &self.response.browning
    }

    /// Colours of flesh and fat.
    #[inline]
    pub fn palette(&self) -> &Palette {
        &self.response.palette
    }

    /// Rules that the piece follows.
    pub fn rules(&self) -> Rules {
        self.rules
    }

    /// How far the piece is turned about the vertical when it is laid down [rad]; 0 for a plain one.
    pub fn turned(&self) -> f64 {
        let most = self.natural().map_or(0.0, |form| form.turned_deg.to_radians());
        most * (2.0 * uniform(self.seed(), TURN) - 1.0)
    }

    /// Seed of the natural variation.
    pub fn seed(&self) -> u64 {
        self.seed
    }

    /// Natural form of the piece; none if it is plain.
    pub fn natural(&self) -> Option<&NaturalForm> {
        self.description.natural.as_ref().filter(|_| self.shape.natural)
    }

    /// Description of the food, as its file states it.
    pub fn description(&self) -> &FoodDescription {
        &self.description
    }

    /// Kinetics of the food, as its file states them.
    pub fn kinetics(&self) -> &Kinetics {
        &self.kinetics
    }
}
