//! Promise: a cut changes no state; it separates the halves for heat and juice, opens fresh faces to the air, and keeps
//! energy, water and the maximum principle.

use saute_food::body::halving::CutError;
use saute_food::{FoodModel, FreeAir, MeshSize, OutlineKind, PieceSpec, Rules, ZERO_C};

use crate::body::cells::cells;
use crate::run::{Run, UP, kitchen_air, model, piece};

const DRY: FreeAir = FreeAir {
    temperature: ZERO_C + 20.0,
    walls: ZERO_C + 20.0,
    convection: 20.0,
    radiation: 1.0,
    vapour_density: 0.0,
    mass_transfer: 0.0,
};

/// One piece of every form.
fn bodies() -> Vec<(&'static str, FoodModel)> {
    vec![
        ("beef-lean", model("beef-lean", 1.6, [0.12, 0.08, 0.025])),
        ("beef-patty", model("beef-patty", 1.6, [0.1, 0.1, 0.02])),
        ("carrot-coin", model("carrot-coin", 1.0, [0.03, 0.03, 0.01])),
        ("leek-ring", model("leek-ring", 1.0, [0.03, 0.03, 0.015])),
        ("carrot-stick", model("carrot-stick", 1.0, [0.06, 0.01, 0.01])),
        ("shrimp", model("shrimp", 1.0, [0.08, 0.02, 0.015])),
        ("cells", cells(1.0)),
    ]
}

/// A run that continues with the cut piece.
fn after<'a>(halves: &'a FoodModel, whole: &Run) -> Run<'a> {
    Run { state: whole.state.clone(), up: whole.up, ..Run::new(halves, 20.0) }
}

#[test]
fn a_cut_changes_nothing_of_the_state_at_its_instant() {
    for (kind, whole) in bodies() {
        let mut run = Run::new(&whole, 5.0);
        run.fry(60.0, 200.0, 400.0, kitchen_air());
        let halves = whole.halved(0.004).expect(kind);
        let state = &run.state;
        assert_eq!(halves.core_temperature(state), whole.core_temperature(state), "{kind}");
        assert_eq!(state.mass(&halves), state.mass(&whole), "{kind}");
        assert_eq!(halves.log_reduction(state), whole.log_reduction(state), "{kind}");
        assert_eq!(halves.elastic_modulus_kpa(state), whole.elastic_modulus_kpa(state), "{kind}");
        for up in [UP, UP.map(|v| -v), [1.0, 0.0, 0.0]] {
            assert_eq!(halves.face_temperature(state, up), whole.face_temperature(state, up), "{kind}");
        }
    }
}

/// With 40 °C on one side and 20 °C on the other nothing changes: no edge conducts through the plane.
#[test]
fn the_halves_pass_each_other_no_heat() {
    for (kind, whole) in bodies() {
        let halves = whole.halved(0.0).expect(kind);
        let mut run = Run::new(&halves, 20.0);
        for node in 0..halves.mesh().node_count() {
            if halves.is_beyond_cut(node) {
                let masses = halves.masses(&run.state, node);
                run.state.temperature[node] = ZERO_C + 40.0;
                run.state.enthalpy[node] = halves.properties().enthalpy(&masses, ZERO_C + 40.0).0;
            }
        }
        let still = FreeAir { convection: 0.0, radiation: 0.0, ..DRY };
        run.fry(60.0, 20.0, 0.0, still);
        for node in 0..halves.mesh().node_count() {
            let expected = if halves.is_beyond_cut(node) { 40.0 } else { 20.0 };
            assert!((run.state.celsius(node) - expected).abs() < 1e-6, "{kind}: {}", run.state.celsius(node));
        }
    }
}

/// The fresh face of each half has the area of the plane and faces the other half.
#[test]
fn the_fresh_faces_have_the_area_of_the_plane_and_look_at_each_other() {
    for (kind, expected, axis) in
        [("beef-lean", 0.08 * 0.025, 0), ("carrot-stick", 0.01 * 0.01, 0), ("cells", 0.04 * 0.02, 0)]
    {
        let whole = &bodies().into_iter().find(|b| b.0 == kind).expect(kind).1;
        let halves = whole.halved(0.0).expect(kind);
        let face = |beyond: bool| {
            let of =
                halves.fresh_faces().filter(|&p| halves.is_beyond_cut(halves.patches()[p].node as usize) == beyond);
            of.fold((0.0, 0.0), |(area, normal), p| {
                (area + halves.patches()[p].area, normal + halves.patches()[p].area * halves.rest_normals()[p][axis])
            })
        };
        let ((near, out), (far, back)) = (face(false), face(true));
        assert!((near / far - 1.0).abs() < 1e-9 && (near / expected - 1.0).abs() < 0.06, "{kind}: {near} {far}");
        assert!((out / near - 1.0).abs() < 1e-6 && (back / far + 1.0).abs() < 1e-6, "{kind}: {out} {back}");
    }
}

