//! Promise: every form has its size, nodes and faces; collision shapes follow the mesh; the meshes of 2013 have their counts.

use saute_food::{Body, FoodModel, FoodState, MeshSize, OutlineKind, PieceSpec, Rules, Solid, ZERO_C};
use saute_heat::sorted::{Quantile, Sorted};

use crate::run::{FLIPPED, Run, UP, food, kitchen_air, model, piece, swept_mesh};

const FOODS: [(&str, [f64; 3], usize); 7] = [
    ("beef-lean", [0.12, 0.08, 0.025], 840),
    ("beef-marbled", [0.12, 0.08, 0.025], 1207),
    ("beef-patty", [0.10, 0.10, 0.018], 840),
    ("carrot-coin", [0.03, 0.03, 0.008], 54),
    ("carrot-stick", [0.06, 0.01, 0.01], 54),
    ("leek-ring", [0.028, 0.028, 0.012], 85),
    ("shrimp", [0.075, 0.016, 0.016], 119),
];

fn spec(size: [f64; 3], seed: u64, mesh: MeshSize, rules: Rules) -> PieceSpec {
    PieceSpec { size, seed, coarseness: 1.0, mesh, rules, outline: OutlineKind::Plain, pool: None }
}

fn volume(model: &FoodModel) -> f64 {
    model.mesh().volumes().iter().sum()
}

#[test]
fn the_meshes_of_2013_have_the_published_vertices_under_both_rules() {
    for (kind, size, nodes) in FOODS {
        for rules in [Rules::Full, Rules::Paper2013] {
            let coarse = piece(kind, &spec(size, 1, MeshSize::Paper2013, rules));
            assert_eq!(coarse.mesh().node_count(), nodes, "{kind}");
            assert!(coarse.mesh().graph().shape.iter().all(|s| *s >= 0.0 && s.is_finite()), "{kind}");
            let fine = piece(kind, &spec(size, 1, MeshSize::Default, rules));
            assert!(
                (volume(&coarse) / volume(&fine) - 1.0).abs() < 0.15,
                "{kind}: {} {}",
                volume(&coarse),
                volume(&fine)
            );
        }
    }
}

#[test]
fn conductances_are_never_negative_and_every_node_has_a_volume() {
    for (kind, size, _) in FOODS {
        let model = model(kind, 1.0, size);
        assert!(model.mesh().graph().shape.iter().all(|s| *s >= 0.0 && s.is_finite()), "{kind}");
        assert!(model.mesh().volumes().iter().all(|v| *v > 0.0), "{kind}");
    }
}

/// A shrimp of 75 mm weighs 8 to 12 g, has 2,000 nodes or more and layers of 0.4 mm below its skin.
#[test]
fn a_shrimp_has_its_mass_its_nodes_and_its_layers() {
    let shrimp = model("shrimp", 1.0, [0.075, 0.016, 0.016]);
    assert!((8e-3..12e-3).contains(&shrimp.raw_mass()), "{}", shrimp.raw_mass());
    assert!(shrimp.mesh().node_count() >= 2000, "{}", shrimp.mesh().node_count());
    let mut depths: Vec<f64> = shrimp.mesh().depths();
    depths.retain(|d| *d > 1e-6);
    let first = depths.iter().copied().fold(f64::INFINITY, f64::min);
    assert!((0.1e-3..0.41e-3).contains(&first), "{first}");
    let deepest = depths.iter().copied().fold(0.0, f64::max);
    assert!((5.5e-3..7.5e-3).contains(&deepest), "{deepest}");
    assert_eq!(shrimp.mesh().depths()[0], 0.0);
}

/// Length along the curve and thickest diameter are the requested ones.
#[test]
fn a_shrimp_is_as_long_and_as_thick_as_asked() {
    for seed in 1..6 {
        let shrimp = piece("shrimp", &spec([0.06, 0.012, 0.012], seed, MeshSize::Default, Rules::Full));
        assert!((swept_mesh(&shrimp).thickness() / 0.06 - 1.0).abs() < 0.01, "{}", swept_mesh(&shrimp).thickness());
        let depth = |level: usize| {
            let points = &swept_mesh(&shrimp).section_at(level).points;
            let ys = points.iter().map(|p| p[0]);
            ys.clone().fold(0.0, f64::max) - ys.fold(0.0, f64::min)
        };
        let thickest = (0..swept_mesh(&shrimp).levels.len()).map(depth).fold(0.0, f64::max);
        assert!((thickest / 0.012 - 1.0).abs() < 0.06, "{thickest}");
    }
}

