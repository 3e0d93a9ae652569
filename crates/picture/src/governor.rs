//! The quality governor: chooses the rendering quality by the time that frames take.

use saute_kitchen::heat::sorted::{Quantile, Sorted};
use saute_scene::quality::Quality;

/// Frames are to come this fast at least [s] (chosen: 50 a second, and what the clock of a 50 Hz screen is off).
const SLOW_S: f64 = 1.025 / 50.0;
/// Frames that come this fast leave room for more [s] (chosen: 55 a second; a 60 Hz screen gives no faster ones).
const QUICK_S: f64 = 1.0 / 55.0;
/// Frames that are judged together (chosen: a second; one slow frame is no slow machine).
const JUDGED: usize = 50;
/// Frames after a change that are not judged (chosen: shaders are compiled and maps redrawn).
const SETTLING: usize = 10;
/// Longer frames are none: the window was hidden, or time stood still [s].
const PAUSE_S: f64 = 0.25;
/// Where stepping the world took more than this share of a frame, the frame says nothing about drawing [-] (chosen).
const STEPPING_SHARE: f64 = 0.25;
/// A better picture is tried after frames have been quick for this long [s]; twice as long after each try that failed,
/// up to a limit (chosen: who cooks is not to see the picture change to and fro).
const PATIENCE_S: f64 = 20.0;
const LONGEST_PATIENCE_S: f64 = 640.0;

/// Steps the quality down where frames are slow, and up again with patience.
#[derive(Clone, Debug)]
pub struct Governor {
    level: Quality,
    judged: Vec<f64>,
    settling: usize,
    /// How long frames have been quick [s].
    quick_s: f64,
    patience_s: f64,
    /// True if the level was raised and has not yet proved itself.
    trying: bool,
}

impl Governor {
    /// Begins at a level.
    pub fn new(level: Quality) -> Self {
        Self { level, judged: Vec::new(), settling: SETTLING, quick_s: 0.0, patience_s: PATIENCE_S, trying: false }
    }

    /// The level that holds.
    pub fn level(&self) -> Quality {
        self.level
    }

    /// Takes the time from one frame to the next and the part of it that went into stepping the world [s].
    pub fn frame(&mut self, frame_s: f64, stepping_s: f64) {
        if frame_s <= 0.0 || frame_s > PAUSE_S || stepping_s > STEPPING_SHARE * frame_s {
            return;
        }
        if self.settling > 0 {
            self.settling -= 1;
            return;
        }
        self.judged.push(frame_s);
        if self.judged.len() == JUDGED {
            self.judge();
        }
    }

    fn judge(&mut self) {
        let judged = Sorted::new(std::mem::take(&mut self.judged));
        let all_s = judged.values().iter().sum::<f64>();
        let median = judged.quantile(0.5, Quantile::After).unwrap_or(0.0);
        if median > SLOW_S {
            self.step_down();
        } else if median > QUICK_S {
            self.quick_s = 0.0;
        } else {
            self.quick_s += all_s;
            if self.quick_s >= self.patience_s {
                self.step_up();
            }
        }
    }

    fn step_down(&mut self) {
        if self.trying {
            self.patience_s = (2.0 * self.patience_s).min(LONGEST_PATIENCE_S);
        }
        self.trying = false;
        self.change(self.level.lower());
    }

    fn step_up(&mut self) {
        self.trying = self.level.higher().is_some();
        self.change(self.level.higher());
    }

    fn change(&mut self, to: Option<Quality>) {
        self.quick_s = 0.0;
        if let Some(level) = to {
            (self.level, self.settling) = (level, SETTLING);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Frames of one length for some seconds; those that step the world are left out.
    fn run(governor: &mut Governor, frame_s: f64, for_s: f64) {
        (0..(for_s / frame_s) as usize).for_each(|_| governor.frame(frame_s, 0.0));
    }

    #[test]
    fn fast_frames_keep_the_best_level() {
        let mut governor = Governor::new(Quality::Best);
        run(&mut governor, 1.0 / 60.0, 600.0);
        assert_eq!(governor.level(), Quality::Best);
        run(&mut governor, 1.0 / 50.0, 600.0);
        assert_eq!(governor.level(), Quality::Best, "a 50 Hz screen");
    }

    #[test]
    fn slow_frames_step_down_level_by_level() {
        let mut governor = Governor::new(Quality::Best);
        run(&mut governor, 0.030, 2.0);
        assert_eq!(governor.level(), Quality::Smooth);
        run(&mut governor, 0.030, 2.0);
        assert_eq!(governor.level(), Quality::Quick);
        run(&mut governor, 0.030, 60.0);
        assert_eq!(governor.level(), Quality::Quick);
    }

    #[test]
    fn a_few_slow_frames_change_nothing() {
        let mut governor = Governor::new(Quality::Best);
        for _ in 0..200 {
            run(&mut governor, 0.100, 0.45);
            run(&mut governor, 1.0 / 60.0, 1.0);
        }
        assert_eq!(governor.level(), Quality::Best);
    }

    #[test]
    fn frames_that_stepping_made_slow_do_not_count() {
        let mut governor = Governor::new(Quality::Best);
        (0..1000).for_each(|_| governor.frame(0.040, 0.020));
        assert_eq!(governor.level(), Quality::Best);
    }

    #[test]
    fn pauses_do_not_count() {
        let mut governor = Governor::new(Quality::Best);
        (0..1000).for_each(|_| governor.frame(0.26, 0.0));
        assert_eq!(governor.level(), Quality::Best);
    }

    #[test]
    fn a_machine_between_two_levels_changes_less_and_less_often() {
        // Smooth holds 60 frames a second here, best only 40.
        let mut governor = Governor::new(Quality::Best);
        let (mut time_s, mut raised_at) = (0.0, Vec::new());
        while time_s < 3600.0 {
            let before = governor.level();
            let frame_s = if before == Quality::Best { 1.0 / 40.0 } else { 1.0 / 60.0 };
            governor.frame(frame_s, 0.0);
            time_s += frame_s;
            assert!(governor.level() >= Quality::Smooth);
            if governor.level() > before {
                raised_at.push(time_s);
            }
        }
        assert!((5..12).contains(&raised_at.len()), "{raised_at:?}");
        let apart: Vec<f64> = raised_at.windows(2).map(|pair| pair[1] - pair[0]).collect();
        assert!(apart.windows(2).take(4).all(|pair| pair[1] > 1.5 * pair[0]), "{apart:?}");
    }

    #[test]
    fn a_machine_that_is_free_again_gets_its_level_back() {
        let mut governor = Governor::new(Quality::Best);
        run(&mut governor, 0.030, 10.0);
        assert_eq!(governor.level(), Quality::Quick);
        run(&mut governor, 1.0 / 60.0, 3.0 * PATIENCE_S);
        assert_eq!(governor.level(), Quality::Best);
    }
}
