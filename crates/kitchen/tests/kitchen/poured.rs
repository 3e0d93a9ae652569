//! Promise: an egg spreads until it has set below, as a liquid does; then it is a body that is turned, tossed and taken out. Its energy
//! and mass balance all the way, and a kitchen stored while it runs goes on bit by bit.

use saute_kitchen::dynamics::{Pose, Tool};
use saute_kitchen::{Command, Kitchen, Library, MeshSize, OutlineKind, PieceOrder, Refused, RestOn, kelvin};

use crate::stove::{imbalance, library, run};

const EGG: &str = "egg";

fn order(library: &Library) -> PieceOrder {
    let food = &library.foods[EGG];
    PieceOrder {
        id: EGG.into(),
        kind: EGG.into(),
        size: food.form.extent(&food.size.default_mm).expect("a size").map(|mm| 1e-3 * mm),
        temperature: kelvin(8.0),
        seed: 4,
        coarseness: 1.5,
        rules: saute_kitchen::food::Rules::Full,
        mesh: MeshSize::Default,
        outline: OutlineKind::Natural,
    }
}

/// A pan at a temperature [°C] with a film of oil, kept warm, and a cold egg poured into its middle.
fn poured(library: &Library, pan_c: f64) -> Kitchen {
    let mut kitchen = Kitchen::with_oil(library, "carbon-steel-26", kelvin(pan_c), 0.005).expect("kitchen");
    kitchen.add(library, &order(library)).expect("is added");
    kitchen.apply(&Command::Hob(if pan_c > 50.0 { 400.0 } else { 0.0 })).expect("hob");
    kitchen.apply(&Command::Put { food: EGG.into(), at: [0.0, 0.0], heap: false }).expect("is poured");
    kitchen
}

/// Area under the egg [m²].
fn area(kitchen: &Kitchen) -> f64 {
    kitchen.pieces()[0].model.outline().area()
}

#[test]
fn energy_and_mass_balance_while_it_runs_sets_and_is_turned() {
    let mut kitchen = poured(&library(), 140.0);
    let (mut worst, mut flipped) = (0.0_f64, false);
    for tick in 0..1200 {
        kitchen.step();
        worst = worst.max(imbalance(&kitchen));
        let piece = &kitchen.pieces()[0];
        let off = (piece.mass() - piece.state.mass_left(&piece.model)).abs();
        assert!(off < 1e-9 * piece.mass(), "tick {tick}: {off} kg");
        if tick == 900 {
            flipped = kitchen.apply(&Command::Flip { food: EGG.into() }).is_ok();
        }
    }
    assert!(flipped && worst < 1e-9, "energy: {worst}");
    assert!(kitchen.pieces()[0].upside_down(), "lies on its other face");
    assert!(kitchen.pieces()[0].is_near_pan());
}

#[test]
fn it_runs_on_a_cold_pan_and_has_set_within_seconds_on_a_hot_one() {
    let library = library();
    let mut cold = poured(&library, 20.0);
    let heap = area(&cold);
    run(&mut cold, 60.0);
    assert!(cold.pieces()[0].runs(), "a cold pan sets nothing");
    assert!(area(&cold) > 1.5 * heap, "{heap} m² became {}", area(&cold));
    let before = area(&cold);
    run(&mut cold, 10.0);
    assert!((area(&cold) / before - 1.0).abs() < 0.02, "it has come to rest");
    let mut hot = poured(&library, 150.0);
    run(&mut hot, 20.0);
    assert!(!hot.pieces()[0].runs(), "a hot pan sets it");
}

