//! Promise: a device in the hand holds the pan in the window, feels the pan, is shown, and lets go when stopped.

use std::sync::{Arc, Mutex};
use std::time::{Duration, Instant};

use egui::{Key, vec2};
use egui_kittest::{Harness, kittest::Queryable};
use glam::DVec3;
use saute_controls::hands::Role;
use saute_haptics::device::{HapticCommand, HapticDevice, HapticSample, Sensed};
use saute_haptics::{Capabilities, Geometry, Health, Pose, StringRig, TensionSolver, library};
use saute_window::SauteApp;

use crate::harness::{press, save, steps, window};

const WIDE: egui::Vec2 = egui::vec2(1280.0, 720.0);

/// What the test moves and sees.
pub struct Script {
    pub pose: Pose,
    turner: Option<Pose>,
    command: HapticCommand,
    stopped: bool,
    length_misfit: f64,
}

/// A device of strings in memory that takes a given pose and solves its tensions as a real one does.
pub struct Scripted {
    script: Arc<Mutex<Script>>,
    geometry: Geometry,
    capabilities: Capabilities,
    solver: TensionSolver,
    time_s: f64,
}

pub fn scripted(name: &str, sensed: Sensed) -> (Box<Scripted>, Arc<Mutex<Script>>) {
    let geometry = library::devices().expect("devices").remove(name).expect("listed");
    let pose = geometry.home();
    let command = HapticCommand::default();
    let script = Arc::new(Mutex::new(Script { pose, turner: None, command, stopped: false, length_misfit: 0.0 }));
    let capabilities = Capabilities { sensed, ..geometry.capabilities() };
    let solver = TensionSolver::new(geometry.tension_rule());
    (Box::new(Scripted { script: Arc::clone(&script), geometry, capabilities, solver, time_s: 0.0 }), script)
}

impl HapticDevice for Scripted {
    fn capabilities(&self) -> &Capabilities {
        &self.capabilities
    }

    fn exchange(&mut self, command: &HapticCommand, dt: f64) -> HapticSample {
        let mut script = self.script.lock().expect("script");
        script.command = *command;
        self.time_s += dt;
        let lines = self.geometry.rig().lines(&script.pose);
        let preload = self.geometry.preload();
        let pulled = self.solver.solve(&lines, &(command.wrench + preload));
        HapticSample {
            time_s: self.time_s,
            pose: script.pose,
            turner: script.turner,
            achieved: pulled.achieved - preload,
            total_force_n: pulled.achieved.force.length(),
            length_misfit: script.length_misfit,
            tension_n: Some(pulled.tension),
            health: if script.stopped { Health::Stopped } else { Health::Running },
            fresh: true,
            ..HapticSample::default()
        }
    }

    fn stop(&mut self) {
        self.script.lock().expect("script").stopped = true;
    }

    fn resume(&mut self) {
        self.script.lock().expect("script").stopped = false;
    }

    fn strings(&self) -> Option<StringRig> {
        Some(self.geometry.rig())
    }
}

/// Lets wall and kitchen go on together, without drawing, until a condition is met; returns true if it was met
/// within a minute.
pub fn until(harness: &mut Harness<'static, SauteApp>, mut enough: impl FnMut(&SauteApp) -> bool) -> bool {
    let begun = Instant::now();
    while begun.elapsed() < Duration::from_secs(60) {
        let session = harness.state_mut().session_mut();
        session.advance(Duration::from_millis(17), Duration::from_secs(1)).expect("goes on");
        session.hands.update();
        if enough(harness.state()) {
            return true;
        }
        std::thread::sleep(Duration::from_millis(10));
    }
    false
}

fn pan(app: &SauteApp) -> Pose {
    app.session().kitchen.world().motion.pose
}

fn with_device(name: &str) -> (Harness<'static, SauteApp>, Arc<Mutex<Script>>) {
    let mut harness = window(WIDE);
    press(&mut harness, Key::A);
    steps(&mut harness, 20);
    let (device, script) = scripted(name, Sensed::Pose);
    harness.state_mut().session_mut().hands.hold(Role::Pan, name, device).expect("starts");
    (harness, script)
}