/// Outline, mean thickness and extent of a steak are the requested ones; its thickness varies.
#[test]
fn natural_variation_keeps_the_mean_thickness() {
    for (kind, size) in [("beef-lean", [0.12, 0.08, 0.025]), ("beef-patty", [0.10, 0.10, 0.018])] {
        let models: Vec<_> = [1, 2].map(|seed| piece(kind, &spec(size, seed, MeshSize::Default, Rules::Full))).into();
        for model in &models {
            let state = FoodState::raw(model, ZERO_C + 5.0);
            assert!((model.thickness(&state) / size[2] - 1.0).abs() < 1e-9);
            assert!((volume(model) / (swept_mesh(model).section.area() * size[2]) - 1.0).abs() < 1e-9);
            let columns: Vec<f64> =
                (0..swept_mesh(model).nodes_per_level()).map(|i| swept_mesh(model).path.column(i)).collect();
            let low = columns.iter().copied().fold(f64::INFINITY, f64::min);
            let high = columns.iter().copied().fold(0.0, f64::max);
            assert!(high - low > 0.008 && low > 0.94 && high < 1.06, "{low} {high}");
        }
        assert_ne!(models[0].outline().points, models[1].outline().points);
    }
}

/// The lower patches of a slice are the big face that is below; those of a shrimp face downwards.
#[test]
fn what_lies_below_is_what_looks_down() {
    let steak = model("beef-lean", 1.6, [0.12, 0.08, 0.025]);
    let n = swept_mesh(&steak).nodes_per_level();
    assert!(steak.patches_below(UP).eq(0..n));
    assert!(steak.patches_below(FLIPPED).eq(n..2 * n));
    for (kind, size) in [("shrimp", [0.075, 0.016, 0.016]), ("carrot-stick", [0.06, 0.01, 0.01])] {
        let body = model(kind, 1.0, size);
        let below: Vec<usize> = body.patches_below(UP).collect();
        assert!(below.len() > 20 && below.iter().all(|p| body.rest_normals()[*p][2] < -0.7), "{kind}");
        let projected: f64 = below.iter().map(|p| -body.rest_normals()[*p][2] * body.patches()[*p].area).sum();
        assert!(projected > 0.4 * 0.8 * size[0] * size[1] * 0.6, "{kind}: {projected}");
    }
    let standing = steak.patches_below([1.0, 0.0, 0.0]);
    assert!(standing.count() > 3);
}

/// The patches close the body: the sum of area × normal is zero.
#[test]
fn patches_close_the_body() {
    for (kind, size, _) in FOODS {
        let model = model(kind, 1.0, size);
        let poses = model.patch_geometry(&FoodState::raw(&model, ZERO_C + 5.0));
        let mut sum = [0.0; 3];
        let mut area = 0.0;
        for (pose, patch) in poses.iter().zip(model.patches()) {
            (0..3).for_each(|k| sum[k] += patch.area * pose.normal[k]);
            area += patch.area;
            assert!((pose.normal.iter().map(|v| v * v).sum::<f64>() - 1.0).abs() < 1e-9);
        }
        assert!(sum.iter().all(|s| s.abs() < 0.01 * area), "{kind}: {sum:?} of {area}");
    }
}

/// Farthest extent of a collision shape in a direction [m].
fn support(solid: &Solid, d: [f64; 3]) -> f64 {
    let of = |points: &[[f64; 3]]| {
        points.iter().map(|p| p[0] * d[0] + p[1] * d[1] + p[2] * d[2]).fold(f64::NEG_INFINITY, f64::max)
    };
    match solid {
        Solid::Cylinder { radius, half_height } => radius * d[0].hypot(d[1]) + half_height * d[2].abs(),
        Solid::Cuboid { half } => (0..3).map(|k| half[k] * d[k].abs()).sum(),
        Solid::Hulls(hulls) => hulls.iter().map(|h| of(h)).fold(f64::NEG_INFINITY, f64::max),
        Solid::Capsules(rods) => {
            let ends = |rod: &saute_food::Capsule| of(&rod.ends) + rod.radius;
            rods.iter().map(ends).fold(f64::NEG_INFINITY, f64::max)
        }
        Solid::Surface { points, .. } => of(points),
    }
}

