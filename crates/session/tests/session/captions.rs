//! Promise: who does not hear the pan reads the same: a caption and a level, from the state that the synthesiser gets.

use saute_session::hearing::caption::{Caption, caption, meter, nearer};
use saute_sound::{Snapshot, Steam, Stove};
use saute_words::language::Language;

/// A hot pan with steam from a place [g/s].
fn hot(place: Steam, g_s: f32) -> Snapshot {
    Snapshot { floor_c: 180.0, oil_c: 180.0, ..Snapshot::default() }.with(place, 1e-3 * g_s)
}

/// What a cook notices by ear is in the caption.
#[test]
fn each_sound_has_its_caption() {
    let cases = [
        (Snapshot { stove: Stove::Flame, stove_w: 1500.0, ..Snapshot::default() }, Caption::Flame),
        (Snapshot { stove: Stove::Flame, stove_w: 1500.0, ..hot(Steam::Floor, 0.02) }, Caption::Soft),
        (Snapshot { stove: Stove::Coil, stove_w: 2000.0, ..Snapshot::default() }, Caption::Quiet),
        (Snapshot::default(), Caption::Quiet),
        (hot(Steam::Floor, 1e-5), Caption::Quiet),
        (hot(Steam::Floor, 0.005), Caption::Crackle),
        (hot(Steam::Floor, 0.02), Caption::Soft),
        (hot(Steam::Floor, 0.05), Caption::Steady),
        (hot(Steam::Floor, 0.2), Caption::Lively),
        (hot(Steam::Oil, 0.2), Caption::DeepOil),
        (hot(Steam::Water, 0.05), Caption::Simmer),
        (hot(Steam::Water, 0.5), Caption::Boil),
        (hot(Steam::Butter, 0.05), Caption::Butter),
        (hot(Steam::Drip, 0.02), Caption::Drip),
        (hot(Steam::Cloth, 1.0), Caption::Cloth),
    ];
    for (snapshot, expected) in cases {
        assert_eq!(caption(&snapshot), expected, "{snapshot:?}");
    }
}

/// An overcrowded pan that drowns in its juice is heard boiling, though something still fries; and the loudest is named.
#[test]
fn the_loudest_is_named() {
    assert_eq!(caption(&hot(Steam::Water, 0.8).with(Steam::Floor, 1e-6)), Caption::Boil);
    assert_eq!(caption(&hot(Steam::Water, 0.1).with(Steam::Floor, 2e-4)), Caption::Lively);
}

/// More steam is a fuller meter, and a lid makes it emptier; silence is empty, and no stove overfills it.
#[test]
fn the_meter_follows_the_steam() {
    let steps = [0.0, 0.001, 0.01, 0.1, 1.0].map(|g_s| meter(&hot(Steam::Floor, g_s)));
    assert!(steps.windows(2).all(|pair| pair[0] < pair[1]), "{steps:?}");
    assert_eq!((steps[0], meter(&hot(Steam::Cloth, 40.0))), (0.0, 1.0));
    let lidded = Snapshot { lid: true, ..hot(Steam::Floor, 0.1) };
    assert!(meter(&lidded) < steps[3]);
}

/// Words stay long enough to be read: one odd tick does not change them, a second does.
#[test]
fn one_tick_does_not_flicker() {
    let (steady, odd) = (hot(Steam::Floor, 0.05), hot(Steam::Floor, 0.25));
    let shown = nearer(&steady, &odd, 0.13);
    assert_eq!(caption(&shown), Caption::Steady);
    let later = (0..10).fold(shown, |shown, _| nearer(&shown, &odd, 0.13));
    assert_eq!(caption(&later), Caption::Lively);
    assert_eq!(nearer(&steady, &odd, 1.0), odd);
}

#[test]
fn captions_are_said_in_both_languages() {
    assert_eq!(Caption::Lively.words(false, Language::ENGLISH), "sizzle, lively");
    assert_eq!(Caption::Crackle.words(false, Language::ENGLISH), "crackling: dry");
    assert_eq!(Caption::Boil.words(true, Language::ENGLISH), "boiling, under the lid");
    assert_eq!(Caption::Quiet.words(true, Language::ENGLISH), "quiet");
    assert_eq!(Caption::Boil.words(true, Language::of_code("ja").expect("Japanese")), "ぐつぐつ沸く（ふたの下）");
}
