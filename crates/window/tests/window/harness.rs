//! The window without a screen: steps, simulated time, pictures.

use std::io::Write;
use std::sync::OnceLock;

use egui::{Key, Pos2, Rect, pos2};
use egui_kittest::Harness;
use egui_kittest::wgpu::{create_render_state, default_wgpu_setup};
use egui_wgpu::wgpu::Backends;
use egui_wgpu::{RenderState, RendererOptions, WgpuSetup, WgpuSetupExisting};
use saute_window::{SauteApp, Start};
use saute_words::language::Language;

/// The language of the tests in addition to English.
pub fn japanese() -> Language {
    Language::of_code("ja").expect("Japanese is a language")
}

/// The window at a size.
pub fn window(size: egui::Vec2) -> Harness<'static, SauteApp> {
    window_with(size, Start::default())
}

/// The window at a size, with options.
pub fn window_with(size: egui::Vec2, start: Start) -> Harness<'static, SauteApp> {
    let mut harness = Harness::builder()
        .with_size(size)
        .with_step_dt(0.05)
        .wgpu_setup(graphics())
        .build_eframe(|cc| SauteApp::new(cc, start).expect("starts"));
    harness.step();
    harness
}

/// The graphics of a window: all share one device, which takes longer to open than a window.
pub fn graphics() -> WgpuSetup {
    tally("windows_opened");
    static DEVICE: OnceLock<WgpuSetupExisting> = OnceLock::new();
    let open = || {
        let mut setup = default_wgpu_setup();
        if let WgpuSetup::CreateNew(new) = &mut setup {
            // Looking for adapters of OpenGL fails where another thread looks for them at the same time.
            new.instance_descriptor.backends.remove(Backends::GL);
        }
        let RenderState { instance, adapter, device, queue, .. } =
            create_render_state(setup, RendererOptions::PREDICTABLE);
        WgpuSetupExisting { instance, adapter, device, queue }
    };
    WgpuSetup::Existing(DEVICE.get_or_init(open).clone())
}

/// Notes one more of what `scripts/durations.toml` has a ceiling for, where `./test.sh` counts.
fn tally(what: &str) {
    let Some(folder) = std::env::var_os("SAUTE_TALLY") else { return };
    let file = std::path::Path::new(&folder).join(format!("{what}.count"));
    let file = std::fs::OpenOptions::new().create(true).append(true).open(file);
    file.and_then(|mut file| file.write_all(b"1\n")).expect("the folder of counts takes a line");
}

/// Draws some frames.
pub fn steps(harness: &mut Harness<'static, SauteApp>, count: usize) {
    (0..count).for_each(|_| harness.step());
}

/// Presses a key and draws what comes of it.
pub fn press(harness: &mut Harness<'static, SauteApp>, key: Key) {
    harness.key_press(key);
    steps(harness, 3);
}

/// Lets simulated time pass without frames.
pub fn cook(harness: &mut Harness<'static, SauteApp>, seconds: f64) {
    for _ in 0..(seconds / saute_kitchen::TICK_S) as usize {
        harness.state_mut().session_mut().tick().expect("ticks");
    }
    steps(harness, 12);
}

/// Keeps a picture of the window for people to look at, where they request it with `SAUTE_PICTURES=1`.
pub fn save(harness: &mut Harness<'static, SauteApp>, name: &str) {
    if std::env::var_os("SAUTE_PICTURES").is_none() {
        return;
    }
    let image = harness.render().expect("renders");
    let folder = std::path::Path::new(env!("CARGO_TARGET_TMPDIR")).join("window");
    std::fs::create_dir_all(&folder).expect("folder");
    image.save(folder.join(format!("{name}.png"))).expect("saves");
}

/// All words that are drawn, also those that have no name.
pub fn drawn_words(harness: &Harness<'static, SauteApp>) -> Vec<String> {
    fn words(shape: &egui::Shape, all: &mut Vec<String>) {
        match shape {
            egui::Shape::Vec(shapes) => shapes.iter().for_each(|shape| words(shape, all)),
            egui::Shape::Text(text) => all.push(text.galley.text().to_owned()),
            _ => {}
        }
    }
    let mut all = Vec::new();
    harness.output().shapes.iter().for_each(|clipped| words(&clipped.shape, &mut all));
    all
}

/// The usual window.
pub const WINDOW: Rect = Rect { min: Pos2::ZERO, max: pos2(1280.0, 720.0) };

/// Clicks at a place.
pub fn click(harness: &mut Harness<'static, SauteApp>, at: Pos2) {
    drag(harness, at, at);
}

/// Drags from one place to another, a good second long.
pub fn drag(harness: &mut Harness<'static, SauteApp>, from: Pos2, to: Pos2) {
    harness.hover_at(from);
    harness.step();
    harness.drag_at(from);
    harness.step();
    if from != to {
        for k in 1..=16u8 {
            harness.hover_at(from + (to - from) * (f32::from(k) / 16.0));
            harness.step();
        }
    }
    harness.drop_at(to);
    steps(harness, 14);
}
