//! What is counted. Each piece of work returns how many units it did, so that counts are per unit.

use std::error::Error;
use std::hint::black_box;
use std::path::Path;

use saute_kitchen::dynamics::RIGID_HZ;
use saute_kitchen::food::{FoodModel, PieceSpec, Rules};
use saute_kitchen::{FRAMES_PER_TICK, Kitchen, Library, MeshSize, OutlineKind};
use saute_lab::{Case, run};
use saute_picture::stage::{Places, Stage, StageOptions};

use crate::counted::counted;
use crate::kitchens;
use crate::kitchens::TICKS;

/// Sets up and does one piece of work with the kitchens of a folder; returns its units.
type Work = fn(&Path) -> Result<u32, Box<dyn Error>>;

/// All work by name.
pub const WORK: [(&str, Work); 7] = [
    ("steak-tick", steak_tick),
    ("shrimps-tick", shrimps_tick),
    ("shrimps-rigid-step", shrimps_rigid_step),
    ("brick", brick),
    ("food-model", food_model),
    ("first-scene", first_scene),
    ("next-scene", next_scene),
];

/// The brick of `saute bench heat` with twice its spacings.
const BRICK: &str = r#"
duration_s = 600
output_every_s = 150
[body]
shape = "box"
size_mm = [100, 70, 25]
resolution_mm = [28, 24, 1.4]
initial_c = 5
[material]
conductivity_w_mk = 0.49
density_kg_m3 = 1058
specific_heat_j_kgk = 3590
[solver]
step_factor = 8
[[boundary]]
face = "all"
h_w_m2k = 15
ambient_c = 25
[[boundary]]
face = "bottom"
h_w_m2k = 500
ambient_c = 180
[flips]
at_s = [300]
[[probe]]
name = "centre"
at_mm = [50, 35, 12.5]
"#;

/// A tick of the steak: its heat, water and changes, and the pan's.
fn steak_tick(folder: &Path) -> Result<u32, Box<dyn Error>> {
    ticks(kitchens::steak(folder)?)
}

/// A tick of the shrimps that lie still.
fn shrimps_tick(folder: &Path) -> Result<u32, Box<dyn Error>> {
    ticks(kitchens::shrimps(folder)?)
}

fn ticks(mut kitchen: Kitchen) -> Result<u32, Box<dyn Error>> {
    counted(&mut || (0..TICKS).for_each(|_| kitchen.step()));
    black_box(&kitchen);
    Ok(TICKS)
}

/// A step of the rigid bodies while none of the shrimps sleeps; the frames of one tick but the last, which heats.
fn shrimps_rigid_step(folder: &Path) -> Result<u32, Box<dyn Error>> {
    let mut kitchen = kitchens::shrimps(folder)?;
    kitchen.set_sleeping(false);
    kitchen.step();
    let frames = FRAMES_PER_TICK - 1;
    counted(&mut || (0..frames).for_each(|_| _ = black_box(kitchen.advance_frame())));
    Ok(frames * RIGID_HZ / 60)
}

/// The brick from its mesh to its end.
fn brick(_: &Path) -> Result<u32, Box<dyn Error>> {
    let case = Case::parse(BRICK, "brick", &Library::embedded()?)?;
    counted(&mut || drop(black_box(run(&case, || 0.0))));
    Ok(1)
}

/// The model of a steak of the default size, with its mesh.
fn food_model(_: &Path) -> Result<u32, Box<dyn Error>> {
    let library = Library::embedded()?;
    let food = library.foods.get("beef-lean").ok_or("there is no beef-lean")?;
    let kinetics = library.kinetics.get(&food.kinetics).ok_or("there are no kinetics of beef")?;
    let size = [0.12, 0.08, 0.025];
    let spec = PieceSpec {
        size,
        seed: 1,
        coarseness: 1.0,
        mesh: MeshSize::Default,
        rules: Rules::Full,
        outline: OutlineKind::Plain,
        pool: None,
    };
    let mut model = Ok(());
    counted(&mut || model = FoodModel::build(food, kinetics, &library.components, &spec).map(|m| drop(black_box(m))));
    model?;
    Ok(1)
}

/// The first picture's input of the steak, with the meshes of its skin.
fn first_scene(folder: &Path) -> Result<u32, Box<dyn Error>> {
    let kitchen = kitchens::steak(folder)?;
    let mut stage = Stage::default();
    counted(&mut || scene(&mut stage, &kitchen));
    Ok(1)
}

/// The next picture's input of the steak, a second later.
fn next_scene(folder: &Path) -> Result<u32, Box<dyn Error>> {
    let mut kitchen = kitchens::steak(folder)?;
    let mut stage = Stage::default();
    scene(&mut stage, &kitchen);
    (0..TICKS).for_each(|_| kitchen.step());
    counted(&mut || scene(&mut stage, &kitchen));
    Ok(1)
}

fn scene(stage: &mut Stage, kitchen: &Kitchen) {
    drop(black_box(stage.scene(kitchen, &StageOptions::default(), &Places::default())));
}
