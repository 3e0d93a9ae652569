//! Views in words: names, meanings, values and marks of legends.

use saute_kitchen::food::Scale;
use saute_kitchen::food::change::doneness::Measure;
use saute_picture::View;
use saute_picture::view::MOST_KILLED;

use saute_words::doneness_words;
use saute_words::language::Language;
use saute_words::speech::Speech;

/// A view in words.
pub trait ViewWords {
    /// Name for people.
    fn name(self, l: Language) -> &'static str;

    /// What its colours say, with the unit; for the look what it shows.
    fn meaning(self, speech: Speech) -> String;

    /// A value of its field in words, with the unit.
    fn words(self, value: f64, speech: Speech, scale: Option<&Scale>) -> String;

    /// A mark in the legend.
    fn mark(self, value: f64, speech: Speech) -> String;
}

impl ViewWords for View {
    fn name(self, l: Language) -> &'static str {
        l.text(match self {
            Self::Look => "view.look",
            Self::Temperature => "view.temperature",
            Self::Moisture => "view.moisture",
            Self::Doneness => "view.doneness",
            Self::Browning => "view.browning",
            Self::Lethality => "view.lethality",
            Self::Marbling => "view.marbling",
        })
    }

    fn meaning(self, speech: Speech) -> String {
        let key = match self {
            Self::Look => "meaning.look",
            Self::Temperature => "meaning.temperature",
            Self::Moisture => "meaning.moisture",
            Self::Doneness => "meaning.doneness",
            Self::Browning => "meaning.browning",
            Self::Lethality => "meaning.lethality",
            Self::Marbling => "meaning.marbling",
        };
        speech.language.fill(key, &[("unit", &speech.unit())])
    }

    fn words(self, value: f64, speech: Speech, scale: Option<&Scale>) -> String {
        let l = speech.language;
        let number = |key, places: usize, value: f64| l.fill(key, &[("value", &format!("{value:.places$}"))]);
        match self {
            Self::Look | Self::Temperature => speech.fine_temperature(value),
            Self::Moisture => number("value.moisture", 0, value),
            Self::Doneness => {
                let class = scale.map(|s| doneness_words::class(s, s.name_of(s.of_nodes(value)), l));
                if let Some((scale, class)) = scale.zip(class).filter(|(s, _)| s.measure() == Measure::Share) {
                    let change = l.called("change", &scale.for_change);
                    let percent = format!("{value:.0}");
                    return l.fill(
                        "value.class_and_change",
                        &[("class", &class), ("change", &change), ("percent", &percent)],
                    );
                }
                let peak = speech.fine_temperature(value);
                class.map_or_else(
                    || l.fill("value.peak", &[("peak", &peak)]),
                    |class| l.fill("value.class_and_peak", &[("class", &class), ("peak", &peak)]),
                )
            }
            Self::Browning => number("value.browning", 2, value),
            Self::Lethality if value > MOST_KILLED - 0.05 => number("value.lethality_at_least", 0, MOST_KILLED),
            Self::Lethality => number("value.lethality", 1, value),
            Self::Marbling => number("value.marbling", 0, value),
        }
    }

    fn mark(self, value: f64, speech: Speech) -> String {
        match self {
            Self::Look | Self::Temperature | Self::Doneness => format!("{:.0}", speech.degrees(value)),
            Self::Browning | Self::Lethality => format!("{value}"),
            Self::Moisture | Self::Marbling => format!("{value:.0}"),
        }
    }
}