/// Two eggs are poured side by side into a pan of 26 cm: they run up to each other, and lap over each other by a node of the pan at
/// most (8 mm).
#[test]
fn two_eggs_lie_side_by_side_and_balance() {
    let library = library();
    let mut kitchen = Kitchen::with_oil(&library, "carbon-steel-26", kelvin(140.0), 0.005).expect("kitchen");
    let ids = ["egg.1", "egg.2"].map(str::to_owned);
    for (seed, id) in ids.iter().enumerate() {
        kitchen.add(&library, &PieceOrder { id: id.clone(), seed: seed as u64, ..order(&library) }).expect("is added");
    }
    let places = kitchen.free_places(&ids, [0.0, 0.0]);
    assert_eq!(places.len(), 2, "{places:?}");
    for (id, at) in ids.iter().zip(places) {
        kitchen.apply(&Command::Put { food: id.clone(), at, heap: false }).expect("is poured");
    }
    kitchen.apply(&Command::Hob(800.0)).expect("hob");
    run(&mut kitchen, 120.0);
    let [a, b] = [0, 1].map(|k| &kitchen.pieces()[k]);
    assert!(!a.runs() && !b.runs(), "both have set");
    assert!(imbalance(&kitchen) < 1e-9);
    let inside = |[x, y]: [f64; 2]| {
        let seen = b.pose.to_body(a.pose.to_world(glam::DVec3::new(0.8 * x, 0.8 * y, 0.0)));
        b.model.outline().contains([seen.x, seen.y])
    };
    let outline = &a.model.outline().points;
    let under = outline.iter().filter(|p| inside(**p)).count();
    assert!(under <= outline.len() / 20, "{under} of {} points of the outline lie in the other egg", outline.len());
}

/// Thick white of an old egg stands half as high: it lies wider.
#[test]
fn an_old_egg_runs_farther_than_a_fresh_one() {
    let mut library = library();
    let mut fresh = poured(&library, 20.0);
    run(&mut fresh, 10.0);
    let food = library.foods.get_mut(EGG).expect("is shipped");
    let pour = food.pour.as_mut().expect("is poured");
    (pour.thick_height_mm, pour.thick_share) = (3.2, 0.40);
    let mut old = poured(&library, 20.0);
    run(&mut old, 10.0);
    assert!(area(&old) > 1.08 * area(&fresh), "{} and {}", area(&old), area(&fresh));
}

#[test]
fn it_runs_downhill_on_a_tilted_pan_and_stays_once_it_has_set() {
    let library = library();
    let moved = |pan_c: f64, sets: bool| {
        let mut kitchen = poured(&library, pan_c);
        if sets {
            run(&mut kitchen, 30.0);
        }
        let from = kitchen.pieces()[0].pose.position;
        kitchen.apply(&Command::Tilt { angle: 0.17, towards: 0.0 }).expect("tilts");
        run(&mut kitchen, 4.0);
        kitchen.pieces()[0].pose.position.x - from.x
    };
    assert!(moved(20.0, false) > 0.01, "{}", moved(20.0, false));
    assert!(moved(140.0, true).abs() < 0.01, "{}", moved(140.0, true));
}

#[test]
fn what_still_runs_is_not_turned_taken_out_or_tossed() {
    let mut kitchen = poured(&library(), 20.0);
    let runs = Err(Refused::StillRuns(EGG.into()));
    let to = Pose::at(0.0, 0.0, 0.1);
    for command in [
        Command::Lead { tool: Tool::Tongs, to, grip: Some(EGG.into()) },
        Command::Flip { food: EGG.into() },
        Command::Rest { food: EGG.into(), on: RestOn::Board },
        Command::Toss { height: 0.1 },
    ] {
        assert_eq!(kitchen.apply(&command), runs, "{command:?}");
    }
}

/// Hot fat over the veil of a sunny egg sets it from above, and the pan's fat gives that heat.
#[test]
fn basting_heats_the_upper_face_with_the_heat_of_the_fat() {
    let library = library();
    let fried = |bastes: bool| {
        let mut kitchen = poured(&library, 150.0);
        kitchen.apply(&Command::Oil { kind: None, mass: 0.010 }).expect("oil");
        run(&mut kitchen, 60.0);
        if bastes {
            kitchen.apply(&Command::Baste { food: EGG.into(), for_s: 30.0 }).expect("bastes");
        }
        run(&mut kitchen, 30.0);
        assert!(imbalance(&kitchen) < 1e-9, "{}", imbalance(&kitchen));
        (kitchen.pieces()[0].face(false), kitchen.pieces()[0].heat_taken, kitchen.pan_temperature())
    };
    let (plain, basted) = (fried(false), fried(true));
    assert!(basted.0 > plain.0 + 10.0, "{} K and {} K", basted.0, plain.0);
    assert!(basted.1 > plain.1 + 1e3 && basted.2 < plain.2 - 1.0, "{basted:?} {plain:?}");
    let mut dry = Kitchen::with_oil(&library, "stainless-clad-26", kelvin(150.0), 0.0).expect("kitchen");
    dry.add(&library, &order(&library)).expect("is added");
    dry.apply(&Command::Put { food: EGG.into(), at: [0.0, 0.0], heap: false }).expect("is poured");
    let refused = dry.apply(&Command::Baste { food: EGG.into(), for_s: 5.0 });
    assert_eq!(refused, Err(Refused::TooLittleFat { least_g: 4 }));
}

