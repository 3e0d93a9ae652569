//! Conditions that hold when a quantity crosses a value.

/// Differences below this are rounding [K, kg] (chosen: area means of an even temperature are off by 1e-12).
const SAME_VALUE: f64 = 1e-7;

/// Differences that are watched until each of them has been on the side on which not all of them began: the last of several
/// pieces counts, and those that are there already are not waited for.
#[derive(Clone, Debug)]
pub(crate) struct Watch {
    above: Vec<bool>,
    below: Vec<bool>,
    began_above: bool,
    began_below: bool,
}

impl Watch {
    /// Begins with the differences of now.
    pub(crate) fn on(differences: &[f64]) -> Self {
        Self {
            above: vec![false; differences.len()],
            below: vec![false; differences.len()],
            began_above: differences.iter().all(|d| *d >= SAME_VALUE),
            began_below: differences.iter().all(|d| *d <= -SAME_VALUE),
        }
    }

    /// Whether it has come to that; a difference that is zero but for rounding is on both sides.
    pub(crate) fn look(&mut self, differences: &[f64]) -> bool {
        for (i, d) in differences.iter().enumerate() {
            self.above[i] |= *d > -SAME_VALUE;
            self.below[i] |= *d < SAME_VALUE;
        }
        let all = |side: &[bool]| side.iter().all(|been| *been);
        (!self.began_above && all(&self.above)) || (!self.began_below && all(&self.below))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Looks at rows one after the other, from the first, at which the watch begins.
    fn looks<const N: usize, const M: usize>(rows: [[f64; M]; N]) -> [bool; N] {
        let mut watch = Watch::on(&rows[0]);
        rows.map(|row| watch.look(&row))
    }

    #[test]
    fn a_single_difference_crosses_in_either_direction_or_is_zero_from_the_start() {
        assert_eq!(looks([[-2.0], [-1.0], [1.0]]), [false, false, true]);
        assert_eq!(looks([[3.0], [1.0], [-0.5]]), [false, false, true]);
        assert_eq!(looks([[1e-9]]), [true]);
        assert_eq!(looks([[f64::NAN], [f64::NAN]]), [false, false]);
    }

    #[test]
    fn of_several_differences_each_must_have_crossed_but_may_have_come_back() {
        assert_eq!(looks([[-2.0, -3.0], [1.0, -2.0], [-1.0, -1.0], [-1.0, 1.0]]), [false, false, false, true]);
        assert_eq!(looks([[2.0, 3.0], [-1.0, 2.0], [-1.0, -1.0]]), [false, false, true]);
    }

    #[test]
    fn those_that_are_there_already_are_not_waited_for() {
        // One core is hot when the step is armed, the other heats up.
        assert_eq!(looks([[5.0, -3.0], [6.0, -1.0], [7.0, 0.5]]), [false, false, true]);
        // One piece is light, the other loses weight.
        assert_eq!(looks([[-5.0, 3.0], [-6.0, 1.0], [-7.0, -0.5]]), [false, false, true]);
    }
}
