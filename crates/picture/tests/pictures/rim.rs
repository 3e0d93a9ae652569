//! Promise: along the rim where a cut meets the outside, both show the same flesh: no step in colour, no gap.

use std::sync::Arc;

use glam::{Vec2, Vec3};
use saute_fixtures::campaign;
use saute_kitchen::Library;
use saute_kitchen::food::{FoodModel, Lab};
use saute_kitchen::heat::sorted::{Quantile, Sorted};
use saute_picture::stage::{Stage, StageOptions};
use saute_picture::still::headless::Gpu;
use saute_picture::still::shot::cook_until;
use saute_recipe::Recipe;
use saute_scene::camera::Camera;
use saute_scene::input::{FoodVertex, SceneInput};
use saute_scene::quality::Quality;
use saute_scene::renderer::SceneRenderer;

use crate::adapter;

const SIZE: [u32; 2] = [2048, 1536];
/// Distance of the eye [m] (chosen: 50 pixels a millimetre).
const DISTANCE: f32 = 0.048;
/// How far from the rim both sides are read [pixels] (chosen: past the pixel that the rim itself crosses).
const BESIDE: f32 = 1.2;
/// From place to place along the rim [pixels].
const APART: f32 = 10.0;
/// Largest ΔE*ab between both sides, in the mean and for nine of ten places (chosen: what patches that touch may differ
/// by unnoticed).
const MOST_MEAN: f64 = 1.0;
const MOST_OF_NINE: f64 = 2.5;

/// A cut of a food whose heated face is above, near by.
struct Rim {
    scene: SceneInput,
    /// The rim that the eye sees from both sides, in the world [m].
    line: Vec<Vec3>,
}

impl Rim {
    fn new(kind: &str, heated_s: f64) -> Self {
        let library = Library::embedded().expect("embedded data");
        let text = format!(
            "[pan]\ninitial_c = 230\n[[food]]\nid = \"f\"\nkind = \"{kind}\"\n[[step]]\nhob_w = 1200\n[[step]]\nput = \"f\"\n\
             [[step]]\nafter_s = {heated_s}\nflip = \"f\"\n[[step]]\nafter_s = 10\nend = true\n"
        );
        let recipe = Recipe::parse(&text, "rim.toml", &library).expect("parses");
        let cook = cook_until(recipe, &library, heated_s + 8.0).expect("cooks");
        let options =
            StageOptions { camera: Camera::close_up(), slice: Some(0.0), flat: true, ..StageOptions::default() };
        let mut scene = Stage::default().scene(&cook.kitchen, &options, &Default::default());
        let (line, towards) = seen_rim(&scene, &cook.kitchen.pieces()[0].model);
        let yaw = towards.x.atan2(-towards.y);
        let target = line[line.len() / 2];
        scene.camera = Camera { yaw, pitch: 0.75, distance: DISTANCE, target, ..Camera::three_quarter() };
        Self { scene, line }
    }

    /// ΔE*ab between both sides at places along the rim, ascending.
    fn steps(&self, gpu: &Gpu, renderer: &mut SceneRenderer) -> Vec<f64> {
        let rgba = renderer.render_to_image(&gpu.device, &gpu.queue, &self.scene, SIZE, Quality::Smooth);
        let size = Vec2::new(SIZE[0] as f32, SIZE[1] as f32);
        let pixel = |p: Vec3| {
            let [x, y] = self.scene.camera.project(p, size.x / size.y)?;
            Some(Vec2::new(0.5 + 0.5 * x, 0.5 - 0.5 * y) * size)
        };
        // The colour of the pixel at a place, and how far from the rim its middle is.
        let read = |at: Vec2, aside: Vec2, rim: Vec2| {
            let inside = at.cmpge(Vec2::ZERO).all() && at.cmplt(size).all();
            let start = 4 * (at.y as usize * SIZE[0] as usize + at.x as usize);
            let away = (at.floor() + 0.5 - rim).dot(aside.normalize());
            inside.then(|| (Lab::from_srgb8([rgba[start], rgba[start + 1], rgba[start + 2]]), f64::from(away)))
        };
        // A crust is so thin that its colour changes next to the rim, and a seam so sharp that it does not change
        // evenly: a step is there both between the nearest pixels and where both sides are followed to the rim itself.
        let sides = |rim: Vec2, aside: Vec2| {
            let (near, far) = (read(rim + aside, aside, rim)?, read(rim + 2.5 * aside, aside, rim)?);
            let back = near.1 / (far.1 - near.1);
            Some([near.0, Lab([0, 1, 2].map(|i| near.0.0[i] - back * (far.0.0[i] - near.0.0[i])))])
        };
        let (mut steps, mut next) = (Vec::new(), 0.0);
        // The wall of a step is seen edge-on: only one side of such a rim is in the picture, and a reading next to its foot
        // or its crest falls on what is behind.
        let wall = |pair: &[Vec3]| (pair[1].z - pair[0].z).abs() > pair[1].truncate().distance(pair[0].truncate());
        let walls: Vec<Vec2> =
            self.line.windows(2).filter(|pair| wall(pair)).flatten().filter_map(|p| pixel(*p)).collect();
        let beside_wall = |at: Vec2| walls.iter().any(|end| end.distance(at) < 2.5 * BESIDE + 1.0);
        for pair in self.line.windows(2).filter(|pair| !wall(pair)) {
            let (Some(from), Some(to)) = (pixel(pair[0]), pixel(pair[1])) else { continue };
            let Some(along) = (to - from).try_normalize() else { continue };
            let across = along.perp() * BESIDE;
            // Places are spread evenly along the whole rim, whatever the lengths of its edges.
            let length = from.distance(to);
            while next < length {
                let at = from + along * next;
                next += APART;
                if beside_wall(at) {
                    continue;
                }
                let both = sides(at, across).zip(sides(at, -across));
                steps.extend(both.map(|(a, b)| a[0].difference(b[0]).min(a[1].difference(b[1]))));
            }
            next -= length;
        }
        steps
    }

