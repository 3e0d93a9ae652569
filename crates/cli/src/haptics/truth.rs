//! What the simulator says was true, against what the driver believed.

use std::collections::BTreeMap;
use std::path::Path;

use glam::{DQuat, DVec3};
use saute_haptics::control_loop::LogRow;
use saute_haptics::{Health, Wrench};
use serde::Serialize;

use crate::error::CliError;

/// Error of poses.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct PoseError {
    /// 99 of 100 samples are nearer [mm].
    pub mm: f64,
    /// 99 of 100 samples are nearer [°].
    pub deg: f64,
}

/// Error of wrenches.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct WrenchError {
    /// Root mean square of what really pulled the pan less what the driver says [N].
    pub n: f64,
    /// The same of torques [N·m].
    pub nm: f64,
}

/// What was true at one moment.
struct True {
    position: DVec3,
    rotation: DQuat,
    wrench: Wrench,
}

/// Compares the log between two device times [s] with the simulator's file.
pub fn compare(
    file: &Path,
    log: &[LogRow],
    [from_s, until_s]: [f64; 2],
    preload: &Wrench,
) -> Result<Option<(PoseError, WrenchError)>, CliError> {
    let truth = read(file)?;
    let (mut mm, mut deg, mut force, mut torque) = (Vec::new(), Vec::new(), Vec::new(), Vec::new());
    let mut told: Option<Wrench> = None;
    for row in log.iter().skip_while(|r| r.time_s < from_s).take_while(|r| r.time_s <= until_s) {
        let now = truth.get(&((row.time_s * 1e6).round() as u64)).filter(|_| row.health == Health::Running);
        if let Some(now) = now {
            mm.push((row.pose.position - now.position).length() * 1e3);
            deg.push(angle(row.pose.rotation, now.rotation).to_degrees());
            // A command acts until the next sample tells what it did.
            if let Some(told) = told {
                let off = now.wrench - *preload - told;
                force.push(off.force.length_squared());
                torque.push(off.torque.length_squared());
            }
        }
        told = now.map(|_| row.achieved);
    }
    if mm.is_empty() || force.is_empty() {
        return Ok(None);
    }
    let rms = |squares: &[f64]| (squares.iter().sum::<f64>() / squares.len() as f64).sqrt();
    let pose = PoseError { mm: of_100(&mut mm, 99), deg: of_100(&mut deg, 99) };
    Ok(Some((pose, WrenchError { n: rms(&force), nm: rms(&torque) })))
}

fn angle(a: DQuat, b: DQuat) -> f64 {
    let d = b * a.conjugate();
    2.0 * DVec3::new(d.x, d.y, d.z).length().atan2(d.w.abs())
}

/// The value that so many of a hundred do not exceed.
fn of_100(values: &mut [f64], count: usize) -> f64 {
    values.sort_by(f64::total_cmp);
    values[(values.len() - 1) * count / 100]
}

fn read(file: &Path) -> Result<BTreeMap<u64, True>, CliError> {
    let reader = csv::Reader::from_path(file).map_err(|e| {
        CliError::place(file.display(), format!("cannot be read: {e}"), "free some space for temporary files")
    })?;
    // The last line is incomplete if the simulator ended while it wrote.
    Ok(reader.into_deserialize::<Row>().filter_map(Result::ok).map(true_at).collect())
}

/// Columns of the simulator's file: time [µs], position [m], rotation as a quaternion x, y, z, w, force [N] and torque [N·m].
type Row = (u64, [f64; 3], [f64; 4], [f64; 6]);

fn true_at((time_us, position, rotation, wrench): Row) -> (u64, True) {
    let (position, rotation) = (DVec3::from_array(position), DQuat::from_array(rotation));
    (time_us, True { position, rotation, wrench: Wrench::from_rows(wrench) })
}
