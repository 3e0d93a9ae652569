//! Promise: the cook is heard while time goes on; one switch and a volume are on top and kept; who does not hear it reads it.

use std::sync::{Arc, Mutex};

use egui::accesskit::Role;
use egui::{Key, vec2};
use egui_kittest::Harness;
use egui_kittest::kittest::{NodeT, Queryable};
use saute_controls::settings::Settings;
use saute_session::hearing::caption::Caption;
use saute_sound::{Event, EventKind, Steam, Told};
use saute_window::SauteApp;
use saute_window::listener::Listener;
use saute_words::language::Language;

use crate::harness::{cook, press, save, steps, window};

/// Keeps what it receives instead of playing it.
#[derive(Clone, Default)]
pub struct Witness(Arc<Mutex<Kept>>);

#[derive(Default)]
struct Kept {
    told: Told,
    events: Vec<EventKind>,
    trouble: Option<String>,
}

impl Listener for Witness {
    fn hear(&mut self, told: &Told, events: &[Event]) {
        let mut kept = self.0.lock().expect("nobody panicked");
        kept.told = *told;
        kept.events.extend(events.iter().map(|event| event.kind));
    }

    fn trouble(&mut self) -> Option<String> {
        self.0.lock().expect("nobody panicked").trouble.take()
    }
}

impl Witness {
    /// Lets a window send it what is heard.
    pub fn of(harness: &mut Harness<'static, SauteApp>) -> Self {
        let witness = Self::default();
        harness.state_mut().let_listen(Box::new(witness.clone()));
        steps(harness, 2);
        witness
    }

    /// What was received last.
    pub fn told(&self) -> Told {
        self.0.lock().expect("nobody panicked").told
    }

    /// Whether something was heard since the last call.
    fn heard(&self, kind: EventKind) -> bool {
        std::mem::take(&mut self.0.lock().expect("nobody panicked").events).contains(&kind)
    }
}

#[test]
fn the_cook_is_heard_switched_and_read() {
    let mut harness = window(vec2(1280.0, 720.0));
    let witness = Witness::of(&mut harness);
    assert!(!witness.told().is_paused && witness.told().volume == 0.5, "{:?}", witness.told());
    harness.state_mut().session_mut().command(&saute_kitchen::Command::Hob(1400.0)).expect("hob");
    a_cue_to_hear_is_played(&mut harness, &witness);
    cook(&mut harness, 30.0);
    hands_are_heard_at_once(&mut harness, &witness);
    it_is_read(&mut harness, &witness);
    it_is_silent_while_time_stands(&mut harness, &witness);
    one_switch_and_a_volume_are_kept(&mut harness, &witness);
    a_loss_is_said_once(&mut harness, &witness);
}

/// A lid sounds in the picture after its key; a steak when it lies.
fn hands_are_heard_at_once(harness: &mut Harness<'static, SauteApp>, witness: &Witness) {
    for _ in 0..2 {
        witness.heard(EventKind::Lid);
        harness.key_press(Key::Z);
        harness.step();
        assert!(witness.heard(EventKind::Lid));
    }
    press(harness, Key::A);
    cook(harness, 0.5);
    assert!(witness.heard(EventKind::Put));
    cook(harness, 20.0);
    steps(harness, 20);
    assert!(witness.told().snapshot.steam[Steam::Floor as usize] > 1e-5, "{:?}", witness.told());
}

/// Under *More* a caption and a meter show what is heard.
fn it_is_read(harness: &mut Harness<'static, SauteApp>, witness: &Witness) {
    assert!(harness.query_by_label_contains("sizzle").is_none());
    harness.get_by_label("More: curves and all readings").click();
    steps(harness, 12);
    harness.get_by_label_contains("sizzle, ");
    let meter = harness.get_by_role(Role::Meter).accesskit_node().label().expect("a level");
    let percent: f64 = meter.trim_matches(|c: char| !c.is_ascii_digit()).parse().expect("a number");
    let level = f64::from(saute_session::hearing::caption::meter(&witness.told().snapshot));
    assert!(percent > 10.0 && (percent - 100.0 * level).abs() < 10.0, "{meter}, {level}");
    save(harness, "sound-more");
    press(harness, Key::Z);
    cook(harness, 2.0);
    harness.get_by_label_contains(", under the lid");
    press(harness, Key::Z);
    harness.get_by_label("Less").click();
    steps(harness, 3);
}

