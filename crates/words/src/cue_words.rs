//! The steps of a plan in words, with what there is to see, hear and feel at each: for the window and for the kitchen card.

use saute_kitchen::food::description::FILE_LANGUAGE;
use saute_plan::schedule::Deed;
use saute_plan::schedule::follow::{Followed, Left};
use saute_plan::schedule::senses::{Colour, Drop, Hiss, Sense};

use crate::language::Language;
use crate::speech::Speech;

/// What is done at a step.
pub fn deed(deed: &Deed, l: Language) -> String {
    match deed {
        Deed::Power(hob_w) => l.fill("sense.power", &[("power", hob_w)]),
        Deed::Put => l.text("sense.put").to_owned(),
        Deed::Flip(number) => l.fill("sense.flip", &[("number", number)]),
        Deed::Pull => l.text("sense.pull").to_owned(),
        Deed::Serve => l.text("sense.serve").to_owned(),
    }
}

/// What is left to do at a step.
pub fn left(followed: &Followed, l: Language) -> String {
    match followed.left {
        Left::All => deed(&followed.step.deed, l),
        Left::Food => l.text("sense.pull_food").to_owned(),
        Left::Hob => l.text("sense.pull_hob").to_owned(),
    }
}

/// What is left to do at steps that share a time.
pub fn deeds(next: &[Followed], l: Language) -> String {
    let deeds: Vec<String> = next.iter().map(|followed| left(followed, l)).collect();
    deeds.join(l.text("doneness.list_joint"))
}

/// What there is to see, hear and feel at a step.
pub fn sense(sense: &Sense, speech: Speech) -> String {
    let l = speech.language;
    let degrees = |celsius: f64| speech.temperature(celsius);
    match sense {
        Sense::Pan { pan_c, drop, is_smokeless } => {
            let smoke = if *is_smokeless { l.text("sense.smoke") } else { "" };
            l.fill("sense.pan", &[("pan", &degrees(*pan_c)), ("drop", &l.text(of_drop(*drop))), ("smoke", &smoke)])
        }
        Sense::Face { browned_pct, colour, hiss, .. } => {
            let percent = format!("{browned_pct:.0}");
            let (colour, hiss) = (l.text(of_colour(*colour)), l.text(of_hiss(*hiss)));
            l.fill("sense.face", &[("colour", &colour), ("percent", &percent), ("hiss", &hiss)])
        }
        Sense::Done { core_c, rise_k, feel } => {
            let feel = feel.get(l.code()).or_else(|| feel.get(FILE_LANGUAGE)).map_or("", String::as_str);
            let rise = difference(*rise_k, speech);
            l.fill("sense.done", &[("core", &degrees(*core_c)), ("rise", &rise), ("feel", &feel)])
        }
        Sense::Rested { peak_c } => l.fill("sense.rested", &[("peak", &degrees(*peak_c))]),
    }
}

/// A difference of temperatures in the chosen unit.
fn difference(kelvin: f64, speech: Speech) -> String {
    let shown = if speech.fahrenheit { 1.8 * kelvin } else { kelvin };
    format!("{shown:.0}\u{a0}{}", speech.unit())
}

fn of_drop(drop: Drop) -> &'static str {
    match drop {
        Drop::Lies => "sense.drop_lies",
        Drop::Bursts => "sense.drop_bursts",
        Drop::Runs => "sense.drop_runs",
    }
}

fn of_colour(colour: Colour) -> &'static str {
    match colour {
        Colour::Pale => "sense.colour_pale",
        Colour::Patches => "sense.colour_patches",
        Colour::Most => "sense.colour_most",
        Colour::All => "sense.colour_all",
    }
}

fn of_hiss(hiss: Hiss) -> &'static str {
    match hiss {
        Hiss::Quiet => "sense.hiss_quiet",
        Hiss::Steady => "sense.hiss_steady",
        Hiss::Loud => "sense.hiss_loud",
    }
}
