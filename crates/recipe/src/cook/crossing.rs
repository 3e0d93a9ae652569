//! Detection of the moment at which quantities have crossed a value.

/// Differences below this are rounding errors [K, kg] (chosen: area means of a uniform temperature are off by 1e-12).
const SAME_VALUE: f64 = 1e-7;

/// Detects that several differences have crossed zero, each at any time since the start.
///
/// If all start on one side, each must reach the other side. If they start on both sides, each must have been on the same
/// side once; those that start there count from the start.
#[derive(Clone, Debug)]
pub(crate) struct Crossing {
    /// True for each difference that has been zero or more.
    above: Vec<bool>,
    /// True for each difference that has been zero or less.
    below: Vec<bool>,
    started_above: bool,
    started_below: bool,
}

impl Crossing {
    /// Returns a detector that starts at the present differences.
    pub(crate) fn new(differences: &[f64]) -> Self {
        Self {
            above: vec![false; differences.len()],
            below: vec![false; differences.len()],
            started_above: differences.iter().all(|d| *d >= SAME_VALUE),
            started_below: differences.iter().all(|d| *d <= -SAME_VALUE),
        }
    }

    /// Takes the present differences and returns true once every difference has crossed zero. A difference within
    /// [`SAME_VALUE`] of zero is on both sides.
    pub(crate) fn update(&mut self, differences: &[f64]) -> bool {
        for (i, d) in differences.iter().enumerate() {
            self.above[i] |= *d > -SAME_VALUE;
            self.below[i] |= *d < SAME_VALUE;
        }
        let all = |side: &[bool]| side.iter().all(|reached| *reached);
        (!self.started_above && all(&self.above)) || (!self.started_below && all(&self.below))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Returns the result for each row; the detector starts at the first.
    fn crossed<const N: usize, const M: usize>(rows: [[f64; M]; N]) -> [bool; N] {
        let mut crossing = Crossing::new(&rows[0]);
        rows.map(|row| crossing.update(&row))
    }

    #[test]
    fn a_single_difference_crosses_in_either_direction_or_is_zero_from_the_start() {
        assert_eq!(crossed([[-2.0], [-1.0], [1.0]]), [false, false, true]);
        assert_eq!(crossed([[3.0], [1.0], [-0.5]]), [false, false, true]);
        assert_eq!(crossed([[1e-9]]), [true]);
        assert_eq!(crossed([[f64::NAN], [f64::NAN]]), [false, false]);
    }

    #[test]
    fn of_several_differences_each_must_have_crossed_but_may_have_come_back() {
        assert_eq!(crossed([[-2.0, -3.0], [1.0, -2.0], [-1.0, -1.0], [-1.0, 1.0]]), [false, false, false, true]);
        assert_eq!(crossed([[2.0, 3.0], [-1.0, 2.0], [-1.0, -1.0]]), [false, false, true]);
    }

    #[test]
    fn differences_that_start_on_the_other_side_count_from_the_start() {
        // One core is hot when the step is armed, the other heats up.
        assert_eq!(crossed([[5.0, -3.0], [6.0, -1.0], [7.0, 0.5]]), [false, false, true]);
        // One piece is light, the other loses weight.
        assert_eq!(crossed([[-5.0, 3.0], [-6.0, 1.0], [-7.0, -0.5]]), [false, false, true]);
    }
}
