//! What is ahead of the piece that the panels show, in words: forecasts, their band and their age.

use saute_kitchen::doneness::at_core;
use saute_kitchen::food::change::doneness::Measure;
use saute_kitchen::{celsius, kelvin};
use saute_plan::forecast::{Outlook, Question};

use crate::context::PanelContext;
use crate::settings::Settings;
use saute_session::forecasts::AgedForecast;
use saute_words::doneness_words;

/// Returns true if forecasts are made and enabled: then there is room for them.
pub fn are_shown(state: &PanelContext) -> bool {
    state.settings.foresees() && state.guided.is_none() && state.session.forecasts().are_made()
}

/// The class in which the core ends, in the cook's words; none where no scale covers it.
pub fn class(state: &PanelContext, outlook: &Outlook) -> Option<String> {
    let (piece, scale) = (state.session.shown_piece()?, state.scale()?);
    let class = outlook.class(&scale, at_core(piece, &scale))?;
    Some(doneness_words::class(&scale, &scale.class[class].name, state.settings.language).to_owned())
}

/// The class of a highest core temperature [°C], in the cook's words; none where no scale determines doneness by it.
pub fn class_of_peak(state: &PanelContext, peak_c: f64) -> Option<String> {
    let scale = state.scale().filter(|scale| scale.measure() == Measure::Peak)?;
    let class = &scale.class[scale.class_of(kelvin(peak_c))];
    Some(doneness_words::class(&scale, &class.name, state.settings.language).to_owned())
}

/// A temperature [K] as a number in the chosen unit.
pub fn number(settings: &Settings, kelvin: f64) -> String {
    format!("{:.0}", settings.degrees(celsius(kelvin)))
}

/// Half the width of a band [K] as a number in the chosen unit.
pub fn half_band(settings: &Settings, kelvin: f64) -> String {
    format!("{:.1}", settings.degrees(kelvin) - settings.degrees(0.0))
}

/// How old answers are, in words, where that is worth one.
pub fn age_words(state: &PanelContext, standing: &AgedForecast) -> Option<String> {
    let seconds = format!("{:.0}", standing.age_s);
    standing.is_old().then(|| state.settings.language.fill("ahead.age", &[("seconds", &seconds)]))
}

/// The question, in words.
pub fn question_words(state: &PanelContext, question: Question) -> &'static str {
    state.settings.language.text(match question {
        Question::AsItIs => "ahead.as_it_is",
        Question::Flip => "ahead.flip",
        Question::TakeOut => "ahead.take_out",
        Question::LowerHeat => "ahead.lower_heat",
    })
}
