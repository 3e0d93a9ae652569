//! A piece on a plate, for the tests.

use std::sync::OnceLock;

use saute_food::components::Components;
use saute_food::{
    FoodDescription, FoodModel, FoodSolver, FoodState, FreeAir, Kinetics, PieceSpec, Surroundings, Touch, ZERO_C,
};
use saute_heat::SweptMesh;

pub const DT: f64 = 0.1;

/// The world's upward direction in the body frame, before and after a flip.
pub const UP: [f64; 3] = [0.0, 0.0, 1.0];
pub const FLIPPED: [f64; 3] = [0.0, 0.0, -1.0];

pub fn model(kind: &str, coarseness: f64, size: [f64; 3]) -> FoodModel {
    piece(kind, &PieceSpec::plain(size, coarseness))
}

pub fn piece(kind: &str, spec: &PieceSpec) -> FoodModel {
    shaped(kind, spec, |_| {})
}

/// A piece of a food with a changed description.
pub fn shaped(kind: &str, spec: &PieceSpec, change: impl Fn(&mut FoodDescription)) -> FoodModel {
    varied(kind, spec, |food, _| change(food))
}

/// A piece of a food with a changed description and changed kinetics.
pub fn varied(kind: &str, spec: &PieceSpec, change: impl Fn(&mut FoodDescription, &mut Kinetics)) -> FoodModel {
    let mut food = food(kind);
    let mut kinetics: Kinetics = toml::from_str(&read(format!("kinetics/{}.toml", food.kinetics))).expect("kinetics");
    change(&mut food, &mut kinetics);
    let components: Components = toml::from_str(&read("components.toml".into())).expect("components");
    FoodModel::build(&food, &kinetics, &components, spec).expect("builds")
}

fn read(path: String) -> String {
    let data = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("../../data");
    std::fs::read_to_string(data.join(path)).expect("data file")
}

/// The description of a shipped food.
pub fn food(kind: &str) -> FoodDescription {
    toml::from_str(&read(format!("foods/{kind}.toml"))).expect("food")
}

pub fn lean() -> &'static FoodModel {
    static LEAN: OnceLock<FoodModel> = OnceLock::new();
    LEAN.get_or_init(|| model("beef-lean", 1.6, [0.12, 0.08, 0.025]))
}

pub fn kitchen_air() -> FreeAir {
    FreeAir {
        temperature: ZERO_C + 23.0,
        walls: ZERO_C + 23.0,
        convection: 7.0,
        radiation: 1.0,
        vapour_density: 0.0103,
        mass_transfer: 4.0e-3,
    }
}

/// Heat and mass exchanged in a whole run.
#[derive(Default)]
pub struct Passed {
    pub contact: f64,
    pub air: f64,
    pub evaporation: f64,
    pub evaporated: f64,
    pub drip: f64,
    pub rendered: f64,
    pub runoff_enthalpy: f64,
}

pub struct Run<'a> {
    pub model: &'a FoodModel,
    pub state: FoodState,
    pub up: [f64; 3],
    pub solver: FoodSolver,
    pub passed: Passed,
    pub dt: f64,
}

impl<'a> Run<'a> {
    pub fn new(model: &'a FoodModel, celsius: f64) -> Self {
        let state = FoodState::raw(model, ZERO_C + celsius);
        Self { model, state, up: UP, solver: FoodSolver::default(), passed: Passed::default(), dt: DT }
    }

    /// Fries on a plate of constant temperature and contact conductance.
    pub fn fry(&mut self, seconds: f64, plate_c: f64, h: f64, air: FreeAir) {
        let mut touch = vec![Touch::default(); self.model.patches().len()];
        for patch in self.model.patches_below(self.up) {
            touch[patch] = Touch::Contact { conductance: h, temperature: ZERO_C + plate_c };
        }
        for _ in 0..(seconds / self.dt).round() as usize {
            let around = Surroundings { touch: &touch, air: &[air; 3], pressed: 0.0 };
            let exchange = self.solver.advance(self.model, &mut self.state, &around, self.dt);
            self.passed.contact += self.solver.contact_heat.iter().sum::<f64>();
            self.passed.air += exchange.air;
            self.passed.evaporation += exchange.evaporation;
            self.passed.evaporated += exchange.evaporated;
            self.passed.drip += exchange.drip.mass;
            self.passed.rendered += exchange.rendered.mass;
            self.passed.runoff_enthalpy += exchange.drip.enthalpy + exchange.rendered.enthalpy;
        }
    }

    /// Energy and water balance since a state, to 1e-9 of what the plate gave and of the water at first.
    pub fn assert_balanced(&self, from: &FoodState, name: &str) {
        let p = &self.passed;
        let stored = self.state.total_enthalpy() - from.total_enthalpy();
        let residual = p.contact - p.air - p.evaporation - p.runoff_enthalpy - stored;
        assert!(residual.abs() < 1e-9 * p.contact, "{name}: {residual} of {}", p.contact);
        let (now, first) = (self.state.water.iter().sum::<f64>(), from.water.iter().sum::<f64>());
        assert!(((now + p.evaporated + p.drip) / first - 1.0).abs() < 1e-9, "{name}: {now} of {first} kg");
    }

    pub fn flip(&mut self) {
        self.up = self.up.map(|v| -v);
    }

    pub fn core(&self) -> f64 {
        self.model.core_temperature(&self.state) - ZERO_C
    }
}

/// The layers of a swept body.
pub fn swept_mesh(model: &FoodModel) -> &SweptMesh {
    model.mesh().swept().expect("a swept body")
}
