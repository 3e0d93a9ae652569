//! Lab cases: checked, in SI units, ready to run.

use saute_food::components::Components;
use saute_food::{FoodDescription, Kinetics};
use saute_heat::Rule;
use saute_heat::axis::End;
use saute_heat::product::FaceBoundary;

use crate::case::check::Check;
use crate::case::{Contact, Physics, Shape};
use crate::result::verdict::Expectation;
use crate::solve::body::node_count;
use crate::solve::material::Material;
use saute_kitchen::data::library::Library;
use saute_kitchen::data::room::Room;
use saute_kitchen::{InputError, InputText};

/// A case, checked.
#[derive(Clone, Debug)]
pub struct Case {
    /// Name for people.
    pub name: String,
    /// How long [s].
    pub duration: f64,
    /// Times at which probes are read, ascending, the end included [s].
    pub outputs: Vec<f64>,
    /// Shape of every body.
    pub shape: Shape,
    /// Bodies, lowest first; none where a pan stands alone.
    pub bodies: Vec<BodyCase>,
    /// What each body is made of.
    pub materials: Vec<Material>,
    /// The pan below them.
    pub pan: Option<PanCase>,
    /// What happens in the body.
    pub physics: Physics,
    /// The food that is cooked.
    pub cooking: Option<CookingCase>,
    /// What makes conductances of the mesh.
    pub rule: Rule,
    /// Length of a step over its usual length [-].
    pub step_factor: f64,
    /// What lies outside, one phase after another; at least one.
    pub phases: Vec<Phase>,
    /// Times of the flips, ascending [s].
    pub flips: Vec<f64>,
    /// Points that are told; a pan is told too, after them.
    pub probes: Vec<ProbeCase>,
    /// Stop once every point has reached this [K].
    pub stop_at: Option<f64>,
    /// Tell the share of the volume ever above these [°C].
    pub volume_above_c: Vec<f64>,
    /// Probe whose highest temperature is told, as an index; the pan comes after all others.
    pub peak_of: Option<usize>,
    /// The same with other flips, to be run for comparison.
    pub compare: Option<Box<Self>>,
    /// Where the expected values come from.
    pub source: String,
    /// What should come out.
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
    /// Conductance of the contact with what lies below [W/(m²·K)]; none where it is perfect.
    pub contact: Option<f64>,
}

/// What cooking needs beyond conduction.
#[derive(Clone, Debug)]
pub struct CookingCase {
    /// The food.
    pub food: FoodDescription,
    /// What heat does to it.
    pub kinetics: Kinetics,
    /// Thermal properties of its components.
    pub components: Components,
    /// The room, for air and contact.
    pub room: Room,
}

/// A plate of even temperature.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PanCase {
    /// Heat capacity [J/(m²·K)].
    pub capacity: f64,
    /// Start temperature [K].
    pub initial: f64,
    /// Thickness [m].
    pub thickness: f64,
}

/// A time with boundaries of its own.
#[derive(Clone, Debug, PartialEq)]
pub struct Phase {
    /// Boundary of each end of each axis that is not insulated.
    pub boundaries: Vec<FaceBoundary>,
    /// What those ends meet when food is cooked; air or a solid by their coefficient where nothing is said.
    pub contacts: Vec<(usize, End, Contact)>,
    /// When it ends.
    pub until: Until,
}

/// The end of a phase.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Until {
    /// With the run.
    Forever,
    /// At a time [s].
    Time(f64),
    /// When a probe, by its index, crosses a temperature [K].
    Probe(usize, f64),
}

/// A probe.
#[derive(Clone, Debug, PartialEq)]
pub struct ProbeCase {
    /// Name.
    pub name: String,
    /// Place on the axes [m].
    pub place: Vec<f64>,
    /// Whether the flux upwards is told too.
    pub flux: bool,
}

impl Case {
    /// Nodes of its mesh, to within a few.
    pub fn node_count(&self) -> usize {
        node_count(self.shape, &self.bodies) as usize
    }

    /// Reads and checks a case. `file` is its name in messages.
    pub fn parse(text: &str, file: &str, library: &Library) -> Result<Self, InputError> {
        Check { input: InputText { text, file }, library }.case()
    }
}
