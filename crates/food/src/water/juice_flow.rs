//! Flow of free juice along the fibres: its direction, its speed and its way through boiling flesh.

use saute_heat::{Layout, SweptMesh};

use crate::model::FoodModel;
use crate::state::FoodState;
use crate::water::air_film::HOTTEST_WET;
use crate::water::juice::Runoff;

/// Temperature above which a node boils [K] (chosen: half a kelvin below the boiling point of wet flesh).
const BOILS: f64 = HOTTEST_WET - 0.5;

/// Direction of new juice, by level.
pub(crate) struct Divide {
    /// The level from which juice flows either way.
    level: usize,
    /// Rising share of the juice that is freed below, on and above that level [-].
    share: [f64; 3],
}

impl Divide {
    /// Rising share of the juice that is freed on a level [-].
    pub(crate) fn rising(&self, level: usize) -> f64 {
        self.share[(level > self.level) as usize + (level >= self.level) as usize]
    }
}

impl FoodModel {
    /// Returns the direction of new juice: away from the coldest level of a slice, and from the middle of a body along
    /// stations. From the hotter side a part flows through the coldest level: all of `through` if the other side is as cold
    /// as that level, none if it is as hot.
    pub(crate) fn divide(&self, mesh: &SweptMesh, state: &FoodState) -> Divide {
        let last = mesh.levels.len() - 1;
        if self.shape.closed_below {
            return Divide { level: 0, share: [1.0; 3] };
        }
        let Layout::Upright(_) = self.shape.mesh.layout() else {
            return Divide { level: last / 2, share: [0.0, 0.5, 1.0] };
        };
        let n = mesh.nodes_per_level();
        let mean = |level: usize| state.temperature[level * n..(level + 1) * n].iter().sum::<f64>() / n as f64;
        let (mut coldest, mut cold, mut hot) = (last / 2, mean(last / 2), [f64::NEG_INFINITY; 2]);
        for level in 0..=last {
            let t = mean(level);
            if t < cold - SAME {
                (coldest, cold) = (level, t);
            }
        }
        for level in 0..=last {
            let side = usize::from(level > coldest);
            hot[side] = hot[side].max(mean(level));
        }
        let through = |own: f64, other: f64| {
            let through = self.kinetics.water_holding.through_share;
            if own > cold { through * ((own - other.max(cold)) / (own - cold)).clamp(0.0, 1.0) } else { 0.0 }
        };
        Divide { level: coldest, share: [through(hot[0], hot[1]), 0.5, 1.0 - through(hot[1], hot[0])] }
    }

    /// Moves the rising juice up and the rest down, by at most one level.
    pub(crate) fn drain(&self, mesh: &SweptMesh, state: &mut FoodState, reach: f64, runoff: &mut Runoff) {
        let last = mesh.levels.len() - 1;
        for to in (1..=last).rev() {
            self.carry_level(mesh, state, [to - 1, to], reach, runoff);
        }
        for to in 0..last {
            self.carry_level(mesh, state, [to + 1, to], reach, runoff);
        }
    }

    /// Moves a share of the juice of a level that flows towards another level, in every column.
    fn carry_level(
        &self,
        mesh: &SweptMesh,
        state: &mut FoodState,
        levels: [usize; 2],
        reach: f64,
        runoff: &mut Runoff,
    ) {
        let share = self.share(mesh, levels, reach);
        let up = levels[1] > levels[0];
        let mixes = mixing(mesh, levels, share);
        let wider = width(mesh, levels[0]) / width(mesh, levels[1]);
        for column in 0..mesh.nodes_per_level() {
            let nodes = levels.map(|level| mesh.node(level, column));
            let [here, ahead] =
                nodes.map(|node| if up { state.rising[node] } else { state.juice[node] - state.rising[node] });
            let mixes = if state.temperature[nodes[1]] > BOILS { 0.0 } else { mixes };
            let flows = here + mixes * (here - wider * ahead);
            // Mixing never takes more than is there.
            let mass = (share * flows).min(here);
            if mass > 0.0 {
                self.flow(state, nodes, mass, up, runoff);
            }
        }
    }

