//! A poured food while it runs over the pan's floor: white and yolk as a film, until what is below has half set.
//!
//! The film flows by the law of the pan's other liquids ([`FilmFlow`]). Below it stands what does not run: thick white up to its own
//! height, the yolk in its skin, and what heat has set. Once half of the lower face has set, the film is done, and the piece is a body
//! like any other. Heat flows in the body all the while; the film gives it its shape.

use saute_food::body::pool::Dome;
use saute_food::change::changes::arrhenius;
use saute_food::description::Pour;
use saute_food::{FoodModel, FoodState};
use saute_heat::Layout;
use serde::{Deserialize, Serialize};

use crate::dynamics::Pose;
use crate::liquids::film_flow::{FilmFlow, Manner, Sweep};
use crate::pan::bed::Bed;
use crate::pan::pan_model::PanModel;
use crate::piece::layout::Footprint;

/// Radii in which thick and thin white land [m] (chosen: an egg cracked close above the pan).
const LANDS: [f64; 2] = [0.034, 0.046];
/// Share that has set at which a layer no longer runs, and share of the lower face at which nothing does [-] (chosen: a gel that has set
/// half way holds what is on it).
const HALF: f64 = 0.5;
/// Film that clings to the floor [m] (chosen: no node runs dry by rounding).
const CLINGING: f64 = 1e-5;
/// Rise of the wall for what runs [m] (chosen: white stays on the floor).
const WALL: f64 = 1.0;
/// Flow steps in a tick [-] (chosen: a film of 1 cm halves its height in a few of them).
const STEPS: usize = 4;
/// Most white at a node [m³] (chosen: a litre).
const MOST: f64 = 1e-3;
/// Movement in a tick below which it lies still, and ticks between two looks at what lies still [-] (chosen).
const STILL: f64 = 1e-6;
const LOOKS: u64 = 10;
/// Share of the volume that has to move before the body takes the new shape [-] (chosen: a millimetre of the outline).
const MOVED: f64 = 0.02;

/// White on the pan's floor, and the yolk in it.
#[derive(Clone, Debug, Default, Deserialize, PartialEq, Serialize)]
pub struct Running {
    /// Thin white at each node of the pan [m³].
    pub(crate) thin: Vec<f64>,
    /// Thick white at each node of the pan [m³].
    pub(crate) thick: Vec<f64>,
    /// The yolk, in the pan's frame.
    pub(crate) dome: Dome,
    /// Share of the volume that has moved since the body took its shape [-].
    pub(crate) moved: f64,
    /// Share that moved in the last tick that it ran [-], and gravity in it [m/s²].
    last: (f64, [f64; 3]),
}

/// Where what runs is and how it is inclined.
pub(crate) struct Lies<'a> {
    pub(crate) model: &'a FoodModel,
    pub(crate) state: &'a FoodState,
    /// Pose of the body in the pan's frame.
    pub(crate) seen: Pose,
    /// Gravity in the pan's frame [m/s²].
    pub(crate) gravity: [f64; 3],
    /// Nodes of the pan under other pieces.
    pub(crate) taken: &'a [bool],
}

/// Footprint with which an egg lands; it runs on from there, around what lies beside it.
pub(crate) fn lands_on() -> Footprint {
    Footprint::disc(LANDS[1])
}

impl Running {
    /// An egg that has just landed at a place of the floor [m].
    pub(crate) fn landed(model: &FoodModel, at: [f64; 2], pan: &PanModel) -> Option<Self> {
        let food = model.description();
        let (yolk, pour) = (food.yolk.as_ref()?, food.pour.as_ref()?);
        let volume: f64 = model.mesh().volumes().iter().sum();
        let white = (1.0 - yolk.share) * volume;
        let heap = |radius: f64, volume: f64| {
            let out = |i: usize| {
                let [x, y] = pan.section.points[i];
                libm::hypot(x - at[0], y - at[1]) / radius
            };
            let share = |i: usize| if i < pan.floor_nodes { (1.0 - out(i) * out(i)).max(0.0) } else { 0.0 };
            let weights: Vec<f64> = pan.liquids.bed.areas.iter().enumerate().map(|(i, area)| share(i) * area).collect();
            let sum: f64 = weights.iter().sum();
            weights.into_iter().map(|w| volume * w / sum).collect()
        };
        let thick = pour.thick_share * white;
        Some(Self {
            thin: heap(LANDS[1], white - thick),
            thick: heap(LANDS[0], thick),
            dome: Dome { at, ..Dome::of(yolk, volume) },
            moved: 1.0,
            last: (1.0, [0.0; 3]),
        })
    }

