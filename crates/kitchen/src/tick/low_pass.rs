//! First-order low-pass filter of a measured quantity.

/// Moves `value` towards `input` over a tick of `dt` [s] with the time constant `constant` [s], by backward Euler: stable for
/// any step.
pub(crate) fn low_pass(value: &mut f64, input: f64, constant: f64, dt: f64) {
    *value += (input - *value) * dt / (dt + constant);
}
