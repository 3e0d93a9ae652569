//! What a cook prints and writes.

use serde_json::Value;

use crate::cook::cooked::{cook, cooked};
use crate::running::{SHORT, run, saute};

/// Every key that the summary promises.
const KEYS: [&str; 57] = [
    "/simulated_s",
    "/wall_s",
    "/stopped_by",
    "/foods/0/id",
    "/foods/0/kind",
    "/foods/0/group",
    "/foods/0/place",
    "/groups",
    "/steps/0/foods",
    "/foods/0/nodes",
    "/foods/0/mass_g/start",
    "/foods/0/mass_g/end",
    "/foods/0/water_g/evaporated",
    "/foods/0/water_g/dripped",
    "/foods/0/core_c/end",
    "/foods/0/core_c/peak",
    "/foods/0/core_c/peak_at_s",
    "/foods/0/section_pct/raw",
    "/foods/0/section_pct/rare",
    "/foods/0/section_pct/medium",
    "/foods/0/section_pct/well_done",
    "/foods/0/volume_pct/raw",
    "/foods/0/volume_pct/rare",
    "/foods/0/volume_pct/medium",
    "/foods/0/volume_pct/well_done",
    "/foods/0/elastic_modulus_kpa",
    "/foods/0/log_reduction/core",
    "/foods/0/log_reduction/surface",
    "/foods/0/denatured/myosin",
    "/foods/0/denatured/collagen",
    "/foods/0/denatured/actin",
    "/foods/0/denatured/myoglobin",
    "/foods/0/surfaces/top/temperature_c",
    "/foods/0/surfaces/top/lab/2",
    "/foods/0/surfaces/top/browned_pct",
    "/foods/0/surfaces/top/charred_pct",
    "/foods/0/surfaces/bottom/temperature_c",
    "/foods/0/surfaces/bottom/lab/2",
    "/foods/0/surfaces/bottom/browned_pct",
    "/foods/0/surfaces/bottom/charred_pct",
    "/pan_c/peak",
    "/pan_c/at_first_put",
    "/pan_c/lowest_after_first_put",
    "/pan_c/end",
    "/energy_j/hob",
    "/energy_j/pan_stored",
    "/energy_j/food_stored",
    "/energy_j/air",
    "/energy_j/evaporation",
    "/energy_j/other",
    "/energy_j/imbalance",
    "/steps/0/time_s",
    "/steps/0/action",
    "/steps/0/target",
    "/steps/0/value",
    "/steps/1/target",
    "/title",
];

#[test]
fn the_json_has_every_key_that_is_promised() {
    for key in KEYS {
        assert!(cooked("medium").summary.pointer(key).is_some(), "{key}");
    }
}

#[test]
fn the_shares_of_doneness_add_up_to_a_hundred_percent() {
    for pointer in ["/foods/0/section_pct", "/foods/0/volume_pct"] {
        let shares = cooked("medium").summary.pointer(pointer).unwrap().as_object().unwrap();
        let sum: f64 = shares.values().filter_map(Value::as_f64).sum();
        assert!((sum - 100.0).abs() < 1e-6, "{pointer}: {sum}");
    }
}

#[test]
fn summary_json_holds_what_was_printed() {
    assert_eq!(cooked("medium").text("summary.json"), cooked("medium").ran.out);
}

#[test]
fn the_series_has_its_header_and_a_row_for_every_second_and_every_step() {
    let medium = cooked("medium");
    let mut lines = medium.text("series.csv").lines();
    assert_eq!(lines.next(), Some("time_s,hob_drawn_w,pan_c,steak.core_c,steak.top_c,steak.bottom_c,steak.mass_g"));
    let times: Vec<f64> = lines.map(|l| l.split(',').next().unwrap().parse().unwrap()).collect();
    let has = |t: f64| times.iter().any(|row| (row - t).abs() < 1e-6);
    assert!((0..=medium.number("/simulated_s") as u32).all(|s| has(f64::from(s))));
    assert!(medium.summary["steps"].as_array().unwrap().iter().all(|s| has(s["time_s"].as_f64().unwrap())));
    assert!(times.windows(2).all(|w| w[1] > w[0]));
}

#[test]
fn there_is_a_picture_of_the_cross_section_for_every_step_from_the_put_on() {
    let medium = cooked("medium");
    let names: Vec<&str> = medium.files.keys().map(String::as_str).collect();
    let pictures = ["02_put", "03_hob_w", "04_flip", "05_rest", "06_hob_w", "07_end"];
    let mut expected: Vec<String> =
        pictures.iter().flat_map(|p| [format!("section_{p}.png"), format!("section_{p}_temperature.png")]).collect();
    let others = ["cooked.glb", "report.html", "series.csv", "series.parquet", "summary.json", "summary.parquet"];
    expected.extend(others.map(str::to_owned));
    expected.sort();
    assert_eq!(names, expected);
}

#[test]
fn the_pictures_decode_and_show_width_by_thickness_at_12_pixels_a_millimetre() {
    let medium = cooked("medium");
    for (name, bytes) in medium.files.iter().filter(|(name, _)| name.ends_with(".png")) {
        let mut reader = png::Decoder::new(std::io::Cursor::new(bytes)).read_info().unwrap();
        let mut pixels = vec![0; reader.output_buffer_size().unwrap()];
        let info = reader.next_frame(&mut pixels).unwrap();
        // 25 × 80 mm and the outline's ripple at the put; frying, a steak changes by no more than a fifth.
        let [height, width] =
            if name.starts_with("section_02_put") { [300..=300, 900..=1000] } else { [240..=345, 720..=1000] };
        assert!(
            height.contains(&info.height) && width.contains(&info.width),
            "{name}: {} × {}",
            info.width,
            info.height
        );
        // As it goes into the pan the steak has one temperature.
        let even = ["section_02_put_temperature.png", "section_03_hob_w_temperature.png"].contains(&name.as_str());
        assert!(even || pixels.chunks(4).any(|p| p[..3] != pixels[..3]), "{name} is blank");
    }
}

