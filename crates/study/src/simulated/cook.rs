//! A cook by rules on coarse meshes.

use saute_kitchen::food::BuildError;
use saute_kitchen::kitchen::SetupError;
use saute_kitchen::reduced::{LAPSE_S, Reductions};
use saute_kitchen::{Command, Kitchen, Library, RestOn, TICK_S, celsius};
use saute_recipe::Recipe;

use crate::measures::{Measures, Times};
use saute_plan::Aimed;

/// What a cook does.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Rules {
    /// Power to heat the pan with [W].
    pub(super) heat_w: f64,
    /// Temperature of the pan at which the food goes in [°C].
    pub(super) pan_c: f64,
    /// Power to fry with [W].
    pub(super) fry_w: f64,
    /// Time in the pan until the first flip, and between two flips [s].
    pub(super) first_flip_s: f64,
    pub(super) between_flips_s: f64,
    /// Temperature of the core at which the food is taken out [°C].
    pub(super) pull_c: f64,
    /// Longest cook [s].
    pub(super) max_s: f64,
}

/// Why a simulated cook cannot be cooked.
#[derive(Clone, Debug, thiserror::Error)]
pub enum CookError {
    /// Its kitchen cannot be set up.
    #[error(transparent)]
    Setup(#[from] SetupError),
    /// A coarse mesh cannot be built.
    #[error(transparent)]
    Build(#[from] BuildError),
    /// Only one piece of food is cooked.
    #[error("simulated participants cook one piece of food; the recipe sets out {0}")]
    Pieces(usize),
    /// The kitchen refuses a command.
    #[error(transparent)]
    Refused(#[from] saute_kitchen::Refused),
}

/// Longest time to heat the pan [s] (chosen: a weak hob and a heavy pan).
const LONGEST_HEATING_S: f64 = 600.0;
/// Time on the full meshes after the food is put in [s] (chosen: it has settled).
const SETTLING_S: f64 = 2.0;
/// A rest ends when the core has cooled so far below its peak [K], or after so long [s] (chosen: as that of a plan).
const FALLEN_K: f64 = 0.2;
const LONGEST_REST_S: f64 = 600.0;

/// Cooks the food of a recipe by rules, and judges it by a goal.
pub(super) fn cook(recipe: &Recipe, rules: &Rules, aimed: &Aimed, library: &Library) -> Result<Measures, CookError> {
    let [order] = &recipe.foods[..] else { return Err(CookError::Pieces(recipe.foods.len())) };
    let mut kitchen = recipe.empty_kitchen(library)?;
    heat(&mut kitchen, rules)?;
    kitchen.add(library, order)?;
    let masses: Vec<f64> = kitchen.pieces().iter().map(saute_kitchen::Piece::mass).collect();
    let food = order.id.clone();
    kitchen.apply(&Command::Put { food: food.clone(), at: [0.0, 0.0], heap: false })?;
    kitchen.apply(&Command::Hob(rules.fry_w))?;
    let put_s = kitchen.time_s();
    ticks(&mut kitchen, SETTLING_S);
    let mut reduced = kitchen.reduced(&mut Reductions::default())?;
    let (mut flips, mut next_flip_s, mut out_s) = (0, put_s + rules.first_flip_s, None);
    while reduced.kitchen().time_s() < rules.max_s {
        let now = reduced.kitchen().time_s();
        let Some(piece) = reduced.kitchen().piece(&food) else { break };
        let (core_c, peak_c) = (celsius(piece.core()), celsius(piece.core_peak.0));
        match out_s {
            Some(out_s) if peak_c - core_c > FALLEN_K || now - out_s > LONGEST_REST_S => break,
            None if piece.in_pan() && core_c >= rules.pull_c => {
                reduced.apply(&Command::Rest { food: food.clone(), on: RestOn::Board })?;
                out_s = Some(now);
            }
            None if piece.in_pan() && now >= next_flip_s => {
                reduced.apply(&Command::Flip { food: food.clone() })?;
                (flips, next_flip_s) = (flips + 1, now + rules.between_flips_s);
            }
            _ => {}
        }
        reduced.step();
    }
    let times = Times { put_s: Some(put_s), out_s, end_s: reduced.kitchen().time_s(), flips };
    Ok(Measures::read(reduced.kitchen(), &masses, aimed, &times))
}

/// Heats the empty pan.
fn heat(kitchen: &mut Kitchen, rules: &Rules) -> Result<(), CookError> {
    kitchen.apply(&Command::Hob(rules.heat_w))?;
    while celsius(kitchen.pan_temperature()) < rules.pan_c && kitchen.time_s() < LONGEST_HEATING_S {
        kitchen.step();
    }
    Ok(())
}

fn ticks(kitchen: &mut Kitchen, seconds: f64) {
    (0..(seconds / TICK_S) as usize).for_each(|_| kitchen.step());
}

/// Steps of a reduced kitchen are short against the pauses between two flips.
const _: () = assert!(LAPSE_S < 10.0);
