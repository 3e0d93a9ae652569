//! Measures frames of the window with a full pan of shrimps, and tells where the time goes.

use std::time::Instant;

use saute_app::{Start, View};
use saute_app::bench_frame::{SHRIMPS, bench_frame};
use saute_app::scene::camera::Camera;
use saute_app::session::{Session, SteakChoice};
use saute_app::stage::{Places, Stage, StageOptions};
use saute_kitchen::{Library, Recipe};

/// Mean time of a frame of the kitchen without and with a tick, and of describing the scene [ms].
fn split(library: &Library, recipe: Recipe) -> Result<[f64; 3], Box<dyn std::error::Error>> {
    let mut session = Session::new(std::sync::Arc::new(library.clone()), &SteakChoice::default())?;
    session.play(recipe)?;
    for _ in 0..40 {
        session.tick()?;
    }
    let (mut stage, mut spent, mut count) = (Stage::default(), [0.0; 3], [0.0; 3]);
    let options = StageOptions {
        camera: Camera::three_quarter(),
        view: View::Look,
        map: saute_app::TemperatureMap::Uniform,
        scale: None,
        slice: None,
        cut: None,
        flat: false,
    };
    for _ in 0..600 {
        let begin = Instant::now();
        let kind = usize::from(session.kitchen.advance_frame());
        spent[kind] += begin.elapsed().as_secs_f64();
        count[kind] += 1.0;
        let begin = Instant::now();
        std::hint::black_box(stage.scene(&session.kitchen, &options, &Places::default()));
        spent[2] += begin.elapsed().as_secs_f64();
        count[2] += 1.0;
    }
    Ok([0, 1, 2].map(|k| 1e3 * spent[k] / count[k]))
}

fn picture(library: &Library, recipe: Recipe) -> Result<(), Box<dyn std::error::Error>> {
    let options = saute_app::shot::ShotOptions { view: View::Look, slice: false, flat: false, scale: library.scales[0].clone() };
    for at in [1.0, 8.0] {
        let picture = saute_app::shot::shot(recipe.clone(), library, at, options.clone(), [1280, 720])?;
        std::fs::write(format!("/tmp/shrimps-{at}.png"), saute_app::png_file::png_bytes(&picture)?)?;
    }
    Ok(())
}

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let library = Library::embedded()?;
    let recipe = Recipe::parse(SHRIMPS, "shrimps", &library)?;
    picture(&library, recipe.clone())?;
    println!("frame, frame with tick, scene [ms]: {:?}", split(&library, recipe.clone())?);
    let plain = std::env::args().nth(1);
    let recipe = match &plain {
        Some(id) => Recipe::parse(&library.recipes[id], id, &library)?,
        None => recipe,
    };
    let start = Start { library: Some(std::sync::Arc::new(library)), recipe: Some(recipe) };
    println!("{}", serde_json::to_string_pretty(&bench_frame(start, [1280, 720], 4.0, Instant::now())?)?);
    Ok(())
}
