//! Refusals of the kitchen in the language of the window.

use saute_kitchen::{Library, Refused};

use crate::language::Language;
use crate::piece_words::name;

/// A refusal in words.
pub fn words(refused: &Refused, library: &Library, l: Language) -> String {
    let of = |key, food: &String| l.fill(key, &[("food", &name(food, library, l))]);
    match refused {
        Refused::NoSuchFood(food) => of("refused.no_such_food", food),
        Refused::NotInPan(food) => of("refused.not_in_pan", food),
        Refused::NotOnBoard(food) => of("refused.not_on_board", food),
        Refused::AlreadyHalved(food) => of("refused.already_halved", food),
        Refused::BesideFood { food, most_mm } => {
            l.fill("refused.beside_food", &[("food", &name(food, library, l)), ("most", most_mm)])
        }
        Refused::AlreadyInPan(food) => of("refused.already_in_pan", food),
        Refused::DoesNotFit { food, reach_mm, floor_mm } => l.fill(
            "refused.does_not_fit",
            &[("food", &name(food, library, l)), ("reach", reach_mm), ("floor", floor_mm)],
        ),
        Refused::Occupied { food, other } => {
            l.fill("refused.occupied", &[("food", &name(food, library, l)), ("other", &name(other, library, l))])
        }
        Refused::TooLittleFat { least_g } => l.fill("refused.too_little_fat", &[("least", least_g)]),
        Refused::StillRuns(food) => of("refused.still_runs", food),
        Refused::Waiting(food) => of("refused.waiting", food),
        Refused::EmptyPan => l.text("refused.empty_pan").to_owned(),
        Refused::PanPlace { farthest_mm } => l.fill("refused.pan_place", &[("farthest", farthest_mm)]),
        Refused::Power { largest_w } => l.fill("refused.power", &[("largest", largest_w)]),
        Refused::FoodToWipe(food) => of("refused.food_to_wipe", food),
        Refused::NoSensor => l.text("refused.no_sensor").to_owned(),
        Refused::HoldTemperature { lowest_c, highest_c } => {
            l.fill("refused.hold_temperature", &[("lowest", lowest_c), ("highest", highest_c)])
        }
        Refused::NoSuchOil { kind, known } => {
            let known: Vec<&str> = known.split(", ").map(|oil| l.called("oil", oil)).collect();
            let separator = l.text("refused.separator");
            l.fill("refused.no_such_oil", &[("kind", &l.called("oil", kind)), ("known", &known.join(separator))])
        }
        Refused::Amount { what, holds_g } => {
            l.fill("refused.amount", &[("what", &l.called("amount", what)), ("most", holds_g)])
        }
        Refused::Range { key, low, high } => {
            let what = l.known("range", &key.replace('.', "-")).unwrap_or(key);
            l.fill("refused.range", &[("what", &what), ("low", low), ("high", high)])
        }
        Refused::NoPose => l.text("refused.no_pose").to_owned(),
        Refused::LidIsOn => l.text("refused.lid_is_on").to_owned(),
    }
}
