//! Views in words: names, meanings, values and marks of legends.

use saute_kitchen::food::Scale;
use saute_kitchen::food::change::doneness::Measure;
use saute_picture::View;
use saute_picture::view::Unit;

use saute_words::doneness_words;
use saute_words::language::Language;
use saute_words::speech::Speech;

/// A view in words.
pub trait ViewWords {
    /// Name for people.
    fn name(self, l: Language) -> &'static str;

    /// What its colours mean, with the unit; for the look what it shows.
    fn meaning(self, speech: Speech) -> String;

    /// A value of its field in words, with the unit.
    fn words(self, value: f64, speech: Speech, scale: Option<&Scale>) -> String;

    /// A mark in the legend.
    fn mark(self, value: f64, speech: Speech) -> String;
}

impl ViewWords for View {
    fn name(self, l: Language) -> &'static str {
        let [name, _, _] = self.spec().texts;
        l.text(name)
    }

    fn meaning(self, speech: Speech) -> String {
        let [_, meaning, _] = self.spec().texts;
        speech.language.fill(meaning, &[("unit", &speech.unit())])
    }

    fn words(self, value: f64, speech: Speech, scale: Option<&Scale>) -> String {
        let number =
            |key, places: usize, value: f64| speech.language.fill(key, &[("value", &format!("{value:.places$}"))]);
        match self.spec().unit {
            Unit::Temperature => speech.fine_temperature(value),
            Unit::Doneness => doneness(value, speech, scale),
            Unit::Number { most: Some((most, text)), .. } if value > most - 0.05 => number(text, 0, most),
            Unit::Number { text, places, .. } => number(text, places, value),
        }
    }

    fn mark(self, value: f64, speech: Speech) -> String {
        match self.spec().unit {
            Unit::Temperature | Unit::Doneness => format!("{:.0}", speech.degrees(value)),
            Unit::Number { .. } => format!("{value}"),
        }
    }
}

/// The class of doneness, with the highest temperature so far or the share of the change that determines it.
fn doneness(value: f64, speech: Speech, scale: Option<&Scale>) -> String {
    let l = speech.language;
    let class = scale.map(|s| doneness_words::class(s, s.name_of(s.of_nodes(value)), l));
    if let Some((scale, class)) = scale.zip(class).filter(|(s, _)| s.measure() == Measure::Share) {
        let change = l.called("change", &scale.for_change);
        let percent = format!("{value:.0}");
        return l.fill("value.class_and_change", &[("class", &class), ("change", &change), ("percent", &percent)]);
    }
    let peak = speech.fine_temperature(value);
    class.map_or_else(
        || l.fill("value.peak", &[("peak", &peak)]),
        |class| l.fill("value.class_and_peak", &[("class", &class), ("peak", &peak)]),
    )
}
