//! Promise: a piece with its natural form has the volume of the plain one, its own outline for each seed, a flat foot, and
//! all the balances of a plain piece; a plain piece is what it was.

use saute_food::{FoodModel, FoodState, MeshSize, OutlineKind, PieceSpec, Rules, ZERO_C};

use crate::run::{Run, UP, kitchen_air, piece, shaped, swept_mesh};

const FOODS: [(&str, [f64; 3]); 7] = [
    ("beef-lean", [0.12, 0.08, 0.025]),
    ("beef-marbled", [0.12, 0.08, 0.020]),
    ("beef-patty", [0.10, 0.10, 0.018]),
    ("carrot-coin", [0.03, 0.03, 0.008]),
    ("carrot-stick", [0.06, 0.01, 0.01]),
    ("leek-ring", [0.028, 0.028, 0.012]),
    ("shrimp", [0.075, 0.016, 0.016]),
];

fn spec(size: [f64; 3], seed: u64, coarseness: f64, outline: OutlineKind) -> PieceSpec {
    PieceSpec { size, seed, coarseness, mesh: MeshSize::Default, rules: Rules::Full, outline, pool: None }
}

fn natural(kind: &str, size: [f64; 3], seed: u64) -> FoodModel {
    piece(kind, &spec(size, seed, 1.6, OutlineKind::Natural))
}

fn volume(model: &FoodModel) -> f64 {
    model.mesh().volumes().iter().sum()
}

fn bits(model: &FoodModel) -> Vec<u64> {
    let outline = model.outline().points.iter().flatten();
    let mesh = model.mesh().volumes().iter().chain(&model.mesh().graph().shape);
    let tissue = model.initial_water().iter().chain(model.initial_fat()).chain(model.lean_solids());
    outline.chain(mesh).chain(tissue).map(|v| v.to_bits()).collect()
}

#[test]
fn a_natural_piece_has_the_volume_of_the_plain_one_within_a_thousandth() {
    for (kind, size) in FOODS {
        for seed in 1..6 {
            let plain = volume(&piece(kind, &spec(size, seed, 1.0, OutlineKind::Plain)));
            let grown = volume(&piece(kind, &spec(size, seed, 1.0, OutlineKind::Natural)));
            println!("{kind} {seed}: {:.5}", grown / plain);
            assert!((grown / plain - 1.0).abs() < 1e-3, "{kind} {seed}: {}", grown / plain);
        }
    }
}

#[test]
fn a_plain_piece_is_that_of_a_food_without_a_natural_form() {
    for (kind, size) in FOODS {
        let plain = spec(size, 2, 1.6, OutlineKind::Plain);
        let never = shaped(kind, &PieceSpec { outline: OutlineKind::Natural, ..plain }, |food| {
            (food.natural, food.fat_cap) = (None, None);
        });
        let model = piece(kind, &plain);
        assert!(bits(&model) == bits(&never), "{kind}");
        assert!(model.natural().is_none(), "{kind}");
        let old = PieceSpec { mesh: MeshSize::Paper2013, outline: OutlineKind::Natural, ..plain };
        assert!(piece(kind, &old).natural().is_none(), "{kind}: the mesh of 2013 is plain");
        let rules = PieceSpec { rules: Rules::Paper2013, outline: OutlineKind::Natural, ..plain };
        assert!(piece(kind, &rules).natural().is_none(), "{kind}: the rules of 2013 are plain");
    }
}

#[test]
fn the_same_seed_gives_the_same_bits_and_another_seed_another_piece() {
    for (kind, size) in FOODS {
        assert!(bits(&natural(kind, size, 7)) == bits(&natural(kind, size, 7)), "{kind}");
        assert!(bits(&natural(kind, size, 7)) != bits(&natural(kind, size, 8)), "{kind}");
    }
}

/// Two steaks differ by 3 mm and more somewhere along their outlines, two patties by 2 mm.
#[test]
fn two_seeds_differ_visibly() {
    for (kind, size, least) in [
        ("beef-lean", [0.12, 0.08, 0.025], 3e-3),
        ("beef-marbled", [0.12, 0.08, 0.02], 3e-3),
        ("beef-patty", [0.1, 0.1, 0.018], 2e-3),
    ] {
        for (a, b) in [(1, 2), (2, 3), (1, 3), (7, 8)] {
            let [a, b] = [a, b].map(|seed| natural(kind, size, seed));
            let apart = a.outline().points.iter().map(|p| b.outline().distance_to(*p)).fold(0.0, f64::max);
            assert!(apart > least, "{kind}: {apart}");
        }
    }
}

/// The extents of a steak stay near the stated ones.
#[test]
fn an_outline_strays_by_no_more_than_a_tenth_of_its_size() {
    for seed in 1..20 {
        let steak = natural("beef-lean", [0.12, 0.08, 0.025], seed);
        for axis in 0..2 {
            let along = steak.outline().points.iter().map(|p| p[axis]);
            let extent = along.clone().fold(0.0, f64::max) - along.fold(0.0, f64::min);
            assert!((extent / steak.size()[axis] - 1.0).abs() < 0.10, "{seed}: {extent}");
        }
    }
}

