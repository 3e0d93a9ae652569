//! Promise: a pan with ridges passes less heat than a plain one, lets liquids run along its grooves alone, and leaves lines
//! where its ridges were, in the frame of the food.

use glam::DQuat;
use saute_kitchen::dynamics::{Pose, Tool};
use saute_kitchen::food::{Face, Rules};
use saute_kitchen::piece::sear_lines::SearLines;
use saute_kitchen::{Command, Kitchen, Library, MeshSize, OutlineKind, PieceOrder, celsius, kelvin};
use saute_recipe::{Cook, Recipe, StoppedBy};

use crate::stove::{apply, library, run};

const GRILL: &str = "cast-iron-grill-26";

fn steak(rules: Rules) -> PieceOrder {
    PieceOrder {
        id: "steak".into(),
        kind: "beef-lean".into(),
        size: [0.09, 0.06, 0.015],
        temperature: kelvin(15.0),
        seed: 1,
        coarseness: 2.0,
        rules,
        mesh: MeshSize::Default,
        outline: OutlineKind::Plain,
    }
}

fn frying(pan: &str, pan_c: f64, seconds: f64) -> Kitchen {
    frying_by(Rules::Full, pan, pan_c, seconds)
}

fn frying_by(rules: Rules, pan: &str, pan_c: f64, seconds: f64) -> Kitchen {
    let mut kitchen = Kitchen::new(&library(), pan, kelvin(pan_c)).expect("pan");
    kitchen.add(&library(), &steak(rules)).expect("food");
    apply(&mut kitchen, Command::Put { food: "steak".into(), at: [0.0, 0.0], heap: false });
    run(&mut kitchen, seconds);
    kitchen
}

/// On ridges less than the share of their tops of a plain pan's heat enters through contact, and something across the grooves.
#[test]
fn less_heat_enters_on_ridges_than_on_a_plain_pan_as_hot() {
    let gained = |pan: &str| {
        let kitchen = frying(pan, 200.0, 20.0);
        let e = kitchen.energy();
        assert!(e.imbalance.abs() < 1e-9 * (e.pan_stored.abs() + e.food_stored.abs()), "{e:?}");
        e.food_stored + e.evaporation
    };
    let (ridged, plain) = (gained(GRILL), gained("cast-iron-26"));
    assert!((0.35..0.85).contains(&(ridged / plain)), "{ridged} {plain}");
}

/// Ridges brown the share of a face that lies on their tops, in bars; turned across them it gets as much of the rest.
#[test]
fn a_face_browns_where_the_tops_are() {
    let reading = |kitchen: &Kitchen| {
        let piece = &kitchen.pieces()[0];
        piece.model.face_reading(&piece.state, piece.up())
    };
    let fried = |pan: &str| {
        let mut kitchen = frying(pan, 230.0, 0.0);
        apply(&mut kitchen, Command::Hob(1200.0));
        run(&mut kitchen, 150.0);
        reading(&kitchen)
    };
    let (bars, plain) = (fried(GRILL), fried("cast-iron-26"));
    assert!((100.0 * 5.0 / 12.0 - 10.0..100.0 * 5.0 / 12.0 + 10.0).contains(&bars.browned_pct), "{bars:?}");
    assert!(plain.browned_pct > 90.0 && plain.crust_pct == plain.browned_pct, "{plain:?}");
    // The bars are as brown as a whole face: that is the crust of a grilled steak.
    assert!(bars.crust_pct > 90.0, "{bars:?}");
    // Between the bars the face is as pale as it was: the mean is lighter than a whole crust.
    assert!(bars.lab.0[0] > plain.lab.0[0] + 4.0, "{bars:?} {plain:?}");
    assert!(bars.browning < 0.55 && bars.charred_pct <= bars.browned_pct, "{bars:?}");
}

