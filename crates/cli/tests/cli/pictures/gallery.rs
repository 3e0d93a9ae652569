//! `saute gallery`.

use crate::running::run;

/// The campaign draws all six.
#[test]
fn figures_of_the_gallery_are_drawn_with_their_numbers() {
    let folder = tempfile::tempdir().unwrap();
    let out = folder.path().join("gallery");
    let asked = ["--figure", "1-one-side", "--figure", "3-temperature"];
    let ran =
        run(&[&["gallery", "--size", "96x64", "--samples", "2", "--out", out.to_str().unwrap()], asked.as_slice()]
            .concat());
    assert_eq!(ran.code, Some(0), "{}", ran.err);
    let page = std::fs::read_to_string(out.join("gallery.md")).unwrap();
    let figures: Vec<&str> =
        page.lines().filter_map(|l| l.strip_prefix("![")?.split("](").nth(1)?.strip_suffix(")")).collect();
    assert_eq!(figures, ["1-one-side.png", "3-temperature.png"], "{page}");
    for figure in figures {
        let png = std::fs::read(out.join(figure)).unwrap();
        assert!(png.starts_with(b"\x89PNG") && png.len() > 4000, "{figure}: {} bytes", png.len());
    }
    // Heat climbs: the numbers of the first figure's panels a to d.
    let core = |row: &str| row.split('|').nth(5).unwrap().trim().parse::<f64>().unwrap();
    let rows: Vec<f64> = page.lines().filter(|l| l.contains("| one-side |")).take(4).map(core).collect();
    assert!(rows.windows(2).all(|pair| pair[0] < pair[1]), "{rows:?}");
    // Two panels of one moment have one row.
    assert!(page.contains("| abcd | turned |"), "{page}");
}

#[test]
fn a_food_is_drawn_from_raw_to_burnt_with_its_numbers() {
    let folder = tempfile::tempdir().unwrap();
    let out = folder.path().join("looks");
    let ran =
        run(&["gallery", "--looks", "leek-ring", "--size", "64x64", "--samples", "2", "--out", out.to_str().unwrap()]);
    assert_eq!(ran.code, Some(0), "{}", ran.err);
    let page = std::fs::read_to_string(out.join("looks.md")).unwrap();
    let png = std::fs::read(out.join("leek-ring.png")).unwrap();
    assert!(png.starts_with(b"\x89PNG") && page.contains("](leek-ring.png)"), "{page}");
    // Nine moments, of which the last is the burnt one's.
    let rows = |cook: &str| page.lines().filter(|l| l.split('|').nth(2).is_some_and(|c| c.trim() == cook)).count();
    assert_eq!([rows("leek-ring"), rows("leek-ring-burnt")], [8, 1], "{page}");
}

#[test]
fn a_figure_that_there_is_not_is_refused_with_those_there_are() {
    let asked = [["--looks", "dumpling", "beef-lean, beef-marbled"], ["--figure", "7-tofu", "1-one-side, 2-turned"]];
    for [option, name, those] in asked {
        let ran = run(&["gallery", option, name, "--out", "never"]);
        assert_eq!(ran.code, Some(2));
        assert!(ran.err.contains(name) && ran.err.contains(those), "{}", ran.err);
    }
}
