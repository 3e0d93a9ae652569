//! Promise: the lab agrees with closed-form solutions on slabs, cylinders, spheres and boxes with any boundary, at
//! second order in space and time, and explains bad cases. Values: series in Carslaw & Jaeger (1959), recomputed.

use saute_kitchen::Library;
use saute_lab::exact::robin_slab_centre;
use saute_lab::{Case, LabReport, run};

fn case(text: &str) -> Case {
    let library = Library::embedded().expect("embedded data");
    Case::parse(text, "case.toml", &library).unwrap_or_else(|e| panic!("{e}"))
}

fn solve(text: &str) -> LabReport {
    run(&case(text), || 0.0)
}

fn at(report: &LabReport, probe: &str, time: f64) -> f64 {
    let series = &report.probes[probe];
    series.iter().find(|[t, _]| (t - time).abs() < 1e-6).unwrap_or_else(|| panic!("{probe} at {time}: {series:?}"))[1]
}

const MEAT: &str =
    "[material]\nconductivity_w_mk = 0.48\ndensity_kg_m3 = 1000\nspecific_heat_j_kgk = 3692.307692307692\n";

/// Step of the surface temperature, θ at the centre at Fo 0.05, 0.1, 0.2, 0.5, 1 (α = 1.3e-7, L = 10 mm, 0 → 1 K scaled to 0 → 100 °C).
#[test]
#[expect(clippy::approx_constant, reason = "the series of the sphere, not a root of two")]
fn centres_follow_the_series_after_a_step_of_the_surface() {
    let expected = [
        ("slab", "size_mm = [20]", "[10]", [0.99687, 0.94931, 0.77231, 0.37078, 0.10798]),
        ("cylinder", "size_mm = [20, 400]", "[0, 0, 200]", [0.98710, 0.84836, 0.50149, 0.08889, 0.00493]),
        ("sphere", "size_mm = [20]", "[0, 0, 0]", [0.96600, 0.70710, 0.27708, 0.01438, 0.00010]),
    ];
    let unit = 1e-4 / 1.3e-7;
    for (shape, size, place, thetas) in expected {
        let face = if shape == "cylinder" { "side" } else { "all" };
        let text = format!(
            "duration_s = {unit}\noutput_every_s = {}\n[body]\nshape = \"{shape}\"\n{size}\nresolution_mm = 0.5\ninitial_c = 0\n{MEAT}\
             [[boundary]]\nface = \"{face}\"\nfixed = true\nambient_c = 100\n[[probe]]\nname = \"centre\"\nat_mm = {place}\n",
            unit * 0.05
        );
        let report = solve(&text);
        for (fo, theta) in [0.05, 0.1, 0.2, 0.5, 1.0].into_iter().zip(thetas) {
            let got = 1.0 - at(&report, "centre", unit * fo) / 100.0;
            assert!((got - theta).abs() < 0.005, "{shape} at Fo {fo}: {got}, series {theta}");
        }
    }
}

fn brick(resolution: &str) -> String {
    format!(
        "duration_s = 600\noutput_every_s = 60\n[body]\nshape = \"box\"\nsize_mm = [40, 30, 20]\nresolution_mm = {resolution}\ninitial_c = 10\n{MEAT}\
         [[boundary]]\nface = \"x\"\nh_w_m2k = 500\nambient_c = 150\n[[boundary]]\nface = \"y\"\nh_w_m2k = 100\nambient_c = 150\n\
         [[boundary]]\nface = \"z\"\nh_w_m2k = 50\nambient_c = 150\n\
         [[probe]]\nname = \"centre\"\nat_mm = [20, 15, 10]\n[[probe]]\nname = \"corner\"\nat_mm = [0, 0, 0]\n"
    )
}

/// Brick with another coefficient on each axis: the product of three slabs.
#[test]
fn a_brick_with_three_coefficients_follows_the_product_solution() {
    let report = solve(&brick("1.0"));
    for (t, centre, corner) in
        [(60.0, 10.3791, 139.0022), (180.0, 23.0288, 145.9898), (300.0, 46.6362, 147.6976), (600.0, 98.4576, 149.1059)]
    {
        assert!((at(&report, "centre", t) - centre).abs() < 0.1, "centre at {t}: {}", at(&report, "centre", t));
        assert!((at(&report, "corner", t) - corner).abs() < 0.1, "corner at {t}: {}", at(&report, "corner", t));
    }
    assert!(report.min_c >= 10.0 - 1e-6 && report.max_c <= 150.0 + 1e-6, "{} {}", report.min_c, report.max_c);
}

