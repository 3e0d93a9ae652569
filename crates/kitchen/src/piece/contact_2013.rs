//! Mean gap and wetness of a face by the rules of 2013, which keep the law that this program had first.

use crate::data::room::Rules2013;

/// Mean gap of a face [m] after `since` [s] of contact under `pressure` [Pa].
///
/// δ = (δ_final + (δ_initial − δ_final) e^(−t/τ) + δ_settling e^(−t/τ_s)) / (1 + (p − p₀)/p_½).
pub(crate) fn mean_gap(gap: &Rules2013, since: f64, pressure: f64) -> f64 {
    let lifted = libm::exp(-since / gap.time_constant_s);
    let unsettled = libm::exp(-since / gap.settling_s);
    let free = gap.final_gap_mm + (gap.initial_gap_mm - gap.final_gap_mm) * lifted + gap.settling_gap_mm * unsettled;
    let pressed = 1.0 + (pressure - gap.pressure_pa).max(-0.5 * gap.halving_pressure_pa) / gap.halving_pressure_pa;
    1e-3 * free / pressed
}

/// Wet share of a face whose node contains a share of its raw water: all or nothing [-].
pub(crate) fn wetness(held: f64) -> f64 {
    f64::from(u8::from(held > WET_FROM))
}

/// Share of the raw water above which a face is wet [-] (chosen: far above a crust, below bound water).
const WET_FROM: f64 = 0.4;
