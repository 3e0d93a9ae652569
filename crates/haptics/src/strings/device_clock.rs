//! The device's clock: 32-bit microseconds that wrap, and that start anywhere after a restart of the device.

/// Difference between the clocks of device and host over the break between two sessions above which the device has restarted [s]
/// (chosen: far above the delay of a link, and quartz clocks differ so much after an hour only).
const RESTARTED_S: f64 = 0.5;

/// Times of samples that never go back, in the device's microseconds.
#[derive(Clone, Copy, Debug, Default)]
pub struct DeviceClock {
    /// Time so far [µs].
    time_us: u64,
    /// The last sample: its time as the device states it [µs], and as the host received it [s]; none before the first one.
    last: Option<(u32, f64)>,
    /// True until the first sample of the session.
    is_new_session: bool,
}

impl DeviceClock {
    /// Begins a session: its first sample may have any time.
    pub fn begin_session(&mut self) {
        self.is_new_session = true;
    }

    /// Takes the time of a sample [µs] that the host received at a time of its clock [s]. Returns the time since the last sample
    /// of the session [s], or `None` if the sample is not later than that one. The first sample of a session is 0 s after it.
    pub fn advance(&mut self, sample_us: u32, host_s: f64) -> Option<f64> {
        if std::mem::take(&mut self.is_new_session) {
            self.time_us += self.since_last_session(sample_us, host_s);
            self.last = Some((sample_us, host_s));
            return Some(0.0);
        }
        let (last_us, _) = self.last?;
        let passed = sample_us.wrapping_sub(last_us);
        if passed as i32 <= 0 {
            return None;
        }
        self.time_us += u64::from(passed);
        self.last = Some((sample_us, host_s));
        Some(f64::from(passed) * 1e-6)
    }

    /// Returns the time since the last sample of the session before [µs]: by the device's clock, or by the host's if the device has
    /// restarted meanwhile.
    fn since_last_session(&self, sample_us: u32, host_s: f64) -> u64 {
        let Some((last_us, last_s)) = self.last else { return u64::from(sample_us) };
        let (passed, passed_s) = (sample_us.wrapping_sub(last_us), (host_s - last_s).max(0.0));
        let restarted = (f64::from(passed) * 1e-6 - passed_s).abs() > RESTARTED_S;
        if restarted { (passed_s * 1e6) as u64 } else { u64::from(passed) }
    }

    /// Returns the time of the last sample [s].
    pub fn time_s(&self) -> f64 {
        self.time_us as f64 * 1e-6
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn time_continues_over_a_wrap_and_old_samples_are_none() {
        let mut clock = DeviceClock::default();
        clock.begin_session();
        assert_eq!(clock.advance(u32::MAX - 499, 1.0), Some(0.0));
        let next = [500, 500, 499].map(|us| clock.advance(us, 1.001));
        assert_eq!(next, [Some(1e-3), None, None]);
        assert!((clock.time_s() - (f64::from(u32::MAX) + 501.0) * 1e-6).abs() < 1e-9, "{}", clock.time_s());
    }

    #[test]
    fn the_clock_of_a_device_that_went_on_continues_in_the_next_session() {
        let mut clock = DeviceClock::default();
        clock.begin_session();
        clock.advance(5_000_000, 1.0);
        clock.begin_session();
        assert_eq!(clock.advance(5_300_000, 1.3), Some(0.0));
        assert!((clock.time_s() - 5.3).abs() < 1e-9, "{}", clock.time_s());
    }

    #[test]
    fn a_restarted_clock_sets_the_time_neither_back_nor_ahead() {
        for restarted in [0, 1000, 40_000_000, u32::MAX] {
            let mut clock = DeviceClock::default();
            clock.begin_session();
            clock.advance(3_000_000_000, 10.0);
            clock.begin_session();
            assert_eq!(clock.advance(restarted, 12.0), Some(0.0));
            assert_eq!(clock.advance(restarted.wrapping_add(1000), 12.001), Some(1e-3));
            assert!((clock.time_s() - 3002.001).abs() < 1e-6, "{restarted}: {} s", clock.time_s());
        }
    }
}