#[test]
fn the_error_falls_at_second_order_with_the_spacing() {
    let unit = 1e-4 / 1.3e-7;
    let error = |resolution: f64| {
        let report = solve(&format!(
            "duration_s = {}\n[body]\nshape = \"slab\"\nsize_mm = [20]\nresolution_mm = {resolution}\ninitial_c = 0\n{MEAT}\
             [[boundary]]\nface = \"all\"\nh_w_m2k = 240\nambient_c = 100\n[[probe]]\nname = \"centre\"\nat_mm = [10]\n",
            0.2 * unit
        ));
        (at(&report, "centre", 0.2 * unit) - 100.0 * (1.0 - robin_slab_centre(5.0, 0.2))).abs()
    };
    let orders: Vec<f64> = [0.4, 0.2].iter().map(|r| (error(*r) / error(0.5 * r)).log2()).collect();
    assert!(orders.iter().all(|o| (1.8..=2.2).contains(o)), "{orders:?}");
}

/// Thiffeault 2022: 10 mm patty, plate 200 °C (h 900), air 25 °C (h 60), done when every point has reached 70 °C:
/// never flipped 283.5 s, flipped at 37.4 s 80.7 s, every 10 s 71.0 s.
#[test]
fn the_burger_is_done_when_the_mathematics_of_flipping_says() {
    for (flips, expected) in [
        ("", 283.5),
        ("[flips]\nat_s = [37.4]\n", 80.7),
        ("[flips]\nevery_s = 10\n", 71.0),
        ("[flips]\nevery_s = 30\n", 78.25),
    ] {
        let report = solve(&format!(
            "duration_s = 600\n[body]\nshape = \"slab\"\nsize_mm = [10]\nresolution_mm = 0.2\ninitial_c = 25\n\
             [material]\nconductivity_w_mk = 0.41667\ndensity_kg_m3 = 1000\nspecific_heat_j_kgk = 3472.2\n\
             [[boundary]]\nface = \"top\"\nh_w_m2k = 60\nambient_c = 25\n[[boundary]]\nface = \"bottom\"\nh_w_m2k = 900\nambient_c = 200\n\
             {flips}[stop]\nwhen_every_point_has_reached_c = 70\n"
        ));
        let done = report.stopped_at_s.expect("done");
        assert!((done / expected - 1.0).abs() < 0.015, "{flips:?}: {done} s, published {expected} s");
    }
}

#[test]
fn heat_taken_up_is_heat_stored_and_a_flip_of_equal_faces_changes_nothing() {
    let text = |flips: &str| {
        format!(
            "duration_s = 300\n[body]\nshape = \"slab\"\nsize_mm = [20]\nresolution_mm = 0.5\ninitial_c = 20\n{MEAT}\
             [[boundary]]\nface = \"all\"\nh_w_m2k = 200\nambient_c = 120\n{flips}[[probe]]\nname = \"centre\"\nat_mm = [10]\n\
             [report]\nvolume_above_c = [20, 119.9]\n"
        )
    };
    let (still, flipped) = (solve(&text("")), solve(&text("[flips]\nevery_s = 7\n")));
    assert!((at(&still, "centre", 300.0) - at(&flipped, "centre", 300.0)).abs() < 1e-3);
    assert!(still.absorbed_j > 0.0 && still.absorbed_j < 100.0 * 0.02 * 3.692307692e6);
    assert_eq!((still.volume_pct_above["20"], still.volume_pct_above["119.9"]), (100.0, 0.0));
}

/// Halving every step quarters what steps alone do to a slab, against steps a hundred times shorter.
#[test]
fn the_error_falls_at_second_order_with_the_step() {
    let centre = |factor: f64| {
        let report = solve(&format!(
            "duration_s = 150\n[body]\nshape = \"slab\"\nsize_mm = [20]\nresolution_mm = 1\ninitial_c = 0\n{MEAT}\
             [solver]\nstep_factor = {factor}\n\
             [[boundary]]\nface = \"all\"\nh_w_m2k = 240\nambient_c = 100\n[[probe]]\nname = \"centre\"\nat_mm = [10]\n"
        ));
        at(&report, "centre", 150.0)
    };
    let exact = centre(0.01);
    // Steps short enough for the same number of stages, on which the constant of the error depends.
    let errors = [1.0, 0.5, 0.25].map(|f| (centre(f) - exact).abs());
    let orders: Vec<f64> = errors.windows(2).map(|w| (w[0] / w[1]).log2()).collect();
    assert!(orders.iter().all(|o| *o >= 1.8), "{orders:?} {errors:?}");
}