#[test]
fn a_kitchen_stored_while_it_runs_and_after_it_has_set_goes_on_bit_by_bit() {
    let library = library();
    let mut kitchen = poured(&library, 120.0);
    for seconds in [0.5, 3.0, 40.0] {
        run(&mut kitchen, seconds);
        let bytes = kitchen.to_bytes();
        let mut again = Kitchen::from_bytes(&bytes, &library).expect("is restored");
        let mut same = kitchen.clone();
        (0..30).for_each(|_| {
            same.step();
            again.step();
        });
        assert!(again.to_bytes() == same.to_bytes(), "after {seconds} s");
    }
}

/// Narrow yolks, white at the floor's edge and eggs on eggs: whatever shape they take is stored and comes back.
#[test]
fn an_egg_in_any_place_and_of_any_yolk_is_stored_and_comes_back() {
    let mut library = library();
    for (share, height_mm, at, heap) in
        [(0.05, 30.0, 0.0, false), (0.6, 5.0, 0.05, false), (0.34, 17.0, 0.12, true), (0.34, 17.0, 0.135, true)]
    {
        let yolk = library.foods.get_mut(EGG).and_then(|food| food.yolk.as_mut()).expect("has a yolk");
        (yolk.share, yolk.height_mm) = (share, height_mm);
        let mut kitchen = Kitchen::new(&library, "carbon-steel-26", kelvin(20.0)).expect("kitchen");
        for id in ["one", "two"] {
            kitchen.add(&library, &PieceOrder { id: id.into(), ..order(&library) }).expect("is added");
        }
        let put = |food: &str, heap| Command::Put { food: food.into(), at: [at, 0.0], heap };
        if kitchen.apply(&put("one", heap)).is_err() {
            kitchen.apply(&put("one", true)).expect("is dropped");
        }
        kitchen.apply(&put("two", true)).expect("is dropped");
        for tick in 0..20 {
            kitchen.step();
            assert!(kitchen.pieces().iter().all(|piece| piece.state.healthy), "{share} {at} {tick}");
            let again = Kitchen::from_bytes(&kitchen.to_bytes(), &library).expect("comes back");
            assert!(again.to_bytes() == kitchen.to_bytes());
        }
    }
}

#[test]
fn a_file_whose_tables_do_not_belong_to_its_form_is_refused_with_a_remedy() {
    let files = Library::embedded_files();
    let corners = |list: &str| format!("[outline]\ncorners = [{list}]\n");
    for (file, from, to, words) in [
        ("egg", "form = \"poured\"".to_owned(), "form = \"steak\"".to_owned(), "belongs to form = \"poured\""),
        ("tofu", "form = \"steak\"".to_owned(), "form = \"poured\"".to_owned(), "needs a table [yolk]"),
        ("egg", "sets_by = \"clouding\"".to_owned(), "sets_by = \"clouds\"".to_owned(), "clouds"),
        ("tofu", "[outline]\n".to_owned(), corners("[-1, -1], [1, 1], [1, -1], [-1, 1]"), "corners"),
        ("tofu", "[outline]\n".to_owned(), corners("[-1, -1], [1, -1], [1, -1], [0, 1]"), "lie on each other"),
        ("carrot-coin", "[outline]\n".to_owned(), corners("[-1, -1], [1, -1], [0, 1]"), "belong to form = \"steak\""),
    ] {
        let name = format!("foods/{file}.toml");
        let shipped = &files[name.as_str()];
        assert!(shipped.contains(&from), "{from}");
        let own = [(name.clone(), shipped.replacen(&from, &to, 1))];
        let error = match Library::with(&own) {
            Err(error) => error.to_string(),
            Ok(library) => {
                let mut kitchen = Kitchen::new(&library, "carbon-steel-26", kelvin(20.0)).expect("kitchen");
                kitchen.add(&library, &order(&library)).expect_err("is refused").to_string()
            }
        };
        assert!(error.contains(words), "{name}: {error}");
    }
}
