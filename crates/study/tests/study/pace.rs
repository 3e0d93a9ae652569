//! Promise: a locked speed is held or not by what passed, whatever clock measured it.

use std::sync::Arc;

use saute_kitchen::Library;
use saute_study::{PaceMeter, Protocol, Study, shipped};

/// A meter at five times real time after frames of some wall time and simulated time each [s].
fn after(frames: impl IntoIterator<Item = (f64, f64)>) -> PaceMeter {
    let mut meter = PaceMeter::at(5.0);
    frames.into_iter().for_each(|(wall_s, simulated_s)| meter.pass(wall_s, simulated_s));
    meter
}

#[test]
fn even_frames_hold_the_speed_however_long_they_are() {
    for wall_s in [0.016, 0.2, 1.5] {
        let meter = after((0..400).map(|_| (wall_s, 5.0 * wall_s)));
        let pace = meter.pace().expect("time has passed");
        assert!(
            pace.holds(meter.wall_s()) && (pace.held_median - 5.0).abs() < 1e-9 && pace.behind_s < 1e-6,
            "{pace:?}"
        );
    }
}

#[test]
fn a_machine_that_holds_three_does_not_hold_five_and_is_behind_by_what_is_missing() {
    let meter = after((0..40).map(|_| (0.25, 0.75)));
    let pace = meter.pace().expect("time has passed");
    assert!(!pace.holds(meter.wall_s()));
    assert!((pace.held_median - 3.0).abs() < 1e-9 && (pace.behind_s - 20.0).abs() < 1e-9, "{pace:?}");
}

#[test]
fn one_second_that_was_lost_shows_in_what_is_missing_and_not_in_the_median() {
    let lost = std::iter::once((1.0, 0.0));
    let meter = after((0..40).map(|_| (0.25, 1.25)).chain(lost));
    let pace = meter.pace().expect("time has passed");
    assert!((pace.held_median - 5.0).abs() < 1e-9 && (pace.behind_s - 5.0).abs() < 1e-9, "{pace:?}");
    assert!(!pace.holds(meter.wall_s()), "half the seconds do not make up for it");
    assert_eq!(PaceMeter::at(5.0).pace(), None, "nothing has passed");
}

#[test]
fn the_speed_to_be_held_is_the_fastest_of_the_trials_to_come() {
    let library = Library::embedded().expect("embedded data");
    let text = shipped::text("2013").expect("is shipped");
    let text = text.replacen("trials = 2\nspeed = 5", "trials = 2\nspeed = 8", 1);
    let protocol = Arc::new(Protocol::parse(&text, "2013.toml", &library).expect("parses"));
    let study = Study::begin(protocol, "P01".parse().expect("a code"));
    assert_eq!(study.fastest_to_come().map(|simulate| simulate.speed), Some(8.0));
}