/// The steak-shaped brick of the format's own example at its own resolution: values from the eigenfunction expansion.
#[test]
fn the_flipped_brick_is_within_a_tenth_of_a_kelvin_at_1_5_mm() {
    let report = solve(&format!("{FLIPPED_BRICK}[solver]\nstep_factor = 4\n"));
    let exact = [
        ("centre", [10.6591, 27.6842, 46.5346, 66.5224]),
        ("low", [106.6758, 126.5504, 88.5359, 72.5154]),
        ("high", [6.6164, 9.1246, 111.6728, 134.2730]),
    ];
    for (probe, values) in exact {
        for (t, value) in [150.0, 300.0, 450.0, 600.0].into_iter().zip(values) {
            let got = at(&report, probe, t);
            assert!((got - value).abs() <= 0.1, "{probe} at {t} s: {got}, exact {value}");
        }
    }
    assert!(report.min_c >= 5.0 - 1e-6 && report.max_c <= 180.0, "{} {}", report.min_c, report.max_c);
}

const FLIPPED_BRICK: &str = "duration_s = 600\noutput_every_s = 150\n[body]\nshape = \"box\"\nsize_mm = [100, 70, 25]\n\
    resolution_mm = 1.5\ninitial_c = 5\n[material]\nconductivity_w_mk = 0.49\ndensity_kg_m3 = 1058\n\
    specific_heat_j_kgk = 3590\n[[boundary]]\nface = \"all\"\nh_w_m2k = 15\nambient_c = 25\n\
    [[boundary]]\nface = \"bottom\"\nh_w_m2k = 500\nambient_c = 180\n[flips]\nat_s = [300]\n\
    [[probe]]\nname = \"centre\"\nat_mm = [50, 35, 12.5]\n[[probe]]\nname = \"low\"\nat_mm = [50, 35, 2.5]\n\
    [[probe]]\nname = \"high\"\nat_mm = [50, 35, 22.5]\n";

/// Without grading a box of cubes has the same conductances under both rules but at its edges, where segments take
/// half and quarter cells for thinner rods than they are.
#[test]
fn segments_are_right_on_cubes_alone() {
    let error = |rule: &str, grading: f64| {
        let report = solve(&format!(
            "{}[solver]\nrule = \"{rule}\"\nstep_factor = 8\n",
            brick("2.0").replace("initial_c = 10", &format!("initial_c = 10\ngrading = {grading}"))
        ));
        (at(&report, "centre", 300.0) - 46.6362).abs()
    };
    let errors = [("shape-functions", 0.0), ("shape-functions", 1.5), ("segments", 0.0), ("segments", 1.5)];
    let [even, graded, even_segments, graded_segments] = errors.map(|(rule, grading)| error(rule, grading));
    assert!(even < 0.5 && graded < 0.5, "{even} {graded}");
    assert!(even_segments < 3.0 && graded_segments > 5.0, "{even_segments} {graded_segments}");
}

