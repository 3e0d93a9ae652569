//! A checked lab case in SI units.

use saute_food::components::Components;
use saute_food::{FoodDescription, Kinetics};
use saute_heat::Rule;
use saute_heat::conduction::axis::End;
use saute_heat::conduction::product::FaceBoundary;

use crate::case::check::Check;
use crate::case::{Contact, Physics, Shape};
use crate::result::evidence::Evidence;
use crate::result::verdict::Expectation;
use crate::solve::body::node_count;
use crate::solve::material::Material;
use saute_kitchen::data::library::Library;
use saute_kitchen::data::room::Room;
use saute_schema::{InputError, InputText};

/// A checked case, ready to run.
#[derive(Clone, Debug)]
pub struct Case {
    /// Name for people.
    pub name: String,
    /// Duration [s].
    pub duration: f64,
    /// Times of the probe readings, ascending, including the end [s].
    pub outputs: Vec<f64>,
    /// Shape of every body.
    pub shape: Shape,
    /// Bodies, lowest first; empty for a pan alone.
    pub bodies: Vec<BodyCase>,
    /// Material of each body.
    pub materials: Vec<Material>,
    /// The pan below them.
    pub pan: Option<PanCase>,
    /// Physics of the body.
    pub physics: Physics,
    /// Data for [`Physics::Cooking`].
    pub cooking: Option<CookingCase>,
    /// Rule for the conductances of the mesh.
    pub rule: Rule,
    /// Factor on the length of every time step [-].
    pub step_factor: f64,
    /// Boundary conditions of consecutive phases; at least one.
    pub phases: Vec<Phase>,
    /// Times of the flips, ascending [s].
    pub flips: Vec<f64>,
    /// Points whose temperature is reported; that of a pan follows them.
    pub probes: Vec<ProbeCase>,
    /// The run stops once every point has reached this temperature [K].
    pub stop_at: Option<f64>,
    /// Temperatures for the share of the volume that has ever exceeded them [°C].
    pub volume_above_c: Vec<f64>,
    /// Index of the probe whose highest temperature is reported; the index of the pan follows all others.
    pub peak_of: Option<usize>,
    /// The same case with other flips, for comparison.
    pub compare: Option<Box<Self>>,
    /// Source of the expected values.
    pub source: String,
    /// Kind of evidence for the expected values; required by `saute validate`.
    pub evidence: Option<Evidence>,
    /// Expected values.
    pub expectations: Vec<Expectation>,
}

/// One body of a stack.
#[derive(Clone, Debug, PartialEq)]
pub struct BodyCase {
    /// Sizes [m].
    pub size: Vec<f64>,
    /// Largest spacing along each size [m].
    pub resolution: Vec<f64>,
    /// Steepness of the grading [-].
    pub grading: f64,
    /// Start temperature [K].
    pub initial: f64,
    /// Contact conductance to the body or pan below [W/(m²·K)]; `None` for perfect contact.
    pub contact: Option<f64>,
}

/// Data for cooking beyond those for conduction.
#[derive(Clone, Debug)]
pub struct CookingCase {
    /// The food.
    pub food: FoodDescription,
    /// Kinetics of its changes.
    pub kinetics: Kinetics,
    /// Thermal properties of its components.
    pub components: Components,
    /// The room, for the air and the contact model.
    pub room: Room,
}

/// A plate of uniform temperature (lumped capacity).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PanCase {
    /// Heat capacity [J/(m²·K)].
    pub capacity: f64,
    /// Start temperature [K].
    pub initial: f64,
    /// Thickness [m].
    pub thickness: f64,
}

/// A phase with its own boundary conditions.
#[derive(Clone, Debug, PartialEq)]
pub struct Phase {
    /// Boundary condition of each end of each axis that is not insulated.
    pub boundaries: Vec<FaceBoundary>,
    /// Medium at those ends whose file gives more than the boundary condition.
    pub media: Vec<(usize, End, Medium)>,
    /// End of the phase.
    pub until: Until,
}

impl Phase {
    /// Returns the ends that exchange thermal radiation with their surroundings.
    pub fn radiation(&self) -> impl Iterator<Item = (usize, End, Radiation)> {
        self.media.iter().filter_map(|(axis, end, medium)| medium.radiation.map(|r| (*axis, *end, r)))
    }
}

/// The medium at a face.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Medium {
    /// Its kind, for cooking; by default air or a solid, depending on the heat transfer coefficient.
    pub contact: Option<Contact>,
    /// Surroundings that radiate.
    pub radiation: Option<Radiation>,
    /// Vapour density of air [kg/m³]; that of the room by default.
    pub vapour_density: Option<f64>,
}

/// Surroundings that exchange thermal radiation with a face.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Radiation {
    /// Their temperature [K].
    pub surroundings: f64,
    /// Effective emissivity of face and surroundings [-].
    pub emissivity: f64,
}

/// The end of a phase.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Until {
    /// The end of the run.
    Forever,
    /// A time [s].
    Time(f64),
    /// A probe, by its index, crosses a temperature [K].
    Probe(usize, f64),
}

/// A probe.
#[derive(Clone, Debug, PartialEq)]
pub struct ProbeCase {
    /// Name.
    pub name: String,
    /// Position on the axes [m].
    pub place: Vec<f64>,
    /// True if the upward heat flux is reported as well.
    pub flux: bool,
}

impl Case {
    /// Returns the number of nodes of its mesh, to within a few [-].
    pub fn node_count(&self) -> usize {
        node_count(self.shape, &self.bodies) as usize
    }

    /// Parses and checks a case. `file` is the name in error messages.
    ///
    /// # Errors
    ///
    /// Returns the first key that is missing, unknown, inconsistent or out of its range, with its line and a remedy.
    pub fn parse(text: &str, file: &str, library: &Library) -> Result<Self, InputError> {
        Check { input: InputText { text, file }, library }.case()
    }
}
