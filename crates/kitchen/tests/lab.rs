//! Promise: the lab agrees with closed-form solutions on slabs, cylinders, spheres and boxes with any boundary, at
//! second order in space and time, and explains bad cases. Values: series in Carslaw & Jaeger (1959), recomputed.

use saute_kitchen::Library;
use saute_kitchen::lab::{Case, LabReport, run};

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

/// θ at the centre of a slab of half thickness L with Bi = hL/k: Σ C exp(−ζ² Fo), ζ tan ζ = Bi.
fn slab_centre(bi: f64, fo: f64) -> f64 {
    let term = |n: u32| {
        let (mut low, mut high) = (f64::from(n) * std::f64::consts::PI, (f64::from(n) + 0.5) * std::f64::consts::PI);
        for _ in 0..200 {
            let middle = 0.5 * (low + high);
            if middle * middle.tan() < bi { low = middle } else { high = middle }
        }
        4.0 * low.sin() / (2.0 * low + (2.0 * low).sin()) * (-low * low * fo).exp()
    };
    (0..40).map(term).sum()
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
        (at(&report, "centre", 0.2 * unit) - 100.0 * (1.0 - slab_centre(5.0, 0.2))).abs()
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
    ] {
        assert!(good.contains(from), "{from}");
        let error = Case::parse(&good.replacen(from, to, 1), "case.toml", &library).map(|_| ()).expect_err(to);
        assert!(error.line >= 1 && !error.remedy.is_empty() && error.to_string().starts_with("case.toml:"), "{error}");
    }
}