fn it_is_silent_while_time_stands(harness: &mut Harness<'static, SauteApp>, witness: &Witness) {
    for key in [Key::Space, Key::F1] {
        press(harness, key);
        assert!(witness.told().is_paused, "{key:?}");
        press(harness, key);
        assert!(!witness.told().is_paused, "{key:?} again");
    }
    let turned = harness.state().session().kitchen.time_s() - 30.0;
    harness.state_mut().session_mut().scrub(turned);
    witness.heard(EventKind::Put);
    // A busy machine takes more frames to get there; until then no time passes.
    while harness.state().session().is_travelling() {
        steps(harness, 1);
    }
    steps(harness, 4);
    assert!(!witness.heard(EventKind::Flip), "what time is turned over is not heard");
}

fn one_switch_and_a_volume_are_kept(harness: &mut Harness<'static, SauteApp>, witness: &Witness) {
    let click = |harness: &mut Harness<'static, SauteApp>| {
        harness.get_by_role_and_label(Role::Switch, "Sound").click();
        steps(harness, 3);
    };
    click(harness);
    assert!(witness.told().is_paused && !harness.state().settings().sound);
    save(harness, "sound-off");
    let kept = serde_json::to_string(harness.state().settings()).expect("is written");
    assert!(!Settings::remembered(&kept, Language::ENGLISH).0.sound);
    click(harness);
    assert!(!witness.told().is_paused && harness.state().settings().sound);
    press(harness, Key::F2);
    harness.get_by_role_and_label(Role::Slider, "Volume").focus();
    steps(harness, 2);
    (0..3).for_each(|_| press(harness, Key::ArrowRight));
    let louder = harness.state().settings().volume;
    assert!(louder > 0.5 && witness.told().volume == louder as f32, "{louder}");
    save(harness, "sound-settings");
    press(harness, Key::Escape);
}

fn a_loss_is_said_once(harness: &mut Harness<'static, SauteApp>, witness: &Witness) {
    witness.0.lock().expect("nobody panicked").trouble = Some("no sound card".into());
    steps(harness, 4);
    let words = "No sound: no sound card. Everything else works.";
    assert_eq!(harness.state().said().iter().filter(|said| *said == words).count(), 1);
    assert!(!harness.state().session().paused, "the cook goes on");
}

/// "Next to hear" plays what it means, also while time stands; with the sound off it is not offered.
fn a_cue_to_hear_is_played(harness: &mut Harness<'static, SauteApp>, witness: &Witness) {
    for _ in 0..30 {
        if harness.query_by_label("Hear it").is_some() {
            break;
        }
        cook(harness, 5.0);
        steps(harness, 4);
    }
    save(harness, "sound-cue");
    press(harness, Key::Space);
    assert!(witness.told().is_paused);
    harness.get_by_label("Hear it").click();
    steps(harness, 3);
    let told = witness.told();
    assert!(!told.is_paused, "also while time stands");
    assert_eq!(saute_session::hearing::caption::caption(&told.snapshot), Caption::Lively);
    // Three seconds of the window's own clock.
    steps(harness, 3 * 60 + 20);
    assert!(witness.told().is_paused, "it ends");
    harness.get_by_role_and_label(Role::Switch, "Sound").click();
    steps(harness, 3);
    assert!(harness.query_by_label("Hear it").is_none());
    harness.get_by_role_and_label(Role::Switch, "Sound").click();
    press(harness, Key::Space);
}
