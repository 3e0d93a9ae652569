//! Advice in words.

use crate::context::PanelContext;
use saute_kitchen::Piece;
use saute_kitchen::advice::Advice;
use saute_kitchen::doneness::core_class;
use saute_words::doneness_words;

/// What a button states that sets the hob as advised [W].
pub fn do_it_words(watts: f64, state: &PanelContext) -> String {
    state.settings.language.fill("advice.do_it", &[("power", &format!("{watts:.0} W"))])
}

/// Advice in the cook's words.
pub fn advice_words(advice: Advice, state: &PanelContext) -> String {
    let l = state.settings.language;
    let at = |key, celsius: f64| l.fill(key, &[("temperature", &state.settings.temperature(celsius))]);
    let hob = |key, watts: f64| l.fill(key, &[("power", &format!("{watts:.0} W"))]);
    let hotter = |key, watts: f64, hottest_c: f64| {
        let hottest = state.settings.temperature(hottest_c);
        l.fill(key, &[("power", &format!("{watts:.0} W")), ("temperature", &hottest)])
    };
    match advice {
        Advice::TurnOn { power_w } => hob("advice.turn_on", power_w),
        Advice::TooCold { power_w } => hob("advice.too_cold", power_w),
        Advice::TurnOff => l.text("advice.turn_off").to_owned(),
        Advice::Heating { until_c, .. } => at("advice.heating", until_c),
        Advice::TooHot { smokes: true, to_w, .. } => hob("advice.smokes", to_w),
        Advice::TooHot { smokes: false, to_w, hottest_c } => hotter("advice.too_hot", to_w, hottest_c),
        Advice::BothBrown { to_w } => hob("advice.both_brown", to_w),
        Advice::TurnDown { to_w, hottest_c } => hotter("advice.turn_down", to_w, hottest_c),
        Advice::PutIn { .. } => l.fill("advice.put_in", &[("food", &state.session.noun(l))]),
        Advice::Wet { .. } => l.text("advice.wet").to_owned(),
        Advice::Browns { .. } => l.text("advice.browns").to_owned(),
        Advice::Flip => l.fill("advice.flip", &[("food", &state.session.noun(l))]),
        Advice::TakeOut { .. } if !state.foretells() => l.text("advice.take_out_ahead").to_owned(),
        Advice::WouldPeak { wet, .. } if !state.foretells() => {
            l.text(if wet { "advice.wet" } else { "advice.browns" }).to_owned()
        }
        Advice::TakeOut { peak_c } => at("advice.take_out", peak_c),
        Advice::Ready { .. } => l.fill("advice.ready", &[("class", &class_now(state))]),
        Advice::NotReady { share_pct, until_pct } => {
            let [share, goal] = [share_pct, until_pct].map(|pct| format!("{pct:.0}"));
            l.fill("advice.not_ready", &[("class", &class_now(state)), ("percent", &share), ("goal", &goal)])
        }
        Advice::WouldPeak { peak_c, wet: true } => at("advice.would_peak_wet", peak_c),
        Advice::WouldPeak { peak_c, wet: false } => at("advice.would_peak", peak_c),
        Advice::Resting { peak_c, warms: true } => resting_words("advice.resting", peak_c, state),
        Advice::Resting { peak_c, warms: false } => resting_words("advice.highest", peak_c, state),
        Advice::Rested { peak_c } => resting_words("advice.rested", peak_c, state),
    }
}

/// The class of the core of the piece that the panels show; empty where no scale covers it.
pub fn class_now(state: &PanelContext) -> String {
    let class = |piece: &Piece| {
        let scale = state.scale_of(piece)?;
        Some(doneness_words::class(&scale, core_class(piece, &scale), state.settings.language).to_owned())
    };
    state.session.shown_piece().and_then(class).unwrap_or_default()
}

/// What a resting piece has reached, with its class where a scale covers it.
pub fn resting_words(key: &'static str, peak_c: f64, state: &PanelContext) -> String {
    let l = state.settings.language;
    let reached = match state.scale() {
        None => state.settings.temperature(peak_c),
        Some(scale) => l.fill(
            "advice.reached_class",
            &[
                ("temperature", &state.settings.temperature(peak_c)),
                ("class", &class_now(state)),
                ("scale", &doneness_words::label(&scale, l)),
            ],
        ),
    };
    l.fill(key, &[("reached", &reached)])
}
