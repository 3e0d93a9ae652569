//! How often a picture looks at what changes slowly.

/// Looks a number of ticks apart, all at the same ticks; one at every tick by default.
#[derive(Clone, Debug)]
pub(crate) struct Pace {
    every: u64,
    /// Number of the last look.
    looked: Option<u64>,
    due: bool,
}

impl Default for Pace {
    fn default() -> Self {
        Self { every: 1, looked: None, due: true }
    }
}

impl Pace {
    /// Sets the ticks between two looks.
    pub(crate) fn set(&mut self, ticks: u64) {
        self.every = ticks.max(1);
    }

    /// Ticks between two looks.
    pub(crate) fn every(&self) -> u64 {
        self.every
    }

    /// Begins a picture at a tick.
    pub(crate) fn begin(&mut self, tick: u64) {
        let look = Some(tick / self.every);
        self.due = self.every == 1 || look != self.looked;
        self.looked = look;
    }

    /// Returns true if the picture is to show the present state.
    pub(crate) fn is_due(&self) -> bool {
        self.due
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_picture_is_due_unless_told_and_then_one_in_an_interval() {
        let mut pace = Pace::default();
        let due = |pace: &mut Pace, ticks: [u64; 5]| {
            ticks.map(|tick| {
                pace.begin(tick);
                pace.is_due()
            })
        };
        assert_eq!(due(&mut pace, [0, 0, 1, 1, 2]), [true; 5]);
        pace.set(3);
        assert_eq!(due(&mut pace, [3, 4, 5, 6, 10]), [true, false, false, true, true]);
        assert_eq!(due(&mut pace, [10, 0, 0, 2, 9]), [false, true, false, false, true], "a restart goes back");
    }
}
