//! The sound of a kitchen.

use std::sync::Arc;

use pyo3::prelude::*;
use saute_kitchen::TICKS_PER_S;
use saute_session::hearing::Sound;
use saute_sound::RATES;

use crate::package::array::shown_rows;
use crate::package::expected::ranged;
use crate::package::kitchen::{PyKitchen, TICKS_PER_LOOK};

/// Longest sound that is made at once [s] (chosen: 230 MB at 48 kHz; longer ones are made in parts, which fit together).
const LONGEST_S: f64 = 600.0;

#[pymethods]
impl PyKitchen {
    /// Advances the kitchen by so many seconds, in whole ticks of 0.1 s, and returns what is heard of them: samples × 2 numbers from -1 to
    /// 1, left and right. Calls that follow each other fit together; what is commanded between them is heard. Before the first one, and
    /// after ticks that were stepped otherwise, it begins to listen again.
    #[pyo3(signature = (seconds, rate = 48_000))]
    fn render_sound<'py>(&mut self, py: Python<'py>, seconds: f64, rate: u32) -> PyResult<Bound<'py, PyAny>> {
        self.whole()?;
        ranged(seconds, "seconds", [0.0, LONGEST_S])?;
        ranged(f64::from(rate), "rate", [*RATES.start(), *RATES.end()].map(f64::from))?;
        let mut left = (seconds * f64::from(TICKS_PER_S)).round() as u64;
        let mut samples = Vec::new();
        while left > 0 {
            let now = left.min(TICKS_PER_LOOK);
            py.detach(|| (0..now).for_each(|_| self.sound_tick(rate, &mut samples)));
            left -= now;
            py.check_signals()?;
        }
        shown_rows(py, &Arc::new(samples), |rows| rows.as_slice(), |frame| frame)
    }
}

impl PyKitchen {
    /// Advances a tick and adds its samples.
    fn sound_tick(&mut self, rate: u32, samples: &mut Vec<[f32; 2]>) {
        let sound = self.sound.take().filter(|sound| sound.goes_on(&self.state, rate));
        let mut sound = sound.unwrap_or_else(|| Arc::new(Sound::new(&self.state, rate)));
        self.ticks(1);
        samples.extend_from_slice(Arc::make_mut(&mut sound).follow(&self.state));
        self.sound = Some(sound);
    }
}
