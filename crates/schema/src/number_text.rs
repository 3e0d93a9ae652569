//! Numbers in messages.

/// Returns a number as people write it: with an exponent if it is very small or very large.
pub fn number_text(v: f64) -> String {
    if v.is_finite() && v != 0.0 && !(1e-4..1e7).contains(&v.abs()) { format!("{v:e}") } else { v.to_string() }
}
