//! Promise: faces of the lab exchange thermal radiation, apart from convection, and air has its humidity.

use saute_kitchen::Library;
use saute_lab::{Case, LabReport, run};

/// Stefan–Boltzmann constant [W/(m²·K⁴)].
const SIGMA: f64 = 5.670_374e-8;
const ZERO_C: f64 = 273.15;

fn case(text: &str) -> Result<Case, String> {
    let library = Library::embedded().expect("embedded data");
    Case::parse(text, "case.toml", &library).map_err(|e| e.to_string())
}

fn solve(text: &str) -> LabReport {
    run(&case(text).unwrap_or_else(|e| panic!("{e}")), || 0.0)
}

/// A copper plate of 10 mm, whose temperature is uniform to within 0.01 K.
fn copper(initial_c: f64, boundary: &str, more: &str) -> String {
    format!(
        "duration_s = 1800\noutput_every_s = 300\n[body]\nshape = \"slab\"\nsize_mm = [10]\nresolution_mm = 2.5\n\
         grading = 0\ninitial_c = {initial_c}\n[material]\nconductivity_w_mk = 400\ndensity_kg_m3 = 8960\n\
         specific_heat_j_kgk = 385\n{more}[[boundary]]\nface = \"all\"\n{boundary}\n\
         [[probe]]\nname = \"middle\"\nat_mm = [5]\n"
    )
}

/// Time at which a lumped body of capacity C [J/(m²·K)] has changed from `from` to `to` [K] by radiation alone:
/// C dT/dt = ε σ (T_w⁴ − T⁴) has the integral t = C/(4 ε σ T_w³) [ln |(T + T_w)/(T − T_w)| + 2 atan(T/T_w)].
fn radiative_time(capacity: f64, emissivity: f64, walls: f64, from: f64, to: f64) -> f64 {
    let integral = |t: f64| ((t + walls) / (t - walls)).abs().ln() + 2.0 * (t / walls).atan();
    capacity / (4.0 * emissivity * SIGMA * walls.powi(3)) * (integral(to) - integral(from))
}

#[test]
fn a_body_that_only_radiates_follows_the_exact_solution() {
    // Half the thickness for each of the two faces.
    let capacity = 0.005 * 8960.0 * 385.0;
    for (initial_c, radiant_c) in [(600.0, 20.0), (20.0, 600.0)] {
        let report = solve(&copper(initial_c, &format!("radiant_c = {radiant_c}\nemissivity = 0.8"), ""));
        let series = &report.probes["middle"];
        assert_eq!(series.len(), 7);
        for [time, c] in &series[1..] {
            let exact = radiative_time(capacity, 0.8, radiant_c + ZERO_C, initial_c + ZERO_C, c + ZERO_C);
            assert!((exact / time - 1.0).abs() < 1e-3, "{c} °C at {time} s, exact {exact} s");
        }
        let heat = 2.0 * capacity * (series[6][1] - initial_c);
        assert!((report.absorbed_j / heat - 1.0).abs() < 1e-3, "{} J, stored {heat} J", report.absorbed_j);
    }
}

/// A small difference makes radiation linear: a coefficient of 4 ε σ T³.
#[test]
fn weak_radiation_is_convection_with_its_coefficient() {
    let h = 4.0 * 0.8 * SIGMA * (100.0 + ZERO_C).powi(3);
    let end = |boundary: &str| solve(&copper(101.0, boundary, "")).probes["middle"][6][1];
    let (radiated, convected) =
        (end("radiant_c = 100\nemissivity = 0.8"), end(&format!("h_w_m2k = {h}\nambient_c = 100")));
    assert!(radiated < 100.6 && (radiated - convected).abs() < 2e-3, "{radiated} {convected}");
}

/// Convection, radiation and a flux add up: the stationary temperature balances them.
#[test]
fn convection_radiation_and_flux_balance_at_the_end() {
    let text = copper(150.0, "h_w_m2k = 20\nambient_c = 30\nradiant_c = 300\nemissivity = 0.6\nq_w_m2 = 500", "");
    let report = solve(&text.replace("duration_s = 1800", "duration_s = 30000"));
    let c = report.probes["middle"].last().expect("readings")[1];
    let k = |c: f64| (c + ZERO_C).powi(4);
    let balance = 20.0 * (30.0 - c) + 0.6 * SIGMA * (k(300.0) - k(c)) + 500.0;
    assert!((30.0..300.0).contains(&c) && balance.abs() < 0.5, "{c} °C, {balance} W/m²");
}

/// A flip takes the radiating face along with its boundary, and a phase ends radiation.
#[test]
fn flips_and_phases_carry_radiation() {
    let meat = "duration_s = 600\n[body]\nshape = \"slab\"\nsize_mm = [20]\ninitial_c = 20\n[material]\n\
                food = \"beef-lean\"\n[[boundary]]\nface = \"top\"\nradiant_c = 400\n";
    let probes = "[[probe]]\nname = \"bottom\"\nat_mm = [0]\n[[probe]]\nname = \"top\"\nat_mm = [20]\n";
    let ends = |more: &str| {
        let report = solve(&format!("{meat}{more}{probes}"));
        (report.probes["bottom"][1][1], report.probes["top"][1][1], report.absorbed_j)
    };
    let (still, flipped) = (ends(""), ends("[flips]\nat_s = [0]\n"));
    assert!((still.0 - flipped.1).abs() < 1e-6 && (still.1 - flipped.0).abs() < 1e-6, "{still:?} {flipped:?}");
    assert!(still.1 > still.0 + 20.0, "{still:?}");
    let never = "[[phase]]\nuntil = { at_s = 0 }\n[[phase]]\n[[phase.boundary]]\nface = \"top\"\nq_w_m2 = 0\n";
    assert!(ends(never).2.abs() < 1e-6 * still.2, "{:?}", ends(never));
}

