//! Promise: the lab cooks plain bodies of food between given boundaries with the same physics as the pan.

use saute_kitchen::Library;
use saute_lab::{Case, LabReport, run};

fn case(text: &str) -> Result<Case, String> {
    let library = Library::embedded().expect("embedded data");
    Case::parse(text, "case.toml", &library).map_err(|e| e.to_string())
}

fn solve(text: &str) -> LabReport {
    run(&case(text).unwrap_or_else(|e| panic!("{e}")), || 0.0)
}

/// A 25 mm slab of lean beef from 5 °C on a plate at 180 °C.
fn slab(flips: &str, boundary: &str, more: &str) -> String {
    format!(
        "duration_s = 1500\n[body]\nshape = \"slab\"\nsize_mm = [25]\nresolution_mm = 1\ninitial_c = 5\n\
         [material]\nfood = \"beef-lean\"\n[solver]\nphysics = \"cooking\"\n\
         [[boundary]]\nface = \"top\"\nh_w_m2k = 8\nambient_c = 40\n[[boundary]]\nface = \"bottom\"\n{boundary}\n\
         {flips}\n[[probe]]\nname = \"centre\"\nat_mm = [12.5]\n{more}"
    )
}

const PLATE: &str = "contact = \"pan\"\nambient_c = 180";

/// Where nothing boils, evaporates or contracts, cooking is conduction with the food's own properties.
#[test]
fn below_any_change_cooking_is_conduction() {
    let body = |physics: &str| {
        format!(
            "duration_s = 300\n[body]\nshape = \"box\"\nsize_mm = [40, 30, 20]\nresolution_mm = 2\ninitial_c = 5\n\
             [material]\nfood = \"shrimp\"\n[solver]\nphysics = \"{physics}\"\n[[boundary]]\nface = \"all\"\n\
             h_w_m2k = 500\nambient_c = 35\n[[probe]]\nname = \"centre\"\nat_mm = [20, 15, 10]\n"
        )
    };
    let [conduction, cooking] = ["conduction", "cooking"].map(|p| solve(&body(p)).probes["centre"][1][1]);
    assert!((conduction - cooking).abs() < 0.1, "{conduction} {cooking}");
}

/// One-dimensional reference computation (enthalpy, boiling at 100 °C, contact 500 falling to 300 W/(m²·K), no juice, no
/// losses): 622 s to a core of 50 °C with one flip at 240 s, 499 s with flips every 60 s.
#[test]
fn the_times_of_the_reference_computation_come_out() {
    let time = |flips: &str| {
        let pulled = "[[phase]]\nuntil = { probe = \"centre\", reaches_c = 50 }\n[[phase]]\n";
        solve(&slab(flips, PLATE, pulled)).phases_ended_s[0]
    };
    let (once, often) = (time("[flips]\nat_s = [240]"), time("[flips]\nevery_s = 60"));
    assert!((once / 622.0 - 1.0).abs() < 0.10, "{once}");
    assert!((often / 499.0 - 1.0).abs() < 0.10, "{often}");
}

#[test]
fn the_report_tells_water_peak_and_colour() {
    let report = solve(&slab("[flips]\nat_s = [240]", PLATE, ""));
    let evaporated = report.evaporated_kg_m2.expect("a slab");
    assert!((0.8..6.0).contains(&evaporated), "{evaporated}");
    assert!((report.evaporated_g.expect("g") - 1e3 * evaporated).abs() < 1e-9);
    assert!(report.dripped_g.is_some() && report.lost_pct.is_some_and(|l| (2.0..35.0).contains(&l)));
    let peak = report.core_peak_c.expect("peak");
    assert!(peak > 60.0 && report.core_peak_at_s.is_some_and(|t| t > 600.0), "{peak}");
    let (bottom, top) = (report.surface_lab["bottom"], report.surface_lab["top"]);
    assert!(bottom[0] < 50.0 && top[0] < 35.0, "{bottom:?} {top:?}");
}

/// The same face in air loses vapour, under a solid or a liquid it does not.
#[test]
fn air_takes_up_vapour_and_a_solid_does_not() {
    let lost = |contact: &str| {
        let boundary = format!("h_w_m2k = 50\nambient_c = 60\n{contact}");
        solve(&slab("", &boundary, "")).evaporated_kg_m2.expect("a slab")
    };
    let (solid, air, plain) = (lost("contact = \"solid\""), lost("contact = \"air\""), lost(""));
    assert!(air > 1.3 * solid && (air - plain).abs() < 1e-12, "{solid} {air} {plain}");
}

