//! What was done in a cook, as summaries and pages tell it.

use serde::Serialize;
use serde_json::{Value, json};

use crate::recipe::{Action, Deed};
use saute_kitchen::hands::command::Command;

/// A step that was carried out.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct StepRecord {
    /// When [s].
    pub time_s: f64,
    /// Name of the action's key.
    pub action: &'static str,
    /// The food, the group, or "all", if it has one.
    pub target: Option<String>,
    /// The foods to which it was done.
    pub foods: Vec<String>,
    /// Its value: watts, seconds, a place or a surface.
    pub value: Value,
}

/// Name of an action's key, its target and its value in the units of the recipe.
pub(crate) fn parts(action: &Action) -> (&'static str, Option<&str>, Value) {
    match action {
        Action::Do(command) => {
            let (key, value) = command_parts(command);
            (key, None, value)
        }
        Action::Each(target, deed) => {
            let (key, value) = deed_parts(*deed);
            (key, Some(&target.name), value)
        }
        Action::End => ("end", None, true.into()),
    }
}

fn command_parts(command: &Command) -> (&'static str, Value) {
    match command {
        Command::Hob(power) => ("hob_w", (*power).into()),
        Command::MovePan { at, lift } => ("move_pan", json!({ "at_mm": at.map(mm), "lift_mm": mm(*lift) })),
        Command::Cool { for_s } => ("cool", (*for_s).into()),
        Command::Toss { height } => ("toss", json!({ "height_mm": mm(*height) })),
        Command::Shake { amplitude, hz, for_s } => {
            ("shake", json!({ "amplitude_mm": mm(*amplitude), "hz": hz, "for_s": for_s }))
        }
        Command::Tilt { angle, towards } => {
            ("tilt", json!({ "deg": tidy(angle.to_degrees()), "towards_deg": tidy(towards.to_degrees()) }))
        }
        Command::Oil { kind, mass } => ("oil_g", json!({ "g": mm(*mass), "kind": kind })),
        Command::Butter(mass) => ("butter_g", mm(*mass).into()),
        Command::Water(mass) => ("water_g", mm(*mass).into()),
        Command::Lead { .. } => ("lead", Value::Null),
        Command::LetGo => ("let_go", Value::Null),
        Command::HoldPan { .. } => ("hold_pan", Value::Null),
        Command::Lid(on) => ("lid", (*on).into()),
        Command::Put { at, heap, .. } => deed_parts(Deed::Put { at: *at, heap: *heap }),
        Command::Flip { .. } => deed_parts(Deed::Flip),
        Command::Rest { on, .. } => deed_parts(Deed::Rest(*on)),
        Command::Halve { at, .. } => deed_parts(Deed::Halve { at: *at }),
        Command::Press { newtons, for_s, .. } => deed_parts(Deed::Press { newtons: *newtons, for_s: *for_s }),
        Command::Move { to, .. } => deed_parts(Deed::Move(*to)),
    }
}

fn deed_parts(deed: Deed) -> (&'static str, Value) {
    match deed {
        Deed::Put { at, heap: false } => ("put", json!(at.map(mm))),
        Deed::Put { at, heap: true } => ("put", json!({ "at_mm": at.map(mm), "heap": true })),
        Deed::Flip => ("flip", Value::Null),
        Deed::Rest(on) => ("rest", json!(on)),
        Deed::Halve { at } => ("halve", json!({ "at_mm": mm(at) })),
        Deed::Press { newtons, for_s } => ("press", json!({ "n": newtons, "for_s": for_s })),
        Deed::Move(to) => ("move", json!(to.map(mm))),
    }
}

pub(crate) fn record(action: &Action, foods: Vec<String>, time_s: f64) -> StepRecord {
    let (action, target, value) = parts(action);
    StepRecord { time_s: rounded(time_s), action, target: target.map(str::to_owned), foods, value }
}

/// A length in millimetres from metres, or a mass in grams from kilograms.
pub(crate) fn mm(si: f64) -> f64 {
    tidy(si * 1e3)
}

/// A number that was read from a recipe without the noise of its conversion to SI units and back.
fn tidy(value: f64) -> f64 {
    libm::round(value * 1e6) / 1e6
}

/// A time without the noise of binary fractions [s].
pub(crate) fn rounded(time_s: f64) -> f64 {
    libm::round(time_s * 1000.0) / 1000.0
}
