//! Draws the conditions of `web/test/poses.json` as the native window does. The page's tests compare their canvas with these
//! pictures.

use std::path::Path;

use saute_controls::pose::Pose;
use saute_picture::cut::section::Picture;
use saute_picture::still::png_file::png_bytes;
use saute_window::Start;
use saute_window::desktop::offscreen::Offscreen;
use serde_json::Value;

/// Size of the window [points].
const SIZE: [u32; 2] = [1280, 720];
/// Frames within which a picture comes to rest as the page shows it; between them passes a second of the window's clock.
const FRAMES: u32 = 40;

/// Pixels of a point along an edge: those of the page, as `SHARP` of `web/test/browser.mjs` states them.
fn pixels_per_point() -> f32 {
    if std::env::var_os("SAUTE_CAMPAIGN").is_some() { 1.0 } else { 0.5 }
}

#[test]
fn every_condition_of_the_page_is_drawn_natively_too() {
    let poses: Vec<Value> = serde_json::from_str(include_str!("../../../../web/test/poses.json")).expect("poses");
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("page-stills");
    std::fs::create_dir_all(&folder).expect("folder");
    let scale = pixels_per_point();
    let pixels = SIZE.map(|points| (points as f32 * scale) as u32);
    let mut window = Offscreen::open_scaled(Start::default(), pixels, scale).expect("graphics");
    for (number, mut pose) in poses.into_iter().enumerate() {
        let name = pose.as_object_mut().and_then(|keys| keys.remove("name")).expect("has a name");
        let pose: Pose = serde_json::from_value(pose).expect("a pose");
        window.app.pose(&pose).expect("a sound pose");
        for frame in 0..FRAMES {
            window.frame(f64::from(number as u32 * FRAMES + frame));
            // The first ones may not have seen the new condition yet.
            if frame > 3 && window.app.rests() {
                break;
            }
        }
        assert!(window.app.rests(), "{name} is still being drawn");
        let picture = Picture { width: pixels[0] as usize, height: pixels[1] as usize, rgba: window.picture() };
        let colours: std::collections::BTreeSet<_> = picture.rgba.chunks(4).collect();
        assert!(colours.len() > 100, "{name} shows something");
        let file = folder.join(format!("{}.png", name.as_str().expect("text")));
        std::fs::write(file, png_bytes(&picture).expect("encodes")).expect("is written");
    }
}
