//! Promise: the page works in a real browser: the user enters the code, tilts the phone, and the kitchen's pan follows.

use std::path::PathBuf;
use std::time::{Duration, Instant};

use glam::DVec3;
use saute_haptics::device::{HapticCommand, HapticSample};
use saute_haptics::{Handover, Health, Opened, Pose, open};
use saute_kitchen::{Command, FRAME_S, Kitchen, Library};
use serde_json::json;

use super::chromium::Chromium;

/// A kitchen whose pan the phone moves, in real time.
struct Led {
    opened: Opened,
    kitchen: Kitchen,
    handover: Handover,
    sample: HapticSample,
}

impl Led {
    fn new() -> Self {
        let library = Library::embedded().unwrap();
        let kitchen = Kitchen::new(&library, "carbon-steel-26", saute_kitchen::kelvin(20.0)).unwrap();
        let opened = open("phone@127.0.0.1:0", 0).unwrap();
        Self { opened, kitchen, handover: Handover::default(), sample: HapticSample::default() }
    }

    fn frame(&mut self) {
        for _ in 0..4 {
            self.sample = self.opened.device.exchange(&HapticCommand::default(), FRAME_S / 4.0);
        }
        if self.sample.health == Health::Running {
            let held = self.kitchen.held_pan();
            let pose = self.handover.pose(&held, &self.sample.pose, FRAME_S);
            self.kitchen.apply(&Command::HoldPan { pose }).unwrap();
        }
        self.kitchen.advance_frame();
        std::thread::sleep(Duration::from_secs_f64(FRAME_S));
    }

    fn pan(&self) -> Pose {
        self.kitchen.world().motion.pose
    }

    /// Advances the kitchen until a condition is met, for at most ten seconds.
    fn until(&mut self, what: &str, seen: impl Fn(&Self) -> bool) {
        let begun = Instant::now();
        while !seen(self) {
            assert!(begun.elapsed() < Duration::from_secs(60), "timeout: {what}; {:?}", self.sample);
            self.frame();
        }
    }
}

/// Tilt of the pan's axis to the right and away from the cook [°].
fn lean(pose: &Pose) -> [f64; 2] {
    let up = pose.rotation * DVec3::Z;
    [up.x.asin().to_degrees(), up.y.asin().to_degrees()]
}

fn pictures() -> PathBuf {
    PathBuf::from(env!("CARGO_TARGET_TMPDIR")).join("phone")
}

fn type_code(browser: &mut Chromium, code: &str) {
    browser.value("document.getElementById('code').value = ''; document.getElementById('code').focus()");
    browser.call("Input.insertText", json!({ "text": code }));
    browser.wait_for("!document.getElementById('go').disabled");
    for kind in ["keyDown", "keyUp"] {
        let key = json!({ "type": kind, "key": "Enter", "code": "Enter", "windowsVirtualKeyCode": 13, "text": "\r" });
        browser.call("Input.dispatchKeyEvent", key);
    }
}

fn turn(browser: &mut Chromium, [alpha, beta, gamma]: [f64; 3]) {
    browser.call(
        "DeviceOrientation.setDeviceOrientationOverride",
        json!({ "alpha": alpha, "beta": beta, "gamma": gamma }),
    );
}

fn open_page(browser: &mut Chromium, url: &str, locale: &str) {
    let screen = json!({ "width": 390, "height": 844, "deviceScaleFactor": 2, "mobile": true });
    browser.call("Emulation.setDeviceMetricsOverride", screen);
    browser.call("Emulation.setTouchEmulationEnabled", json!({ "enabled": true }));
    let agent = browser.call("Browser.getVersion", json!({}))["userAgent"].clone();
    browser.call("Emulation.setUserAgentOverride", json!({ "userAgent": agent, "acceptLanguage": locale }));
    browser.call("Page.navigate", json!({ "url": url }));
    browser.wait_for("document.readyState === 'complete' && location.protocol === 'https:'");
}