/// 15 mm of lean beef between air and walls.
fn beef(initial_c: f64, duration_s: f64, boundary: &str) -> String {
    format!(
        "duration_s = {duration_s}\n[body]\nshape = \"slab\"\nsize_mm = [15]\ninitial_c = {initial_c}\n[material]\n\
         food = \"beef-lean\"\n[solver]\nphysics = \"cooking\"\n[[boundary]]\nface = \"all\"\n{boundary}\n\
         [[probe]]\nname = \"face\"\nat_mm = [15]\n"
    )
}

/// An oven of 180 °C with its fan: the wet face dries, becomes hotter than boiling water, and browns.
#[test]
fn a_face_in_an_oven_dries_and_browns() {
    let oven = "h_w_m2k = 15\nambient_c = 180\nradiant_c = 180";
    let (soon, late) = (solve(&beef(5.0, 300.0, oven)), solve(&beef(5.0, 9000.0, oven)));
    let face = |report: &LabReport| report.probes["face"][1][1];
    assert!(face(&soon) < 80.0, "{}", face(&soon));
    assert!((105.0..180.0).contains(&face(&late)), "{}", face(&late));
    // Browner than the face soon after it has cooked: darker.
    let [pale, brown] = [&soon, &late].map(|report| report.surface_lab["top"][0]);
    assert!(brown < pale - 8.0, "L* {pale} {brown}");
}

/// Radiation heats a wet face without drying it as convection does: evaporation follows the convective coefficient.
#[test]
fn radiation_does_not_drive_evaporation_by_itself() {
    let lost = |boundary: &str| solve(&beef(60.0, 60.0, boundary)).evaporated_kg_m2.expect("a slab");
    let still = lost("h_w_m2k = 7\nambient_c = 60\nradiant_c = 60");
    let all_convection = lost("h_w_m2k = 14\nambient_c = 60");
    assert!(still > 0.0 && all_convection > 1.4 * still, "{still} {all_convection}");
    assert!(lost("radiant_c = 60").abs() < 1e-9, "{}", lost("radiant_c = 60"));
}

/// Saturated air at the temperature of the body neither takes up vapour nor gives any.
#[test]
fn saturated_air_at_the_temperature_of_the_body_takes_up_nothing() {
    let change = |humidity: f64| {
        let boundary = format!("h_w_m2k = 15\nambient_c = 30\nhumidity_pct = {humidity}");
        solve(&beef(30.0, 120.0, &boundary)).evaporated_kg_m2.expect("a slab")
    };
    let (dry, half, saturated) = (change(0.0), change(50.0), change(100.0));
    assert!(dry > half && half > 0.4 * dry, "{dry} {half}");
    assert!(saturated.abs() < 0.03 * dry, "{saturated} of {dry}");
    // Air more humid than the face can bear condenses: 60 °C over a body of 30 °C.
    let warm = solve(&beef(30.0, 120.0, "h_w_m2k = 15\nambient_c = 60\nhumidity_pct = 100"));
    assert!(warm.lost_pct.expect("mass") < 0.0, "{:?}", warm.lost_pct);
}

/// Without the new keys, nothing changes: the air of the room and no radiation.
#[test]
fn the_humidity_of_the_room_is_the_default() {
    let room = Library::embedded().expect("embedded data").room;
    let lost = |more: &str| {
        let boundary = format!("h_w_m2k = 15\nambient_c = {}{more}", room.air.temperature_c);
        solve(&beef(40.0, 60.0, &boundary)).evaporated_kg_m2.expect("a slab")
    };
    let given = format!("\nhumidity_pct = {}", 100.0 * room.air.relative_humidity);
    assert!((lost("") / lost(&given) - 1.0).abs() < 1e-9, "{} {}", lost(""), lost(&given));
}

#[test]
fn radiation_and_humidity_out_of_place_say_what_to_write() {
    let air = "h_w_m2k = 15\nambient_c = 180";
    let bad = [
        (copper(20.0, "radiant_c = 180", ""), "radiant_c needs an emissivity"),
        (copper(20.0, &format!("{air}\nemissivity = 0.9"), ""), "emissivity has no effect without radiant_c"),
        (copper(20.0, &format!("{air}\nhumidity_pct = 10"), ""), "humidity_pct is only valid for cooking"),
        (copper(20.0, "fixed = true\nambient_c = 9\nradiant_c = 9\nemissivity = 1", ""), "fixed temperature"),
        (copper(20.0, "radiant_c = 9\nemissivity = 1.1", ""), "emissivity = 1.1 is out of range"),
        (beef(5.0, 9.0, &format!("{air}\nhumidity_pct = 20")), "humidity_pct = 10.1"),
        (beef(5.0, 9.0, "radiant_c = 180\nhumidity_pct = 20"), "humidity_pct needs ambient_c"),
        (beef(5.0, 9.0, "contact = \"pan\"\nambient_c = 180\nradiant_c = 180"), "face in air"),
        (beef(5.0, 9.0, &format!("contact = \"solid\"\n{air}\nhumidity_pct = 1")), "face in air"),
    ];
    for (text, expected) in bad {
        let error = case(&text).expect_err("is refused");
        assert!(error.contains(expected) && error.contains("case.toml:") && error.contains("remedy:"), "{error}");
    }
}
