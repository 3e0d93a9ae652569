//! What a kitchen begins with.

use saute_kitchen::PieceOrder;
use saute_kitchen::data::at_home::{CONTACT_FACTOR, HOB_FACTOR};
use saute_kitchen::hands::ranges::{MAX_S, PAN_INITIAL_C, PAN_OIL_G};

use super::{Part, Range, Start, Way};

const fn start(name: &'static str, write: Part, named: &'static [&'static str], range: Range) -> Start {
    Start { name, recipe: Way { write, named, range } }
}

/// All that a kitchen begins with.
pub const STARTS: &[Start] = &[
    start("kind of the pan", Part::Pan("kind = \"cast-iron-26\""), &[], Range::Plain),
    start(
        "temperature of the pan [°C]",
        Part::Pan("initial_c = #"),
        &["pan.initial_c"],
        Range::Within(PAN_INITIAL_C.low, PAN_INITIAL_C.high),
    ),
    start("oil in the pan [g]", Part::Pan("oil_g = #"), &["pan.oil_g"], Range::Within(PAN_OIL_G[0], PAN_OIL_G[1])),
    start("kind of the hob", Part::Hob("kind = \"gas\""), &[], Range::Plain),
    start(
        "food: temperature [°C]",
        Part::Food("initial_c = #"),
        &["food.initial_c"],
        Range::Within(PieceOrder::INITIAL_C[0], PieceOrder::INITIAL_C[1]),
    ),
    start(
        "food: spacing of its mesh [-]",
        Part::Food("coarseness = #"),
        &["food.coarseness"],
        Range::Within(*PieceOrder::COARSENESS.start(), *PieceOrder::COARSENESS.end()),
    ),
    start("food: thickness [mm]", Part::Food("size_mm = [60, 50, #]"), &["size_mm"], Range::Fitting),
    start("food: seed [-]", Part::Food("seed = #"), &["seed"], Range::Fitting),
    start("food: pieces of a group [-]", Part::Food("count = #"), &["count"], Range::Fitting),
    start("end of the cook [s]", Part::Top("max_s = #"), &["max_s"], Range::Within(MAX_S.low, MAX_S.high)),
    start(
        "kitchen at home: factor on the hob's efficiency [-]",
        Part::Home("hob_factor = #\ncontact_factor = 1"),
        &["hob_factor"],
        Range::Within(HOB_FACTOR[0], HOB_FACTOR[1]),
    ),
    start(
        "kitchen at home: factor on the contact [-]",
        Part::Home("hob_factor = 1\ncontact_factor = #"),
        &["contact_factor"],
        Range::Within(CONTACT_FACTOR[0], CONTACT_FACTOR[1]),
    ),
];
