//! Looks at the fields of a run at regular times.

use saute_food::NodeField;
use saute_heat::conduction::tensor::TensorBody;

/// What is reported at each instant: time [s], body, fields.
pub type Told<'a> = dyn FnMut(f64, &TensorBody, Vec<NodeField<'_>>) + 'a;

/// Reports the fields at the start, after the first step that reaches each multiple of an interval, and at the end.
///
/// No step is made shorter for it, so that the run gives the same numbers as unwatched.
pub struct Watch<'a> {
    /// Interval [s].
    every_s: f64,
    /// How often the interval has passed [-].
    count: f64,
    last_s: Option<f64>,
    tell: Option<&'a mut Told<'a>>,
}

impl<'a> Watch<'a> {
    /// Returns a watch that reports the fields about every `every_s` [s].
    pub fn every(every_s: f64, tell: &'a mut Told<'a>) -> Self {
        Self { every_s, count: 0.0, last_s: None, tell: Some(tell) }
    }

    /// Returns a watch that reports nothing.
    pub(crate) fn none() -> Self {
        Self { every_s: f64::INFINITY, count: 0.0, last_s: None, tell: None }
    }

    /// Reports the fields if they are due at a time [s].
    pub(crate) fn look<'b>(&mut self, time: f64, fields: impl FnOnce() -> (&'b TensorBody, Vec<NodeField<'b>>)) {
        // Times are sums of steps.
        if self.tell.is_some() && time > self.count * self.every_s - 1e-9 * self.every_s {
            self.count = libm::floor(time / self.every_s + 1e-9) + 1.0;
            self.tell(time, fields);
        }
    }

    /// Reports the fields at the end of the run, unless they were just reported.
    pub(crate) fn end<'b>(&mut self, time: f64, fields: impl FnOnce() -> (&'b TensorBody, Vec<NodeField<'b>>)) {
        if self.last_s != Some(time) {
            self.tell(time, fields);
        }
    }

    fn tell<'b>(&mut self, time: f64, fields: impl FnOnce() -> (&'b TensorBody, Vec<NodeField<'b>>)) {
        let Some(tell) = &mut self.tell else { return };
        let (body, fields) = fields();
        tell(time, body, fields);
        self.last_s = Some(time);
    }
}
