//! Promise: what a kitchen does is heard: its steam as it boils off, its blows when they fall.

#[path = "../../../sound/tests/sound/ear.rs"]
#[allow(dead_code, reason = "the tests of the synthesiser need the rest")]
mod ear;

use saute_kitchen::{Command, Kitchen, Library, TICK_S};
use saute_recipe::{Cook, Recipe};
use saute_session::hearing::{Ear, Sound, plate};
use saute_sound::{EventKind, Metal, Snapshot, Steam, Stove};

/// A thin steak, fried on both sides, then butter and a lid.
const COOK: &str = r#"
[pan]
kind = "carbon-steel-26"
initial_c = 200
[[food]]
id = "steak"
kind = "beef-lean"
size_mm = [60, 50, 10]
initial_c = 5
mesh = "2013"
[[step]]
hob_w = 1200
[[step]]
at_s = 2
put = "steak"
[[step]]
at_s = 12
flip = "steak"
[[step]]
at_s = 20
lid = true
[[step]]
at_s = 23
lid = false
[[step]]
at_s = 25
rest = "steak"
[[step]]
at_s = 30
butter_g = 10
[[step]]
at_s = 60
water_g = 60
[[step]]
at_s = 90
end = true
"#;

fn cook(library: &Library) -> Cook {
    Cook::new(Recipe::parse(COOK, "cook.toml", library).expect("parses"), library).expect("builds")
}

/// What is heard of each tick.
fn heard() -> Vec<(f64, Snapshot, Vec<EventKind>)> {
    let library = Library::embedded().expect("the library is sound");
    let mut cook = cook(&library);
    let mut ear = Ear::new(&cook.kitchen);
    let mut heard = Vec::new();
    while cook.stopped().is_none() {
        cook.advance().expect("cooks");
        if cook.stopped().is_none() {
            let (snapshot, events) = ear.hear(&cook.kitchen);
            heard.push((cook.kitchen.time_s(), snapshot, events.into_iter().map(|event| event.kind).collect()));
        }
    }
    heard
}

#[test]
fn flows_and_happenings_are_heard_when_they_are() {
    let heard = heard();
    let times = |kind: EventKind| -> Vec<f64> {
        heard.iter().filter(|(_, _, events)| events.contains(&kind)).map(|(time, ..)| *time).collect()
    };
    let near = |found: &[f64], expected: &[f64], within: f64| {
        assert_eq!(found.len(), expected.len(), "{found:?}, expected {expected:?}");
        assert!(found.iter().zip(expected).all(|(a, b)| (a - b).abs() <= within), "{found:?}, expected {expected:?}");
    };
    near(&times(EventKind::Put), &[2.1], 0.15);
    near(&times(EventKind::Flip), &[13.0], 1.5);
    near(&times(EventKind::Lid), &[20.1, 23.1], 0.15);
    near(&times(EventKind::Board), &[26.0], 1.5);
    near(&times(EventKind::Pour), &[60.1], 0.15);
    let mean = |place: Steam, from: f64, to: f64| {
        let ticks: Vec<_> = heard.iter().filter(|(time, ..)| (from..to).contains(time)).collect();
        ticks.iter().map(|(_, snapshot, _)| f64::from(snapshot.steam[place as usize])).sum::<f64>() / ticks.len() as f64
    };
    let frying = |from, to| mean(Steam::Floor, from, to) + mean(Steam::Drip, from, to);
    assert_eq!(frying(0.0, 2.0), 0.0);
    assert!(frying(8.0, 12.0) > 1e-5, "frying: {} kg/s", frying(8.0, 12.0));
    assert!(mean(Steam::Floor, 28.0, 90.0) == 0.0, "nothing fries once the steak is out");
    assert!(mean(Steam::Butter, 30.0, 45.0) > 1e-5, "butter: {} kg/s", mean(Steam::Butter, 30.0, 45.0));
    assert!(mean(Steam::Water, 60.0, 90.0) > 1e-5, "water boils: {} kg/s", mean(Steam::Water, 60.0, 90.0));
}

