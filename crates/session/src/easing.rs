//! Time slows to that of a kitchen where a hand is needed, and returns to its speed afterwards.

/// Speed at which a hand keeps up [-].
const REAL_TIME: f64 = 1.0;

/// The speed that was left for a hand.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Easing {
    left: Option<f64>,
    /// The speed before time was let run fast up to the next hand [-].
    before_hurry: Option<f64>,
}

impl Easing {
    /// Returns the speed to change to, if any: real time while a hand is needed, and then the speed before unless another was chosen [-].
    pub fn look(&mut self, is_needed: bool, speed: f64) -> Option<f64> {
        if is_needed && speed > REAL_TIME {
            let from = self.before_hurry.take().unwrap_or(speed);
            self.left = (from > REAL_TIME).then_some(from);
            return Some(REAL_TIME);
        }
        if speed != REAL_TIME {
            self.left = None;
        }
        self.left.take_if(|_| !is_needed)
    }

    /// The speed to which it returns [-].
    pub fn left(&self) -> Option<f64> {
        self.left
    }

    /// Time is let run fast until a hand is needed, and is to return to this speed [-] afterwards.
    pub fn hurry_from(&mut self, speed: f64) {
        self.before_hurry = Some(speed);
    }

    /// Forgets the speeds that were left: another one was chosen.
    pub fn forget(&mut self) {
        *self = Self::default();
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn it_slows_for_a_hand_and_returns_to_the_speed_before() {
        let mut easing = Easing::default();
        assert_eq!(easing.look(false, 5.0), None);
        assert_eq!(easing.look(true, 5.0), Some(1.0));
        assert_eq!((easing.look(true, 1.0), easing.left()), (None, Some(5.0)));
        assert_eq!(easing.look(false, 1.0), Some(5.0));
        assert_eq!((easing.look(false, 5.0), easing.left()), (None, None));
    }

    #[test]
    fn a_speed_that_was_chosen_meanwhile_stays() {
        let mut easing = Easing::default();
        easing.look(true, 20.0);
        assert_eq!(easing.look(false, 2.0), None);
        assert_eq!(easing.look(true, 1.0), None);
        assert_eq!(easing.look(false, 1.0), None, "real time was chosen");
        easing.look(true, 20.0);
        easing.forget();
        assert_eq!(easing.look(false, 1.0), None);
    }

    #[test]
    fn after_a_hurry_it_returns_to_the_speed_before_the_hurry() {
        let mut easing = Easing::default();
        easing.hurry_from(5.0);
        assert_eq!(easing.look(true, 20.0), Some(1.0));
        assert_eq!(easing.look(false, 1.0), Some(5.0));
        easing.hurry_from(1.0);
        assert_eq!(easing.look(true, 20.0), Some(1.0));
        assert_eq!(easing.look(false, 1.0), None);
    }
}
