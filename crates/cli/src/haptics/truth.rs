//! Errors of the driver's poses and wrenches against the true ones of the simulator.

use std::collections::BTreeMap;
use std::path::Path;

use glam::{DQuat, DVec3};
use saute_haptics::control::control_loop::LogRow;
use saute_haptics::{Health, Wrench};
use saute_kitchen::heat::sorted::{Quantile, Sorted};
use serde::Serialize;

use crate::error::CliError;

/// Error of poses.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct PoseError {
    /// 99th percentile of the position error [mm].
    pub mm: f64,
    /// 99th percentile of the rotation error [°].
    pub deg: f64,
}

/// Error of wrenches.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct WrenchError {
    /// Root mean square of the true force less the reported one [N].
    pub n: f64,
    /// Root mean square of the true torque less the reported one [N·m].
    pub nm: f64,
}

/// The true state at one sample.
struct TrueState {
    position: DVec3,
    rotation: DQuat,
    wrench: Wrench,
}

/// Compares the log between two device times [s] with the file of the simulator; none without common samples.
pub fn compare(
    file: &Path,
    log: &[LogRow],
    [from_s, until_s]: [f64; 2],
    preload: &Wrench,
) -> Result<Option<(PoseError, WrenchError)>, CliError> {
    let truth = read(file)?;
    let (mut mm, mut deg, mut force, mut torque) = (Vec::new(), Vec::new(), Vec::new(), Vec::new());
    let mut reported: Option<Wrench> = None;
    for row in log.iter().skip_while(|r| r.time_s < from_s).take_while(|r| r.time_s <= until_s) {
        let now = truth.get(&((row.time_s * 1e6).round() as u64)).filter(|_| row.health == Health::Running);
        if let Some(now) = now {
            mm.push((row.pose.position - now.position).length() * 1e3);
            deg.push(angle(row.pose.rotation, now.rotation).to_degrees());
            // A command acts until the next sample, so the wrench reported before is compared.
            if let Some(reported) = reported {
                let off = now.wrench - *preload - reported;
                force.push(off.force.length_squared());
                torque.push(off.torque.length_squared());
            }
        }
        reported = now.map(|_| row.achieved);
    }
    let p99 = |values| Sorted::new(values).quantile(0.99, Quantile::Below);
    let (Some(mm), Some(deg), false) = (p99(mm), p99(deg), force.is_empty()) else { return Ok(None) };
    let rms = |squares: &[f64]| (squares.iter().sum::<f64>() / squares.len() as f64).sqrt();
    let pose = PoseError { mm, deg };
    Ok(Some((pose, WrenchError { n: rms(&force), nm: rms(&torque) })))
}

fn angle(a: DQuat, b: DQuat) -> f64 {
    let d = b * a.conjugate();
    2.0 * DVec3::new(d.x, d.y, d.z).length().atan2(d.w.abs())
}

fn read(file: &Path) -> Result<BTreeMap<u64, TrueState>, CliError> {
    let reader = csv::Reader::from_path(file).map_err(|e| {
        CliError::place(file.display(), format!("cannot be read: {e}"), "free some space for temporary files")
    })?;
    // The last line is incomplete if the simulator ended while it wrote.
    Ok(reader.into_deserialize::<Row>().filter_map(Result::ok).map(true_at).collect())
}

/// Columns of the simulator's file: time [µs], position [m], rotation as a quaternion x, y, z, w, force [N] and torque [N·m].
type Row = (u64, [f64; 3], [f64; 4], [f64; 6]);

fn true_at((time_us, position, rotation, wrench): Row) -> (u64, TrueState) {
    let (position, rotation) = (DVec3::from_array(position), DQuat::from_array(rotation));
    (time_us, TrueState { position, rotation, wrench: Wrench::from_rows(wrench) })
}