    /// Moves juice [kg] from a node to the next. Where it comes from flesh that does not boil into flesh that does, a part passes all that
    /// boils as liquid: once for all of it, so that the part does not depend on the number of levels that boil.
    #[inline]
    pub(crate) fn flow(&self, state: &mut FoodState, nodes: [usize; 2], mass: f64, up: bool, runoff: &mut Runoff) {
        let mut carried = mass;
        if state.temperature[nodes[1]] > BOILS && state.temperature[nodes[0]] <= BOILS {
            let passes = self.kinetics.water_holding.passes_boiling * mass;
            self.pass_boiling(state, nodes, passes, up, runoff);
            // The rest of the same number: together they are no more than there was.
            carried -= passes;
        }
        self.carry(state, nodes, carried, up);
    }

    /// Share of a level's free juice that passes to the next level while juice moves by `reach` [m] [-]; 0 across a cut.
    fn share(&self, mesh: &SweptMesh, [from, to]: [usize; 2], reach: f64) -> f64 {
        if self.shape.parts_levels(from, to) {
            return 0.0;
        }
        let spacing = libm::fabs(mesh.levels[from] - mesh.levels[to]);
        1.0 - 1.0 / (1.0 + reach / spacing)
    }

    /// Moves juice [kg], with its heat, from a node to another.
    #[inline]
    fn carry(&self, state: &mut FoodState, [from, to]: [usize; 2], mass: f64, up: bool) {
        let enthalpy = mass * self.properties.water_enthalpy(state.temperature[from]);
        for (field, amount) in [(&mut state.juice, mass), (&mut state.water, mass), (&mut state.enthalpy, enthalpy)] {
            field[from] -= amount;
            field[to] += amount;
        }
        if up {
            state.rising[from] -= mass;
            state.rising[to] += mass;
        }
    }

    /// Lets juice [kg] pass through a boiling node to the face as liquid at 100 °C; the node heats it.
    fn pass_boiling(&self, state: &mut FoodState, [from, to]: [usize; 2], mass: f64, up: bool, runoff: &mut Runoff) {
        if mass <= 0.0 {
            return;
        }
        let [cold, hot] = [state.temperature[from], HOTTEST_WET].map(|t| mass * self.properties.water_enthalpy(t));
        state.juice[from] -= mass;
        state.water[from] -= mass;
        if up {
            state.rising[from] -= mass;
        }
        state.enthalpy[from] -= cold;
        state.enthalpy[to] -= hot - cold;
        runoff.mass += mass;
        runoff.enthalpy += hot;
    }
}

/// Length over which juice mixes while it flows, its dispersivity [m] (chosen: a fortieth of the way from the middle of a steak to its
/// face; beds of grains mix over up to a tenth of the way. With twice as much the drip of levels of 0.25 mm is a third off).
const MIXES_OVER: f64 = 0.3e-3;

/// Flow by mixing between two levels, relative to that by the mean speed, per difference of their juice [-]. First-order steps mix over half
/// the spacing by themselves; finer levels get the rest, as far as it is stable, so that the drip depends less on the mesh. Juice that reaches
/// a face does not mix back.
fn mixing(mesh: &SweptMesh, [from, to]: [usize; 2], share: f64) -> f64 {
    let spacing = libm::fabs(mesh.levels[from] - mesh.levels[to]);
    if to == 0 || to == mesh.levels.len() - 1 || share <= 0.0 {
        return 0.0;
    }
    let stable = 0.5 / share - 1.0;
    (MIXES_OVER / spacing - 0.5).clamp(0.0, if stable > 0.0 { stable } else { 0.0 })
}

/// Twice the thickness of the flesh that belongs to a level [m].
fn width(mesh: &SweptMesh, level: usize) -> f64 {
    let last = mesh.levels.len() - 1;
    libm::fabs(mesh.levels[(level + 1).min(last)] - mesh.levels[level.saturating_sub(1)])
}

/// Difference of temperature below which two levels are equally cold [K] (chosen: far above rounding).
const SAME: f64 = 1e-6;
