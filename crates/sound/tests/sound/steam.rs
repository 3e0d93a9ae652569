//! What goes on: hiss, crackle, boiling, butter, the lid.

use saute_sound::{Metal, Plate, Snapshot, Steam, Synth};

use crate::ear::{band, centroid, kurtosis, level, levels_by_second, mono, spearman};

pub const RATE: u32 = 48_000;
pub const PAN: Plate = Plate { metal: Metal::CarbonSteel, radius_m: 0.115, thickness_m: 2.3e-3 };

/// A snapshot of a hot pan with steam from a place [g/s].
pub fn hot(place: Steam, g_s: f64) -> Snapshot {
    let water = matches!(place, Steam::Water);
    let floor_c = if water { 105.0 } else { 180.0 };
    Snapshot { floor_c, oil_c: 180.0, ..Snapshot::default() }.with(place, 1e-3 * g_s as f32)
}

/// Renders ticks at a rate.
pub fn rendered_at(rate: u32, snapshots: &[Snapshot]) -> Vec<[f32; 2]> {
    let mut synth = Synth::new(rate, 7, &PAN);
    let mut frames = vec![[0.0; 2]; snapshots.len() * rate as usize / 10];
    for (snapshot, tick) in snapshots.iter().zip(frames.chunks_mut(rate as usize / 10)) {
        synth.feed(snapshot, &[]);
        synth.render(tick);
    }
    frames
}

pub fn rendered(snapshots: &[Snapshot]) -> Vec<[f32; 2]> {
    rendered_at(RATE, snapshots)
}

/// Renders a steady state for a number of seconds, after a second in which it settles.
pub fn steady(snapshot: Snapshot, seconds: usize) -> Vec<[f32; 2]> {
    rendered(&vec![snapshot; 10 * (1 + seconds)]).split_off(RATE as usize)
}

fn level_in(frames: &[[f32; 2]], hz: [f64; 2]) -> f64 {
    level(&band(&mono(frames), hz, f64::from(RATE)))
}

/// A cold pan, and a hot one with nothing wet in it, is silent: a cook hears that it waits. Oil at its smoke point has no water.
#[test]
fn a_pan_without_steam_is_silent_cold_or_smoking() {
    for floor_c in [20.0, 240.0] {
        let quiet = Snapshot { floor_c, oil_c: floor_c, ..Snapshot::default() };
        assert!(steady(quiet, 1).iter().all(|frame| *frame == [0.0; 2]), "{floor_c} °C");
    }
}

/// Sound falls silent with the steam, exactly and soon.
#[test]
fn when_the_steam_ends_it_is_silent() {
    let frames = rendered(&[vec![hot(Steam::Floor, 0.1); 10], vec![hot(Steam::Floor, 0.0); 10]].concat());
    assert!(level(&mono(&frames[RATE as usize / 2..RATE as usize])) > -40.0);
    assert!(frames[RATE as usize * 3 / 2..].iter().all(|frame| *frame == [0.0; 2]));
}

/// The crackle shows that the water is nearly gone: few bubbles are heard one by one, many are a hiss.
#[test]
fn hiss_becomes_crackle_as_the_water_goes() {
    for g_s in [0.1, 0.15, 0.3, 1.0] {
        let found = kurtosis(&steady(hot(Steam::Floor, g_s), 2), 48e3);
        println!("{g_s} g/s: kurtosis {found:.2}");
        assert!(found <= 2.0, "{g_s} g/s: {found}");
    }
    for g_s in [0.01, 0.005, 0.002] {
        let found = kurtosis(&steady(hot(Steam::Floor, g_s), 2), 48e3);
        println!("{g_s} g/s: kurtosis {found:.2}");
        assert!(found >= 5.0, "{g_s} g/s: {found}");
    }
}

/// A cook hears how much boils: the level follows the steam, second by second.
#[test]
fn the_level_follows_the_steam() {
    // As a face dries: from 0.3 g/s, to a thirtieth in a minute.
    let flow = |tick: usize| 0.3 * (-(tick as f64) / 180.0).exp();
    let ticks: Vec<Snapshot> = (0..600).map(|tick| hot(Steam::Floor, flow(tick))).collect();
    let levels = levels_by_second(&rendered(&ticks), 48e3);
    // The first second begins with the fade in.
    let flows: Vec<f64> = (0..60).map(|second| flow(10 * second)).collect();
    let found = spearman(&levels[1..], &flows[1..]);
    println!("Spearman {found:.3}; {:.1} dB(A) at 0.3 g/s, {:.1} at 0.01", levels[1], levels[59]);
    assert!(found >= 0.95, "{found}: {levels:?}");
}

/// A hotter pan bursts the same water brighter; louder it is by the steam that it makes.
#[test]
fn a_hotter_floor_is_brighter_with_the_same_steam() {
    let at = |floor_c| steady(Snapshot { floor_c, ..hot(Steam::Floor, 0.2) }, 2);
    let [mild, hot] = [at(160.0), at(220.0)];
    let louder = levels_by_second(&hot, 48e3)[0] - levels_by_second(&mild, 48e3)[0];
    assert!((-0.5..1.5).contains(&louder), "{louder} dB");
    assert!(centroid(&hot, 48e3) > 1.05 * centroid(&mild, 48e3));
}