    /// Returns true if it has a sound amount at each node of a pan.
    pub(crate) fn fits(&self, nodes: usize) -> bool {
        let sound = |field: &[f64]| field.len() == nodes && field.iter().all(|v| (0.0..=MOST).contains(v));
        sound(&self.thin) && sound(&self.thick) && self.dome.is_sound() && self.moved.is_finite()
    }

    /// Volume of white at a node [m³].
    pub(crate) fn white(&self, node: usize) -> f64 {
        self.thin[node] + self.thick[node]
    }

    /// Returns true if the body is to take the film's shape.
    pub(crate) fn has_moved(&self) -> bool {
        self.moved > MOVED
    }

    /// Lets it run for `dt` [s].
    pub(crate) fn run(&mut self, lies: &Lies<'_>, pan: &PanModel, dt: f64) {
        let Some(pour) = lies.model.description().pour.as_ref() else { return };
        let still = self.last.0 < STILL && self.last.1 == lies.gravity;
        if still && !lies.state.ticks.is_multiple_of(LOOKS) {
            return;
        }
        let bed = &pan.liquids.bed;
        let columns = self.columns(lies, pan, pour);
        let manner = Manner { density: 1.0, puddle: 1e-3 * pour.edge_mm, clinging: CLINGING };
        let before: Vec<f64> = (0..self.thin.len()).map(|i| self.white(i)).collect();
        let whole: f64 = before.iter().sum();
        let mut level = FilmFlow::default();
        level.lean(bed, lies.gravity);
        level.fluidity = columns.iter().map(|column| column.fluidity).collect();
        for step in 0..STEPS {
            let mut flow = level.clone();
            let runs = self.stand(&mut flow, (bed, pan.floor_nodes, lies.taken), pour, &columns);
            self.flow(flow, bed, &manner, &runs, Sweep::BOTH[step % 2], dt / STEPS as f64);
        }
        let moved: f64 = before.iter().enumerate().map(|(i, v)| libm::fabs(self.white(i) - v)).sum();
        self.hold_yolk(pan);
        self.last = (0.5 * moved / whole, lies.gravity);
        self.moved += self.last.0;
    }

    /// Keeps the yolk on the floor.
    fn hold_yolk(&mut self, pan: &PanModel) {
        let [x, y] = self.dome.at;
        let (away, most) = (libm::hypot(x, y), 1e-3 * pan.description.floor.radius_mm - self.dome.radius);
        if away > most && most > 0.0 {
            self.dome.at = [x, y].map(|v| v * most / away);
        }
    }

    /// Raises the bed by what stands at each node; returns the height of white that runs on it [m].
    fn stand(
        &self,
        flow: &mut FilmFlow,
        (bed, floor, taken): (&Bed, usize, &[bool]),
        pour: &Pour,
        columns: &[Column],
    ) -> Vec<f64> {
        let [mound, edge] = [pour.thick_height_mm, pour.edge_mm].map(|mm| 1e-3 * mm);
        flow.puddle = vec![edge; self.thin.len()];
        let runs = |i: usize| {
            if i >= floor || taken[i] {
                flow.raise(i, WALL);
                return 0.0;
            }
            let [x, y, _] = bed.places[i];
            let yolk = self.dome.top([x, y]).unwrap_or(0.0);
            let height = self.white(i) * bed.per_area[i];
            if height <= 0.0 {
                flow.raise(i, yolk);
                return 0.0;
            }
            // Round the yolk thick white stands as high as beside it, not on top of it.
            let room = (mound - yolk).max(0.0);
            let stands = (self.thick[i] * bed.per_area[i]).min(room).max(columns[i].set * height).min(height);
            flow.raise(i, yolk + stands);
            flow.puddle[i] = (edge - stands).max(0.0);
            height - stands
        };
        (0..self.thin.len()).map(runs).collect()
    }

