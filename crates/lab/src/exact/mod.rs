//! Exact solutions of heat conduction, as series. Source: Carslaw & Jaeger, Conduction of Heat in Solids (1959).

mod flipped_brick;
mod slab;

pub use flipped_brick::FlippedBrick;
pub use slab::{FixedSlab, robin_slab_centre};

/// Returns the root of a function between two points of different sign, by bisection.
fn root(mut low: f64, mut high: f64, f: impl Fn(f64) -> f64) -> f64 {
    let negative = f(low) < 0.0;
    for _ in 0..200 {
        let middle = 0.5 * (low + high);
        if (f(middle) < 0.0) == negative { low = middle } else { high = middle }
    }
    0.5 * (low + high)
}
