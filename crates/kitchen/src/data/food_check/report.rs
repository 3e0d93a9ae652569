//! What a food's file makes.

use saute_food::{
    BuildError, Exchange, FoodDescription, FoodModel, FoodSolver, FoodState, PieceSpec, Surroundings, Touch,
};
use saute_heat::Surface;
use serde::Serialize;

use crate::data::library::Library;
use crate::piece::work;
use crate::{celsius, kelvin};

/// What a food's file makes, at its default size.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct FoodReport {
    /// Name for people.
    pub name: String,
    /// Shape.
    pub form: String,
    /// What the dimensions are called.
    pub dimensions: Vec<String>,
    /// Default dimensions [mm].
    pub size_mm: Vec<f64>,
    /// Mass [g].
    pub mass_g: f64,
    /// Nodes of the default mesh.
    pub nodes: usize,
    /// Density of the raw food at 20 °C [kg/m³].
    pub density_kg_m3: f64,
    /// Thermal conductivity of the raw flesh at 20 °C and at 60 °C [W/(m·K)].
    pub conductivity_w_mk: [f64; 2],
    /// Distance of the nodes below the surface from it [mm].
    pub first_layer_mm: f64,
    /// Time in water of 60 °C, from 5 °C, until the core has 55 °C; none where a day does not suffice [min].
    pub core_55_c_min: Option<f64>,
    /// The surface that was meshed inside, where there is one.
    pub surface: Option<SurfaceReport>,
}

/// Numbers of a closed surface.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct SurfaceReport {
    /// Triangles.
    pub triangles: usize,
    /// Edges of the box around it [mm].
    pub extent_mm: [f64; 3],
    /// Enclosed volume [cm³].
    pub volume_cm3: f64,
    /// Area [cm²].
    pub area_cm2: f64,
}

impl SurfaceReport {
    /// Measures a surface.
    pub fn of(surface: &Surface) -> Self {
        Self {
            triangles: surface.triangles.len(),
            extent_mm: surface.extent().map(|e| 1e3 * e),
            volume_cm3: 1e6 * surface.volume(),
            area_cm2: 1e4 * surface.area(),
        }
    }
}

/// Temperatures of the bath, of the start, and of the core whose time is reported [°C] (chosen: a gentle bath, a refrigerator,
/// medium).
const BATH_C: f64 = 60.0;
const START_C: f64 = 5.0;
const CORE_C: f64 = 55.0;
/// Conductance of stirred water to a piece in it [W/(m²·K)] (chosen: so large that it does not matter).
const BATH_CONDUCTANCE: f64 = 1000.0;
/// Longest time in the bath [s] (a day).
const LONGEST: f64 = 86_400.0;
/// Mesh spacing over the default for the time in the bath [-] (chosen: a few percent of that time).
const COARSE: f64 = 1.5;
/// Tick in the bath [s] (chosen: temperatures rise by a few hundredths of a kelvin).
const TICK: f64 = 1.0;

impl FoodReport {
    /// Builds a piece of default size and measures it.
    pub fn of(food: &FoodDescription, library: &Library) -> Result<Self, BuildError> {
        let build = |coarseness| {
            let size = food.form.extent(&food.size.default_mm).unwrap_or_default().map(|mm| 1e-3 * mm);
            let spec = PieceSpec::plain(size, coarseness);
            FoodModel::build(food, &library.kinetics[&food.kinetics], &library.components, &spec)
        };
        let model = build(1.0)?;
        work::check(&model, 1.0)?;
        let volume: f64 = model.mesh().volumes().iter().sum();
        let lean = [food.lean.water, food.lean.lean_solids(), food.lean.fat];
        Ok(Self {
            name: food.name.clone(),
            form: food.form.name().to_owned(),
            dimensions: food.form.dimensions().iter().map(|d| (*d).to_owned()).collect(),
            size_mm: food.size.default_mm.clone(),
            mass_g: 1e3 * model.raw_mass(),
            nodes: model.mesh().node_count(),
            density_kg_m3: model.raw_mass() / volume,
            conductivity_w_mk: [20.0, 60.0].map(|c| model.properties().conductivity(&lean, kelvin(c))),
            first_layer_mm: 1e3 * model.mesh().first_layer(),
            core_55_c_min: minutes_in_a_bath(&build(COARSE)?, library),
            surface: food.body.as_deref().map(SurfaceReport::of),
        })
    }
}

/// Time until the core is done in the bath [min].
fn minutes_in_a_bath(model: &FoodModel, library: &Library) -> Option<f64> {
    let mut state = FoodState::raw(model, kelvin(START_C));
    let mut solver = FoodSolver::default();
    let touch =
        vec![Touch::Contact { conductance: BATH_CONDUCTANCE, temperature: kelvin(BATH_C) }; model.patches().len()];
    // Every patch is in water, so that the air passes nothing.
    let air = [library.room.still_air(); 3];
    let around = Surroundings { touch: &touch, air: &air, pressed: 0.0 };
    let mut time = 0.0;
    while celsius(model.core_temperature(&state)) < CORE_C {
        let _: Exchange = solver.advance(model, &mut state, &around, TICK);
        time += TICK;
        if time > LONGEST || !state.healthy {
            return None;
        }
    }
    Some(time / 60.0)
}