#[test]
fn the_pan_follows_the_device_its_steak_is_felt_and_enter_lets_go() {
    let (mut harness, script) = with_device("spidar-pan-crossed");
    let there = Pose::at(0.05, -0.03, 0.12).turned(DVec3::X, 0.1);
    script.lock().expect("script").pose = there;
    let near = |app: &SauteApp| (pan(app).position - there.position).length() < 1e-3;
    assert!(until(&mut harness, near), "{:?}", pan(harness.state()));
    let weight = harness.state().session().kitchen.pieces()[0].mass() * 9.806_65;
    let force = || script.lock().expect("script").command.wrench.force;
    assert!(until(&mut harness, |_| (-force().z / weight - 1.0).abs() < 0.1), "{} of {weight} N", force());
    steps(&mut harness, 3);
    harness.get_by_label_contains("The pan: at work");
    harness.get_by_label_contains("shows forces and torques");
    save(&mut harness, "hand-pan");
    // Even while something else has the focus.
    harness.get_by_label("Strings").focus();
    steps(&mut harness, 1);
    press(&mut harness, Key::Enter);
    let stopped = || script.lock().expect("script").stopped;
    assert!(until(&mut harness, |_| stopped() && force() == DVec3::ZERO), "Enter stops it");
    let laid = |app: &SauteApp| pan(app).position.truncate().length() < 1e-4 && pan(app).position.z < 0.02;
    assert!(until(&mut harness, laid), "the pan is laid down: {:?}", pan(harness.state()));
    assert!(harness.state().session().kitchen.pieces()[0].in_pan());
    steps(&mut harness, 3);
    harness.get_by_label_contains("The pan: stopped");
    harness.get_by_label_contains("Stopped: the devices have let go");
    save(&mut harness, "hand-stopped");
}

#[test]
fn after_a_stop_the_button_shows_it_and_there_is_a_visible_way_to_go_on() {
    let (mut harness, script) = with_device("spidar-pan-crossed");
    script.lock().expect("script").pose = Pose::at(0.0, 0.0, 0.12);
    let force = || script.lock().expect("script").command.wrench.force.z;
    assert!(until(&mut harness, |_| force() < -1.5), "the steak is felt");
    steps(&mut harness, 3);
    assert!(harness.query_by_label("Go on").is_none());
    harness.get_by_label("Stop (Enter)").click();
    assert!(settled(&mut harness, || script.lock().expect("script").stopped && force() == 0.0));
    harness.get_by_label("Stopped (Enter)");
    harness.get_by_label("Go on").click();
    assert!(settled(&mut harness, || !script.lock().expect("script").stopped && force() < -1.5), "it goes on");
    harness.get_by_label("Stop (Enter)");
    assert!(harness.query_by_label("Go on").is_none());
}

#[test]
fn the_window_names_the_safety_rule_that_fired_and_only_a_hand_goes_on() {
    let (mut harness, script) = with_device("spidar-pan-crossed");
    assert!(until(&mut harness, |_| script.lock().expect("script").command.enabled));
    script.lock().expect("script").length_misfit = 40.0;
    assert!(settled(&mut harness, || script.lock().expect("script").stopped));
    harness.get_by_label_contains("The pan: stopped for safety: the lengths of its strings contradict each other");
    save(&mut harness, "hand-safety");
    script.lock().expect("script").length_misfit = 0.0;
    steps(&mut harness, 30);
    assert!(script.lock().expect("script").stopped, "not by itself");
    harness.get_by_label("Go on").click();
    assert!(settled(&mut harness, || script.lock().expect("script").command.enabled));
}

/// Draws and lets time go on until a condition of the device is met, and then until the panel shows it.
fn settled(harness: &mut Harness<'static, SauteApp>, holds: impl Fn() -> bool) -> bool {
    steps(harness, 2);
    let came = until(harness, |_| holds());
    std::thread::sleep(Duration::from_millis(20));
    steps(harness, 3);
    came
}

#[test]
fn a_device_that_is_disconnected_leaves_the_pan_on_its_ring_and_time_faster_than_the_clock_fades_forces() {
    let (mut harness, script) = with_device("spidar-pan");
    script.lock().expect("script").pose = Pose::at(0.0, 0.05, 0.15);
    let enabled = || script.lock().expect("script").command.enabled;
    assert!(until(&mut harness, |app| enabled() && pan(app).position.z > 0.149), "it comes into the hand");
    harness.state_mut().session_mut().set_speed(5.0);
    assert!(until(&mut harness, |_| !enabled()), "forces fade");
    harness.state_mut().session_mut().set_speed(1.0);
    assert!(until(&mut harness, |_| enabled()), "and come back");
    steps(&mut harness, 2);
    harness.get_by_label("Disconnect").click();
    steps(&mut harness, 2);
    assert!(script.lock().expect("script").stopped && harness.state().session().hands.device(Role::Pan).is_none());
    assert!(until(&mut harness, |app| pan(app).position.z < 0.02 && !app.session().hands.has_pan()));
}