/// Collision shapes extend as far as the mesh in every direction, within 0.3 mm, raw and cooked. A shrimp is wider than
/// high, but capsules are round: 0.5 mm below and above. The strips of a steak cut its corners: 1.5 mm.
#[test]
fn solids_follow_the_mesh() {
    for (kind, size, _) in FOODS {
        for seed in [1, 2, 3] {
            let model = piece(kind, &spec(size, seed, MeshSize::Default, Rules::Full));
            let mut state = FoodState::raw(&model, ZERO_C + 5.0);
            state.changed.iter_mut().for_each(|field| field.fill(if seed == 3 { 1.0 } else { 0.0 }));
            state.stretch.lateral = if seed == 3 { 0.93 } else { 1.0 };
            let (solid, mut positions) = (model.solid(&state), Vec::new());
            model.flat_positions_into(&state, &mut positions);
            let steak = matches!(solid, Solid::Hulls(_));
            let within = if steak { 1.5e-3 } else { 0.3e-3 };
            let lying = if kind == "shrimp" { 0.5e-3 } else { 0.3e-3 };
            for up in [UP, FLIPPED] {
                let low = positions.iter().map(|p| p[2] * up[2]).fold(f64::NEG_INFINITY, f64::max);
                let off = support(&solid, up) - low;
                assert!(off.abs() < lying, "{kind} {seed}: it would float or sink by {off}");
            }
            let spiral = (0..400).map(|i| {
                let (z, a) = (1.0 - (f64::from(i) + 0.5) / 200.0, f64::from(i) * 2.399_963);
                let r = (1.0 - z * z).sqrt();
                [r * a.cos(), r * a.sin(), z]
            });
            let sides = [0, 1, 2].map(|k| [-1.0, 1.0].map(|s| [0, 1, 2].map(|i| if i == k { s } else { 0.0 })));
            for d in spiral.chain(sides.into_iter().flatten()) {
                let mesh =
                    positions.iter().map(|p| p[0] * d[0] + p[1] * d[1] + p[2] * d[2]).fold(f64::NEG_INFINITY, f64::max);
                // A box replaces rounded edges by sharp ones: its extent is compared on its six sides.
                let sharp = matches!(solid, Solid::Cuboid { .. }) && d.iter().all(|v| v.abs() < 0.999);
                let off = support(&solid, d) - mesh;
                // The tail fan has no separate capsule; another test covers how the capsules follow the curve.
                assert!(
                    kind == "shrimp" || (off > -within && (sharp || off < within)),
                    "{kind} {seed}: {off} towards {d:?}"
                );
            }
        }
    }
}

/// The capsules of a shrimp follow its curve: every node of its body is within 2.5 mm of one of them.
#[test]
fn rods_of_a_shrimp_follow_its_bow() {
    let shrimp = model("shrimp", 1.0, [0.075, 0.016, 0.016]);
    let state = FoodState::raw(&shrimp, ZERO_C + 5.0);
    let Solid::Capsules(rods) = shrimp.solid(&state) else { panic!("rods") };
    let off = |p: [f64; 3]| {
        let from = |rod: &saute_food::Capsule| {
            let ([a, b], mut d, mut t) = (rod.ends, 0.0, 0.0);
            for k in 0..3 {
                d += (b[k] - a[k]) * (b[k] - a[k]);
                t += (p[k] - a[k]) * (b[k] - a[k]);
            }
            let t = (t / d).clamp(0.0, 1.0);
            (0..3).map(|k| (p[k] - a[k] - t * (b[k] - a[k])).powi(2)).sum::<f64>().sqrt() - rod.radius
        };
        rods.iter().map(from).fold(f64::INFINITY, f64::min)
    };
    let distances = Sorted::new(shrimp.positions(&state).into_iter().map(off).collect());
    // The flat tail fan is wider than its capsule.
    let of_nine = distances.quantile(0.9, Quantile::After).expect("nodes");
    assert!(of_nine < 2.5e-3, "{of_nine}");
}