#[test]
fn the_foot_of_a_natural_slice_is_flat_and_looks_down() {
    for (kind, size) in FOODS.into_iter().filter(|(kind, _)| !["shrimp", "carrot-stick"].contains(kind)) {
        let model = natural(kind, size, 3);
        let below: Vec<usize> = model.patches_below(UP).collect();
        assert_eq!(below.len(), swept_mesh(&model).nodes_per_level(), "{kind}");
        let low = -0.5 * size[2];
        assert!(below.iter().all(|i| (model.rest_position(model.patches()[*i].node as usize)[2] - low).abs() < 1e-12));
    }
    let stick = natural("carrot-stick", [0.06, 0.01, 0.01], 3);
    let heights = stick.patches_below(UP).map(|i| stick.rest_position(stick.patches()[i].node as usize)[2]);
    let lowest = heights.fold(f64::INFINITY, f64::min);
    let ends = [0, swept_mesh(&stick).levels.len() - 1].map(|level| {
        let nodes = 0..swept_mesh(&stick).nodes_per_level();
        nodes.map(|i| stick.rest_position(swept_mesh(&stick).node(level, i))[2]).fold(f64::INFINITY, f64::min)
    });
    assert!(ends.iter().all(|z| (z - lowest).abs() < 0.1e-3), "{ends:?} {lowest}");
}

/// A cap of 4–6 mm along 26–36 % of the outline, tapering off at its ends, on one long side.
#[test]
fn a_fat_cap_lies_along_its_share_of_one_long_side() {
    for seed in 1..9 {
        let steak = piece("beef-lean", &spec([0.12, 0.08, 0.025], seed, 1.0, OutlineKind::Natural));
        let mesh = swept_mesh(&steak);
        let rim = mesh.section.rim();
        let fat: Vec<u32> = rim.iter().copied().filter(|i| steak.adipose()[*i as usize] > 0.5).collect();
        let share = fat.len() as f64 / rim.len() as f64;
        assert!((0.15..0.37).contains(&share), "{seed}: {share}");
        let side = fat.iter().map(|i| mesh.section.points[*i as usize][1]).sum::<f64>().signum();
        assert!(fat.iter().all(|i| side * mesh.section.points[*i as usize][1] > 0.0), "{seed}: on one side");
        let held = steak.adipose().iter().zip(mesh.graph.volume.iter()).map(|(a, v)| a * v).sum::<f64>();
        assert!((0.01..0.08).contains(&(held / volume(&steak))), "{seed}: {}", held / volume(&steak));
        let plain = piece("beef-lean", &spec([0.12, 0.08, 0.025], seed, 1.0, OutlineKind::Plain));
        assert!(plain.adipose().iter().all(|a| *a == 0.0));
        assert!((steak.raw_mass() / plain.raw_mass() - 1.0).abs() < 0.015, "{seed}");
    }
}

#[test]
fn no_conductance_of_a_natural_piece_is_negative_and_no_more_weights_are_clamped() {
    for (kind, size) in FOODS {
        for seed in 1..9 {
            let model = piece(kind, &spec(size, seed, 1.0, OutlineKind::Natural));
            assert!(model.mesh().graph().shape.iter().all(|s| *s >= 0.0 && s.is_finite()), "{kind}");
            assert!(model.mesh().volumes().iter().all(|v| *v > 0.0), "{kind}");
            let plain = piece(kind, &spec(size, seed, 1.0, OutlineKind::Plain));
            let clamped = [&model, &plain].map(|model| swept_mesh(model).section.clamped_edges);
            // A body along stations conducts by the sections of its stations, not by this one.
            let conducts = swept_mesh(&model).is_upright();
            assert!(!conducts || clamped[0] <= clamped[1], "{kind} {seed}: {clamped:?}");
        }
    }
}

#[test]
fn the_patches_of_a_natural_piece_close_it() {
    for (kind, size) in FOODS {
        let model = natural(kind, size, 4);
        let poses = model.patch_geometry(&FoodState::raw(&model, ZERO_C + 5.0));
        let (mut sum, mut area) = ([0.0; 3], 0.0);
        for (pose, patch) in poses.iter().zip(model.patches()) {
            (0..3).for_each(|k| sum[k] += patch.area * pose.normal[k]);
            area += patch.area;
        }
        assert!(sum.iter().all(|s| s.abs() < 0.02 * area), "{kind}: {sum:?} of {area}");
    }
}

#[test]
fn natural_pieces_keep_their_energy_and_water() {
    for (kind, size) in FOODS {
        let body = natural(kind, size, 3);
        let mut run = Run::new(&body, 5.0);
        let raw = run.state.clone();
        for _ in 0..2 {
            run.fry(40.0, 200.0, 300.0, kitchen_air());
            run.flip();
        }
        run.assert_balanced(&raw, kind);
    }
}

#[test]
fn no_node_of_a_natural_piece_leaves_the_range_of_its_surroundings() {
    for (kind, size) in FOODS {
        let still = saute_food::FreeAir { mass_transfer: 0.0, ..kitchen_air() };
        let body = natural(kind, size, 5);
        let mut run = Run::new(&body, 5.0);
        run.fry(30.0, 95.0, 2000.0, still);
        let (low, high) = run.state.range();
        assert!(low >= ZERO_C + 5.0 - 1e-6 && high <= ZERO_C + 95.0 + 1e-6, "{kind}: {low} {high}");
    }
}

/// Seeds give shrimps of unlike curl.
#[test]
fn shrimps_curl_by_their_seed() {
    let gap = |seed: u64| {
        let shrimp = natural("shrimp", [0.075, 0.016, 0.016], seed);
        let mesh = swept_mesh(&shrimp);
        let centre = |level: usize| mesh.stations().expect("a path")[level].centre;
        let (a, b) = (centre(0), centre(mesh.levels.len() - 1));
        (a[0] - b[0]).hypot(a[1] - b[1])
    };
    let gaps: Vec<f64> = (1..13).map(gap).collect();
    let (low, high) = gaps.iter().fold((f64::INFINITY, 0.0f64), |(l, h), g| (l.min(*g), h.max(*g)));
    assert!(high - low > 0.012, "{gaps:?}");
}