/// By the rules of 2013 a face browns as a whole, as it did.
#[test]
fn the_rules_of_2013_know_no_bars() {
    let mut kitchen = frying_by(Rules::Paper2013, GRILL, 280.0, 60.0);
    assert!(kitchen.pieces()[0].state.open.iter().all(|open| *open == 1.0));
    // And no ice, by whichever door it comes.
    let frozen = PieceOrder { id: "frozen".into(), temperature: kelvin(-18.0), ..steak(Rules::Paper2013) };
    let refused = kitchen.add(&library(), &frozen).expect_err("no ice in 2013");
    assert!(refused.to_string().contains("below 0 °C"), "{refused}");
    kitchen.add(&library(), &PieceOrder { rules: Rules::Full, ..frozen }).expect("freezes");
}

fn lines(kitchen: &Kitchen, face: Face) -> Vec<SearLines> {
    kitchen.pieces()[0].all_sear_lines(face)
}

#[test]
fn ridges_leave_lines_on_the_faces_that_lay_on_them() {
    let mut kitchen = frying(GRILL, 280.0, 0.0);
    apply(&mut kitchen, Command::Hob(2000.0));
    run(&mut kitchen, 120.0);
    assert!(kitchen.pieces()[0].sear_lines(Face::Top).is_none());
    apply(&mut kitchen, Command::Flip { food: "steak".into() });
    run(&mut kitchen, 120.0);
    let (ridges, piece) = (kitchen.pan_model().ridges.expect("ridges"), &kitchen.pieces()[0]);
    for face in [Face::Bottom, Face::Top] {
        let lines = piece.sear_lines(face).expect("lines");
        assert!((0.5..=1.0).contains(&lines.share), "{lines:?}");
        assert!((lines.width / lines.pitch / ridges.share() - 1.0).abs() < 1e-9);
        assert!((0.8..1.2).contains(&(lines.pitch / ridges.pitch)) && (0.0..lines.pitch).contains(&lines.phase));
        // Laid and flipped about its long axis it still is along x: the ridges run across it.
        assert!(lines.direction[1].abs() > 0.97, "{lines:?}");
    }
    assert!(piece.sear_lines(Face::Side).is_none());
}

#[test]
fn lines_turn_with_a_steak_that_is_turned_by_90_degrees_between() {
    let mut kitchen = frying(GRILL, 280.0, 0.0);
    apply(&mut kitchen, Command::Hob(2000.0));
    run(&mut kitchen, 90.0);
    let at = kitchen.pieces()[0].pose.position;
    let grip = || Some("steak".to_owned());
    let led = |kitchen: &mut Kitchen, lift: f64, turned: f64, grip: Option<String>| {
        let mut to = Pose::at(at.x, at.y, at.z + lift);
        to.rotation = DQuat::from_rotation_z(turned.to_radians());
        apply(kitchen, Command::Lead { tool: Tool::Tongs, to, grip });
        run(kitchen, 0.4);
    };
    led(&mut kitchen, 0.0, 0.0, grip());
    led(&mut kitchen, 0.05, 0.0, grip());
    for turned in [30.0, 60.0, 90.0] {
        led(&mut kitchen, 0.05, turned, grip());
    }
    apply(&mut kitchen, Command::LetGo);
    run(&mut kitchen, 120.0);
    let sets = lines(&kitchen, Face::Bottom);
    assert!(sets.len() >= 2, "{sets:?}");
    let cosine: f64 = (0..2).map(|k| sets[0].direction[k] * sets[1].direction[k]).sum();
    assert!(cosine.abs() < 0.35, "{sets:?}");
    assert!(sets[0].share + sets[1].share <= 1.0 + 1e-9 && sets[1].share > 0.02, "{sets:?}");
}

#[test]
fn a_plain_pan_leaves_no_lines() {
    let kitchen = frying("cast-iron-26", 280.0, 120.0);
    assert!(kitchen.pieces()[0].sear_lines(Face::Bottom).is_none());
    assert!(kitchen.pieces()[0].face(true) > kelvin(100.0));
}

