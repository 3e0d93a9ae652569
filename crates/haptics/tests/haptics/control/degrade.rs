//! Promise: rendering degrades by stated rules: wrench, force, rumble, sound and picture.

use saute_haptics::DoublePulse;
use saute_haptics::control::degrade::RULES;
use saute_haptics::control::rumble::{Rumble, RumbleRule};
use saute_haptics::device::{Capabilities, HapticDevice, Vibration};
use saute_haptics::kitchen::contact_model::{ContactModel, Impulse};
use saute_haptics::{HapticCommand, HapticSample, Health, Renderer, Rendering, WeightOnSpring, Wrench, library};

const ALL: Wrench = Wrench { force: glam::DVec3::X, torque: glam::DVec3::Y };
const SHAKE: Rumble = Rumble { strong: 0.7, weak: 0.2 };

fn device(dof_actuated: u8, vibration: Vibration) -> Capabilities {
    Capabilities { dof_actuated, vibration, ..WeightOnSpring::default().capabilities().clone() }
}

#[test]
fn a_wrench_becomes_a_force_then_a_rumble_then_sound_and_picture_alone() {
    let six = device(6, Vibration::Wrench);
    assert_eq!((six.rendering(), six.shown(&ALL), six.rumbled(&SHAKE)), (Rendering::Wrench, ALL, Rumble::default()));
    let three = device(3, Vibration::Wrench);
    let force = Wrench { torque: glam::DVec3::ZERO, ..ALL };
    assert_eq!(
        (three.rendering(), three.shown(&ALL), three.rumbled(&SHAKE)),
        (Rendering::Force, force, Rumble::default())
    );
    let pad = device(0, Vibration::Rumble);
    assert_eq!((pad.rendering(), pad.shown(&ALL), pad.rumbled(&SHAKE)), (Rendering::Rumble, Wrench::ZERO, SHAKE));
    let still = device(0, Vibration::None);
    assert_eq!(
        (still.rendering(), still.shown(&ALL), still.rumbled(&SHAKE)),
        (Rendering::SoundAndPicture, Wrench::ZERO, Rumble::default())
    );
}

#[test]
fn a_weak_device_omits_the_pan_s_own_weight_so_that_its_contents_are_felt() {
    let held = |force_n: f64, holds_real_pan: bool| {
        let base = device(3, Vibration::Wrench);
        Capabilities { limits: saute_haptics::device::Limits { force_n, ..base.limits }, holds_real_pan, ..base }
    };
    assert!(
        held(30.0, false).renders_pan(1.3) && !held(6.0, false).renders_pan(1.3) && !held(30.0, true).renders_pan(1.3)
    );
}

#[test]
fn every_device_meets_a_rule_and_the_last_one_requires_nothing() {
    assert_eq!(RULES[RULES.len() - 1], (0, false, Rendering::SoundAndPicture));
    for dof in 0..=6 {
        for vibration in [Vibration::None, Vibration::Rumble, Vibration::Wrench] {
            let shown = device(dof, vibration).rendering();
            assert!(dof < 3 || shown != Rendering::SoundAndPicture, "{dof} {vibration:?}");
            assert!(vibration != Vibration::Rumble || shown != Rendering::SoundAndPicture, "{dof}");
        }
    }
}

#[test]
fn a_collision_is_a_decaying_strong_rumble_and_boiling_a_constant_weak_one() {
    let mut rule = RumbleRule::new(&library::feel().unwrap());
    let mut model = ContactModel { number: 1, vapour: 5e-4, ..ContactModel::default() };
    assert_eq!(rule.step(&model, 1e-3).strong, 0.0);
    model.impulses[0] = Impulse { number: 1, impulse: glam::DVec3::NEG_Z * 0.05, ..Impulse::default() };
    let hit = rule.step(&model, 1e-3);
    assert!((hit.strong - 0.5).abs() < 1e-9 && (0.1..0.6).contains(&hit.weak), "{hit:?}");
    let later = (0..400).map(|_| rule.step(&model, 1e-3)).last().unwrap();
    assert!(later.strong < 0.01 && later.weak == hit.weak, "{later:?}");
    model.impulses[0].impulse = glam::DVec3::splat(f64::NAN);
    model.impulses[0].number = 2;
    assert!(rule.step(&model, 1e-3).strong < later.strong, "NaN adds no rumble");
}

