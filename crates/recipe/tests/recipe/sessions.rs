//! Promise: a session is played again bit by bit: recipes, hands that take over, devices, foods that come and go, and undone deeds;
//! through its file too, however often that was appended to.

use std::sync::Arc;

use saute_kitchen::dynamics::{Pose, Tool};
use saute_kitchen::food::{MeshSize, OutlineKind, Rules};
use saute_kitchen::{Command, Library, PieceOrder, RestOn, kelvin};
use saute_recipe::session::{FoodDetail, SetOutFood, set_out};
use saute_recipe::{Cook, Recipe, Recording, Replay};

use saute_fixtures::draws::{Draws, count, seed};

/// A recipe that plays while a hand may take over.
const RECIPE: &str = r#"
title = "Shrimps and a coin"
max_s = 120
[pan]
initial_c = 160
[[food]]
id = "shrimp"
kind = "shrimp"
mesh = "2013"
count = 3
[[food]]
id = "coin"
kind = "carrot-coin"
mesh = "2013"
[[step]]
oil_g = 8
[[step]]
hob_w = 1500
[[step]]
put = "shrimp"
[[step]]
after_s = 3
put = { food = "coin", heap = true }
[[step]]
after_s = 2
shake = 1
[[step]]
after_s = 3
flip = "shrimp"
[[step]]
after_s = 10
end = true
"#;

fn pose(draws: &mut Draws) -> Pose {
    let mut pose = Pose::at(draws.within(-0.06, 0.06), draws.within(-0.06, 0.06), draws.within(0.0, 0.08));
    pose.rotation.x = draws.within(-0.15, 0.15);
    pose.rotation = pose.rotation.normalize();
    pose
}

fn command(foods: &[String], draws: &mut Draws) -> Command {
    let food = foods[draws.below(foods.len() as u64) as usize].clone();
    let at = [draws.within(-0.05, 0.05), draws.within(-0.05, 0.05)];
    match draws.below(14) {
        0 => Command::Hob(draws.within(0.0, 3000.0)),
        1 => Command::Put { food, at, heap: true },
        2 => Command::Flip { food },
        3 => Command::Rest { food, on: RestOn::Rack },
        4 => Command::Halve { food, at: 0.0 },
        5 => Command::MovePan { at, lift: draws.within(0.0, 0.1) },
        6 => Command::Cool { for_s: 1.0 },
        7 => Command::Toss { height: draws.within(0.05, 0.2) },
        8 => Command::Shake { amplitude: 0.02, hz: 3.0, for_s: 1.0 },
        9 => Command::Tilt { angle: draws.within(0.0, 0.4), towards: draws.within(0.0, 6.0) },
        10 => Command::Press { food, newtons: draws.within(1.0, 20.0), for_s: 0.7 },
        11 => Command::Lead { tool: Tool::Tongs, to: pose(draws), grip: Some(food) },
        12 => Command::Water(draws.within(0.001, 0.03)),
        _ => Command::Lid(draws.below(2) == 0),
    }
}

fn added(name: String) -> PieceOrder {
    PieceOrder {
        id: name,
        kind: "carrot-coin".into(),
        size: [0.026, 0.026, 0.006],
        temperature: kelvin(15.0),
        seed: 7,
        coarseness: 1.0,
        rules: Rules::Full,
        mesh: MeshSize::Paper2013,
        outline: OutlineKind::Plain,
    }
}

/// A live session as a window has it.
struct Live<'a> {
    library: &'a Library,
    here: Replay,
    recording: Recording,
    file: Vec<u8>,
}

impl<'a> Live<'a> {
    fn begin(library: &'a Library, recipe: &Recipe, plays: bool) -> Self {
        let recording = Recording::begin(recipe, plays, library);
        let mut here = Replay::begin(&recording, library).expect("begins");
        here.kitchen.listen();
        let mut live = Self { library, here, recording, file: Vec::new() };
        live.recording.observe(&live.here.kitchen);
        live
    }

    fn plays(&self) -> bool {
        self.recording.beginning().plays && !self.recording.is_taken_over()
    }

    /// What a frame of the window does; `device` moves pan or turner in it.
    fn frame(&mut self, device: Option<Command>) {
        let Replay { kitchen, runner, .. } = &mut self.here;
        if kitchen.is_between_ticks() && self.recording.beginning().plays && !self.recording.is_taken_over() {
            runner.poll(kitchen).expect("carried out");
            self.recording.on_steps(kitchen);
        }
        device.iter().for_each(|command| _ = kitchen.apply(command));
        self.recording.take(kitchen);
        kitchen.advance_frame();
        self.recording.observe(kitchen);
    }

    fn person(&mut self, command: Command) {
        if self.here.kitchen.apply(&command).is_ok() {
            self.recording.take_over(&self.here.kitchen);
            self.recording.take(&mut self.here.kitchen);
        }
    }

