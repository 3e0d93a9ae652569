//! Numbers in messages.

/// Returns a number as people write it: with an exponent if it is very small or very large, and shorter so.
pub fn number_text(v: f64) -> String {
    let plain = v.to_string();
    if !v.is_finite() || v == 0.0 || (1e-4..1e7).contains(&v.abs()) {
        return plain;
    }
    let with_exponent = format!("{v:e}");
    if with_exponent.len() < plain.len() { with_exponent } else { plain }
}