/// A cooked shrimp is more curled: its ends are closer to each other, and the centre of volume stays at the origin.
#[test]
fn a_shrimp_curls_in_its_present_shape() {
    let shrimp = model("shrimp", 1.6, [0.075, 0.016, 0.016]);
    let mut state = FoodState::raw(&shrimp, ZERO_C + 5.0);
    let gap = |state: &FoodState| {
        let positions = shrimp.positions(state);
        let last = swept_mesh(&shrimp).node(swept_mesh(&shrimp).levels.len() - 1, 0);
        (positions[0][0] - positions[last][0]).hypot(positions[0][1] - positions[last][1])
    };
    let raw = gap(&state);
    let rest: Vec<_> = (0..shrimp.mesh().node_count()).map(|n| shrimp.rest_position(n)).collect();
    let same = shrimp.positions(&state).iter().zip(&rest).all(|(a, b)| (0..3).all(|k| (a[k] - b[k]).abs() < 1e-9));
    assert!(same, "the raw piece has its rest shape");
    state.changed.iter_mut().for_each(|field| field.fill(1.0));
    assert!(gap(&state) < 0.9 * raw, "{raw} -> {}", gap(&state));
    let mut centre = [0.0; 3];
    for (p, v) in shrimp.positions(&state).iter().zip(shrimp.mesh().volumes()) {
        (0..3).for_each(|k| centre[k] += p[k] * v / volume(&shrimp));
    }
    assert!(centre.iter().all(|c| c.abs() < 1e-9), "{centre:?}");
}

/// A shrimp and a stick on a plate keep energy and water in balance, as a steak does.
#[test]
fn curved_bodies_keep_their_energy_and_water() {
    for (kind, size) in
        [("shrimp", [0.075, 0.016, 0.016]), ("carrot-stick", [0.06, 0.01, 0.01]), ("leek-ring", [0.028, 0.028, 0.012])]
    {
        let body = model(kind, 1.6, size);
        let mut run = Run::new(&body, 5.0);
        let raw = run.state.clone();
        for _ in 0..3 {
            run.fry(40.0, 200.0, 300.0, kitchen_air());
            run.flip();
        }
        run.assert_balanced(&raw, kind);
        assert!(run.core() > 30.0, "{kind}: {}", run.core());
    }
}

/// Two tissues of a carrot have their colours, seeded; the stick's core runs along it.
#[test]
fn a_carrot_has_a_core_and_a_leek_sheaths() {
    let coin = model("carrot-coin", 1.0, [0.03, 0.03, 0.008]);
    assert!(coin.tissue_at([0.0, 0.0, 0.004]) > 0.99 && coin.tissue_at([0.013, 0.0, 0.004]) < 0.01);
    let share = coin.second_tissue().iter().sum::<f64>() / coin.second_tissue().len() as f64;
    assert!((0.08..0.5).contains(&share), "{share}");
    let stick = model("carrot-stick", 1.0, [0.06, 0.01, 0.01]);
    let along = |x: f64| [-0.004, -0.002, 0.0, 0.002, 0.004].map(|y| stick.tissue_at([x, y, 0.0]));
    assert_eq!(along(-0.02), along(0.02));
    let leek = model("leek-ring", 1.0, [0.028, 0.028, 0.012]);
    let sheaths: Vec<usize> = (0..14).map(|mm| leek.tissue_field().sheath([f64::from(mm) * 1e-3, 0.0, 0.0])).collect();
    assert!(sheaths.windows(2).all(|w| w[1] >= w[0]) && sheaths[13] >= 4, "{sheaths:?}");
}

/// Heat crosses a leek's sheaths less well than it runs along them: 0.35–0.45 against 0.55 W/(m·K).
#[test]
fn sheath_borders_lower_the_conductivity_across_to_the_measured_range() {
    let leek = model("leek-ring", 0.6, [0.028, 0.028, 0.012]);
    let plain = 0.55;
    let (mut through, mut free) = (0.0, 0.0);
    let steps = 400;
    for i in 0..steps {
        let at = |k: i32| [0.013 * f64::from(k) / f64::from(steps), 0.0, 0.006];
        through += 1.0 / leek.tissue_field().share_across([at(i), at(i + 1)], plain);
        free += 1.0;
    }
    let across = plain * free / through;
    assert!((0.34..0.47).contains(&across), "{across}");
}