    /// Undoes from a random entry on.
    fn undo(&mut self, draws: &mut Draws) {
        let count = self.recording.entries().len() as u64;
        if count == 0 {
            return;
        }
        let moment = self.recording.before(draws.below(count) as usize).expect("an entry");
        self.recording.truncate(moment);
        let mut replay = Replay::begin(&self.recording, self.library).expect("begins");
        replay.run_to(&self.recording, self.library, moment);
        assert_eq!(replay.departure(), None);
        self.here = replay;
        self.here.kitchen.listen();
    }
}

fn random_session<'a>(library: &'a Library, draws: &mut Draws) -> Live<'a> {
    let recipe = Recipe::parse(RECIPE, "random.toml", library).expect("parses");
    let plays = draws.below(4) > 0;
    let mut live = Live::begin(library, &recipe, plays);
    let (takes_over_at, mut foods_added) = (draws.below(1200), 0);
    let device_from = draws.below(2000);
    for frame in 0..900 + draws.below(600) {
        let is_free = !live.plays();
        if (frame >= takes_over_at || is_free) && draws.below(40) == 0 {
            let foods: Vec<String> = live.here.kitchen.pieces().iter().map(|p| p.id.clone()).collect();
            match draws.below(12) {
                0 => {
                    foods_added += 1;
                    let order = added(format!("more-{foods_added}"));
                    if live.here.kitchen.add(library, &order).is_ok() {
                        live.recording.add(&live.here.kitchen, order);
                    }
                }
                1 if foods.len() > 2 => {
                    live.here.kitchen.remove(&foods[0]);
                    live.recording.remove(&live.here.kitchen, &foods[0]);
                }
                2 => live.undo(draws),
                _ => live.person(command(&foods, draws)),
            }
        }
        let device = (frame > device_from && frame < device_from + 100).then(|| Command::HoldPan { pose: pose(draws) });
        live.frame(device);
        if draws.below(60) == 0 {
            let appended = live.recording.unsaved();
            live.file.extend(appended);
        }
    }
    let appended = live.recording.unsaved();
    live.file.extend(appended);
    live
}

/// Plays a session to its end.
fn cooked_again(recording: Recording, library: &Library) -> Cook {
    let mut cook = Cook::again(recording, Arc::new(library.clone())).expect("begins");
    while cook.stopped().is_none() {
        cook.advance().expect("goes on");
    }
    cook
}

#[test]
fn random_sessions_are_played_again_bit_by_bit_from_their_files() {
    let library = Library::embedded().expect("embedded data");
    let mut draws = Draws(seed());
    let (mut entries, mut over) = (0, 0);
    for session in 0..count("SAUTE_RANDOM_SESSIONS", 10) {
        let live = random_session(&library, &mut draws);
        let opened = Recording::from_file(&live.file).expect("opens");
        assert_eq!(opened.damage, None);
        let read = opened.recording;
        assert_eq!(read.entries(), live.recording.entries(), "session {session}");
        assert_eq!(read.hashes(), live.recording.hashes(), "session {session}");
        assert_eq!(read.moment().frame, live.recording.moment().frame, "session {session}");
        let cook = cooked_again(read.clone(), &library);
        assert_eq!(cook.departure(), None, "session {session}");
        assert_eq!(cook.kitchen.state_hash(), live.here.kitchen.state_hash(), "session {session}");
        serde_json::to_string(&cook.summary(0.0)).expect("numbers");
        // The whole file, written again, states the same.
        let anew = Recording::from_file(&live.recording.to_file()).expect("opens").recording;
        assert_eq!((anew.entries(), anew.hashes()), (read.entries(), read.hashes()));
        entries += read.entries().len();
        over += u32::from(read.is_taken_over());
    }
    println!("{} sessions with {entries} entries, {over} taken over", count("SAUTE_RANDOM_SESSIONS", 10));
}

#[test]
fn a_keyframe_leads_to_the_same_instant_as_the_beginning() {
    let library = Library::embedded().expect("embedded data");
    let live = random_session(&library, &mut Draws(3));
    let recording = &live.recording;
    let mut from_start = Replay::begin(recording, &library).expect("begins");
    from_start.run_to(recording, &library, recording.moment_at(300));
    let mut keyframe = from_start.clone();
    let bytes = from_start.kitchen.to_bytes();
    let later = recording.moment_at(420);
    from_start.run_to(recording, &library, later);
    keyframe.run_to(recording, &library, later);
    assert!(from_start.kitchen.to_bytes() == keyframe.kitchen.to_bytes());
    assert!(saute_kitchen::Kitchen::from_bytes(&bytes, &library).is_ok());
}