/// How far the oil's middle has moved in a pan that leans by so many degrees towards a direction [m].
fn ran(pan: &str, degrees: f64, towards: f64) -> f64 {
    let mut kitchen = Kitchen::new(&library(), pan, kelvin(100.0)).expect("pan");
    apply(&mut kitchen, Command::Tilt { angle: degrees.to_radians(), towards });
    run(&mut kitchen, 20.0);
    let (bed, oil) = (&kitchen.pan_model().liquids.bed, &kitchen.pan_state().liquids.oil);
    let way = [towards.cos(), towards.sin()];
    let moved = |(p, m): (&[f64; 3], &f64)| m * (p[0] * way[0] + p[1] * way[1]);
    bed.places.iter().zip(&oil.mass).map(moved).sum::<f64>() / oil.total()
}

#[test]
fn oil_runs_along_the_grooves_and_over_the_ridges_only_when_the_pan_leans_far() {
    let quarter = core::f64::consts::FRAC_PI_2;
    let (along, across, far) = (ran(GRILL, 8.0, quarter), ran(GRILL, 8.0, 0.0), ran(GRILL, 40.0, 0.0));
    let plain = ran("cast-iron-26", 8.0, quarter);
    assert!(along > 0.03 && along > plain, "{along} {plain}");
    assert!(across < 0.35 * along && far > 3.0 * across, "{across} {far}");
}

#[test]
fn ridges_that_cannot_be_are_refused_where_they_stand() {
    let text = &Library::embedded_files()["pans/cast-iron-grill-26.toml"];
    for (from, to, said) in [
        ("width_mm = 5.0", "width_mm = 14.0", "width_mm = 14 is out of range"),
        ("pitch_mm = 12.0", "pitch_mm = 0.0", "pitch_mm = 0 is out of range"),
        ("height_mm = 5.0", "hight_mm = 5.0", "hight_mm"),
    ] {
        let own = ("pans/own.toml".to_owned(), text.replacen(from, to, 1));
        let error = Library::with(&[own]).expect_err(to);
        assert!(error.file == "pans/own.toml" && error.line > 7 && error.message.contains(said), "{error}");
    }
}

/// The file that the documentation shows is sound.
#[test]
fn the_documented_pan_can_be_used() {
    let page = concat!(env!("CARGO_MANIFEST_DIR"), "/../../docs/your-own-pan.md");
    let page = std::fs::read_to_string(page).expect("the page");
    let file = page.split("```toml").nth(1).and_then(|rest| rest.split("```").next()).expect("a file");
    let library = Library::with(&[("pans/own.toml".into(), file.into())]).expect("sound");
    assert!(library.pans["own"].ridges.is_some() && library.pans.contains_key("own-nonstick"));
}

#[test]
fn the_shipped_grill_pan_recipe_rests_up_to_a_pink_centre_with_lines_on_both_faces() {
    let library = library();
    let recipe = Recipe::parse(&library.recipes["grill-pan-steak"], "grill-pan-steak.toml", &library).expect("parses");
    let mut cook = Cook::new(recipe, &library).expect("sets out");
    while cook.stopped().is_none() {
        cook.advance().expect("runs");
    }
    let (summary, piece) = (cook.summary(0.0), &cook.kitchen.pieces()[0]);
    assert_eq!((summary.stopped_by, summary.warnings.len()), (StoppedBy::End, 0), "{:?}", summary.warnings);
    let peak = celsius(piece.core_peak.0);
    assert!((55.0..60.0).contains(&peak), "{peak}");
    for (face, told) in [(Face::Bottom, 0), (Face::Top, 1)] {
        assert!(piece.sear_lines(face).is_some_and(|l| l.share > 0.5), "{told}");
    }
    let faces = [summary.foods[0].surfaces.top, summary.foods[0].surfaces.bottom];
    assert!(faces.iter().all(|f| f.charred_pct < 5.0), "{faces:?}");
    assert!(piece.halved().is_some());
}
