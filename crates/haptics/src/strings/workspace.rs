//! Workspace analysis of a string device: distance from singular poses, and the wrenches that it can render.

use saute_kitchen::dynamics::Pose;
use saute_kitchen::dynamics::pose::about;
use serde::Serialize;

use crate::strings::geometry::Geometry;
use crate::strings::linear::eigenvalues;
use crate::strings::tension::TensionSolver;
use crate::strings::{Lines, STRINGS};
use crate::wrench::Wrench;

/// Names of the axes of a wrench, force first.
pub const AXES: [&str; 6] = ["fx", "fy", "fz", "tx", "ty", "tz"];

/// Largest relative error of a rendered wrench [-] (chosen: below what hands notice).
const MISSING: f64 = 0.02;
/// Largest absolute error of a rendered wrench [N] (chosen: below what hands notice).
const MISSING_N: f64 = 0.02;
/// Number of bisections for the largest wrench (chosen: they resolve a thousandth of the limit).
const HALVINGS: usize = 12;
/// Smallest singular value of the structure matrix below which a pose counts as singular [-] (chosen: an encoder count then moves
/// the pose by twenty pitches).
const SINGULAR: f64 = 0.05;
/// Grid positions along each axis of the workspace (chosen: its centre and its ends).
const SHARES: [f64; 3] = [-1.0, 0.0, 1.0];

/// Largest renderable wrench along each axis, beyond the empty device [N, N·m].
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Reach {
    /// In the positive direction of fx, fy, fz, tx, ty, tz [N, N·m].
    pub plus: [f64; 6],
    /// In the negative direction [N, N·m].
    pub minus: [f64; 6],
}

/// Workspace analysis of a device.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct WorkspaceReport {
    /// Largest wrenches at home [N, N·m].
    pub home: Reach,
    /// Minimum of the largest wrenches over the workspace [N, N·m].
    pub least: Reach,
    /// Smallest singular value of the structure matrix at home, torques over the rule's lever [-].
    pub home_singular_value: f64,
    /// Minimum of the smallest singular value over the workspace [-].
    pub least_singular_value: f64,
    /// Number of poses on the grid.
    pub poses: usize,
    /// Number of singular poses among them.
    pub singular_poses: usize,
}

/// Returns the smallest singular value of the structure matrix, torques over a lever [m] [-].
///
/// It is 0 where a motion leaves all lengths unchanged.
pub fn smallest_singular_value(lines: &Lines, lever: f64) -> f64 {
    let mut square = [[0.0; 6]; 6];
    for i in 0..STRINGS {
        let mut column = lines.column(i);
        column[3..].iter_mut().for_each(|v| *v /= lever);
        for (r, row) in square.iter_mut().enumerate() {
            (0..6).for_each(|c| row[c] += column[r] * column[c]);
        }
    }
    libm::sqrt(eigenvalues(square).into_iter().fold(f64::INFINITY, f64::min).max(0.0))
}

/// Returns the largest multiple of a unit wrench that the device renders beyond its rest, up to `limit` [N or N·m].
pub fn largest(geometry: &Geometry, lines: &Lines, unit: &Wrench, limit: f64) -> f64 {
    let mut solver = TensionSolver::new(geometry.tension_rule());
    let preload = geometry.preload();
    let lever = geometry.tension_rule().lever;
    let base = solver.solve(lines, &preload).achieved;
    let mut shown = |size: f64| {
        let missing = solver.solve(lines, &(preload + *unit * size)).achieved - base - *unit * size;
        let in_newtons = unit.force.length() + unit.torque.length() / lever;
        missing.force.length() + missing.torque.length() / lever < MISSING * size * in_newtons + MISSING_N
    };
    if shown(limit) {
        return limit;
    }
    let (mut low, mut high) = (0.0, limit);
    for _ in 0..HALVINGS {
        let middle = 0.5 * (low + high);
        if shown(middle) { low = middle } else { high = middle }
    }
    low
}

fn reach(geometry: &Geometry, lines: &Lines) -> Reach {
    let limits = &geometry.limits;
    let along = |axis: usize, sign: f64| {
        let mut rows = [0.0; 6];
        rows[axis] = sign;
        let limit = if axis < 3 { limits.force_n } else { limits.torque_nm };
        largest(geometry, lines, &Wrench::from_rows(rows), limit)
    };
    Reach { plus: std::array::from_fn(|axis| along(axis, 1.0)), minus: std::array::from_fn(|axis| along(axis, -1.0)) }
}

/// Analyses the workspace on a grid of positions and tilts.
pub fn report(geometry: &Geometry) -> WorkspaceReport {
    let rig = geometry.rig();
    let lever = geometry.tension_rule().lever;
    let home = rig.lines(&geometry.home());
    let value = smallest_singular_value(&home, lever);
    let mut report = WorkspaceReport {
        home: reach(geometry, &home),
        least: reach(geometry, &home),
        home_singular_value: value,
        least_singular_value: value,
        poses: 0,
        singular_poses: 0,
    };
    for pose in poses(geometry) {
        let lines = rig.lines(&pose);
        let value = smallest_singular_value(&lines, lever);
        report.poses += 1;
        report.singular_poses += usize::from(value < SINGULAR);
        report.least_singular_value = report.least_singular_value.min(value);
        let there = reach(geometry, &lines);
        for axis in 0..6 {
            report.least.plus[axis] = report.least.plus[axis].min(there.plus[axis]);
            report.least.minus[axis] = report.least.minus[axis].min(there.minus[axis]);
        }
    }
    report
}

/// Returns poses on a grid over the workspace, upright and tilted in four directions.
fn poses(geometry: &Geometry) -> impl Iterator<Item = Pose> {
    let half = glam::DVec3::from_array(geometry.workspace.half_mm) * 1e-3;
    let (home, tilt) = (geometry.home(), geometry.workspace.tilt_deg.to_radians());
    let turns = [[0.0, 0.0], [1.0, 0.0], [-1.0, 0.0], [0.0, 1.0], [0.0, -1.0]];
    let shares = SHARES.into_iter().flat_map(|x| SHARES.into_iter().flat_map(move |y| SHARES.map(|z| [x, y, z])));
    shares.flat_map(move |share| {
        turns.map(|[x, y]| Pose {
            position: home.position + half * glam::DVec3::from_array(share),
            rotation: about(glam::DVec3::new(x, y, 0.0) * tilt),
        })
    })
}