    /// The same food with an outside that has browned more than its flesh.
    fn painted(&self, more: f32) -> Self {
        let mut scene = self.scene.clone();
        let browner = |v: &FoodVertex| FoodVertex { browning: v.browning + more, ..*v };
        scene.foods[0].vertices = Arc::new(scene.foods[0].vertices.iter().map(browner).collect());
        Self { scene, line: self.line.clone() }
    }
}

/// The rim in the world and the direction from which it is seen: of a slice the upper edge of the cut, of any other
/// body its edge along the path.
fn seen_rim(scene: &SceneInput, model: &FoodModel) -> (Vec<Vec3>, Vec3) {
    let food = &scene.foods[0];
    let cut = food.slice.as_ref().expect("a cut");
    let place = |v: &FoodVertex| food.world_from_rest.transform_point3(Vec3::from_array(v.position));
    if model.mesh().is_slice() {
        let along = |v: &FoodVertex| Vec3::Z.cross(cut.normal).dot(Vec3::from_array(v.rest));
        let rows: Vec<Vec<Vec3>> =
            cut.vertices.chunk_by(|a, b| along(a) <= along(b)).map(|row| row.iter().map(place).collect()).collect();
        let [first, last] = [&rows[0], &rows[rows.len() - 1]];
        let above = if first[first.len() / 2].z > last[last.len() / 2].z { first } else { last };
        return (above.clone(), food.world_from_rest.transform_vector3(cut.normal));
    }
    // A row runs straight across the body: the next one begins where the points come nearer to its beginning again.
    let mut rows: Vec<Vec<FoodVertex>> = Vec::new();
    for v in &cut.vertices {
        let away = |from: &FoodVertex, to: &FoodVertex| Vec3::from(from.rest).distance(Vec3::from(to.rest));
        match rows.last_mut() {
            Some(row) if away(&row[0], v) >= away(&row[0], &row[row.len() - 1]) => row.push(*v),
            _ => rows.push(vec![*v]),
        }
    }
    let line: Vec<Vec3> = rows.iter().map(|row| place(&row[0])).collect();
    let middle = line.len() / 2;
    let towards = line[middle] - place(&rows[middle][rows[middle].len() / 2]);
    (line, towards.with_z(0.0).normalize())
}

#[test]
fn a_cut_and_the_outside_show_the_same_flesh_along_their_rim() {
    let Some(gpu) = adapter() else { return };
    let mut renderer = SceneRenderer::new(&gpu.device, &gpu.queue);
    let mut told = Vec::new();
    let foods = ["beef-lean", "beef-marbled", "beef-patty", "carrot-coin", "leek-ring", "carrot-stick", "shrimp"];
    // The campaign looks between them too.
    let between: &[(&str, f64)] = if campaign::runs() { &[("half", 90.0)] } else { &[] };
    for kind in foods {
        for (state, heated_s) in [("raw", 0.5), ("browned", 240.0)].iter().chain(between) {
            let steps = Rim::new(kind, *heated_s).steps(&gpu, &mut renderer);
            let mean = steps.iter().sum::<f64>() / steps.len() as f64;
            let of_nine = Sorted::new(steps.clone()).quantile(0.9, Quantile::After).expect("steps");
            println!("{kind} {state}: ΔE {mean:.2} in the mean, {of_nine:.2} for nine of ten of {}", steps.len());
            if steps.len() < 40 || mean > MOST_MEAN || of_nine > MOST_OF_NINE {
                told.push(format!("{kind} {state}: {mean:.2}, {of_nine:.2} of {}", steps.len()));
            }
        }
    }
    assert!(told.is_empty(), "{}", told.join("\n"));
}

#[test]
fn an_outside_that_browned_by_itself_would_be_seen_along_the_rim() {
    let Some(gpu) = adapter() else { return };
    let mut renderer = SceneRenderer::new(&gpu.device, &gpu.queue);
    let steps = Rim::new("beef-lean", 90.0).painted(0.1).steps(&gpu, &mut renderer);
    assert!(steps.iter().sum::<f64>() / steps.len() as f64 > MOST_MEAN, "{steps:?}");
}