/// The lid damps: it takes the highs, not the lows.
#[test]
fn a_lid_takes_the_highs() {
    for place in Steam::ALL.into_iter().filter(|place| *place != Steam::Cloth) {
        let open = steady(hot(place, 0.5), 2);
        let shut = steady(Snapshot { lid: true, ..hot(place, 0.5) }, 2);
        let less = |hz| level_in(&open, hz) - level_in(&shut, hz);
        let [highs, lows] = [less([2e3, 20e3]), less([50.0, 500.0])];
        println!("{place:?}: {highs:.1} dB less above 2 kHz, {lows:.1} dB less below 500 Hz");
        assert!(highs >= 6.0, "{place:?}: {highs} dB less above 2 kHz");
        assert!((0.0..=4.0).contains(&lows), "{place:?}: {lows} dB less below 500 Hz");
    }
}

/// An overcrowded pan boils instead of frying: that is low and soft, not bright.
#[test]
fn boiling_is_told_from_frying_by_its_spectrum() {
    let [frying, boiling] = [Steam::Floor, Steam::Water].map(|place| steady(hot(place, 0.5), 2));
    let tilt = |frames: &[[f32; 2]]| level_in(frames, [2e3, 12e3]) - level_in(frames, [100.0, 600.0]);
    println!("highs over lows: frying {:.1} dB, boiling {:.1} dB", tilt(&frying), tilt(&boiling));
    assert!(tilt(&frying) > tilt(&boiling) + 12.0);
    assert!((3e3..7e3).contains(&centroid(&frying, 48e3)), "frying {} Hz", centroid(&frying, 48e3));
    assert!((100.0..1500.0).contains(&centroid(&boiling, 48e3)), "boiling {} Hz", centroid(&boiling, 48e3));
}

/// A simmer blubs, a rolling boil roars: single bubbles against noise.
#[test]
fn a_simmer_is_single_bubbles() {
    let blubs = |g_s| {
        let samples = band(&mono(&steady(hot(Steam::Water, g_s), 2)), [400.0, 4e3], 48e3);
        let mean = |power: i32| samples.iter().map(|x| x.powi(power)).sum::<f64>() / samples.len() as f64;
        mean(4) / mean(2).powi(2) - 3.0
    };
    let [simmer, boil] = [blubs(0.01), blubs(0.8)];
    println!("kurtosis: simmer {simmer:.1}, boil {boil:.1}");
    assert!(simmer > 3.0 && boil < 1.0, "{simmer} {boil}");
}

/// Wine on the hot floor bursts, and is over when it has gone.
#[test]
fn deglazing_bursts_and_decays() {
    let flow = |tick: usize| if tick < 20 { 0.02 } else { 3.0 * (-(tick as f64 - 20.0) / 15.0).exp() };
    let ticks: Vec<Snapshot> = (0..120).map(|tick| hot(Steam::Drip, flow(tick))).collect();
    let levels = levels_by_second(&rendered(&ticks), 48e3);
    assert!(levels[2] > levels[1] + 15.0, "{levels:?}");
    assert!(levels[2..].windows(2).all(|w| w[1] < w[0]), "{levels:?}");
    assert!(levels[11] < levels[2] - 20.0, "{levels:?}");
}

/// Butter foams and falls silent as its water ends: then it browns.
#[test]
fn butter_falls_silent_as_its_water_ends() {
    let flow = |tick: usize| 0.2 * (1.0 - tick as f64 / 200.0).max(0.0);
    let ticks: Vec<Snapshot> = (0..260).map(|tick| hot(Steam::Butter, flow(tick))).collect();
    let levels = levels_by_second(&rendered(&ticks), 48e3);
    let loudest = levels.iter().copied().fold(f64::MIN, f64::max);
    // One per cent of the water is left after 18 s.
    assert!(levels[23..].iter().all(|level| *level < loudest - 12.0), "{levels:?}");
}

/// The same cook sounds alike on every device.
#[test]
fn the_bands_are_the_same_at_every_rate() {
    for place in Steam::ALL {
        for g_s in [0.5, 0.05] {
            let at = |rate: u32| {
                let frames = rendered_at(rate, &vec![hot(place, g_s); 50]).split_off(rate as usize);
                [125.0, 250.0, 500.0, 1e3, 2e3, 4e3, 8e3]
                    .map(|hz: f64| level(&band(&mono(&frames), [hz / 1.414, hz * 1.414], f64::from(rate))))
            };
            let [cd, dvd, high] = [44_100, 48_000, 96_000].map(at);
            let loudest = dvd.iter().copied().fold(f64::MIN, f64::max);
            for (octave, ((a, b), c)) in cd.iter().zip(&dvd).zip(&high).enumerate() {
                // What is 30 dB below the loudest band is masked by it.
                let is_heard = *b > loudest - 30.0;
                assert!(
                    !is_heard || ((a - b).abs() <= 1.0 && (c - b).abs() <= 1.0),
                    "{place:?} {g_s} {octave}: {a} {b} {c}"
                );
            }
        }
    }
}