/// Heat, vapour, juice and fat of a halved piece balance to 1e-12, and no water is lost.
#[test]
fn energy_and_water_of_halves_balance() {
    for (kind, whole) in bodies() {
        let mut run = Run::new(&whole, 5.0);
        run.fry(120.0, 200.0, 400.0, kitchen_air());
        let halves = whole.halved(0.002).expect(kind);
        let mut run = after(&halves, &run);
        let (heat, water) = (run.state.total_enthalpy(), run.state.water.iter().sum::<f64>());
        run.fry(200.0, 30.0, 150.0, kitchen_air());
        let p = &run.passed;
        let residual = p.contact - p.air - p.evaporation - p.runoff_enthalpy - (run.state.total_enthalpy() - heat);
        let gross = p.contact.abs() + p.air.abs() + p.evaporation + heat.abs();
        assert!(residual.abs() < 1e-12 * gross, "{kind}: {residual} J of {gross} J");
        let left = run.state.water.iter().sum::<f64>() + p.evaporated + p.drip;
        assert!((left / water - 1.0).abs() < 1e-12, "{kind}");
    }
}

/// In a room of 20 °C a piece of 60 °C stays between these temperatures.
#[test]
fn halves_obey_the_maximum_principle() {
    for (kind, whole) in bodies() {
        let halves = whole.halved(-0.003).expect(kind);
        let mut run = Run::new(&halves, 60.0);
        for _ in 0..30 {
            run.fry(10.0, 20.0, 0.0, DRY);
            let (low, high) = run.state.range();
            assert!(low > ZERO_C + 20.0 - 1e-9 && high < ZERO_C + 60.0 + 1e-6, "{kind}: {low} {high}");
        }
    }
}

#[test]
fn a_halved_piece_cools_faster_than_a_whole_one() {
    for (kind, whole) in bodies() {
        let halves = whole.halved(0.0).expect(kind);
        let mean = |model: &FoodModel| {
            let mut run = Run::new(model, 60.0);
            run.fry(120.0, 20.0, 0.0, kitchen_air());
            model.volume_mean(&run.state.temperature)
        };
        let (cut, left) = (mean(&halves), mean(&whole));
        assert!(cut < left - 0.1, "{kind}: {cut} {left}");
    }
}

/// A cut releases juice that a whole piece would have kept.
#[test]
fn juice_runs_out_of_the_fresh_cut() {
    for (kind, size) in [("beef-lean", [0.12, 0.08, 0.025]), ("shrimp", [0.08, 0.02, 0.015])] {
        let whole = model(kind, 1.6, size);
        let halves = whole.halved(0.0).expect(kind);
        let mut cooked = Run::new(&whole, 5.0);
        cooked.fry(300.0, 150.0, 400.0, kitchen_air());
        let drip = |model: &FoodModel| {
            let mut run = after(model, &cooked);
            run.fry(300.0, 20.0, 0.0, FreeAir { vapour_density: 0.02, ..kitchen_air() });
            run.passed.drip
        };
        let (cut, left) = (drip(&halves), drip(&whole));
        assert!(cut > left + 1e-6, "{kind}: {cut} {left}");
    }
}

#[test]
fn a_piece_is_cut_once_and_where_it_is() {
    for (kind, whole) in bodies() {
        let halves = whole.halved(0.0).expect(kind);
        assert_eq!(halves.halved_at().map(|cut| cut.at), Some(0.0), "{kind}");
        assert_eq!(halves.halved(0.0).err(), Some(CutError::Halved), "{kind}");
        for at in [0.5 * whole.size()[0], -0.5 * whole.size()[0], f64::NAN] {
            assert!(matches!(whole.halved(at), Err(CutError::Beside { most }) if most > 0.0), "{kind} {at}");
        }
    }
}

#[test]
fn a_piece_of_2013_can_be_cut_too() {
    for kind in ["beef-lean", "carrot-stick"] {
        let size = if kind == "beef-lean" { [0.12, 0.08, 0.025] } else { [0.06, 0.01, 0.01] };
        let spec = PieceSpec {
            size,
            seed: 1,
            coarseness: 1.0,
            mesh: MeshSize::Paper2013,
            rules: Rules::Paper2013,
            outline: OutlineKind::Plain,
            pool: None,
        };
        let halves = piece(kind, &spec).halved(0.0).expect(kind);
        let area: f64 = halves.fresh_faces().map(|p| 0.5 * halves.patches()[p].area).sum();
        let plane = size[1] * size[2];
        assert!((0.7 * plane..1.1 * plane).contains(&area), "{kind}: {area}");
    }
}
