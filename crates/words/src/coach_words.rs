//! The texts of a coach, in the cook's words: what happens and why, and what to look, listen or feel for next.

use saute_kitchen::advice::coaching::{Coaching, Cue, Happening};

use crate::speech::Speech;
use saute_kitchen::pan::heater::HeaterKind;

/// Text for what heats a pan.
fn pan_heats(by: HeaterKind) -> &'static str {
    match by {
        HeaterKind::Coil => "coach.pan_heats",
        HeaterKind::Flame => "coach.pan_heats_over_gas",
        HeaterKind::Element => "coach.pan_heats_on_glass",
        HeaterKind::Plate => "coach.pan_heats_on_iron",
    }
}

/// What happens and why.
pub fn happening(coaching: &Coaching, speech: Speech) -> String {
    let l = speech.language;
    let at = |key, celsius: f64| l.fill(key, &[("temperature", &speech.temperature(celsius))]);
    match coaching.happening {
        Happening::PanIsCold => l.text("coach.pan_is_cold").to_owned(),
        Happening::PanHeats { pan_c, by } => at(pan_heats(by), pan_c),
        Happening::PanIsHot { pan_c } => at("coach.pan_is_hot", pan_c),
        Happening::OilSmokes => l.text("coach.oil_smokes").to_owned(),
        Happening::FaceWarms { underside_c } => at("coach.face_warms", underside_c),
        Happening::WaterBoilsOff { underside_c } => at("coach.water_boils_off", underside_c),
        Happening::FaceDries { underside_c } => at("coach.face_dries", underside_c),
        Happening::Browns { underside_c } => at("coach.browns", underside_c),
        Happening::CrustDarkens => l.text("coach.crust_darkens").to_owned(),
        Happening::FatRenders => l.text("coach.fat_renders").to_owned(),
        Happening::CoreLags { core_c } => at("coach.core_lags", core_c),
        Happening::Softens { share_pct } => l.fill("coach.softens", &[("percent", &format!("{share_pct:.0}"))]),
        Happening::CarriesOver { core_c } => at("coach.carries_over", core_c),
        Happening::Rested => l.text("coach.rested").to_owned(),
    }
}

/// The next cue, with the sense that it is for.
pub fn cue(coaching: &Coaching, speech: Speech) -> Option<&'static str> {
    let key = match coaching.cue? {
        Cue::OilShimmers => "cue.oil_shimmers",
        Cue::DropDances => "cue.drop_dances",
        Cue::LivelySizzle => "cue.lively_sizzle",
        Cue::SmokeStops => "cue.smoke_stops",
        Cue::SizzleFades => "cue.sizzle_fades",
        Cue::EdgeBrowns => "cue.edge_browns",
        Cue::SteamAtSides => "cue.steam_at_sides",
        Cue::JuiceBeads => "cue.juice_beads",
        Cue::Firmer => "cue.firmer",
        Cue::CurlsOpaque => "cue.curls_opaque",
        Cue::KnifeSlides => "cue.knife_slides",
        Cue::WarmOnTop => "cue.warm_on_top",
    };
    Some(speech.language.text(key))
}
