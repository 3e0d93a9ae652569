//! Cooks of many kinds, each forecast at an instant for all questions and then cooked in full.

use saute_fixtures::draws::Draws;
use saute_kitchen::food::Rules;
use saute_kitchen::reduced::Reductions;
use saute_kitchen::{Command, Kitchen, Library, MeshSize, OutlineKind, PieceOrder, kelvin};
use saute_plan::forecast::{Ahead, Ask, Exact, HORIZON_S, Outlook, Question, SPANS_S};

/// Name of the piece in every comparison.
pub const FOOD: &str = "steak";

/// A cook up to the instant at which it is forecast.
#[derive(Clone, Debug)]
pub struct Case {
    pub number: u64,
    pub kind: &'static str,
    pub size_mm: [f64; 3],
    pub food_c: f64,
    pub pan: &'static str,
    pub pan_c: f64,
    pub power_w: f64,
    /// Temperature that the hob keeps; none if it gives its power.
    pub held_c: Option<f64>,
    pub flipped_at_s: Option<f64>,
    pub at_s: f64,
}

/// What a forecast gave, less what the full cook did [K]: the core at each span, and its peak.
#[derive(Clone, Copy, Debug)]
pub struct Miss {
    pub question: Question,
    pub cores: [f64; SPANS_S.len()],
    /// None where the food was still too raw to have one.
    pub peak: Option<f64>,
}

impl Case {
    /// The case with a number: foods, thickness 15 to 40 mm, pans, powers and instants all differ.
    pub fn numbered(number: u64) -> Self {
        let mut draws = Draws(number);
        (0..4).for_each(|_| {
            draws.bits();
        });
        let kind = draws.pick(&["beef-lean", "beef-marbled", "beef-lean", "beef-patty"]);
        let thickness = draws.within(15.0, 40.0);
        let round = draws.within(85.0, 115.0);
        let size_mm = match kind {
            "beef-patty" => [round, round, thickness.min(30.0)],
            _ => [draws.within(90.0, 140.0), draws.within(65.0, 95.0), thickness],
        };
        let at_s = draws.within(30.0, 60.0 + 10.0 * thickness);
        let flips = draws.unit() < 0.5 && at_s > 90.0;
        Self {
            number,
            kind,
            size_mm,
            food_c: draws.within(3.0, 22.0),
            pan: draws.pick(&["stainless-clad-26", "cast-iron-26", "carbon-steel-26", "aluminium-26"]),
            pan_c: draws.within(150.0, 240.0),
            power_w: draws.within(400.0, 1600.0),
            held_c: (draws.unit() < 0.25).then(|| draws.within(150.0, 220.0)),
            flipped_at_s: flips.then(|| draws.within(0.3, 0.9) * at_s),
            at_s,
        }
    }

    /// Cooks up to the instant.
    pub fn kitchen(&self, library: &Library) -> Kitchen {
        let mut kitchen = Kitchen::new(library, self.pan, kelvin(self.pan_c)).unwrap();
        let order = PieceOrder {
            id: FOOD.into(),
            kind: self.kind.into(),
            size: self.size_mm.map(|mm| 1e-3 * mm),
            temperature: kelvin(self.food_c),
            seed: self.number,
            coarseness: 1.0,
            rules: Rules::Full,
            mesh: MeshSize::Default,
            outline: OutlineKind::Natural,
        };
        kitchen.add(library, &order).unwrap();
        let hob = match self.held_c {
            Some(held) => Command::HobHold { temperature: kelvin(held), power: self.power_w },
            None => Command::Hob(self.power_w),
        };
        kitchen.apply(&hob).unwrap();
        kitchen.apply(&Command::Put { food: FOOD.into(), at: [0.0, 0.0], heap: false }).unwrap();
        let mut flip = self.flipped_at_s;
        while kitchen.time_s() < self.at_s {
            if flip.is_some_and(|at| kitchen.time_s() >= at) {
                kitchen.apply(&Command::Flip { food: FOOD.into() }).unwrap();
                flip = None;
            }
            kitchen.step();
        }
        kitchen
    }

    /// Forecasts every question and cooks it in full.
    pub fn misses(&self, library: &Library) -> Vec<Miss> {
        let kitchen = self.kitchen(library);
        let mut reductions = Reductions::default();
        Question::ALL.into_iter().filter_map(|question| miss(&kitchen, question, &mut reductions)).collect()
    }
}

fn miss(kitchen: &Kitchen, question: Question, reductions: &mut Reductions) -> Option<Miss> {
    let ask = Ask { food: FOOD.into(), question, scale: None };
    let mut ahead = Ahead::begin(kitchen, &ask, reductions).unwrap()?;
    while !ahead.is_done() {
        ahead.advance(u64::MAX);
    }
    let foreseen = ahead.outlook();
    let happened = cooked(kitchen, &ask, foreseen.peak.after_s);
    Some(Miss {
        question,
        cores: SPANS_S.map(|span| foreseen.core_at(span) - happened.core_at(span)),
        peak: (!foreseen.still_warms()).then_some(foreseen.peak.core - happened.peak.core),
    })
}

/// Cooks in full, for the horizon; food that was taken out until its peak is past.
fn cooked(kitchen: &Kitchen, ask: &Ask, peak_after_s: f64) -> Outlook {
    let for_s = if ask.question == Question::TakeOut { HORIZON_S.max(1.3 * peak_after_s + 60.0) } else { HORIZON_S };
    let mut full = Exact::begin(kitchen, ask, for_s).unwrap().unwrap();
    full.advance(u64::MAX);
    full.outlook().clone()
}
