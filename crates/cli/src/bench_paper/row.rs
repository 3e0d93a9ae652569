//! The rows of the tables: scenes, published speeds and goals.

use std::collections::BTreeSet;

use saute_kitchen::dynamics::{RIGID_HZ, solid_shape};
use saute_kitchen::{Kitchen, Library, MeshSize};
use serde::Serialize;

use super::scene::{PAN, Scene};
use super::stopwatch;
use crate::error::CliError;

/// The published tables: name, carrots, shrimps and speed [cycles/s], measured on hardware of 2009; the last row gives
/// "more than 60" (source: Kato, Hasegawa, "Interactive Cooking Simulator", SIGGRAPH Asia 2013
/// `[@kato-hasegawa-2013]`).
const PUBLISHED: [(&str, usize, usize, f64); 15] = [
    ("3", 5, 0, 310.0),
    ("3", 10, 0, 205.0),
    ("3", 15, 0, 155.0),
    ("3", 20, 0, 127.0),
    ("3", 0, 5, 310.0),
    ("3", 0, 10, 190.0),
    ("3", 0, 15, 145.0),
    ("3", 0, 20, 110.0),
    ("4", 1, 1, 333.0),
    ("4", 3, 3, 293.0),
    ("4", 5, 5, 200.0),
    ("4", 7, 7, 161.0),
    ("4", 9, 9, 139.0),
    ("4", 11, 11, 116.0),
    ("35", 0, 35, 60.0),
];
/// Goals over published speeds with the meshes of 2013, at rest and while the pan is shaken [-] (chosen).
const GOAL_RATIOS: [f64; 2] = [20.0, 10.0];
/// Goal with 35 shrimps of the default meshes [cycles/s] (chosen).
const GOAL_DEFAULT: f64 = 240.0;

/// A scene of a table.
#[derive(Clone, Debug)]
pub struct Case {
    table: &'static str,
    published: f64,
    /// The scene that is timed.
    pub scene: Scene,
}

/// A row, as `--json` prints it.
#[derive(Debug, Serialize)]
pub struct Row {
    /// Table: "3", "4" or "35".
    pub table: &'static str,
    /// Number of carrot coins.
    pub carrots: usize,
    /// Number of shrimps.
    pub shrimps: usize,
    /// Meshes: "2013" or "default".
    pub mesh: MeshSize,
    /// Rule of the conductances: "segments" or "shape functions".
    pub rule: &'static str,
    /// True if the pan is shaken.
    pub shaking: bool,
    /// Number of nodes of all pieces.
    pub nodes: usize,
    /// Rigid-body steps per second of simulated time [1/s].
    pub rigid_hz: u32,
    /// Collision shapes of the pieces.
    pub collider: String,
    /// Largest penetration [mm].
    pub max_penetration_mm: f64,
    /// Rise of the core temperature over the timed part, mean of the pieces [K].
    pub core_rise_k: f64,
    /// Median of the runs [cycles/s].
    pub cycles_per_s: f64,
    /// Published speed [cycles/s].
    pub published: Option<f64>,
    /// Measured over published [-].
    pub ratio: Option<f64>,
    /// Goal [cycles/s].
    pub goal: Option<f64>,
    /// True if the goal is met; none without a goal.
    pub met: Option<bool>,
    /// Number of pieces that fell out of the pan.
    pub lost: usize,
    /// Speed of each run [cycles/s].
    pub runs: Vec<f64>,
}

/// Returns all rows: with the meshes of 2013, then with the default ones, each at rest and shaken.
pub fn cases() -> Vec<Case> {
    let sorts = [MeshSize::Paper2013, MeshSize::Default].into_iter().flat_map(|m| [(m, false), (m, true)]);
    let rows = |(mesh, shaking): (MeshSize, bool)| {
        PUBLISHED.map(|(table, carrots, shrimps, published)| Case {
            table,
            published,
            scene: Scene { carrots, shrimps, mesh, shaking, pan: PAN.to_owned() },
        })
    };
    sorts.flat_map(rows).collect()
}

impl Case {
    fn goal(&self) -> Option<f64> {
        match self.scene.mesh {
            MeshSize::Paper2013 => Some(GOAL_RATIOS[usize::from(self.scene.shaking)] * self.published),
            MeshSize::Default => (self.table == "35").then_some(GOAL_DEFAULT),
        }
    }
}

/// Times a row.
pub fn measure(case: &Case, library: &Library) -> Result<Row, CliError> {
    let timed = stopwatch::time(&case.scene, library)?;
    let (scene, goal, kitchen) = (&case.scene, case.goal(), &timed.kitchen);
    let paper = scene.mesh == MeshSize::Paper2013;
    Ok(Row {
        table: case.table,
        carrots: scene.carrots,
        shrimps: scene.shrimps,
        mesh: scene.mesh,
        rule: if paper { "segments" } else { "shape functions" },
        shaking: scene.shaking,
        nodes: kitchen.pieces().iter().map(|p| p.model.mesh().node_count()).sum(),
        rigid_hz: RIGID_HZ,
        collider: colliders(kitchen),
        max_penetration_mm: timed.max_penetration_mm,
        core_rise_k: timed.core_rise_k,
        cycles_per_s: timed.cycles_per_s,
        published: Some(case.published),
        ratio: Some(timed.cycles_per_s / case.published),
        goal,
        met: goal.map(|g| timed.cycles_per_s >= g && timed.lost == 0),
        lost: timed.lost,
        runs: timed.runs,
    })
}

/// Returns the names of the collision shapes of the pieces.
fn colliders(kitchen: &Kitchen) -> String {
    let solids = kitchen.pieces().iter().filter_map(|p| kitchen.world().solid(p.key));
    let names: BTreeSet<&str> = solids.map(solid_shape::name).collect();
    names.into_iter().collect::<Vec<_>>().join(", ")
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]
    use super::*;

    #[test]
    fn a_row_has_every_number() {
        let case = cases().into_iter().find(|c| c.table == "4" && c.scene.shaking).unwrap();
        let row = measure(&case, &Library::embedded().unwrap()).unwrap();
        let row = serde_json::to_value(row).unwrap();
        for key in ["max_penetration_mm", "core_rise_k", "cycles_per_s", "ratio", "runs"] {
            assert!(!row[key].is_null(), "{key}: {row}");
        }
        // A carrot of 54 and a shrimp of 119 vertices.
        assert_eq!((&row["nodes"], &row["carrots"], &row["shrimps"]), (&173.into(), &1.into(), &1.into()));
        assert_eq!((&row["table"], &row["mesh"], &row["rule"]), (&"4".into(), &"2013".into(), &"segments".into()));
        assert_eq!((&row["collider"], &row["lost"]), (&"capsules, cylinder".into(), &0.into()));
        assert_eq!((&row["published"], &row["goal"], &row["shaking"]), (&333.0.into(), &3330.0.into(), &true.into()));
        assert!(row["rigid_hz"].as_u64().unwrap() >= 120 && row["cycles_per_s"].as_f64().unwrap() > 0.0);
    }

    #[test]
    fn the_goals_of_thirty_five_shrimps_are_1200_at_rest_600_shaken_and_240_with_default_meshes() {
        let goals: Vec<Option<f64>> = cases().iter().filter(|c| c.table == "35").map(Case::goal).collect();
        assert_eq!(goals, [Some(1200.0), Some(600.0), Some(240.0), Some(240.0)]);
        assert_eq!(cases().len(), 60);
    }
}