/// No allowed size gives a mesh with slivers: the stable step of every raw node is at least 20 ms.
#[test]
fn meshes_of_all_sizes_allow_long_steps() {
    for (kind, default, _) in FOODS {
        let range = model(kind, 2.5, default).description().size.clone();
        let form = model(kind, 2.5, default).description().form;
        for corner in 0..8usize {
            let pick = |axis: usize| if corner >> axis & 1 == 0 { range.min_mm[axis] } else { range.max_mm[axis] };
            let mm: Vec<f64> = (0..range.min_mm.len()).map(pick).collect();
            let size = form.extent(&mm).expect("dimensions").map(|v| 1e-3 * v);
            for (seed, mesh, coarseness) in
                [(1, MeshSize::Paper2013, 1.0), (2, MeshSize::Default, 2.5), (3, MeshSize::Default, 2.5)]
            {
                let piece = piece(
                    kind,
                    &PieceSpec {
                        size,
                        seed,
                        coarseness,
                        mesh,
                        rules: Rules::Full,
                        outline: OutlineKind::Plain,
                        pool: None,
                    },
                );
                assert!(shortest_step(&piece) > 0.02, "{kind} {size:?} {mesh:?}: {}", shortest_step(&piece));
            }
        }
    }
    // The sizes that once folded or left slivers on the hull of a wavy outline.
    let once = [("carrot-stick", [0.0403, 0.0044, 0.0273], 20), ("shrimp", [0.0388, 0.0238, 0.0238], 51)];
    for (kind, size, seed) in once {
        let piece = piece(kind, &spec(size, seed, MeshSize::Default, Rules::Full));
        assert!(shortest_step(&piece) > 0.02, "{kind}: {}", shortest_step(&piece));
    }
}

/// Stable step [s]: least heat capacity over the sum of conductances, with 3.7 MJ/(m³·K) and 0.52 W/(m·K).
fn shortest_step(model: &FoodModel) -> f64 {
    let mut conduction = saute_heat::Conduction::default();
    let graph = model.mesh().graph();
    conduction.refresh(graph, &vec![0.52; graph.volume.len()]);
    conduction.stable_step(&graph.volume.iter().map(|v| 3.7e6 * v).collect::<Vec<_>>())
}

/// A request is checked before a mesh is built: the estimate must be valid for every form, size and fineness.
#[test]
fn the_nodes_of_a_piece_are_known_within_a_fifth_before_it_is_meshed() {
    for (kind, size, _) in FOODS {
        let food = food(kind);
        for (scale, coarseness) in [(1.0, 0.5), (1.0, 1.0), (1.0, 2.0), (1.0, 8.0), (1.25, 1.0)] {
            for outline in [OutlineKind::Plain, OutlineKind::Natural] {
                let size = size.map(|length| scale * length);
                let spec = PieceSpec { coarseness, outline, ..spec(size, 7, MeshSize::Default, Rules::Full) };
                let (estimated, built) = (Body::estimated_nodes(&food, &spec), Body::cut(&food, &spec));
                let (estimated, built) = (estimated.expect("a form"), built.expect("meshes").mesh.node_count() as f64);
                println!("{kind} {coarseness} {outline:?}: {built} nodes, estimated {estimated:.0}");
                assert!((estimated / built - 1.0).abs() < 0.2, "{kind} {coarseness}: {built}, estimated {estimated}");
            }
        }
        let coarse = spec(size, 1, MeshSize::Paper2013, Rules::Full);
        let exact = Body::cut(&food, &coarse).expect("meshes").mesh.node_count();
        assert_eq!(Body::estimated_nodes(&food, &coarse).expect("a form"), exact as f64);
    }
}

/// A mushroom has hollows beside its stem: on the rings of 2013 no node lies in them.
#[test]
fn a_slice_with_hollows_has_a_volume_at_every_node_of_either_mesh() {
    for mesh in [MeshSize::Default, MeshSize::Paper2013] {
        let model = piece("mushroom-slice", &spec([0.046, 0.040, 0.0042], 1, mesh, Rules::Full));
        assert!(model.mesh().volumes().iter().all(|v| *v > 0.0), "{mesh:?}");
    }
}