#[test]
fn strings_are_drawn_with_their_tensions_and_hidden_by_a_key() {
    for (name, tilt) in [("spidar-frame", 0.15), ("spidar-pan-crossed", -0.1)] {
        let (mut harness, script) = with_device(name);
        script.lock().expect("script").pose = Pose::at(0.04, -0.02, 0.10).turned(DVec3::Y, tilt);
        let felt = || script.lock().expect("script").command.wrench.force.z < -1.5;
        assert!(until(&mut harness, |app| felt() && pan(app).position.z > 0.099));
        assert!(harness.query_by_label_contains("Tension of the strings").is_none(), "not unless asked for");
        press(&mut harness, Key::F7);
        assert!(until(&mut harness, |app| app.session().hands.device(Role::Pan).expect("on").state().rate_hz > 500.0));
        steps(&mut harness, 3);
        harness.get_by_label_contains("Tension of the strings");
        save(&mut harness, &format!("hand-strings-{name}"));
        press(&mut harness, Key::F7);
        assert!(harness.query_by_label_contains("Tension of the strings").is_none());
    }
}

#[test]
fn a_second_device_leads_the_turner_if_it_senses_place_and_turning() {
    let mut harness = window(WIDE);
    let hands = |h: &mut Harness<'static, SauteApp>, device| {
        h.state_mut().session_mut().hands.hold(Role::Turner, "turner", device)
    };
    let refused = hands(&mut harness, scripted("spidar-frame", Sensed::Place).0).expect_err("three are too few");
    assert!(refused.to_string().contains("senses 3 degrees"), "{refused}");
    let (device, script) = scripted("spidar-frame", Sensed::Pose);
    hands(&mut harness, device).expect("starts");
    let there = Pose::at(0.02, -0.06, 0.11);
    script.lock().expect("script").pose = there;
    let tip = |app: &SauteApp| app.session().kitchen.hand().pose.position;
    let led =
        |app: &SauteApp| app.session().kitchen.led_tool().is_some() && (tip(app) - there.position).length() < 0.005;
    assert!(until(&mut harness, led), "{}", tip(harness.state()));
    assert!(!script.lock().expect("script").command.enabled, "a turner is without force");
    steps(&mut harness, 3);
    harness.get_by_label_contains("The turner: at work");
    // The pose of a turner counts before that of the pan.
    let there = Pose::at(-0.03, 0.02, 0.13);
    script.lock().expect("script").turner = Some(there);
    let led = |app: &SauteApp| (tip(app) - there.position).length() < 0.005;
    assert!(until(&mut harness, led), "{}", tip(harness.state()));
    save(&mut harness, "hand-turner");
    harness.state_mut().session_mut().hands.disconnect(Role::Turner);
    assert!(until(&mut harness, |app| app.session().kitchen.led_tool().is_none()), "it is put away");
}

/// Connects an OSC device and sends it what it does not understand: nobody looks at the terminal of a program with a window.
fn panel_states_why_a_message_is_rejected(harness: &mut Harness<'static, SauteApp>) {
    let hands = &mut harness.state_mut().session_mut().hands;
    hands.connect(Role::Pan, "osc@127.0.0.1:0", 0).expect("a free port");
    let place = hands.device(Role::Pan).and_then(|device| device.access.clone()).expect("a place").place;
    let sender = std::net::UdpSocket::bind("127.0.0.1:0").expect("a socket");
    sender.send_to(b"no osc", &place).expect("sent");
    assert!(until(harness, |app| app.session().hands.device(Role::Pan).is_some_and(|d| d.reported().is_some())));
    press(harness, Key::Escape);
    steps(harness, 12);
    harness.get_by_label_contains("rejected a message from 127.0.0.1");
    save(harness, "hand-rejected");
}

#[test]
fn devices_are_chosen_on_the_settings_card() {
    for (size, name) in [(WIDE, "wide"), (vec2(390.0, 844.0), "phone")] {
        let mut harness = window(size);
        press(&mut harness, Key::F2);
        harness.get_by_label("Hands").scroll_to_me();
        steps(&mut harness, 4);
        harness.get_by_label("Hands").click();
        steps(&mut harness, 12);
        harness.get_by_label_contains("Device: spidar-frame").scroll_to_me();
        steps(&mut harness, 4);
        harness.get_by_label_contains("Device: spidar-frame").click();
        steps(&mut harness, 2);
        harness.get_by_label("It holds: The turner").click();
        steps(&mut harness, 2);
        let typed = |h: &mut Harness<'static, SauteApp>| {
            let line = h.get_by_role_and_label(egui::accesskit::Role::TextInput, "Address");
            line.focus();
            line.type_text("no-such-place");
        };
        typed(&mut harness);
        steps(&mut harness, 2);
        harness.get_by_label("Connect").scroll_to_me();
        steps(&mut harness, 4);
        save(&mut harness, &format!("hand-settings-{name}"));
        harness.get_by_label("Connect").click();
        steps(&mut harness, 3);
        harness.get_by_label_contains("no-such-place");
        assert!(!harness.state().session().hands.any());
        if size == WIDE {
            panel_states_why_a_message_is_rejected(&mut harness);
        }
    }
}
