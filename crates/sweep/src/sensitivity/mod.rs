//! Which of the varied values matter for a number: Sobol' indices of a `saltelli` design, elementary effects of a `morris` design.

pub mod elementary_effects;
pub mod sobol_indices;

/// A block of rows that belong together has all of its numbers, or is left out. Returns the whole ones.
fn whole_blocks(numbers: &[Option<f64>], block: usize) -> Vec<Vec<f64>> {
    numbers.chunks_exact(block).filter_map(|rows| rows.iter().copied().collect()).collect()
}

fn mean(values: impl ExactSizeIterator<Item = f64>) -> f64 {
    let count = values.len() as f64;
    values.sum::<f64>() / count
}
