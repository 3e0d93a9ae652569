//! Promise: a window that is killed loses at most the last second of its cook.
//!
//! The real window is opened on a virtual screen and watched by the clock, so this belongs to the campaign, which needs `Xvfb` and
//! `xdotool`. `./test.sh` tests the same for a window without a screen (`time::a_window_that_was_killed_goes_on_with_its_cook`) and of
//! a recorded cook that is killed (`sessions::a_killed_cook_loses_at_most_a_second`).

use std::path::Path;
use std::process::{Child, Command, Stdio};
use std::thread::sleep;
use std::time::{Duration, Instant};

use saute_recipe::Recording;

use crate::running::run;

/// What the promise allows to be lost [s].
const LOST_S: f64 = 1.0;
/// Longest wait for a window, or for a key to take effect [s] (chosen: software graphics on a busy machine).
const PATIENCE_S: u64 = 60;
/// How long is cooked before the window is killed [s].
const COOKED_S: u64 = 4;

/// A process that ends with the test.
struct Ending(Child);

impl Drop for Ending {
    fn drop(&mut self) {
        // It may have ended already.
        let _ = self.0.kill();
        let _ = self.0.wait();
    }
}

/// Starts a program without input and output.
fn started(command: &mut Command) -> Ending {
    let program = command.get_program().to_string_lossy().into_owned();
    let child = command.stdin(Stdio::null()).stdout(Stdio::null()).stderr(Stdio::null()).spawn();
    Ending(child.unwrap_or_else(|error| panic!("{program} does not start ({error}): is it installed?")))
}

/// Waits until something is there.
fn awaited<T>(mut found: impl FnMut() -> Option<T>) -> Option<T> {
    let begun = Instant::now();
    while begun.elapsed().as_secs() < PATIENCE_S {
        if let Some(found) = found() {
            return Some(found);
        }
        sleep(Duration::from_millis(100));
    }
    None
}

fn xdotool(display: &str, arguments: &[&str]) -> Option<String> {
    let output = Command::new("xdotool").env("DISPLAY", display).args(arguments).output().ok()?;
    let text = String::from_utf8_lossy(&output.stdout).lines().next().map(str::to_owned);
    text.or_else(|| output.status.success().then(String::new))
}

fn cook_in(file: &Path) -> Option<Recording> {
    let opened = Recording::from_file(&std::fs::read(file).ok()?).ok()?;
    Some(opened.recording).filter(|recording| !recording.entries().is_empty())
}

#[test]
#[ignore = "a real window on a virtual screen, by the clock: part of the campaign"]
fn a_window_that_is_killed_loses_at_most_a_second() {
    let display = format!(":{}", 100 + std::process::id() % 900);
    let _screen = started(Command::new("Xvfb").args([&display, "-screen", "0", "1280x720x24", "-nolisten", "tcp"]));
    awaited(|| xdotool(&display, &["getmouselocation"])).expect("the screen is there");
    let data = tempfile::tempdir().expect("folder");
    let folder = data.path().join("saute");
    std::fs::create_dir_all(&folder).expect("folder");
    // No card of first steps is before the hob.
    std::fs::write(folder.join("app.ron"), r#"{"saute.settings": "{\"introduced\":true}"}"#).expect("settings");
    let mut command = Command::new(env!("CARGO_BIN_EXE_saute"));
    command.env("DISPLAY", &display).env("XDG_DATA_HOME", data.path()).env_remove("WAYLAND_DISPLAY");
    let window = started(&mut command);
    let id = awaited(|| xdotool(&display, &["search", "--name", "^saute$"]).filter(|id| !id.is_empty()));
    let id = id.expect("a window opens on the virtual screen");
    let file = folder.join("cook.saute");
    // The hob on; a window that has just opened may not hear the first key.
    let begun = awaited(|| {
        xdotool(&display, &["mousemove", "400", "300", "windowfocus", &id, "key", "e"]);
        sleep(Duration::from_secs(1));
        cook_in(&file)
    });
    let begun = begun.expect("the cook is kept").moment().time_s();
    let since = Instant::now();
    sleep(Duration::from_secs(COOKED_S));
    let passed = since.elapsed().as_secs_f64();
    drop(window);
    let kept = cook_in(&file).expect("opens").moment().time_s();
    println!("of {passed:.2} s that passed {:.2} s are kept", kept - begun);
    assert!(kept - begun > passed - LOST_S, "{kept} s after {begun} s and {passed} s");
    // It is sound, and goes on bit by bit.
    let replay = run(&["replay".as_ref(), file.as_os_str()]);
    assert_eq!(replay.code, Some(0), "{}", replay.err);
}
