//! Promise: food in a mesh of cells cooks as food in a swept mesh does, and keeps the same balances.

use std::sync::Arc;

use saute_food::description::{Confidence, FoodDescription, Kinetics, SurfaceFile};
use saute_food::{FoodModel, Form, PieceSpec, Solid, ZERO_C};
use saute_heat::{Soup, Surface};

use crate::run::{Run, UP, kitchen_air, varied};

const SIZE: [f64; 3] = [0.06, 0.04, 0.02];

fn spec(size: [f64; 3], coarseness: f64) -> PieceSpec {
    PieceSpec::plain(size, coarseness)
}

fn brick() -> Surface {
    let corner = |k: usize| [0, 1, 2].map(|a| if k >> a & 1 == 1 { SIZE[a] } else { 0.0 });
    let quads = [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]];
    let triangles = quads.iter().flat_map(|q| [[q[0], q[1], q[2]], [q[0], q[2], q[3]]]).collect();
    let soup = Soup { vertices: (0..8).map(corner).collect(), triangles, ..Soup::default() };
    Surface::close(&soup, 1.0).expect("closed")
}

/// Leaves out what cells treat otherwise than layers: in cells juice flows to the nearer end of the fibres and not away from
/// the coldest level, and a two-point flux smooths the anisotropy, as edges have all directions.
fn plain(food: &mut FoodDescription, kinetics: &mut Kinetics) {
    kinetics.water_holding.release_per_s = 0.0;
    food.anisotropy = None;
}

/// A brick of beef meshed with cells, its fibres upright as in a steak.
pub fn cells(coarseness: f64) -> FoodModel {
    cells_with(coarseness, |_, _| {})
}

/// The same brick with a changed description and kinetics.
fn cells_with(coarseness: f64, change: impl Fn(&mut FoodDescription, &mut Kinetics)) -> FoodModel {
    varied("beef-lean", &spec([SIZE[0]; 3], coarseness), |food, kinetics| {
        change(food, kinetics);
        food.form = Form::Mesh;
        food.body = Some(Arc::new(brick()));
        let (file, source) = (String::new(), String::new());
        let confidence = Confidence::Low;
        food.mesh = Some(SurfaceFile { file, scale_mm: None, fibres: Some([0.0, 0.0, 1.0]), source, confidence });
        for size in [&mut food.size.default_mm, &mut food.size.min_mm, &mut food.size.max_mm] {
            *size = vec![60.0];
        }
    })
}

/// The same brick in a swept mesh.
fn swept() -> FoodModel {
    swept_with(|_, _| {})
}

/// The swept brick with a changed description and kinetics.
fn swept_with(change: impl Fn(&mut FoodDescription, &mut Kinetics)) -> FoodModel {
    varied("beef-lean", &spec(SIZE, 1.0), |food, kinetics| {
        change(food, kinetics);
        (food.outline.exponent, food.outline.ripple) = (20.0, 0.0);
        (food.outline.wedge, food.outline.bumps) = (0.0, 0.0);
        food.size.min_mm = vec![10.0; 3];
    })
}

#[test]
fn a_surface_is_filled_to_its_volume_and_lies_on_its_lower_face() {
    let model = cells(1.0);
    assert!((2000..10_000).contains(&model.mesh().node_count()), "{}", model.mesh().node_count());
    let volume: f64 = model.mesh().volumes().iter().sum();
    assert!((volume / 48e-6 - 1.0).abs() < 1e-9);
    let below: f64 = model.patches_below(UP).map(|i| model.patches()[i].area).sum();
    assert!((below / 24e-4 - 1.0).abs() < 0.01, "{below}");
    assert!((model.raw_mass() - swept().raw_mass()).abs() < 0.01 * model.raw_mass());
}

/// Below the boiling point.
#[test]
fn cells_cook_as_swept_layers_do() {
    let (cells, swept) = (cells_with(1.0, plain), swept_with(plain));
    for plate in [60.0, 90.0] {
        for (what, [a, b], within) in read_both(&cells, &swept, plate) {
            assert!((a - b).abs() < within, "plate {plate} °C, {what}: {a} in cells, {b} in layers");
        }
    }
}

/// With juice and anisotropy, which cells treat otherwise, below boiling and on a plate that boils: there juice wets the
/// crust by different ways and dry cells hold more of it, so cells stay up to 3 K colder.
#[test]
fn cells_cook_nearly_as_layers_do_with_their_own_juice() {
    let (cells, swept) = (cells(1.0), swept());
    let bounds = [(90.0, [1.5, 1.5, 2.0, 0.2, 0.3]), (130.0, [3.0, 3.0, 5.0, 1.0, 1.0])];
    for (plate, within) in bounds {
        for ((what, [a, b], _), within) in read_both(&cells, &swept, plate).into_iter().zip(within) {
            assert!((a - b).abs() < within, "plate {plate} °C, {what}: {a} in cells, {b} in layers");
        }
    }
}

/// Readings of both meshes after four minutes on a plate, and how far they may differ.
fn read_both(cells: &FoodModel, swept: &FoodModel, plate: f64) -> [(&'static str, [f64; 2], f64); 5] {
    let mut runs = [Run::new(cells, 10.0), Run::new(swept, 10.0)];
    runs.iter_mut().for_each(|run| run.fry(240.0, plate, 500.0, kitchen_air()));
    let both = |read: &dyn Fn(&Run) -> f64| runs.each_ref().map(read);
    [
        ("core °C", both(&|r| r.model.core_temperature(&r.state) - ZERO_C), 0.6),
        ("mean °C", both(&|r| r.model.volume_mean(&r.state.temperature) - ZERO_C), 0.5),
        ("lower face °C", both(&|r| r.model.face_temperature(&r.state, UP) - ZERO_C), 1.0),
        ("evaporated g", both(&|r| 1e3 * r.passed.evaporated), 0.06),
        ("from the plate kJ", both(&|r| 1e-3 * r.passed.contact), 0.08),
    ]
}

#[test]
fn energy_and_mass_balance_and_no_node_leaves_the_range() {
    let model = cells(1.5);
    let mut run = Run::new(&model, 10.0);
    let start = run.state.total_enthalpy();
    run.fry(400.0, 200.0, 800.0, kitchen_air());
    let p = &run.passed;
    let gained = run.state.total_enthalpy() - start;
    let balance = p.contact - p.air - p.evaporation - p.runoff_enthalpy;
    assert!((gained - balance).abs() < 1e-9 * p.contact, "{gained} {balance}");
    let (low, high) = run.state.range();
    assert!(low > ZERO_C + 5.0 && high <= ZERO_C + 200.0 && run.state.healthy);
    let skin: std::collections::BTreeSet<u32> = model.patches().iter().map(|p| p.node).collect();
    assert!(skin.iter().map(|n| run.state.juice[*n as usize]).sum::<f64>() > 0.0, "juice reaches the skin");
    assert!((run.state.mass(&model) - run.state.mass_left(&model)).abs() < 1e-9);
}

#[test]
fn a_cooked_body_is_smaller_and_its_solid_with_it() {
    let model = cells(1.5);
    let mut run = Run::new(&model, 10.0);
    run.fry(400.0, 200.0, 800.0, kitchen_air());
    let left = model.relative_volume(&run.state);
    assert!(left < 0.97, "{left}");
    let Solid::Surface { points, triangles } = model.solid(&run.state) else { panic!("a surface") };
    let solid = Surface { vertices: points, triangles };
    // Nodes contract every two seconds.
    assert!((solid.volume() / 48e-6 - left).abs() < 0.01, "{} {left}", solid.volume() / 48e-6);
}
