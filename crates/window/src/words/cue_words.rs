//! The steps of a plan in words, with what there is to see, hear and feel at each: for the window and for the kitchen card.

use saute_plan::schedule::Deed;
use saute_plan::schedule::senses::{Colour, Drop, Feel, Hiss, Sense};

use crate::settings::Settings;
use crate::words::language::Language;

/// What is done at a step.
pub fn deed(deed: &Deed, l: Language) -> String {
    match deed {
        Deed::Power(hob_w) => l.fill("cue.power", &[("power", hob_w)]),
        Deed::Put => l.text("cue.put").to_owned(),
        Deed::Flip(number) => l.fill("cue.flip", &[("number", number)]),
        Deed::Pull => l.text("cue.pull").to_owned(),
        Deed::Serve => l.text("cue.serve").to_owned(),
    }
}

/// What there is to see, hear and feel at a step.
pub fn sense(sense: &Sense, settings: &Settings) -> String {
    let l = settings.language;
    let degrees = |celsius: f64| settings.temperature(celsius);
    match *sense {
        Sense::Pan { pan_c, drop, smoke_c } => {
            let smoke = smoke_c.map_or(String::new(), |c| l.fill("cue.smoke", &[("smoke", &degrees(c))]));
            l.fill("cue.pan", &[("pan", &degrees(pan_c)), ("drop", &l.text(of_drop(drop))), ("smoke", &smoke)])
        }
        Sense::Face { browned_pct, colour, hiss, .. } => {
            let percent = format!("{browned_pct:.0}");
            let (colour, hiss) = (l.text(of_colour(colour)), l.text(of_hiss(hiss)));
            l.fill("cue.face", &[("colour", &colour), ("percent", &percent), ("hiss", &hiss)])
        }
        Sense::Done { core_c, rise_k, feel } => {
            let feel = feel.map_or("", |feel| l.text(of_feel(feel)));
            l.fill("cue.done", &[("core", &degrees(core_c)), ("rise", &difference(rise_k, settings)), ("feel", &feel)])
        }
        Sense::Rested { peak_c } => l.fill("cue.rested", &[("peak", &degrees(peak_c))]),
    }
}

/// A difference of temperatures in the chosen unit.
fn difference(kelvin: f64, settings: &Settings) -> String {
    let shown = if settings.fahrenheit { 1.8 * kelvin } else { kelvin };
    format!("{shown:.0}\u{a0}{}", settings.unit())
}

fn of_drop(drop: Drop) -> &'static str {
    match drop {
        Drop::Lies => "cue.drop_lies",
        Drop::Bursts => "cue.drop_bursts",
        Drop::Runs => "cue.drop_runs",
    }
}

fn of_colour(colour: Colour) -> &'static str {
    match colour {
        Colour::Pale => "cue.colour_pale",
        Colour::Patches => "cue.colour_patches",
        Colour::Most => "cue.colour_most",
        Colour::All => "cue.colour_all",
    }
}

fn of_hiss(hiss: Hiss) -> &'static str {
    match hiss {
        Hiss::Quiet => "cue.hiss_quiet",
        Hiss::Steady => "cue.hiss_steady",
        Hiss::Loud => "cue.hiss_loud",
    }
}

fn of_feel(feel: Feel) -> &'static str {
    match feel {
        Feel::LooseThumb => "cue.feel_loose",
        Feel::Forefinger => "cue.feel_forefinger",
        Feel::MiddleFinger => "cue.feel_middle",
        Feel::RingFinger => "cue.feel_ring",
        Feel::LittleFinger => "cue.feel_little",
        Feel::SoftPatty => "cue.feel_soft_patty",
        Feel::FirmPatty => "cue.feel_firm_patty",
        Feel::Shrimp => "cue.feel_shrimp",
        Feel::Knife => "cue.feel_knife",
    }
}