#[test]
fn the_report_stands_alone_and_shows_curves_sections_bars_numbers_and_the_recipe() {
    let report = cooked("medium").text("report.html");
    for part in [
        "<svg",
        "data:image/png;base64,",
        "class=\"bar\"",
        "Medium steak, one flip",
        "Imbalance",
        "when = { pan_c = 220 }",
        "prefers-color-scheme",
    ] {
        assert!(report.contains(part), "{part}");
    }
    for outside in ["http:", "https:", "<link", "<script", "url("] {
        assert!(!report.contains(outside), "{outside}");
    }
    assert_eq!(report.matches("src=\"").count(), report.matches("src=\"data:image/png;base64,").count());
}

#[test]
fn a_report_takes_no_markup_from_a_recipe() {
    let dir = tempfile::tempdir().unwrap();
    let path = dir.path().join("odd.toml");
    std::fs::write(&path, SHORT.replace("Short", "<img src=x> & <b>bold</b>")).unwrap();
    let odd = cook(path.to_str().unwrap());
    let report = odd.text("report.html");
    assert!(report.contains("&lt;img src=x&gt; &amp; &lt;b&gt;") && !report.contains("<img src=x>"));
}

#[test]
fn several_foods_have_pictures_of_their_own() {
    let dir = tempfile::tempdir().unwrap();
    let path = dir.path().join("two.toml");
    let second = "[[food]]\nid = \"other\"\nkind = \"beef-marbled\"\nsize_mm = [50, 40, 12]\n[[step]]\nput = \"other\"\nat_mm = [0, 60]\n[[step]]\n";
    std::fs::write(
        &path,
        SHORT.replacen("[[step]]\n", second, 1).replace("put = \"steak\"", "put = \"steak\"\nat_mm = [0, -30]"),
    )
    .unwrap();
    let two = cook(path.to_str().unwrap());
    for name in ["section_04_flip.steak.png", "section_04_flip.other.png", "section_04_flip_temperature.other.png"] {
        assert!(two.files.contains_key(name), "{name}: {:?} {}", two.files.keys(), two.ran.err);
    }
    assert!(two.text("series.csv").starts_with("time_s,hob_drawn_w,pan_c,steak.core_c,"));
}

#[test]
fn without_json_the_text_has_a_summary_and_no_progress_bar_gets_into_a_file() {
    let dir = tempfile::tempdir().unwrap();
    let path = dir.path().join("short.toml");
    std::fs::write(&path, SHORT).unwrap();
    let ran = run(&["cook", path.to_str().unwrap()]);
    assert_eq!((ran.code, ran.err.as_str()), (Some(0), ""));
    for part in [
        "Short\n",
        "ended by its last step after 20.0 s",
        "cross-section",
        "well-done",
        "browned",
        "imbalance",
        "flip steak",
        "steps (min:s)",
        "0:20.0",
    ] {
        assert!(ran.out.contains(part), "{part}:\n{}", ran.out);
    }
}

#[test]
fn a_reader_that_goes_away_is_not_an_error() {
    let (reader, writer) = std::io::pipe().unwrap();
    drop(reader);
    let output = saute().args(["schema", "recipe"]).stdout(writer).output().unwrap();
    assert_eq!((output.status.code(), output.stderr), (Some(0), Vec::new()));
}

/// A condition that is exceeded does not wait; a bare number is an error with its line and what to write.
#[test]
fn a_bare_temperature_that_is_exceeded_warns_with_line_and_remedy() {
    let dir = tempfile::tempdir().unwrap();
    let path = dir.path().join("passed.toml");
    let passed =
        |condition: &str| SHORT.replace("after_s = 10\nflip", &format!("when = {{ pan_c = {condition} }}\nflip"));
    std::fs::write(&path, passed("150")).unwrap();
    let warned = cook(path.to_str().unwrap());
    assert_eq!(warned.ran.code, Some(0));
    assert!(warned.ran.err.contains("warning: line 15: pan_c = 150"), "{}", warned.ran.err);
    assert!(warned.ran.err.contains("{ below = 150 }"), "{}", warned.ran.err);
    assert_eq!(warned.summary["warnings"].as_array().unwrap().len(), 1);
    std::fs::write(&path, passed("{ above = 150 }")).unwrap();
    let plain = cook(path.to_str().unwrap());
    assert_eq!((plain.ran.err.contains("warning"), plain.time_of("flip")), (false, warned.time_of("flip")));
}

#[test]
fn every_repetition_is_listed_among_the_steps() {
    let dir = tempfile::tempdir().unwrap();
    let path = dir.path().join("repeat.toml");
    let repeat = "repeat = { flip = \"steak\", every_s = 4, times = 3 }";
    std::fs::write(&path, SHORT.replace("after_s = 10\nflip = \"steak\"", repeat)).unwrap();
    let summary = cook(path.to_str().unwrap()).summary;
    let flips = summary["steps"].as_array().unwrap().iter().filter(|s| s["action"] == "flip");
    let times: Vec<f64> = flips.map(|s| s["time_s"].as_f64().unwrap()).collect();
    assert_eq!(times, [4.0, 8.0, 12.0]);
}
