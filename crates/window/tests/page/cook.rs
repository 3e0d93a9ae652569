//! Records a cook as the window does, for the page's tests: they open it there and compare the hashes of its states.

use std::path::Path;
use std::sync::Arc;

use saute_controls::session::Session;
use saute_kitchen::{Command, Library};
use saute_recipe::{Recipe, Replay};

/// A dish with everything that a hand does: rigid bodies, liquids, a lid.
const DISH: &str = r#"
title = "Dish"
[pan]
initial_c = 160
[[food]]
id = "carrots"
kind = "carrot-coin"
count = 5
[[food]]
id = "shrimp"
kind = "shrimp"
[[step]]
hob_w = 1400
[[step]]
butter_g = 10
[[step]]
put = "carrots"
[[step]]
put = { food = "shrimp", heap = true }
[[step]]
at_s = 10
toss = true
[[step]]
at_s = 900
end = true
"#;

#[test]
fn a_cook_for_the_page_replays_bit_by_bit() {
    let library = Arc::new(Library::embedded().expect("embedded data"));
    let mut session = Session::new(Arc::clone(&library), &Default::default()).expect("sets out");
    session.play(Recipe::parse(DISH, "dish.toml", &library).expect("parses")).expect("plays");
    let cook = |session: &mut Session, until_s: f64| {
        while session.kitchen.time_s() < until_s - 1e-9 {
            session.tick().expect("ticks");
        }
    };
    cook(&mut session, 20.0);
    session.command(&Command::Flip { food: "shrimp".into() }).expect("flips");
    cook(&mut session, 35.0);
    session.command(&Command::Water(0.02)).expect("pours");
    session.command(&Command::Lid(true)).expect("lids");
    cook(&mut session, 50.0);
    session.command(&Command::Lid(false)).expect("lids");
    session.command(&Command::Hob(500.0)).expect("hob");
    cook(&mut session, 62.0);
    let recording = session.whole_recording();
    let mut replay = Replay::begin(&recording, &library).expect("begins");
    replay.run_to(&recording, &library, recording.moment());
    assert_eq!(replay.departure(), None);
    let hashes: String = recording.hashes().iter().map(|(frame, hash)| format!("{frame} {hash:016x}\n")).collect();
    assert!(hashes.lines().count() > 5, "{hashes}");
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("page-stills");
    std::fs::create_dir_all(&folder).expect("folder");
    std::fs::write(folder.join("cook.saute"), recording.to_file()).expect("is written");
    std::fs::write(folder.join("cook.hashes"), hashes).expect("is written");
}
