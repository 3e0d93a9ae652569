//! The known name that a misspelt one is meant to be.

/// Longest name in which two letters make another word of it (chosen: `end` is not `lid`).
const SHORT: usize = 3;

/// Returns the known name with the smallest Damerau–Levenshtein distance to another name, if the distance is small.
pub fn nearest<'n>(name: &str, known: impl IntoIterator<Item = &'n str>) -> Option<&'n str> {
    let near = known.into_iter().map(|k| (strsim::damerau_levenshtein(name, k), k)).min()?;
    let most = if name.len() <= SHORT { 1 } else { 2.max(name.len() / 3) };
    (near.0 <= most).then_some(near.1)
}