/// Strengths of a double pulse from its beginning, in steps [s].
fn pulsed(dt: f64) -> Vec<Rumble> {
    let mut pulse = DoublePulse::default();
    assert_eq!(pulse.step(dt), Rumble::default(), "nothing before it begins");
    pulse.begin();
    let mut steps = Vec::new();
    while pulse.is_on() {
        steps.push(pulse.step(dt));
    }
    assert_eq!(pulse.step(dt), Rumble::default(), "nothing after it");
    steps
}

#[test]
fn a_double_pulse_is_two_knocks_within_half_a_second_however_long_the_frames_are() {
    for dt in [1.0 / 144.0, 1.0 / 60.0, 0.05, 0.5] {
        let steps = pulsed(dt);
        let is_on: Vec<bool> = steps.iter().map(|rumble| rumble.strong > 0.5 && rumble.weak > 0.5).collect();
        let changes = is_on.windows(2).filter(|pair| pair[0] != pair[1]).count();
        assert!(is_on[0] && changes == 2 && is_on[is_on.len() - 1], "{dt} s: {is_on:?}");
        assert!(dt > 0.1 || (steps.len() as f64 * dt) < 0.5, "{dt} s: {} steps", steps.len());
    }
    let felt = Rumble { strong: 0.9, weak: 0.1 };
    assert_eq!(felt.or(pulsed(0.5)[0]), Rumble { strong: 0.9, weak: 1.0 }, "what is felt in the pan stays");
}

#[test]
fn collisions_before_the_first_model_are_not_rendered() {
    let mut rule = RumbleRule::new(&library::feel().unwrap());
    rule.step(&ContactModel::default(), 1e-3);
    let mut model = ContactModel { number: 1, ..ContactModel::default() };
    model.impulses[0] = Impulse { number: 7, impulse: glam::DVec3::NEG_Z * 0.05, ..Impulse::default() };
    assert_eq!(rule.step(&model, 1e-3).strong, 0.0);
    model.impulses[1] = Impulse { number: 8, ..model.impulses[0] };
    assert!(rule.step(&model, 1e-3).strong > 0.4);
}

#[test]
fn collisions_during_a_disconnection_are_not_rendered_afterwards() {
    let mut renderer = Renderer::new(&device(0, Vibration::Rumble), &library::feel().unwrap());
    let (there, away) = (Health::Running, Health::Lost);
    let mut model = ContactModel::default();
    let mut strongest = 0.0_f64;
    for number in 1..3000 {
        let health = if (1000..2000).contains(&number) { away } else { there };
        if number == 1500 {
            model.impulses[0] = Impulse { number: 1, impulse: glam::DVec3::NEG_Z * 0.1, ..Impulse::default() };
        }
        model.number = number;
        let sample = HapticSample { health, ..HapticSample::default() };
        strongest = strongest.max(renderer.step(&sample, &model, 1e-3).rumble.strong);
    }
    assert!(strongest < 1e-3, "{strongest}");
}

/// The loop's command to a device over a boiling pan.
fn command(capabilities: Capabilities) -> HapticCommand {
    let mut renderer = Renderer::new(&capabilities, &library::feel().unwrap());
    let sample = HapticSample { health: Health::Running, ..HapticSample::default() };
    let mut command = HapticCommand::default();
    for number in 1..1000 {
        let model = ContactModel { number, vapour: 5e-4, ..ContactModel::default() };
        command = renderer.step(&sample, &model, 1e-3);
    }
    command
}

#[test]
fn a_device_without_forces_is_commanded_to_rumble_and_one_with_forces_is_not() {
    let pad = command(device(0, Vibration::Rumble));
    assert!(pad.rumble.weak > 0.1 && pad.wrench == Wrench::ZERO, "{pad:?}");
    assert_eq!(command(device(3, Vibration::Wrench)).rumble, Rumble::default());
}