    /// One sweep of what runs, thin white before thick; the yolk drifts with the white round it.
    fn flow(&mut self, mut flow: FilmFlow, bed: &Bed, manner: &Manner, runs: &[f64], sweep: Sweep, dt: f64) {
        let mobile: Vec<f64> = runs.iter().zip(&bed.areas).map(|(height, area)| height * area).collect();
        let thin: Vec<f64> = mobile.iter().zip(&self.thin).map(|(mobile, thin)| mobile.min(*thin)).collect();
        let thick: Vec<f64> = mobile.iter().zip(&thin).map(|(mobile, thin)| mobile - thin).collect();
        flow.sweep(bed, manner, &mobile, sweep, dt);
        let near = |i: usize| {
            let [x, y, _] = bed.places[i];
            libm::hypot(x - self.dome.at[0], y - self.dome.at[1]) < 1.5 * self.dome.radius
        };
        let sum: f64 = (0..runs.len()).filter(|i| near(*i)).map(|i| self.white(i)).sum();
        let mut drifted: Vec<f64> = (0..runs.len()).map(|i| if near(i) { mobile[i] } else { 0.0 }).collect();
        let from = drifted.clone();
        flow.carry(bed, &mut drifted);
        if sum > 0.0 {
            for axis in 0..2 {
                let shift: f64 =
                    drifted.iter().zip(&from).zip(&bed.places).map(|((to, from), p)| (to - from) * p[axis]).sum();
                self.dome.at[axis] += shift / sum;
            }
        }
        for (field, mut moving) in [(&mut self.thin, thin), (&mut self.thick, thick)] {
            field.iter_mut().zip(&moving).for_each(|(v, m)| *v -= m);
            flow.carry(bed, &mut moving);
            field.iter_mut().zip(&moving).for_each(|(v, m)| *v = (*v + m).max(0.0));
        }
    }

    /// What heat has made of the white at each node of the pan.
    fn columns(&self, lies: &Lies<'_>, pan: &PanModel, pour: &Pour) -> Vec<Column> {
        let (model, state) = (lies.model, lies.state);
        let Layout::Upright(mesh) = model.mesh().layout() else { return vec![Column::default(); self.thin.len()] };
        let set = model.changed(state, &pour.sets_by);
        let fluidity = arrhenius(pour.activation_energy_kj_mol, 20.0, 1e3 * DENSITY / pour.viscosity_mpa_s);
        let (heights, whole) = (mesh.layer_heights(), mesh.thickness());
        let column = |i: usize| {
            let [x, y, z] = pan.liquids.bed.places[i];
            let p = lies.seen.to_body(glam::DVec3::new(x, y, z));
            let found = mesh.locate_or_nearest([p.x, p.y]);
            let (mut warm, mut below) = (0.0, 0.0);
            for (level, height) in heights.iter().enumerate() {
                let at = |field: &[f64]| -> f64 {
                    (0..3).map(|k| found.weights[k] * field[mesh.node(level, found.nodes[k] as usize)]).sum()
                };
                warm += height / whole * at(&state.temperature);
                below += if set.is_some_and(|set| at(set) > HALF) { height / whole } else { 0.0 };
            }
            Column { fluidity: fluidity(warm), set: below.min(1.0) }
        };
        let wet = |i: usize| pan.liquids.bed.places[i][2] <= 0.0 && self.white(i) > 0.0;
        (0..self.thin.len()).map(|i| if wet(i) { column(i) } else { Column::default() }).collect()
    }
}

/// Density of egg white [kg/m³] (chosen: within 1 % of white and yolk).
const DENSITY: f64 = 1030.0;

/// White above a node of the pan.
#[derive(Clone, Copy, Debug, Default)]
struct Column {
    /// One over the kinematic viscosity [s/m²].
    fluidity: f64,
    /// Share of its height that has set [-].
    set: f64,
}

/// Returns true if enough of the lower face has set that nothing runs any more.
pub(crate) fn has_set(model: &FoodModel, state: &FoodState) -> bool {
    let (Layout::Upright(mesh), Some(pour)) = (model.mesh().layout(), model.description().pour.as_ref()) else {
        return true;
    };
    let Some(set) = model.changed(state, &pour.sets_by) else { return true };
    let areas = &mesh.section.areas;
    let below: f64 = set.iter().zip(areas).map(|(x, area)| x * area).sum();
    below >= HALF * areas.iter().sum::<f64>()
}
