//! What the stove adds: a flame is heard, a coil hums, a hot plate is silent.

use saute_sound::{Snapshot, Steam, Stove};

use crate::ear::{band, level, mono};
use crate::steam::{RATE, hot, rendered, steady};

fn on(stove: Stove, stove_w: f32) -> Snapshot {
    Snapshot { stove, stove_w, ..Snapshot::default() }
}

fn loud(snapshot: Snapshot) -> f64 {
    level(&mono(&steady(snapshot, 2)))
}

/// A cook hears whether the gas is lit and how high; an iron plate tells nothing.
#[test]
fn a_flame_doubles_its_power_with_its_heat_a_coil_quadruples_it_and_a_plate_is_silent() {
    for (stove, at_2_kw, for_half) in [(Stove::Flame, -48.0, 3.0), (Stove::Coil, -58.0, 6.0)] {
        let [full, half] = [2000.0, 1000.0].map(|watts| loud(on(stove, watts)));
        assert!((full - at_2_kw).abs() < 1.5, "{stove:?}: {full} dB");
        assert!((full - half - for_half).abs() < 0.5, "{stove:?}: {full} and {half} dB");
        let stated = f64::from(on(stove, 2000.0).level());
        assert!((full - stated).abs() < 3.0, "{full} dB rendered, {stated} stated");
    }
    for off in [on(Stove::Silent, 2000.0), on(Stove::Flame, 0.0), on(Stove::Coil, f32::NAN)] {
        assert!(steady(off, 1).iter().all(|frame| *frame == [0.0; 2]), "{off:?}");
    }
}

/// The two are told apart: a coil hums at twice the mains and its overtones, a flame roars and hisses.
#[test]
fn a_coil_hums_low_and_a_flame_is_broad() {
    let share = |stove: Stove, hz: [f64; 2]| {
        let heard = mono(&steady(on(stove, 2000.0), 2));
        level(&band(&heard, hz, f64::from(RATE))) - level(&heard)
    };
    assert!(share(Stove::Coil, [80.0, 520.0]) > -0.5);
    assert!(share(Stove::Coil, [1000.0, 12_000.0]) < -30.0);
    assert!(share(Stove::Flame, [100.0, 1000.0]) > -6.0 && share(Stove::Flame, [1500.0, 8000.0]) > -9.0);
}

/// It is far below a sizzle, so that it hides nothing: 0.1 g/s is at least 10 dB louder.
#[test]
fn the_stove_hides_no_sizzle() {
    let sizzle = loud(hot(Steam::Floor, 0.1));
    for stove in [Stove::Flame, Stove::Coil] {
        assert!(sizzle - loud(on(stove, 3000.0)) > 10.0, "{stove:?}");
    }
}

/// Turned off it is silent after a moment, without a step.
#[test]
fn turned_off_it_falls_silent() {
    for stove in [Stove::Flame, Stove::Coil] {
        let frames = rendered(&[vec![on(stove, 2000.0); 10], vec![on(stove, 0.0); 10]].concat());
        let most = |frames: &[[f32; 2]]| frames.iter().fold(0.0_f32, |most, frame| most.max(frame[0].abs()));
        let steps = |frames: &[[f32; 2]]| {
            frames.windows(2).fold(0.0_f32, |most, pair| most.max((pair[1][0] - pair[0][0]).abs()))
        };
        let (before, after) = frames.split_at(RATE as usize);
        assert!(most(before) > 1e-4);
        assert!(steps(after) <= 1.2 * steps(before), "{stove:?}: no step as it ends");
        assert_eq!(most(&after[RATE as usize / 2..]), 0.0, "{stove:?}");
    }
}
