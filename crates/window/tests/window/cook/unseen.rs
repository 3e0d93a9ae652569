//! Promise: nothing burns while nobody sees the window: time that passed without a frame is not cooked, and a tab that was hidden
//! pauses and shows a notice.

use egui::{Context, RawInput};
use saute_kitchen::Command;
use saute_window::{SauteApp, Start};

/// Time of a frame [s].
const FRAME_S: f64 = 0.05;

/// The window without a picture, its hob on.
struct Unwatched {
    app: SauteApp,
    ctx: Context,
    now_s: f64,
}

impl Unwatched {
    fn new() -> Self {
        let ctx = Context::default();
        let mut app = SauteApp::start(&ctx, None, None, Start::default()).expect("starts");
        app.session_mut().command(&Command::Hob(2000.0)).expect("heats");
        Self { app, ctx, now_s: 0.0 }
    }

    /// Draws a frame after a time; returns what was cooked [s].
    fn frame_after(&mut self, wall_s: f64) -> f64 {
        let before = self.app.session().kitchen.time_s();
        self.now_s += wall_s;
        let input = RawInput { time: Some(self.now_s), ..RawInput::default() };
        let _ = self.ctx.clone().run_ui(input, |ui| self.app.frame(ui));
        self.app.session().kitchen.time_s() - before
    }

    fn frames(&mut self, count: usize) -> f64 {
        (0..count).map(|_| self.frame_after(FRAME_S)).sum()
    }
}

#[test]
fn a_gap_between_two_frames_counts_for_a_second_at_most() {
    let mut window = Unwatched::new();
    for speed in [1.0, 20.0] {
        window.app.session_mut().set_speed(speed);
        window.frames(5);
        let cooked = window.frame_after(100.0) + window.frames(40);
        let most = speed * (1.0 + 40.0 * FRAME_S + 0.1);
        assert!(cooked <= most + 1e-6, "{cooked} s at {speed} times real time, not {most} s");
    }
}

#[test]
fn a_hidden_tab_pauses_and_says_so_on_return() {
    let mut window = Unwatched::new();
    assert!(window.frames(10) > 0.0);
    window.app.be_seen(false);
    assert_eq!(window.frames(10), 0.0);
    window.app.be_seen(true);
    assert_eq!(window.frames(10), 0.0, "it waits until somebody goes on");
    let said = window.app.said();
    assert!(said[0].contains("The tab was hidden, so the simulation is paused"), "{said:?}");
    // What was paused before gets no notice.
    window.app.be_seen(false);
    window.app.be_seen(true);
    assert_eq!(window.app.said(), said);
}
