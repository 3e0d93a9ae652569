//! Verdicts and values in words.

use saute_lab::Verdict;

/// Returns what came out, in words.
pub fn word(verdict: &Verdict) -> &'static str {
    match (verdict.pass, &verdict.known_miss) {
        (Some(true), None) => "holds",
        (Some(true), Some(_)) => "HOLDS, but known_miss says that it does not",
        (Some(false), None) => "FALLS SHORT",
        (Some(false), Some(_)) => "known miss",
        (None, _) => "information",
    }
}

/// Returns a value with four decimals, or `none`.
pub fn number(value: Option<f64>) -> String {
    value.map_or_else(|| "none".into(), |v| format!("{v:.4}"))
}
