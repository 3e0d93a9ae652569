//! The present shape of a piece: positions of its nodes after contraction, bending and curling.

use saute_heat::{Layout, Station, SweptMesh};

use crate::body::shrimp::volume_centre;
use crate::model::FoodModel;
use crate::state::FoodState;

/// Present pose of a station of the path.
#[derive(Clone, Copy, Debug)]
pub(crate) struct StationPose {
    /// Centre of the station [m].
    pub(crate) centre: [f64; 3],
    /// Rotation about z from the rest pose [rad].
    pub(crate) turned: f64,
}

impl StationPose {
    /// Position of a point of the section, stretched across [m].
    pub(crate) fn place(&self, station: &Station, [x, y]: [f64; 2], lateral: f64) -> [f64; 3] {
        let [a, b] = station.across;
        let from = rotated([0, 1, 2].map(|k| lateral * (x * a[k] + y * b[k])), self.turned);
        [0, 1, 2].map(|k| self.centre[k] + from[k])
    }
}

impl FoodModel {
    /// Present mean thickness, or of a curved body the height as it lies on its side [m].
    pub fn thickness(&self, state: &FoodState) -> f64 {
        let Layout::Upright(mesh) = self.shape.mesh.layout() else {
            return self.shape.size[2] * state.stretch.lateral;
        };
        let areas = mesh.section.areas.iter().enumerate();
        let sum: f64 = areas.map(|(i, a)| a * column_heights(mesh, state, i).last().unwrap_or_default()).sum();
        sum / mesh.section.area()
    }

    /// Present position of every node in the body frame [m].
    ///
    /// The origin of a slice is midway between its lowest and highest mean levels, that of a curved body the centre of its
    /// volume.
    pub fn positions(&self, state: &FoodState) -> Vec<[f64; 3]> {
        let mut positions = Vec::new();
        self.flat_positions_into(state, &mut positions);
        if state.stretch.dome != 0.0 {
            for (node, p) in positions.iter_mut().enumerate() {
                p[2] += state.stretch.dome * (0.5 - self.shape.outwards_at(self.shape.mesh.position(node)));
            }
        }
        if let Some(waves) = self.shape.waves.as_ref().filter(|_| state.stretch.waves != 0.0) {
            for (node, p) in positions.iter_mut().enumerate() {
                let [x, y, _] = self.shape.mesh.position(node);
                p[2] += state.stretch.waves * (waves.at([x, y]) - 0.5);
            }
        }
        positions
    }

    /// As [`Self::positions`], without dome and waves, into a reused buffer.
    pub fn flat_positions_into(&self, state: &FoodState, positions: &mut Vec<[f64; 3]>) {
        positions.clear();
        positions.resize(self.shape.mesh.node_count(), [0.0; 3]);
        match self.shape.mesh.layout() {
            Layout::Upright(mesh) => self.upright(mesh, state, positions),
            Layout::Along(mesh, stations) => self.along_stations(mesh, stations, state, positions),
            Layout::Cells(cells) => self.cell_positions(cells, state, positions),
        }
    }

    fn upright(&self, mesh: &SweptMesh, state: &FoodState, positions: &mut [[f64; 3]]) {
        let n = mesh.nodes_per_level();
        let (half, lateral) = (0.5 * self.thickness(state), state.stretch.lateral);
        for (i, &[x, y]) in mesh.section.points.iter().enumerate() {
            for (level, z) in column_heights(mesh, state, i).enumerate() {
                positions[level * n + i] = [x * lateral, y * lateral, z - half];
            }
        }
        if state.stretch.draped > 0.0 {
            sink(state.stretch.draped, half, n, positions);
        }
    }

    fn along_stations(&self, mesh: &SweptMesh, stations: &[Station], state: &FoodState, positions: &mut [[f64; 3]]) {
        let standing = self.spine(mesh, stations, state);
        let centre = self.stand(state, stations, standing, positions);
        positions.iter_mut().for_each(|p| (0..3).for_each(|k| p[k] -= centre[k]));
    }

    /// Places the nodes by the poses of their stations; returns the centre of their volume, which [`Self::positions`]
    /// subtracts [m].
    pub(crate) fn stand(
        &self,
        state: &FoodState,
        stations: &[Station],
        standing: impl Iterator<Item = StationPose>,
        positions: &mut [[f64; 3]],
    ) -> [f64; 3] {
        let n = stations.first().map_or(0, |s| s.section.points.len());
        for (level, (standing, station)) in standing.zip(stations).enumerate() {
            for (i, p) in station.section.points.iter().enumerate() {
                positions[level * n + i] = standing.place(station, *p, state.stretch.lateral);
            }
        }
        self.centre_of(positions)
    }

    /// Centre of the nodes weighted by their rest volumes [m].
    fn centre_of(&self, positions: &[[f64; 3]]) -> [f64; 3] {
        volume_centre(self.shape.mesh.volumes().iter().copied(), |node| positions[node])
    }