/// Steam below a food is no more than what leaves it.
#[test]
fn no_more_is_heard_than_boils_off() {
    let library = Library::embedded().expect("the library is sound");
    let mut cook = cook(&library);
    let mut ear = Ear::new(&cook.kitchen);
    let water = |kitchen: &Kitchen| kitchen.pieces()[0].mass() + kitchen.pan_state().water_mass();
    let (mut sounded, mut gone, mut before) = (0.0, 0.0, water(&cook.kitchen));
    while cook.kitchen.time_s() < 12.0 {
        cook.advance().expect("cooks");
        // What condenses on the cold face, in the same tick or later, was heard when it boiled.
        let (now, early) = (water(&cook.kitchen), cook.kitchen.pieces()[0].early_steam * TICK_S);
        (gone, before) = (gone + f64::max(before - now, early), now);
        let (snapshot, _) = ear.hear(&cook.kitchen);
        sounded += snapshot.steam.iter().map(|flow| f64::from(*flow)).sum::<f64>() * TICK_S;
    }
    println!("{:.3} g left as steam, {:.3} g of it sounded", 1e3 * gone, 1e3 * sounded);
    assert!(sounded < gone && sounded > 0.5 * gone, "{gone} kg left, {sounded} kg sounded");
}

#[test]
fn each_shipped_pan_rings_as_its_metal() {
    let library = Library::embedded().expect("the library is sound");
    let metal = |kind: &str| plate(&Kitchen::new(&library, kind, 300.0).expect("builds")).metal;
    assert_eq!(metal("carbon-steel-26"), Metal::CarbonSteel);
    assert_eq!(metal("cast-iron-26"), Metal::CastIron);
    assert_eq!(metal("stainless-clad-26"), Metal::StainlessClad);
    assert_eq!(metal("aluminium-26"), Metal::Aluminium);
}

/// A cook hears how much boils: while it fries the level of each second follows the steam of that second.
#[test]
fn the_level_follows_the_steam_of_a_cook() {
    let library = Library::embedded().expect("the library is sound");
    let mut cook = cook(&library);
    let (mut ear, mut sound) = (Ear::new(&cook.kitchen), Sound::new(&cook.kitchen, 48_000));
    let (mut samples, mut steam) = (Vec::new(), Vec::new());
    while cook.kitchen.time_s() < 19.95 {
        cook.advance().expect("cooks");
        samples.extend_from_slice(sound.follow(&cook.kitchen));
        steam.push(ear.hear(&cook.kitchen).0.steam.iter().map(|flow| f64::from(*flow)).sum());
    }
    let levels = ear::levels_by_second(&samples, 48e3);
    let flows: Vec<f64> = steam.chunks_exact(10).map(|second: &[f64]| second.iter().sum()).collect();
    // From the first steam on, without the seconds of the put and of the flip, whose blows are louder than it.
    let (from, flip) = (flows.iter().position(|flow| *flow > 0.0).expect("it fries").max(4), 12..14);
    let heard: Vec<usize> = (from..20).filter(|second| !flip.contains(second)).collect();
    let of = |values: &[f64]| heard.iter().map(|second| values[*second]).collect::<Vec<_>>();
    let found = ear::spearman(&of(&levels), &of(&flows));
    println!("Spearman {found:.3} of {} seconds", heard.len());
    assert!(found >= 0.95, "{found}: {levels:?} {flows:?}");
}

/// The sound is as long as the cook, at any rate, and a second look at the same tick gives nothing.
#[test]
fn the_sound_lasts_as_long_as_the_cook() {
    let library = Library::embedded().expect("the library is sound");
    let mut cook = cook(&library);
    let mut sound = Sound::new(&cook.kitchen, 11_025);
    let mut samples = 0;
    while cook.kitchen.time_s() < 2.95 {
        cook.advance().expect("cooks");
        samples += sound.follow(&cook.kitchen).len();
        assert!(sound.follow(&cook.kitchen).is_empty());
    }
    assert_eq!(samples, 3 * 11_025);
}

/// In a window the ear looks at each picture: what hands do is heard in the same one, flows are those of the last tick, and fast time is
/// neither louder nor quieter.
#[test]
fn an_ear_may_look_at_any_pace() {
    let library = Library::embedded().expect("the library is sound");
    let mut cook = cook(&library);
    let (mut each, mut slow) = (Ear::new(&cook.kitchen), Ear::new(&cook.kitchen));
    while cook.kitchen.time_s() < 9.05 {
        cook.advance().expect("cooks");
        each.hear(&cook.kitchen);
        // Twenty times real time, ten pictures a second.
        if cook.kitchen.tick().is_multiple_of(20) {
            slow.hear(&cook.kitchen);
        }
    }
    let (now, events) = each.hear(&cook.kitchen);
    let flow = |snapshot: &Snapshot| snapshot.steam.iter().sum::<f32>();
    assert!(events.is_empty() && flow(&now) > 1e-5, "{now:?}");
    let (fast, _) = slow.hear(&cook.kitchen);
    assert!((flow(&fast) / flow(&now) - 1.0).abs() < 0.3, "{fast:?} after eleven ticks, {now:?} after each");
    cook.kitchen.apply(&Command::Lid(true)).expect("a lid");
    let (lidded, events) = each.hear(&cook.kitchen);
    assert!(lidded.lid && lidded.steam == now.steam);
    assert_eq!(events.iter().map(|event| event.kind).collect::<Vec<_>>(), [EventKind::Lid]);
}

