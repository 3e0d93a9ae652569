//! Arguments from Python: shapes and types are refused with what was expected.

use glam::{DQuat, DVec3};
use pyo3::exceptions::{PyTypeError, PyValueError};
use pyo3::prelude::*;
use saute_kitchen::dynamics::Pose;
use saute_kitchen::hands::ranges::Limits;

/// Returns the name of the type of a value.
pub(crate) fn type_name(value: &Bound<'_, PyAny>) -> String {
    value.get_type().name().map_or_else(|_| "?".to_owned(), |name| name.to_string())
}

/// Reads so many finite numbers; `form` states how they are written.
pub(crate) fn numbers<const N: usize>(value: &Bound<'_, PyAny>, what: &str, form: &str) -> PyResult<[f64; N]> {
    let expected = || format!("{what} must be {form}, {N} finite numbers");
    let list: Vec<f64> =
        value.extract().map_err(|_| PyTypeError::new_err(format!("{}, not {}", expected(), type_name(value))))?;
    let found = list.len();
    let array = <[f64; N]>::try_from(list);
    let array = array.map_err(|_| PyValueError::new_err(format!("{}, not {found} of them", expected())))?;
    if array.iter().all(|v| v.is_finite()) { Ok(array) } else { Err(PyValueError::new_err(expected())) }
}

/// Checks that a number is in its range.
pub(crate) fn ranged(value: f64, what: &str, [low, high]: [f64; 2]) -> PyResult<f64> {
    if (low..=high).contains(&value) {
        return Ok(value);
    }
    Err(PyValueError::new_err(format!("{what} = {value} is out of range: it may be {low} to {high}")))
}

/// Returns a number in its range, or its default.
pub(crate) fn limited(value: Option<f64>, what: &str, limits: Limits) -> PyResult<f64> {
    ranged(value.unwrap_or(limits.default), what, [limits.low, limits.high])
}

/// How a pose is written: the order of ROS.
const POSE: &str = "[x, y, z, qx, qy, qz, qw] (metres and a unit quaternion)";
/// How far the length of a quaternion may be from 1 [-] (chosen: what single precision leaves).
const UNIT: f64 = 1e-3;

/// Reads a pose.
pub(crate) fn pose(value: &Bound<'_, PyAny>) -> PyResult<Pose> {
    let [x, y, z, qx, qy, qz, qw] = numbers::<7>(value, "pose", POSE)?;
    let rotation = DQuat::from_xyzw(qx, qy, qz, qw);
    if (rotation.length() - 1.0).abs() > UNIT {
        return Err(PyValueError::new_err(format!(
            "pose must be {POSE}; the quaternion has length {}",
            rotation.length()
        )));
    }
    Ok(Pose { position: DVec3::new(x, y, z), rotation: rotation.normalize() })
}

/// Returns a pose in the order in which it is read.
pub(crate) fn seven(pose: &Pose) -> Vec<f64> {
    let (p, q) = (pose.position, pose.rotation);
    vec![p.x, p.y, p.z, q.x, q.y, q.z, q.w]
}
