//! Promise: a device moves pan and turner, and what it releases is laid down gently.

use glam::{DQuat, DVec3};
use saute_haptics::device::HapticSample;
use saute_haptics::{Health, PanInHand, Pose, TurnerInHand};
use saute_kitchen::dynamics::Against;
use saute_kitchen::food::Rules;
use saute_kitchen::{Command, FRAME_S, Kitchen, Library, MeshSize, OutlineKind, PieceOrder, kelvin};

/// A cold pan with a steak at rest.
fn kitchen() -> Kitchen {
    let library = Library::embedded().unwrap();
    let mut kitchen = Kitchen::new(&library, "carbon-steel-26", kelvin(20.0)).unwrap();
    let order = PieceOrder {
        id: "steak".into(),
        kind: "beef-lean".into(),
        size: [0.12, 0.08, 0.025],
        temperature: kelvin(20.0),
        seed: 1,
        coarseness: 1.0,
        mesh: MeshSize::Paper2013,
        rules: Rules::Full,
        outline: OutlineKind::Plain,
    };
    kitchen.add(&library, &order).unwrap();
    kitchen.apply(&Command::Put { food: "steak".into(), at: [0.0; 2], heap: false }).unwrap();
    for _ in 0..90 {
        kitchen.advance_frame();
    }
    kitchen
}

fn at(pose: Pose, health: Health) -> HapticSample {
    HapticSample { pose, health, fresh: true, ..HapticSample::default() }
}

fn pan(kitchen: &Kitchen) -> Pose {
    kitchen.world().motion.pose
}

#[test]
fn a_pan_follows_the_hand_and_is_laid_down_gently_when_the_device_is_gone() {
    for gone in [None, Some(Health::Lost), Some(Health::Stopped)] {
        let (mut kitchen, mut hand) = (kitchen(), PanInHand::default());
        let ring = pan(&kitchen);
        let there = Pose::at(0.08, -0.05, 0.15).turned(DVec3::Y, 0.15);
        for _ in 0..120 {
            hand.step(Some(&at(there, Health::Running)), &mut kitchen, FRAME_S);
            kitchen.advance_frame();
        }
        assert!((pan(&kitchen).position - there.position).length() < 1e-3 && hand.holds());
        let (mut fastest, mut sample) = (0.0f64, None);
        for k in 0..180 {
            sample = gone.map(|health| at(there, health));
            hand.step(sample.as_ref(), &mut kitchen, FRAME_S);
            kitchen.advance_frame();
            fastest = fastest.max(kitchen.world().motion.velocity.length());
            assert!(k > 30 || hand.lays_down());
        }
        assert!(sample.is_some() == gone.is_some() && !hand.holds() && !hand.lays_down());
        assert!(fastest < 0.25, "{fastest} m/s");
        let left = (pan(&kitchen).position - ring.position).length();
        assert!(left < 1e-3 && (pan(&kitchen).rotation * DVec3::Z).z > 0.9999, "{left} m from the ring");
        assert!(kitchen.pieces()[0].in_pan(), "the steak stays in it");
    }
}

#[test]
fn a_device_for_the_turner_alone_does_not_move_the_pan() {
    let (mut kitchen, mut hand) = (kitchen(), PanInHand::default());
    let ring = pan(&kitchen);
    let sample = HapticSample { leads_pan: false, ..at(Pose::at(0.1, 0.1, 0.2), Health::Running) };
    for _ in 0..60 {
        hand.step(Some(&sample), &mut kitchen, FRAME_S);
        kitchen.advance_frame();
    }
    assert!(!hand.holds() && (pan(&kitchen).position - ring.position).length() < 1e-6);
}

#[test]
fn another_hand_may_take_a_pan_that_is_being_laid_down() {
    let (mut kitchen, mut hand) = (kitchen(), PanInHand::default());
    for _ in 0..90 {
        hand.step(Some(&at(Pose::at(0.0, 0.0, 0.2), Health::Running)), &mut kitchen, FRAME_S);
        kitchen.advance_frame();
    }
    hand.step(None, &mut kitchen, FRAME_S);
    let pose = Pose::at(0.1, 0.0, 0.18);
    kitchen.apply(&Command::HoldPan { pose }).unwrap();
    for _ in 0..90 {
        hand.step(None, &mut kitchen, FRAME_S);
        kitchen.advance_frame();
    }
    assert!((pan(&kitchen).position - pose.position).length() < 1e-3 && !hand.lays_down());
}

/// A grip with a level blade, at a distance away from the cook and a height above the pan's floor [m].
fn grip(kitchen: &Kitchen, y: f64, height: f64) -> Pose {
    let position = DVec3::new(0.0, y, pan(kitchen).position.z + height);
    Pose { position, rotation: DQuat::IDENTITY }
}

#[test]
fn a_six_dof_device_slides_the_turner_under_a_steak_lifts_it_and_lays_it_down_when_it_is_gone() {
    let (mut kitchen, mut hand) = (kitchen(), TurnerInHand::default());
    let lies = kitchen.pieces()[0].pose.position;
    let floor_force = |kitchen: &Kitchen| -> f64 {
        let contacts = kitchen.world().contacts(kitchen.pieces()[0].key);
        contacts.iter().filter(|c| c.against == Against::Floor).map(|c| c.force).sum()
    };
    // In over the edge at the cook's side, under the steak within half a second, up within another.
    let way = [(-0.085, 0.0, 5), (-0.02, 0.0, 30), (-0.02, 0.0, 10), (-0.02, 0.08, 30), (-0.02, 0.08, 20)];
    let (mut y, mut height) = (-0.085, 0.0);
    for (to_y, to_height, frames) in way {
        let step = [(to_y - y) / f64::from(frames), (to_height - height) / f64::from(frames)];
        for _ in 0..frames {
            (y, height) = (y + step[0], height + step[1]);
            let grip = grip(&kitchen, y, height);
            hand.step(Some(&grip), &mut kitchen);
            kitchen.advance_frame();
        }
    }
    let lifted = kitchen.pieces()[0].pose.position.z - lies.z;
    assert!(hand.leads() && lifted > 0.06 && floor_force(&kitchen) == 0.0, "lifted by {lifted} m");
    for _ in 0..180 {
        hand.step(None, &mut kitchen);
        kitchen.advance_frame();
    }
    let left = kitchen.pieces()[0].pose.position;
    assert!(!hand.leads() && kitchen.led_tool().is_none() && kitchen.hand().gripped().is_none());
    assert!(left.z - lies.z < 0.005 && (left - lies).length() < 0.03, "laid down at {left}, lay at {lies}");
}
