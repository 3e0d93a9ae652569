//! What hands change in a kitchen.

use glam::{DQuat, DVec3};
use saute_haptics::Pose;
use saute_kitchen::dynamics::Tool;
use saute_kitchen::food::{MeshSize, OutlineKind, Rules};
use saute_kitchen::hands::ranges::{
    ANY_TILT_DEG, ANY_TOSS_MM, COOL_S, FAT_G, FOR_S, HALVE_AT_MM, LIFT_MM, Limits, PAN_MM, PLACE_MM, PRESS_N,
    SHAKE_AMPLITUDE_MM, SHAKE_HZ, TILT_DEG, TOSS_HEIGHT_MM, TOWARDS_DEG, WATER_G,
};
use saute_kitchen::{Command, PieceOrder, RestOn, kelvin};
use saute_recipe::session::Deed;

use super::{Before, Change, Part, Range, Way};

const fn within(limits: Limits) -> Range {
    Range::Within(limits.low, limits.high)
}

const fn between([low, high]: [f64; 2]) -> Range {
    Range::Within(low, high)
}

const fn step(text: &'static str, named: &'static [&'static str], range: Range) -> Option<Way<Part>> {
    Some(Way { write: Part::Step(text), named, range })
}

type PossibleDeed = Option<Way<fn(f64) -> Deed>>;

const fn entry(write: fn(f64) -> Deed, named: &'static [&'static str], range: Range) -> PossibleDeed {
    Some(Way { write, named, range })
}

/// A change of the pan or of food in it.
const IN_PAN: Change =
    Change { name: "", before: Before::InPan, recipe: None, entry: None, python: None, posed: false };

fn food() -> String {
    "steak".to_owned()
}

fn done(command: Command) -> Deed {
    Deed::Command(command)
}

fn held(position: DVec3, rotation: DQuat) -> Deed {
    done(Command::HoldPan { pose: Pose { position, rotation } })
}

fn led(position: DVec3, rotation: DQuat) -> Deed {
    done(Command::Lead { tool: Tool::Tongs, to: Pose { position, rotation }, grip: Some(food()) })
}

/// The order of a small steak.
fn order() -> PieceOrder {
    PieceOrder {
        id: "second".to_owned(),
        kind: "beef-lean".to_owned(),
        size: [0.06, 0.05, 0.015],
        temperature: kelvin(5.0),
        seed: 1,
        coarseness: 4.0,
        rules: Rules::Full,
        mesh: MeshSize::Default,
        outline: OutlineKind::Plain,
    }
}

const IN_REACH: DVec3 = DVec3::new(0.0, 0.0, 0.1);
const NO_POSE: &[&str] = &["this pose is none"];
const NO_ROOM: &[&str] = &["the pan cannot take this amount"];
const HOB_GIVES: &[&str] = &["the hob gives 0 to"];
const PAN_PLACE: &[&str] = &["the pan can be moved and lifted by up to"];

