//! The engine of the original on a current machine.

use serde::Serialize;

/// Speed of the engine of the original, rebuilt and measured on one thread of a machine with two cores, in
/// steps of 1/60 s.
#[derive(Clone, Copy, Debug, Serialize)]
pub struct OriginalEngine {
    /// Rigid-body steps with 10 carrots and 10 shrimps [1/s].
    pub rigid_20_mixed_per_s: f64,
    /// Rigid-body steps with 35 shrimps of three hulls each [1/s].
    pub rigid_35_shrimps_per_s: f64,
    /// Heat solver: number of vertices and time of one step [ms].
    pub heat_step_ms: [(u32, f64); 4],
    /// Both together with 35 shrimps [cycles/s].
    pub cycles_35_shrimps_per_s: f64,
}

/// The measured values.
pub const MEASURED: OriginalEngine = OriginalEngine {
    rigid_20_mixed_per_s: 722.0,
    rigid_35_shrimps_per_s: 222.0,
    heat_step_ms: [(54, 0.073), (120, 0.19), (1210, 2.35), (10_080, 21.9)],
    cycles_35_shrimps_per_s: 88.0,
};