#[test]
fn after_the_code_is_entered_on_the_page_the_kitchen_s_pan_follows_the_phone() {
    let mut led = Led::new();
    let url = led.opened.access.url.clone().unwrap();
    let code = led.opened.access.code.clone().unwrap();
    let mut browser = Chromium::start();
    open_page(&mut browser, &url, "en-GB");
    assert_eq!(browser.value("window.isSecureContext"), true, "sensors need a secure context");
    browser.picture(&pictures().join("pairing.png"));
    turn(&mut browser, [30.0, 0.0, 0.0]);

    // A wrong code is refused with a message and moves nothing.
    let wrong = format!("{:06}", (code.parse::<u32>().unwrap() + 7) % 1_000_000);
    type_code(&mut browser, &wrong);
    browser.wait_for("document.getElementById('said').textContent.includes('not the code')");
    turn(&mut browser, [30.0, 25.0, 0.0]);
    (0..30).for_each(|_| led.frame());
    assert!(led.sample.health == Health::Connecting && lean(&led.pan()) == [0.0, 0.0], "{:?}", led.sample);

    // The right one, after the wait.
    turn(&mut browser, [30.0, 0.0, 0.0]);
    browser.wait_for("!document.getElementById('go').disabled");
    type_code(&mut browser, &code);
    browser.wait_for("!document.getElementById('holding').hidden");
    led.until("the phone is there", |l| l.sample.health == Health::Running);
    (0..60).for_each(|_| led.frame());
    turn(&mut browser, [30.0, 0.0, 18.0]);
    led.until("the kitchen's pan leans right", |l| {
        (lean(&l.pan())[0] - 18.0).abs() < 1.0 && lean(&l.pan())[1].abs() < 1.0
    });
    turn(&mut browser, [30.0, 15.0, 0.0]);
    led.until("the kitchen's pan leans to the cook", |l| {
        (lean(&l.pan())[1] + 15.0).abs() < 1.0 && lean(&l.pan())[0].abs() < 1.0
    });
    browser.wait_for("Math.abs(turn[0]) > 0.1");
    browser.picture(&pictures().join("held.png"));

    // Hold flat and tap: these 15 degrees are level now.
    browser.value("document.getElementById('flat').click()");
    led.until("the present orientation is level", |l| lean(&l.pan()).iter().all(|v| v.abs() < 0.5));

    // A toss: the pan rises by more than five centimetres and comes back.
    let before = led.pan().position.z;
    browser.value(TOSS);
    led.until("the pan is tossed", |l| l.pan().position.z > before + 0.05);
    led.until("the pan comes back", |l| l.pan().position.z < before + 0.02);

    // The page is closed: the phone is lost.
    browser.call("Page.navigate", json!({ "url": "about:blank" }));
    led.until("the phone is lost", |l| l.sample.health == Health::Lost);
}

/// Motion events like those of a phone's sensors: upward acceleration for 0.15 s, then downward.
const TOSS: &str = "(() => { let n = 0;
  const timer = setInterval(() => { const a = n < 9 ? 9 : -9; if (++n > 18) { clearInterval(timer); return; }
    const acceleration = { x: 0, y: a * Math.sin(15 * Math.PI / 180), z: a * Math.cos(15 * Math.PI / 180) };
    dispatchEvent(new DeviceMotionEvent('devicemotion', { acceleration, interval: 16 })); }, 16); })()";

#[test]
fn the_page_is_japanese_in_a_japanese_browser() {
    let led = Led::new();
    let mut browser = Chromium::start();
    open_page(&mut browser, &led.opened.access.url.clone().unwrap(), "ja-JP");
    assert_eq!(browser.value("document.documentElement.lang"), "ja");
    assert_eq!(browser.value("document.querySelector('h1').textContent"), "スマホがフライパンになります");
    let missing = browser.value("[...document.querySelectorAll('[data-text]')].filter(e => !e.textContent).length");
    assert_eq!(missing, 0);
    assert_eq!(browser.value("JSON.stringify(Object.keys(TEXT.en)) === JSON.stringify(Object.keys(TEXT.ja))"), true);
    browser.picture(&pictures().join("pairing-ja.png"));
}
