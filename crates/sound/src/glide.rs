//! Values that change without a step: straight over a tick, or smoothly towards a goal.

/// A value that goes to its goal in a straight line over a number of steps.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Glide {
    value: f32,
    goal: f32,
    step: f32,
    left: u32,
}

impl Glide {
    /// A constant value.
    pub(crate) fn at(value: f32) -> Self {
        Self { value, goal: value, step: 0.0, left: 0 }
    }

    /// Sets out for a goal, to be reached after a number of steps.
    pub(crate) fn set_out(&mut self, goal: f32, steps: u32) {
        self.goal = goal;
        self.left = steps.max(1);
        self.step = (goal - self.value) / self.left as f32;
    }

    /// Goes a step and returns the value.
    pub(crate) fn step(&mut self) -> f32 {
        if self.left > 0 {
            self.left -= 1;
            self.value = if self.left == 0 { self.goal } else { self.value + self.step };
        }
        self.value
    }

    /// Returns true if it is at 0.
    pub(crate) fn is_zero(&self) -> bool {
        self.left == 0 && self.value == 0.0
    }
}

/// A gain that follows its goal with a time constant; it arrives at exactly 0.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Smooth {
    value: f32,
    share: f32,
}

/// Gain that counts as none [-] (chosen: −140 dB, below the least step of 16 bits by far).
const NOTHING: f32 = 1e-7;

impl Smooth {
    /// A gain of 0 whose way to a goal is done to 95 % after a time [s].
    pub(crate) fn over(time_s: f32, rate: f32) -> Self {
        // 95 % are three time constants.
        Self { value: 0.0, share: 1.0 - libm::expf(-3.0 / (time_s * rate)) }
    }

    /// Moves towards the goal and returns the value.
    pub(crate) fn follow(&mut self, goal: f32) -> f32 {
        self.value += (goal - self.value) * self.share;
        if goal == 0.0 && self.value < NOTHING {
            self.value = 0.0;
        }
        self.value
    }

    /// The value now.
    pub(crate) fn value(&self) -> f32 {
        self.value
    }
}