/// The kitchen of a window's choice is the kitchen of the recipe that states it.
#[test]
fn a_choice_is_set_out_as_a_recipe() {
    let library = Library::embedded().expect("embedded data");
    let food = SetOutFood {
        id: "steak".into(),
        kind: "beef-lean".into(),
        size_mm: vec![120.0, 80.0, 25.3],
        initial_c: 5.5,
        seed: 1,
        count: None,
        detail: FoodDetail::default(),
    };
    let shrimps = SetOutFood {
        id: "shrimp".into(),
        kind: "shrimp".into(),
        size_mm: vec![80.0, 16.0],
        count: Some(2),
        ..food.clone()
    };
    let text = set_out("A \"choice\"", None, "cast-iron-26", 180.25, &[food, shrimps]);
    let recipe = Recipe::parse(&text, "choice", &library).expect("parses");
    assert_eq!((recipe.title.as_str(), recipe.pan_kind.as_str()), ("A \"choice\"", "cast-iron-26"));
    assert_eq!(recipe.pan_temperature, kelvin(180.25));
    let ids: Vec<&str> = recipe.foods.iter().map(|order| order.id.as_str()).collect();
    assert_eq!(ids, ["steak", "shrimp.1", "shrimp.2"]);
    assert_eq!(recipe.foods[0].size, [120.0, 80.0, 25.3].map(|mm| mm * 1e-3));
    assert_eq!((recipe.foods[0].temperature, recipe.foods[2].seed), (kelvin(5.5), 2));
}

/// A session with a hand's commands becomes a recipe whose cook goes nearly the same way.
#[test]
fn a_session_becomes_a_recipe() {
    let library = Library::embedded().expect("embedded data");
    let recipe = Recipe::parse(RECIPE, "random.toml", &library).expect("parses");
    let mut live = Live::begin(&library, &recipe, true);
    for frame in 0..1200 {
        match frame {
            500 => live.person(Command::Hob(700.0)),
            560 => live.person(Command::Put { food: "coin".into(), at: [0.04, 0.0], heap: true }),
            700 => live.person(Command::Flip { food: "shrimp.2".into() }),
            900 => live.person(Command::Rest { food: "coin".into(), on: RestOn::Foil }),
            _ => {}
        }
        live.frame((frame == 1000).then(|| Command::HoldPan { pose: Pose::at(0.0, 0.0, 0.1) }));
    }
    let cook = cooked_again(live.recording, &library);
    assert_eq!(cook.kitchen.state_hash(), live.here.kitchen.state_hash());
    let made = cook.to_recipe(&library).expect("a recipe");
    assert_eq!(made.left_out, ["motions of pan and tools in the hand"]);
    let again = Recipe::parse(&made.text, "again.toml", &library).expect("parses");
    let mut cooked = saute_recipe::Cook::new(again, &library).expect("builds");
    while cooked.stopped().is_none() {
        cooked.advance().expect("carried out");
    }
    assert!((cooked.kitchen.time_s() - 20.0).abs() < 0.11, "{}", cooked.kitchen.time_s());
    assert_eq!(cooked.kitchen.hob_w(), 700.0);
    let cores = |kitchen: &saute_kitchen::Kitchen| kitchen.pieces().iter().map(|p| p.core()).collect::<Vec<_>>();
    for (now, then) in cores(&cooked.kitchen).iter().zip(cores(&cook.kitchen)) {
        assert!((now - then).abs() < 3.0, "{}\n{now} K, {then} K", made.text);
    }
}

/// Promise: a session that is made a recipe of is cooked with the meshes, the outlines and the rules that it had.
#[test]
fn a_session_keeps_how_its_food_is_meshed_and_by_which_rules_it_cooks() {
    let library = Library::embedded().expect("embedded data");
    let coarse = "title = \"coarse\"\n[[food]]\nid = \"steak\"\nkind = \"beef-lean\"\ncoarseness = 2.5\noutline = \"plain\"\n\
                  [[step]]\nat_s = 60\nend = true\n";
    let of_2013 = "title = \"then\"\npreset = \"2013\"\n[[food]]\nid = \"steak\"\nkind = \"beef-lean\"\nmesh = \"2013\"\n\
                   [[step]]\nat_s = 60\nend = true\n";
    let individual = "title = \"own\"\n[[food]]\nid = \"steak\"\nkind = \"beef-lean\"\ncoarseness = 2.5\noutline = \"individual\"\n\
                      [[step]]\nat_s = 60\nend = true\n";
    for text in [coarse, of_2013, individual] {
        let recipe = Recipe::parse(text, "begun.toml", &library).expect("parses");
        let mut live = Live::begin(&library, &recipe, false);
        live.person(Command::Hob(900.0));
        (0..12).for_each(|_| live.frame(None));
        let made = cooked_again(live.recording, &library).to_recipe(&library).expect("a recipe");
        let again = Recipe::parse(&made.text, "again.toml", &library).expect("parses");
        assert_eq!((&again.foods, &again.title), (&recipe.foods, &recipe.title), "{}", made.text);
    }
}
