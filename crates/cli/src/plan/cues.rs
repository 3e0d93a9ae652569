//! What a cook looks, listens and feels for at a step. Temperatures and browning come from the planned cook; the words for them
//! are those of the kitchen.

use saute_kitchen::Library;
use saute_kitchen::food::Form;
use saute_plan::schedule::{Cue, Plan};

use super::steps::Deed;

/// Returns what there is to look, listen and feel for at a step.
pub fn words(deed: &Deed, cue: Option<&Cue>, plan: &Plan, library: &Library) -> String {
    match (deed, cue) {
        (Deed::Power(_), _) => String::new(),
        (Deed::Put, Some(cue)) => put(cue, library),
        (Deed::Flip(_), Some(cue)) => format!("{}, {}.", underside(cue.browned_pct), hiss(cue.steam_g_s)),
        (Deed::Pull, Some(cue)) => {
            let rise = (plan.promised.core_peak_c - cue.core_c).max(0.0);
            let touch = touch(plan, library);
            format!("{:.0} °C in the middle; rests up by another {rise:.0} K. {touch}", cue.core_c)
        }
        (Deed::Serve, _) => format!("The middle peaks at {:.0} °C.", plan.promised.core_peak_c),
        (_, None) => String::new(),
    }
}

/// The pan when the food goes in.
fn put(cue: &Cue, library: &Library) -> String {
    let smoke_c = library.oils.get(&library.room.oil.default).map(|oil| oil.heat.smoke_c);
    let drop = match cue.pan_c {
        c if c < 150.0 => "a drop of water lies and hisses",
        c if c < 190.0 => "a drop of water bursts at once",
        _ => "a drop of water runs about in beads",
    };
    let smoke =
        smoke_c.map_or(String::new(), |c| format!(" Smoke from the oil means over {c:.0} °C: wait off the hob."));
    format!("Pan at {:.0} °C: the oil shimmers, {drop}. A loud hiss at once.{smoke}", cue.pan_c)
}

/// The face on the pan, seen when its edge is lifted.
fn underside(browned_pct: f64) -> String {
    let colour = match browned_pct {
        pct if pct < 10.0 => "pale",
        pct if pct < 50.0 => "brown in patches",
        pct if pct < 90.0 => "brown over most of it",
        _ => "brown all over",
    };
    format!("Underside {colour} ({browned_pct:.0} %)")
}

/// The sound of the steam (chosen: a hand's breadth of wet meat on a hot pan gives off about 0.1 g/s).
fn hiss(steam_g_s: f64) -> &'static str {
    match steam_g_s {
        s if s < 0.03 => "a quiet sizzle",
        s if s < 0.1 => "a steady sizzle",
        _ => "a loud hiss",
    }
}

/// The feel of the food when it is done.
fn touch(plan: &Plan, library: &Library) -> &'static str {
    let form = library.foods.get(&plan.order.food).map(|food| food.form);
    match (form, plan.promised.core_peak_c) {
        (Some(Form::Steak), c) if c < 50.0 => "Gives like the ball of a loose thumb.",
        (Some(Form::Steak), c) if c < 55.0 => "Gives like the ball of the thumb with thumb and forefinger joined.",
        (Some(Form::Steak), c) if c < 60.0 => "Springs like the ball of the thumb with thumb and middle finger joined.",
        (Some(Form::Steak), c) if c < 70.0 => "Firm like the ball of the thumb with thumb and ring finger joined.",
        (Some(Form::Steak), _) => "Hard like the ball of the thumb with thumb and little finger joined.",
        (Some(Form::Patty), c) if c < 68.0 => "Gives in the middle; red juice on top.",
        (Some(Form::Patty), _) => "Firm all over; clear juice on top. Only a thermometer shows that it is safe.",
        (Some(Form::Shrimp), _) => "Opaque all through, curled, springy.",
        (Some(Form::Coin | Form::Ring | Form::Stick), _) => "A knife point goes in.",
        (Some(Form::Mesh) | None, _) => "",
    }
}