    /// Present poses of the stations; the first centre stays at rest. The spine shortens by each level's mean stretch and
    /// turns by the curl, evenly along its length.
    pub(crate) fn spine<'a>(
        &self,
        mesh: &'a SweptMesh,
        stations: &'a [Station],
        state: &'a FoodState,
    ) -> impl Iterator<Item = StationPose> + use<'a> {
        let (curl, length) = (self.curl(state), mesh.thickness());
        let turned = move |level: usize| curl * (0.5 - mesh.levels[level] / length);
        let mut centre = stations.first().map_or([0.0; 3], |s| s.centre);
        (0..stations.len()).map(move |level| {
            if let Some(before) = level.checked_sub(1) {
                let stretch = 0.5 * (mean_axial(mesh, state, before) + mean_axial(mesh, state, level));
                let run = [0, 1, 2].map(|k| stretch * (stations[level].centre[k] - stations[before].centre[k]));
                let run = rotated(run, 0.5 * (turned(before) + turned(level)));
                (0..3).for_each(|k| centre[k] += run[k]);
            }
            StationPose { centre, turned: turned(level) }
        })
    }

    /// Height of the origin of [`Self::positions`] above the plane on which the flat side of the piece lies [m].
    pub fn rest_height(&self, state: &FoodState) -> f64 {
        if let Some(cells) = self.shape.mesh.cells() {
            let lowest = cells.surface.vertices.iter().map(|p| p[2]).fold(f64::INFINITY, f64::min);
            return -lowest * state.stretch.lateral;
        }
        0.5 * (self.thickness(state) + state.stretch.dome.abs() + state.stretch.waves)
    }

    /// Gap below a patch of the lower face that dome and waves of a bent slice cause, at a point of the rest shape [m].
    ///
    /// `up` is the world's upward direction in the body frame.
    pub fn dome_gap(&self, state: &FoodState, point: [f64; 2], up: [f64; 3]) -> f64 {
        let waved = self.shape.waves.as_ref().map_or(0.0, |waves| wave_gap(state, waves.at(point), up));
        dome_gap(state, self.shape.outwards_at([point[0], point[1], 0.0]), up) + waved
    }

    /// As [`Self::dome_gap`], below the middle of a patch [m].
    #[inline]
    pub fn patch_dome_gap(&self, state: &FoodState, patch: usize, up: [f64; 3]) -> f64 {
        let gap = dome_gap(state, self.shape.outwards[patch], up);
        if state.stretch.waves == 0.0 {
            return gap;
        }
        gap + self.shape.waved.get(patch).map_or(0.0, |at| wave_gap(state, *at, up))
    }
}

/// Gap that the dome causes at a relative square of the distance from the middle [m].
#[inline]
fn dome_gap(state: &FoodState, out: f64, up: [f64; 3]) -> f64 {
    let upwards = state.stretch.dome * up[2];
    if upwards > 0.0 { upwards * (1.0 - out).max(0.0) } else { -upwards * out }
}

/// Gap that the waves cause at their relative height [m].
#[inline]
fn wave_gap(state: &FoodState, at: f64, up: [f64; 3]) -> f64 {
    state.stretch.waves * if up[2] > 0.0 { at } else { 1.0 - at }
}

/// Present height of a column of a slice above its lowest level, level by level [m].
fn column_heights<'a>(mesh: &'a SweptMesh, state: &'a FoodState, column: usize) -> impl Iterator<Item = f64> + use<'a> {
    let n = mesh.nodes_per_level();
    let mut height = 0.0;
    core::iter::once(0.0).chain(mesh.levels.windows(2).enumerate().map(move |(level, pair)| {
        let (low, high) = (state.stretch.axial[level * n + column], state.stretch.axial[(level + 1) * n + column]);
        height += 0.5 * (low + high) * (pair[1] - pair[0]) * mesh.path.column(column);
        height
    }))
}

/// Sinks a limp piece of uneven height onto its upper face, which is flat when it is draped.
fn sink(draped: f64, half: f64, per_level: usize, positions: &mut [[f64; 3]]) {
    let top = positions.len() - per_level;
    for i in 0..per_level {
        let down = draped * (half - positions[top + i][2]);
        (i..positions.len()).step_by(per_level).for_each(|node| positions[node][2] += down);
    }
}

/// Mean stretch along the path over a level [-].
fn mean_axial(mesh: &SweptMesh, state: &FoodState, level: usize) -> f64 {
    let (n, areas) = (mesh.nodes_per_level(), &mesh.section_at(level).areas);
    let axial = &state.stretch.axial[level * n..(level + 1) * n];
    axial.iter().zip(areas).map(|(s, a)| s * a).sum::<f64>() / areas.iter().sum::<f64>()
}

/// A vector turned about z by an angle [rad].
fn rotated([x, y, z]: [f64; 3], angle: f64) -> [f64; 3] {
    let (sine, cosine) = (libm::sin(angle), libm::cos(angle));
    [cosine * x - sine * y, sine * x + cosine * y, z]
}