/// Two half-spaces in perfect contact: the interface is at (b₁T₁ + b₂T₂)/(b₁ + b₂) with b = √(kρc) at all times.
#[test]
fn stacked_bodies_meet_at_the_temperature_of_their_effusivities() {
    let slab = |initial: f64| {
        format!(
            "[[body]]\nshape = \"slab\"\nsize_mm = [30]\nresolution_mm = 0.5\ngrading = 1.5\ninitial_c = {initial}\n"
        )
    };
    let text = format!(
        "duration_s = 20\noutput_every_s = 10\n{}{}[[material]]\nconductivity_w_mk = 0.5\ndensity_kg_m3 = 1000\nspecific_heat_j_kgk = 3600\n\
         [[material]]\nconductivity_w_mk = 2\ndensity_kg_m3 = 1000\nspecific_heat_j_kgk = 3600\n\
         [[probe]]\nname = \"interface\"\nat_mm = [30]\nflux = true\n",
        slab(10.0),
        slab(100.0)
    );
    let report = solve(&text);
    for t in [10.0, 20.0] {
        assert!((at(&report, "interface", t) - 70.0).abs() < 0.05, "{}", at(&report, "interface", t));
    }
    let down = (0.5 * 3.6e6_f64).sqrt() * 60.0 / (std::f64::consts::PI * 20.0).sqrt();
    let flux = report.flux["interface"].last().expect("read")[1];
    assert!((flux / -down - 1.0).abs() < 0.01, "{flux} {down}");
    assert!(report.absorbed_j.abs() < 1.0, "{}", report.absorbed_j);
    let apart = text.replacen("initial_c = 100\n", "initial_c = 100\ncontact_h_w_m2k = 1e-3\n", 1);
    assert!((at(&solve(&apart), "interface", 20.0) - 100.0).abs() < 0.01);
}

/// One-phase Stefan problem: crust 2λ√(αt) with λ e^(λ²) erf λ √π = c ΔT / L', here λ from tables of the case.
#[test]
fn an_evaporation_front_follows_the_square_root_of_time() {
    let crust = |duration: f64| {
        let report = solve(&format!(
            "duration_s = {duration}\n[body]\nshape = \"slab\"\nsize_mm = [5]\nresolution_mm = 0.1\ninitial_c = 100\n\
             [material]\nconductivity_w_mk = 0.12\ndensity_kg_m3 = 900\nspecific_heat_j_kgk = 1000\nwater_kg_m3 = 735\n\
             boiling_c = 100\nlatent_j_kg = 2.257e6\ncrust_conductivity_w_mk = 0.12\n\
             [[boundary]]\nface = \"bottom\"\nfixed = true\nambient_c = 200\n"
        ));
        let (crust, vapour) = (report.crust_mm.expect("a slab"), report.evaporated_kg_m2.expect("a slab"));
        assert!((vapour / (735.0 * crust * 1e-3) - 1.0).abs() < 1e-9);
        let sensible = report.absorbed_j - vapour * 2.257e6;
        assert!(sensible > 0.0 && sensible < 9e5 * 100.0 * crust * 1e-3, "{sensible}");
        crust
    };
    assert!((crust(300.0) / 2.065 - 1.0).abs() < 0.03, "{}", crust(300.0));
    assert!((crust(300.0) / crust(75.0) - 2.0).abs() < 0.06);
}

#[test]
fn a_wet_surface_stays_at_its_boiling_point_while_water_is_made_up_for() {
    let report = solve(&format!(
        "duration_s = 120\n[body]\nshape = \"box\"\nsize_mm = [30, 30, 10]\nresolution_mm = 2\ninitial_c = 20\n{MEAT}\
         juice = \"unlimited\"\n[[boundary]]\nface = \"bottom\"\nh_w_m2k = 900\nambient_c = 240\n"
    ));
    assert!(report.max_c <= 100.0 + 1e-9 && report.evaporated_g.expect("boils") > 1.0);
}

#[test]
fn a_pan_alone_warms_with_its_time_constant_and_shares_its_heat_with_cold_food() {
    let alone = solve(
        "duration_s = 100\n[pan]\nkind = \"carbon-steel-26\"\nq_w_m2 = 20000\nh_w_m2k = 30\nambient_c = 20\ninitial_c = 20\n",
    );
    let tau = 7850.0 * 490.0 * 2.5e-3 / 30.0;
    let expected = 20.0 + 20000.0 / 30.0 * (1.0 - (-100.0_f64 / tau).exp());
    assert!((at(&alone, "pan", 100.0) / expected - 1.0).abs() < 1e-4, "{}", at(&alone, "pan", 100.0));
    let both = solve(&format!(
        "duration_s = 3000\n[pan]\nthickness_mm = 2.5\ndensity_kg_m3 = 7850\nspecific_heat_j_kgk = 470\ninitial_c = 200\n\
         [body]\nshape = \"slab\"\nsize_mm = [20]\ninitial_c = 5\n{MEAT}[[probe]]\nname = \"top\"\nat_mm = [20]\n"
    ));
    let (pan, food) = (7850.0 * 470.0 * 2.5e-3, 0.02 * 1000.0 * 3692.307692307692);
    let mean = (pan * 200.0 + food * 5.0) / (pan + food);
    for probe in ["pan", "top"] {
        assert!((at(&both, probe, 3000.0) / mean - 1.0).abs() < 1e-3, "{probe}: {}", at(&both, probe, 3000.0));
    }
}