/// All changes.
pub const CHANGES: &[Change] = &[
    Change {
        name: "power of the hob [W]",
        recipe: step("hob_w = #", &["hob_w"], Range::Fitting),
        entry: entry(|v| done(Command::Hob(v)), HOB_GIVES, Range::Fitting),
        python: Some(("hob(w)", Range::Fitting)),
        ..IN_PAN
    },
    Change {
        name: "temperature that the hob holds [°C]",
        recipe: step("hob_w = { w = 1000, hold_c = # }", &["hob_w.hold_c"], Range::Fitting),
        entry: entry(
            |v| done(Command::HobHold { temperature: kelvin(v), power: 1000.0 }),
            &["the hob holds"],
            Range::Fitting,
        ),
        python: Some(("hob_hold(c)", Range::Fitting)),
        ..IN_PAN
    },
    Change {
        name: "power with which the hob holds it [W]",
        recipe: step("hob_w = { w = #, hold_c = 180 }", &["hob_w"], Range::Fitting),
        entry: entry(|v| done(Command::HobHold { temperature: kelvin(180.0), power: v }), HOB_GIVES, Range::Fitting),
        python: Some(("hob_hold(w)", Range::Fitting)),
        ..IN_PAN
    },
    Change {
        name: "put: place [mm]",
        before: Before::Waiting,
        recipe: step("put = { food = \"steak\", at_mm = [#, 0] }", &["at_mm"], within(PLACE_MM)),
        entry: entry(
            |v| done(Command::Put { food: food(), at: [1e-3 * v, 0.0], heap: false }),
            &["put.at_mm"],
            within(PLACE_MM),
        ),
        python: Some(("put(at_mm)", within(PLACE_MM))),
        ..IN_PAN
    },
    Change {
        name: "put onto a heap: place [mm]",
        before: Before::Waiting,
        recipe: step("put = { food = \"steak\", at_mm = [0, #], heap = true }", &["at_mm"], within(PLACE_MM)),
        entry: entry(
            |v| done(Command::Put { food: food(), at: [0.0, 1e-3 * v], heap: true }),
            &["put.at_mm"],
            within(PLACE_MM),
        ),
        python: Some(("put(heap)", within(PLACE_MM))),
        ..IN_PAN
    },
    Change {
        name: "flip",
        recipe: step("flip = \"steak\"", &[], Range::Plain),
        entry: entry(|_| done(Command::Flip { food: food() }), &[], Range::Plain),
        python: Some(("flip()", Range::Plain)),
        ..IN_PAN
    },
    Change {
        name: "rest",
        recipe: step("rest = \"steak\"", &[], Range::Plain),
        entry: entry(|_| done(Command::Rest { food: food(), on: RestOn::Rack }), &[], Range::Plain),
        python: Some(("rest()", Range::Plain)),
        ..IN_PAN
    },
    Change {
        name: "halve: place of the cut [mm]",
        before: Before::OnBoard,
        recipe: step("halve = { food = \"steak\", at_mm = # }", &["halve.at_mm"], within(HALVE_AT_MM)),
        entry: entry(
            |v| done(Command::Halve { food: food(), at: 1e-3 * v }),
            &["halve.at_mm", "the knife would miss"],
            Range::Fitting,
        ),
        python: Some(("halve(at_mm)", within(HALVE_AT_MM))),
        ..IN_PAN
    },
    Change {
        name: "press: force [N]",
        recipe: step("press = { food = \"steak\", n = #, for_s = 0.5 }", &["press.n"], within(PRESS_N)),
        entry: entry(|v| done(Command::Press { food: food(), newtons: v, for_s: 0.5 }), &["press.n"], within(PRESS_N)),
        python: Some(("press(n)", within(PRESS_N))),
        ..IN_PAN
    },
    Change {
        name: "press: duration [s]",
        recipe: step("press = { food = \"steak\", for_s = # }", &["press.for_s"], within(FOR_S)),
        entry: entry(
            |v| done(Command::Press { food: food(), newtons: 10.0, for_s: v }),
            &["press.for_s"],
            within(FOR_S),
        ),
        python: Some(("press(for_s)", within(FOR_S))),
        ..IN_PAN
    },
    Change {
        name: "baste: duration [s]",
        recipe: step("baste = { food = \"steak\", for_s = # }", &["baste.for_s"], within(FOR_S)),
        entry: entry(
            |v| done(Command::Baste { food: food(), for_s: v }),
            &["baste.for_s", "too little fat"],
            within(FOR_S),
        ),
        python: Some(("baste(for_s)", within(FOR_S))),
        ..IN_PAN
    },
    Change {
        name: "move food: place [mm]",
        recipe: step("move = { food = \"steak\", to_mm = [#, 0] }", &["move.to_mm"], within(PLACE_MM)),
        entry: entry(|v| done(Command::Move { food: food(), to: [1e-3 * v, 0.0] }), &["move.to_mm"], within(PLACE_MM)),
        python: Some(("move(to_mm)", within(PLACE_MM))),
        ..IN_PAN
    },
    Change {
        name: "move the pan: place [mm]",
        recipe: step("move_pan = { at_mm = [#, 0] }", &["move_pan.at_mm"], within(PAN_MM)),
        entry: entry(|v| done(Command::MovePan { at: [1e-3 * v, 0.0], lift: 0.0 }), PAN_PLACE, Range::Fitting),
        python: Some(("move_pan(at_mm)", Range::Fitting)),
        ..IN_PAN
    },
    Change {
        name: "move the pan: lift [mm]",
        recipe: step("move_pan = { lift_mm = # }", &["move_pan.lift_mm"], within(LIFT_MM)),
        entry: entry(|v| done(Command::MovePan { at: [0.0; 2], lift: 1e-3 * v }), PAN_PLACE, Range::Fitting),
        python: Some(("move_pan(lift_mm)", within(LIFT_MM))),
        ..IN_PAN
    },
    Change {
        name: "cool: duration [s]",
        recipe: step("cool = \"wet-cloth\"\nfor_s = #", &["for_s"], within(COOL_S)),
        entry: entry(|v| done(Command::Cool { for_s: v }), &["cool.for_s"], within(COOL_S)),
        python: Some(("cool(for_s)", within(COOL_S))),
        ..IN_PAN
    },
    Change {
        name: "toss: height [mm]",
        recipe: step("toss = { height_mm = # }", &["toss.height_mm"], within(TOSS_HEIGHT_MM)),
        entry: entry(|v| done(Command::Toss { height: 1e-3 * v }), &["toss.height_mm"], within(ANY_TOSS_MM)),
        python: Some(("toss(height_mm)", within(TOSS_HEIGHT_MM))),
        ..IN_PAN
    },
    Change {
        name: "shake: amplitude [mm]",
        recipe: step("shake = { amplitude_mm = # }", &["shake.amplitude_mm"], within(SHAKE_AMPLITUDE_MM)),
        entry: entry(
            |v| done(Command::Shake { amplitude: 1e-3 * v, hz: 3.0, for_s: 0.5 }),
            &["shake.amplitude_mm"],
            within(SHAKE_AMPLITUDE_MM),
        ),
        python: Some(("shake(amplitude_mm)", within(SHAKE_AMPLITUDE_MM))),
        ..IN_PAN
    },
    Change {
        name: "shake: frequency [Hz]",
        recipe: step("shake = { hz = # }", &["shake.hz"], within(SHAKE_HZ)),
        entry: entry(|v| done(Command::Shake { amplitude: 0.02, hz: v, for_s: 0.5 }), &["shake.hz"], within(SHAKE_HZ)),
        python: Some(("shake(hz)", within(SHAKE_HZ))),
        ..IN_PAN
    },
    Change {
        name: "shake: duration [s]",
        recipe: step("shake = #", &["step.shake"], within(FOR_S)),
        entry: entry(|v| done(Command::Shake { amplitude: 0.02, hz: 3.0, for_s: v }), &["shake.for_s"], within(FOR_S)),
        python: Some(("shake(for_s)", within(FOR_S))),
        ..IN_PAN
    },
    Change {
        name: "tilt: angle [°]",
        recipe: step("tilt = #", &["step.tilt"], between(TILT_DEG)),
        entry: entry(
            |v| done(Command::Tilt { angle: v.to_radians(), towards: 0.0 }),
            &["tilt.deg"],
            within(ANY_TILT_DEG),
        ),
        python: Some(("tilt(deg)", between(TILT_DEG))),
        ..IN_PAN
    },
    Change {
        name: "tilt: direction [°]",
        recipe: step("tilt = { deg = 15, towards_deg = # }", &["tilt.towards_deg"], within(TOWARDS_DEG)),
        entry: entry(
            |v| done(Command::Tilt { angle: 0.2, towards: v.to_radians() }),
            &["tilt.towards_deg"],
            within(TOWARDS_DEG),
        ),
        python: Some(("tilt(towards_deg)", within(TOWARDS_DEG))),
        ..IN_PAN
    },
    Change {
        name: "hold the pan: place [m]",
        entry: entry(|v| held(DVec3::new(v, 0.0, 0.1), DQuat::IDENTITY), NO_POSE, Range::Reach),
        python: Some(("hold_pan(pose_m)", Range::Reach)),
        posed: true,
        ..IN_PAN
    },
    Change {
        name: "hold the pan: orientation [-]",
        entry: entry(|v| held(IN_REACH, DQuat::from_xyzw(v, 0.0, 0.0, 1.0)), NO_POSE, Range::Reach),
        python: Some(("hold_pan(pose_m)", Range::Reach)),
        posed: true,
        ..IN_PAN
    },
    Change {
        name: "lead turner or tongs, grip: place [m]",
        entry: entry(|v| led(DVec3::new(0.0, v, 0.1), DQuat::IDENTITY), NO_POSE, Range::Reach),
        python: Some(("lead(pose_m)", Range::Reach)),
        posed: true,
        ..IN_PAN
    },
    Change {
        name: "lead turner or tongs, grip: orientation [-]",
        entry: entry(|v| led(IN_REACH, DQuat::from_xyzw(0.0, v, 0.0, 1.0)), NO_POSE, Range::Reach),
        python: Some(("lead(pose_m)", Range::Reach)),
        posed: true,
        ..IN_PAN
    },
    Change {
        name: "let go",
        entry: entry(|_| done(Command::LetGo), &[], Range::Plain),
        python: Some(("let_go()", Range::Plain)),
        posed: true,
        ..IN_PAN
    },
    Change {
        name: "oil [g]",
        recipe: step("oil_g = #", &["oil_g"], between(FAT_G)),
        entry: entry(|v| done(Command::Oil { kind: None, mass: 1e-3 * v }), NO_ROOM, Range::Fitting),
        python: Some(("oil(g)", between(FAT_G))),
        ..IN_PAN
    },
    Change {
        name: "butter [g]",
        recipe: step("butter_g = #", &["butter_g"], between(FAT_G)),
        entry: entry(|v| done(Command::Butter(1e-3 * v)), NO_ROOM, Range::Fitting),
        python: Some(("butter(g)", between(FAT_G))),
        ..IN_PAN
    },
    Change {
        name: "water [g]",
        recipe: step("water_g = #", &["water_g"], between(WATER_G)),
        entry: entry(|v| done(Command::Water(1e-3 * v)), NO_ROOM, Range::Fitting),
        python: Some(("water(g)", between(WATER_G))),
        ..IN_PAN
    },
    Change {
        name: "lid",
        recipe: step("lid = true", &[], Range::Plain),
        entry: entry(|_| done(Command::Lid(true)), &[], Range::Plain),
        python: Some(("lid()", Range::Plain)),
        ..IN_PAN
    },
    Change {
        name: "wipe",
        before: Before::OnBoard,
        recipe: step("wipe = true", &[], Range::Plain),
        entry: entry(|_| done(Command::Wipe), &[], Range::Plain),
        python: Some(("wipe()", Range::Plain)),
        ..IN_PAN
    },
    Change {
        name: "add a food: temperature [°C]",
        entry: entry(
            |v| Deed::Add(PieceOrder { temperature: kelvin(v), ..order() }),
            &["food begins with"],
            between(PieceOrder::INITIAL_C),
        ),
        ..IN_PAN
    },
    Change {
        name: "add a food: spacing of its mesh [-]",
        entry: entry(
            |v| Deed::Add(PieceOrder { coarseness: v, ..order() }),
            &["its spacing is"],
            Range::Within(*PieceOrder::COARSENESS.start(), *PieceOrder::COARSENESS.end()),
        ),
        ..IN_PAN
    },
    Change {
        name: "add a food: thickness [mm]",
        entry: entry(
            |v| {
                let [length, width, _] = order().size;
                Deed::Add(PieceOrder { size: [length, width, 1e-3 * v], ..order() })
            },
            &["thickness"],
            Range::Fitting,
        ),
        ..IN_PAN
    },
    Change { name: "remove a food", entry: entry(|_| Deed::Remove(food()), &[], Range::Plain), ..IN_PAN },
];
