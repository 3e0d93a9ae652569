//! Scales: from values to pixels, and the steps at which they are labelled.

/// A linear map from values to pixels [px].
#[derive(Clone, Copy, Debug)]
pub struct Scale {
    from: [f64; 2],
    to: [f64; 2],
}

impl Scale {
    /// Returns the map of the range `from` onto the range `to` [px].
    pub fn new(from: [f64; 2], to: [f64; 2]) -> Self {
        Self { from, to }
    }

    /// Returns the position of a value [px].
    pub fn at(&self, value: f64) -> f64 {
        let span = (self.from[1] - self.from[0]).max(f64::MIN_POSITIVE);
        self.to[0] + (value - self.from[0]) / span * (self.to[1] - self.to[0])
    }
}

/// Returns the smallest step of 1, 2 or 5 times a power of ten that divides a span into at most `most` parts.
pub fn nice_step(span: f64, most: f64) -> f64 {
    let rough = (span / most).max(1e-9);
    let power = 10_f64.powf(rough.log10().floor());
    [1.0, 2.0, 5.0, 10.0].into_iter().map(|m| m * power).find(|s| *s >= rough * (1.0 - 1e-9)).unwrap_or(10.0 * power)
}

/// Returns the smallest range that contains both values and ends on steps, with the step; steps are whole numbers, as the
/// labels are.
pub fn nice_range(low: f64, high: f64, most: f64) -> ([f64; 2], f64) {
    let step = nice_step(high - low, most).max(1.0);
    let from = (low / step + 1e-9).floor() * step;
    let to = (high / step - 1e-9).ceil() * step;
    ([from, to.max(from + step)], step)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_axis_ends_on_its_steps_and_holds_every_value() {
        for (low, high) in [(0.0, 219.6), (5.0, 58.2), (179.8, 213.8), (20.0, 20.0), (0.0, 3500.0)] {
            let (range, step) = nice_range(low, high, 5.0);
            assert!(range[0] <= low && range[1] >= high, "{low} {high}: {range:?}");
            let pieces = (range[1] - range[0]) / step;
            assert!(
                (pieces - pieces.round()).abs() < 1e-9 && step >= 1.0 && (1.0..=7.0).contains(&pieces),
                "{range:?} by {step}"
            );
        }
    }
}