/// Time that is turned is not heard: nothing clanks that happened long ago.
#[test]
fn turned_time_begins_anew() {
    let library = Library::embedded().expect("the library is sound");
    let mut cook = cook(&library);
    let start = cook.kitchen.clone();
    let mut ear = Ear::new(&cook.kitchen);
    while cook.kitchen.time_s() < 15.0 {
        cook.advance().expect("cooks");
    }
    let (heard, events) = ear.hear(&cook.kitchen);
    assert!(events.is_empty() && heard.steam.iter().all(|flow| *flow == 0.0), "a leap forward: {events:?}");
    assert_eq!(ear.hear(&start).1, []);
}

/// A gas burner and an induction hob are heard while they heat; a pan on an iron plate is silent until something boils.
#[test]
fn the_stove_is_heard_while_it_heats() {
    let library = Library::embedded().expect("the library is sound");
    for (kind, stove) in
        [("gas", Stove::Flame), ("induction", Stove::Coil), ("iron-plate", Stove::Silent), ("radiant", Stove::Silent)]
    {
        let text = format!("[hob]\nkind = \"{kind}\"\n[[step]]\nat_s = 5\nend = true\n");
        let recipe = Recipe::parse(&text, "stove.toml", &library).expect("parses");
        let mut kitchen = recipe.kitchen(&library).expect("a kitchen");
        let mut sound = Sound::new(&kitchen, 48_000);
        let mut ear = Ear::new(&kitchen);
        let mut heard = |kitchen: &mut Kitchen| {
            kitchen.step();
            sound.follow(kitchen).iter().any(|frame| *frame != [0.0; 2])
        };
        assert!(!heard(&mut kitchen), "{kind}: off");
        let most = *kitchen.hob().settings_w().last().expect("settings");
        kitchen.apply(&Command::Hob(most)).expect("turned on");
        heard(&mut kitchen);
        assert_eq!(heard(&mut kitchen), stove != Stove::Silent, "{kind}: on");
        assert_eq!(ear.hear(&kitchen).0.stove, stove, "{kind}");
    }
}

/// Wet meat on hot fat: the loudest sizzle is the first, and the louder the hotter the pan is. The bounds are chosen: no level is published.
#[test]
fn wet_meat_bursts_on_hot_fat_and_the_louder_the_hotter() {
    let library = Library::embedded().expect("the library is sound");
    let first = [160, 190, 220].map(|pan_c| {
        let text = format!(
            "[pan]\nkind = \"carbon-steel-26\"\ninitial_c = {pan_c}\n[[food]]\nid = \"steak\"\nkind = \"beef-lean\"\n\
             [[step]]\nhob_w = 1200\n[[step]]\nat_s = 2\nput = \"steak\"\n[[step]]\nat_s = 63\nend = true\n"
        );
        let mut cook =
            Cook::new(Recipe::parse(&text, "put.toml", &library).expect("parses"), &library).expect("builds");
        let mut sound = Sound::new(&cook.kitchen, 48_000);
        let mut samples = Vec::new();
        while cook.stopped().is_none() {
            cook.advance().expect("cooks");
            samples.extend_from_slice(sound.follow(&cook.kitchen));
        }
        let heard = ear::weighted(&ear::mono(&samples), 48e3);
        let between = |from_s: usize, to_s: usize| ear::level(&heard[from_s * 48_000..to_s * 48_000]);
        let (burst, later) = (between(2, 3), between(42, 62));
        // A fast meter's time constant is an eighth of a second.
        let fast = heard[2 * 48_000..5 * 48_000].chunks(6000).map(ear::level).fold(f64::MIN, f64::max);
        println!("{pan_c} °C: {burst:.1} dB(A) in the first second, {fast:.1} at most, {later:.1} after 40 to 60 s");
        assert!(burst >= later + 6.0 && fast >= later + 10.0, "{pan_c} °C: {burst} {fast} {later}");
        burst
    });
    assert!(first.is_sorted() && first[0] < first[2], "{first:?}");
}
