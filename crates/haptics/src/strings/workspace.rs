//! Where a string device works: how far it is from singular, and which wrenches it can show.

use saute_kitchen::dynamics::Pose;
use saute_kitchen::dynamics::pose::about;
use serde::Serialize;

use crate::strings::geometry::Geometry;
use crate::strings::linear::eigenvalues;
use crate::strings::tension::TensionSolver;
use crate::strings::{Lines, STRINGS};
use crate::wrench::Wrench;

/// Axes of a wrench, force first.
pub const AXES: [&str; 6] = ["fx", "fy", "fz", "tx", "ty", "tz"];

/// A wrench counts as shown when no more than this is missing: share of it, and newtons (chosen: what hands notice).
const MISSING: f64 = 0.02;
const MISSING_N: f64 = 0.02;
/// Halvings of the search for the largest wrench (chosen: to a thousandth of the limit).
const HALVINGS: usize = 12;
/// Smallest singular value of the strings' directions below which a pose counts as singular [-] (chosen: an encoder's
/// count then moves the pose by twenty).
const SINGULAR: f64 = 0.05;
/// Poses along each axis of the workspace (chosen: its middle and its ends).
const SHARES: [f64; 3] = [-1.0, 0.0, 1.0];

/// How much of a wrench along each axis can be shown, beyond the empty device [N, N·m].
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Reach {
    /// Towards + along fx, fy, fz, tx, ty, tz.
    pub plus: [f64; 6],
    /// Towards −.
    pub minus: [f64; 6],
}

/// The workspace of a device.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct WorkspaceReport {
    /// At its home.
    pub home: Reach,
    /// The least over the workspace.
    pub least: Reach,
    /// Smallest singular value at home, torques at the rule's lever [-].
    pub home_singular_value: f64,
    /// The least over the workspace.
    pub least_singular_value: f64,
    /// Poses that were looked at.
    pub poses: usize,
    /// How many of them are singular.
    pub singular_poses: usize,
}

/// Smallest singular value of the strings' directions, torques over a lever [m]; 0 where a motion leaves all lengths as they
/// are.
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

/// The largest multiple of a unit wrench that can be shown beyond the empty device, up to `limit`.
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

/// Looks at the workspace's middle, corners and tilts.
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

/// Places on a grid over the workspace, upright and tilted each way.
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