/// A ball and a cylinder, as a dumpling and a shrimp in boiling water: the surface nears 100 °C, the middle follows.
#[test]
fn balls_and_cylinders_cook_from_all_sides() {
    let body = |shape: &str, size: &str, place: &str, food: &str| {
        format!(
            "duration_s = 240\noutput_every_s = 60\n[body]\nshape = \"{shape}\"\nsize_mm = {size}\ninitial_c = 5\n\
             [material]\nfood = \"{food}\"\n[solver]\nphysics = \"cooking\"\n[[boundary]]\nface = \"all\"\nh_w_m2k = 1000\n\
             ambient_c = 100\n[[probe]]\nname = \"axis\"\nat_mm = {place}\n"
        )
    };
    let shrimp = solve(&body("cylinder", "[14, 70]", "[0, 0, 35]", "shrimp"));
    // The plain cylinder of the same diameter reaches 70 °C at 116.5 s, 80 °C at 145.9 s; contraction makes it sooner.
    assert!((60.0..82.0).contains(&shrimp.probes["axis"][2][1]), "{:?}", shrimp.probes["axis"]);
    let ball = solve(&body("sphere", "[20]", "[0, 0, 0]", "beef-patty"));
    let series = &ball.probes["axis"];
    assert!(series.windows(2).all(|w| w[1][1] >= w[0][1]) && series[4][1] > 80.0 && ball.max_c < 100.5, "{series:?}");
}

#[test]
fn bad_cooking_cases_say_what_to_write() {
    let bad = [
        (slab("", PLATE, "").replace("food = \"beef-lean\"", "food = \"dumpling\""), "is not a food"),
        (slab("", PLATE, "").replace("physics = \"cooking\"", ""), "contact is only valid for cooking"),
        (slab("", "q_w_m2 = 1000", ""), "q_w_m2 is not supported"),
        (
            slab("", "h_w_m2k = 9\nambient_c = 9", "").replace(
                "food = \"beef-lean\"",
                "conductivity_w_mk = 0.5\ndensity_kg_m3 = 1000\nspecific_heat_j_kgk = 3600",
            ),
            "one body of one food",
        ),
    ];
    for (text, expected) in bad {
        let error = case(&text).expect_err("is refused");
        assert!(error.contains(expected), "{error}");
    }
}

/// Thin bodies have layers of micrometres: the tick is divided until they are stable.
#[test]
fn thin_bodies_stay_sound() {
    let text = "duration_s = 10\n[body]\nshape = \"slab\"\nsize_mm = [0.5]\ninitial_c = 5\n[material]\nfood = \"beef-lean\"\n\
                [solver]\nphysics = \"cooking\"\n[[boundary]]\nface = \"all\"\nh_w_m2k = 500\nambient_c = 180\n";
    let report = solve(text);
    assert!(report.warnings.is_empty() && report.max_c < 180.1 && report.min_c >= 4.9, "{report:?}");
    assert!(report.absorbed_j.is_finite() && report.lost_pct.is_some_and(|l| l > 20.0), "{report:?}");
}

/// Segments change conduction alone: juice, fat and contraction go on.
#[test]
fn segments_cook_with_all_other_physics() {
    let lost = |rule: &str| {
        let text = slab("", "h_w_m2k = 500\nambient_c = 90", "");
        let report = solve(&text.replace("[solver]\n", &format!("[solver]\nrule = \"{rule}\"\n")));
        (report.dripped_g.expect("juice"), report.section_shrunk_pct.expect("contraction"))
    };
    let (shapes, segments) = (lost("shape-functions"), lost("segments"));
    assert!(shapes.0 > 100.0 && segments.0 > 100.0 && segments.1 > 1.0, "{shapes:?} {segments:?}");
}

/// Each pair of sides has its own air: the warmer one is nearer to its air.
#[test]
fn every_side_of_a_box_meets_its_own_air() {
    let text = "duration_s = 60\n[body]\nshape = \"box\"\nsize_mm = [30, 30, 30]\ninitial_c = 20\n\
                [material]\nfood = \"beef-lean\"\n[solver]\nphysics = \"cooking\"\n\
                [[boundary]]\nface = \"x\"\nh_w_m2k = 80\nambient_c = 150\n\
                [[boundary]]\nface = \"y\"\nh_w_m2k = 10\nambient_c = 20\n\
                [[probe]]\nname = \"x\"\nat_mm = [0, 15, 15]\n[[probe]]\nname = \"y\"\nat_mm = [15, 0, 15]\n";
    let report = solve(text);
    let [x, y] = ["x", "y"].map(|name| report.probes[name][1][1]);
    // Warm air heats the one; cool air dries the other, which falls towards the wet bulb.
    assert!(x > 30.0 && y < 20.0, "{x} {y}");
}
