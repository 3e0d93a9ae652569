//! What is struck: pans ring by their metal.

use saute_sound::{Event, EventKind, Metal, Plate, Snapshot, Synth};

use crate::ear::{band, level, mono};
use crate::steam::{PAN, RATE};

/// Renders an event on a pan for a number of seconds.
pub fn struck(kind: EventKind, pan: &Plate, covered: f32, seconds: usize) -> Vec<[f32; 2]> {
    let mut synth = Synth::new(RATE, 3, pan);
    let mut frames = vec![[0.0; 2]; seconds * RATE as usize];
    synth.feed(&Snapshot { covered, ..Snapshot::default() }, &[Event::now(kind, 1.0)]);
    synth.render(&mut frames);
    frames
}

/// Time in which a mode falls by 60 dB, from the levels of two windows of 50 ms [s].
fn decay_s(frames: &[[f32; 2]], hz: f64, windows_s: [f64; 2]) -> f64 {
    let heard = band(&mono(frames), [hz / 1.12, hz * 1.12], f64::from(RATE));
    let at = |s: f64| level(&heard[(s * 48e3) as usize..][..2400]);
    60.0 * (windows_s[1] - windows_s[0]) / (at(windows_s[0]) - at(windows_s[1]))
}

/// Thin steel rings, cast iron is dull: a mode falls by 60 dB in 2.2·Q/f.
#[test]
fn each_metal_rings_by_its_quality() {
    for metal in Metal::ALL {
        let pan = Plate { metal, thickness_m: if metal == Metal::CastIron { 4.3e-3 } else { 2.3e-3 }, ..PAN };
        let hz = f64::from(pan.frequency(0));
        let expected = 2.2 * f64::from(metal.quality()) / hz;
        let frames = struck(EventKind::Clank, &pan, 0.0, 3);
        let found = decay_s(&frames, hz, [0.1 * expected + 0.03, 0.5 * expected + 0.03]);
        println!("{metal:?}: {hz:.0} Hz, {found:.2} s to −60 dB, from Q {expected:.2} s");
        assert!((found / expected - 1.0).abs() < 0.15, "{metal:?}: {found} s, expected {expected} s");
    }
}

/// Food on it makes the pan dull.
#[test]
fn food_damps_what_it_lies_on() {
    let later = |covered| level(&mono(&struck(EventKind::Clank, &PAN, covered, 1)[RATE as usize / 4..]));
    assert!(later(0.0) > later(0.5) + 20.0, "{} {}", later(0.0), later(0.5));
}

/// Every event is heard, none is beyond −6 dBFS alone, and all are over within four seconds.
#[test]
fn every_event_is_heard_and_ends() {
    for kind in EventKind::ALL {
        let frames = struck(kind, &PAN, 0.3, 5);
        let peak = frames.iter().flatten().fold(0.0f32, |peak, x| peak.max(x.abs()));
        println!("{kind:?}: peak {:.1} dBFS", 20.0 * peak.log10());
        assert!((0.02..0.5).contains(&peak), "{kind:?}: {peak}");
        assert!(frames[4 * RATE as usize..].iter().all(|frame| *frame == [0.0; 2]), "{kind:?} does not end");
    }
}
