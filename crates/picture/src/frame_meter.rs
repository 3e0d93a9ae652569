//! How fast frames come and simulated time runs.

use std::collections::VecDeque;

use saute_kitchen::heat::sorted::{Quantile, Sorted};

/// Wall time over which is measured [s] (chosen: long enough for a median, short enough to follow a change).
const WINDOW_S: f64 = 10.0;

/// Times of the last frames.
#[derive(Clone, Debug, Default)]
pub struct FrameMeter {
    /// Wall time and simulated time of each [s].
    frames: VecDeque<(f64, f64)>,
    count: u64,
}

impl FrameMeter {
    /// Takes a frame at wall and simulated time [s]. Simulated time that goes back starts the measurement again.
    pub fn frame(&mut self, now_s: f64, simulated_s: f64) {
        if self.frames.back().is_some_and(|last| simulated_s < last.1) {
            self.frames.clear();
        }
        self.frames.push_back((now_s, simulated_s));
        self.count += 1;
        while self.frames.front().is_some_and(|first| now_s - first.0 > WINDOW_S) {
            self.frames.pop_front();
        }
    }

    /// Frames since the start.
    pub fn count(&self) -> u64 {
        self.count
    }

    /// Frames per second, the median of the last seconds; 0 before the second frame.
    pub fn frames_per_s(&self) -> f64 {
        let apart = self.frames.iter().zip(self.frames.iter().skip(1)).map(|(a, b)| b.0 - a.0);
        let middle = Sorted::new(apart.collect()).quantile(0.5, Quantile::After);
        middle.filter(|apart| *apart > 0.0).map_or(0.0, |apart| 1.0 / apart)
    }

    /// Wall time of the longest frame of the last seconds [s]; 0 before the second frame.
    pub fn longest_frame_s(&self) -> f64 {
        self.frames.iter().zip(self.frames.iter().skip(1)).map(|(a, b)| b.0 - a.0).fold(0.0, f64::max)
    }

    /// Simulated seconds per wall second, over the last seconds.
    pub fn time_ratio(&self) -> f64 {
        let (Some(first), Some(last)) = (self.frames.front(), self.frames.back()) else { return 0.0 };
        if last.0 > first.0 { (last.1 - first.1) / (last.0 - first.0) } else { 0.0 }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn even_frames_give_their_rate_and_the_speed_of_time() {
        let mut meter = FrameMeter::default();
        (0..100).for_each(|n| meter.frame(f64::from(n) * 0.05, f64::from(n) * 0.25));
        assert!((meter.frames_per_s() - 20.0).abs() < 1e-9 && (meter.time_ratio() - 5.0).abs() < 1e-9);
        assert_eq!(meter.count(), 100);
        assert!((meter.longest_frame_s() - 0.05).abs() < 1e-9);
        meter.frame(5.4, 30.0);
        assert!((meter.longest_frame_s() - 0.45).abs() < 1e-9);
    }

    #[test]
    fn a_restart_begins_the_measurement_again() {
        let mut meter = FrameMeter::default();
        meter.frame(0.0, 90.0);
        meter.frame(1.0, 0.0);
        assert_eq!((meter.frames_per_s(), meter.time_ratio()), (0.0, 0.0));
    }
}
