//! Promise: the photo mode shows the scene alone, stops time, and saves a picture of the chosen size and a time
//! lapse of the cook.

use std::path::PathBuf;

use egui::{Key, vec2};
use egui_kittest::Harness;
use egui_kittest::kittest::Queryable;
use saute_controls::act::{Act, AppAct, HostAct, PhotoChoice};
use saute_window::{DesktopOptions, SauteApp, Start};

use crate::harness::{cook, press, save, steps, window_with};

/// A window that saves pictures into its own folder.
fn window(name: &str, size: egui::Vec2) -> (Harness<'static, SauteApp>, PathBuf) {
    let folder = PathBuf::from(env!("CARGO_TARGET_TMPDIR")).join(format!("photos-{name}"));
    let _ = std::fs::remove_dir_all(&folder);
    std::fs::create_dir_all(&folder).expect("folder");
    let mut harness = window_with(
        size,
        Start {
            desktop: DesktopOptions { pictures: Some(folder.clone()), ..DesktopOptions::default() },
            ..Start::default()
        },
    );
    let text = "[pan]\ninitial_c = 210\n[[food]]\nid = \"steak\"\nkind = \"beef-lean\"\n\
        [[step]]\nhob_w = 900\n[[step]]\nput = \"steak\"\n[[step]]\nafter_s = 900\nend = true\n";
    harness.state_mut().open_recipe(text, "steak.toml");
    cook(&mut harness, 3.0);
    (harness, folder)
}

/// Waits for a file that is made in the background.
fn wait_for(harness: &mut Harness<'static, SauteApp>, file: &std::path::Path) {
    let begun = std::time::Instant::now();
    while !file.exists() || harness.state().photo_mode().progress().is_some() {
        assert!(begun.elapsed().as_secs() < 240, "{} was not made", file.display());
        std::thread::sleep(std::time::Duration::from_millis(50));
        harness.step();
    }
}

/// Mean of all colours of the window, 0–255.
fn brightness(harness: &mut Harness<'static, SauteApp>) -> f64 {
    let image = harness.render().expect("renders");
    let values = image.pixels().flat_map(|pixel| pixel.0[..3].to_vec());
    let (sum, count) = values.fold((0.0, 0.0), |(sum, count), value| (sum + f64::from(value), count + 1.0));
    sum / count
}

#[test]
fn the_photo_mode_shows_the_scene_alone_and_time_waits() {
    let (mut harness, _) = window("alone", vec2(1280.0, 720.0));
    harness.get_by_label("Photo").click();
    steps(&mut harness, 3);
    assert!(harness.query_by_label("Temperature").is_none(), "panels are gone");
    harness.get_by_label("Take the photo");
    let time_s = harness.state().session().kitchen.time_s();
    steps(&mut harness, 20);
    assert_eq!(harness.state().session().kitchen.time_s(), time_s);
    save(&mut harness, "photo");
    let usual = brightness(&mut harness);
    let choice = harness.state().photo_mode().choice;
    let brighter =
        PhotoChoice { photo: saute_scene::light::photo::Photo { exposure_ev: 1.0, ..choice.photo }, ..choice };
    let ctx = harness.ctx.clone();
    harness.state_mut().act(Act::App(AppAct::Host(HostAct::SetPhoto(brighter))), &ctx);
    steps(&mut harness, 3);
    assert!(brightness(&mut harness) > usual + 10.0, "one stop more is brighter");
    press(&mut harness, Key::Escape);
    steps(&mut harness, 3);
    assert!(!harness.state().photo_mode().open);
    assert!((brightness(&mut harness) - usual).abs() < 40.0, "the exposure is the camera's alone");
    harness.get_by_label("Temperature");
}

#[test]
fn a_phone_has_room_for_the_photo_mode() {
    let (mut harness, _) = window("phone", vec2(390.0, 844.0));
    press(&mut harness, Key::F8);
    let screen = egui::Rect::from_min_size(egui::Pos2::ZERO, vec2(390.0, 844.0));
    save(&mut harness, "phone-photo");
    for label in ["Take the photo", "Time lapse", "Done", "1280 × 720", "3840 × 2160"] {
        let at = harness.get_by_label(label).rect();
        assert!(screen.contains_rect(at), "{label} at {at}");
    }
}

#[test]
fn a_photo_has_the_chosen_size_and_a_time_lapse_its_frames() {
    let (mut harness, folder) = window("files", vec2(1280.0, 720.0));
    press(&mut harness, Key::F8);
    harness.get_by_label("1280 × 720").click();
    steps(&mut harness, 2);
    press(&mut harness, Key::S);
    let photo = folder.join("saute-1.png");
    wait_for(&mut harness, &photo);
    let reader = png::Decoder::new(std::io::BufReader::new(std::fs::File::open(&photo).expect("opens")));
    let reader = reader.read_info().expect("is a picture");
    assert_eq!((reader.info().width, reader.info().height), (1280, 720));
    harness.get_by_label("Time lapse").click();
    steps(&mut harness, 2);
    let lapse = folder.join("saute-1.gif");
    wait_for(&mut harness, &lapse);
    let bytes = std::fs::read(&lapse).expect("reads");
    assert!(bytes.starts_with(b"GIF89a"));
    // Three to five seconds, and a frame every half a second; each begins with a graphic control extension.
    let frames = bytes.windows(3).filter(|bytes| bytes == &[0x21, 0xf9, 0x04]).count();
    assert!((6..=11).contains(&frames), "{frames} frames");
}