#[test]
fn a_phase_ends_when_its_probe_gets_there_and_the_core_still_rises() {
    let report = solve(&format!(
        "duration_s = 900\n[body]\nshape = \"slab\"\nsize_mm = [25]\ninitial_c = 20\n{MEAT}\
         [[phase]]\nuntil = {{ probe = \"centre\", reaches_c = 50 }}\n[[phase.boundary]]\nface = \"all\"\nh_w_m2k = 300\nambient_c = 180\n\
         [[phase]]\n[[phase.boundary]]\nface = \"all\"\nh_w_m2k = 15\nambient_c = 22\n\
         [[probe]]\nname = \"centre\"\nat_mm = [12.5]\n[report]\npeak_of = \"centre\"\n"
    ));
    assert!((report.phases_ended_s[0] - 263.7).abs() < 0.3, "{:?}", report.phases_ended_s);
    assert!((report.core_peak_c.expect("asked for") - 80.4).abs() < 0.1, "{:?}", report.core_peak_c);
    assert!(report.core_peak_at_s.expect("asked for") > 400.0);
}

#[test]
fn bad_cases_are_refused_with_line_and_remedy() {
    let library = Library::embedded().expect("embedded data");
    let good = brick("2.0");
    for (from, to) in [
        ("conductivity_w_mk = 0.48", "conductivity_w_mk = -1"),
        ("density_kg_m3 = 1000", "density_kg_m3 = nan"),
        ("size_mm = [40, 30, 20]", "size_mm = [40, 30, 0]"),
        ("size_mm = [40, 30, 20]", "size_mm = [40, 30]"),
        ("resolution_mm = 2.0", "resolution_mm = 0.01"),
        ("face = \"x\"", "face = \"left\""),
        ("at_mm = [20, 15, 10]", "at_mm = [20, 15, 30]"),
        ("h_w_m2k = 500", "h_w_m2k = -500"),
        ("h_w_m2k = 500\n", ""),
        ("shape = \"box\"", "shape = \"cone\""),
        ("duration_s = 600", "duration_s = 0"),
        ("initial_c = 10", "initial = 10"),
        ("initial_c = 10", "initial_c = 10\ncontact_h_w_m2k = 100"),
        ("initial_c = 10", "initial_c = nan"),
        ("resolution_mm = 2.0", "resolution_mm = [2.0, 1.0]"),
        ("resolution_mm = 2.0", "resolution_mm = [2.0, 1.0, 20.0]"),
        ("conductivity_w_mk = 0.48", "conductivity_w_mk = 0.48\nboiling_c = 100"),
        ("conductivity_w_mk = 0.48", "conductivity_w_mk = 0.48\nwater_kg_m3 = -3"),
        ("[material]", "[solver]\nphysics = \"magic\"\n[material]"),
        ("[material]", "[solver]\nstep_factor = 0\n[material]"),
        ("[material]", "[pan]\nkind = \"wok\"\ninitial_c = 20\n[material]"),
        ("[material]", "[pan]\ninitial_c = 20\n[material]"),
        ("[material]", "[report]\npeak_of = \"nobody\"\n[material]"),
        ("[material]", "[stop]\nwhen_every_point_has_reached_c = inf\n[material]"),
        ("[material]", "[[phase]]\n[[phase]]\n[material]"),
        ("[material]", "[[phase]]\nuntil = { probe = \"nobody\", reaches_c = 3 }\n[material]"),
        ("[body]", "[[body]]\nshape = \"slab\"\nsize_mm = [3]\ninitial_c = 3\n[[body]]"),
        ("[[boundary]]\nface = \"x\"", "[[boundary]]\nface = \"z\"\nq_w_m2 = nan\n[[boundary]]\nface = \"x\""),
    ] {
        assert!(good.contains(from), "{from}");
        let error = Case::parse(&good.replacen(from, to, 1), "case.toml", &library).map(|_| ()).expect_err(to);
        assert!(error.line >= 1 && !error.remedy.is_empty() && error.to_string().starts_with("case.toml:"), "{error}");
    }
}
