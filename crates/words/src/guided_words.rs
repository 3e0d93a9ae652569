//! Words for studies and lessons.

use std::collections::BTreeSet;
use std::fmt::Display;

use saute_kitchen::food::change::doneness::Class;
use saute_study::Measures;
use saute_study::class::{Ask, Lesson, Locked};
use saute_study::protocol_file::Entered;

use crate::doneness_words;
use crate::language::Language;
use crate::speech::Speech;

/// What came of a cook, in two sentences.
pub fn outcome(measures: &Measures, speech: Speech) -> String {
    let l = speech.language;
    let met = l.text(if measures.is_met { "guided.met" } else { "guided.missed" });
    let [share, mark] = [measures.target_share_pct, measures.mark].map(|value| format!("{value:.0}"));
    let peak = speech.temperature(measures.core_peak_c);
    let parts: [(&str, &dyn Display); 4] = [("met", &met), ("share", &share), ("mark", &mark), ("peak", &peak)];
    l.fill("guided.outcome", &parts)
}

/// A question of a lesson.
pub fn question(ask: Ask, l: Language) -> String {
    match ask {
        Ask::CoreNow => l.text("lesson.ask_core_now").to_owned(),
        Ask::CoreIn(s) => l.fill("lesson.ask_core_in", &[("time", &crate::clock::clock(s))]),
        Ask::CorePeak => l.text("lesson.ask_core_peak").to_owned(),
        Ask::UndersideBrown => l.text("lesson.ask_underside").to_owned(),
        Ask::ClassInTheEnd => l.text("lesson.ask_class").to_owned(),
    }
}

/// The same in a few words.
pub fn short_question(ask: Ask, l: Language) -> String {
    match ask {
        Ask::CoreNow => l.text("lesson.core_now").to_owned(),
        Ask::CoreIn(s) => l.fill("lesson.core_in", &[("time", &crate::clock::clock(s))]),
        Ask::CorePeak => l.text("lesson.core_peak").to_owned(),
        Ask::UndersideBrown => l.text("lesson.underside").to_owned(),
        Ask::ClassInTheEnd => l.text("lesson.class").to_owned(),
    }
}

/// An answer or a truth with its unit; a dash where there is none.
pub fn value(ask: Ask, value: Option<f64>, lesson: &Lesson, speech: Speech) -> String {
    let Some(value) = value else { return "–".to_owned() };
    match ask {
        Ask::CoreNow | Ask::CoreIn(_) | Ask::CorePeak => speech.temperature(value),
        Ask::UndersideBrown => format!("{value:.0} %"),
        Ask::ClassInTheEnd => {
            let scale = &lesson.scenario.goal.scale;
            let of = |class: &Class| doneness_words::class(scale, &class.name, speech.language).to_owned();
            scale.class.get(value as usize).map_or_else(String::new, of)
        }
    }
}

/// What was answered and what was true, and whether that is near.
pub fn truth(lesson: &Lesson, place: usize, speech: Speech) -> String {
    let (asked, ask) = (lesson.asked()[place], lesson.scenario.predictions[place].ask);
    let shown = |of: Option<f64>| value(ask, of, lesson, speech);
    let (said, was) = (shown(asked.answer), shown(asked.truth));
    let off = asked.answer.zip(asked.truth).map_or(f64::INFINITY, |(said, was)| (said - was).abs());
    let key = if off <= ask.near() { "lesson.near" } else { "lesson.off" };
    let parts: [(&str, &dyn Display); 2] = [("said", &said), ("was", &was)];
    speech.language.fill(key, &parts)
}

/// What is locked, as a list.
pub fn locked(locked: &BTreeSet<Locked>, l: Language) -> String {
    let words = |what: &Locked| match what {
        Locked::Foods => "lesson.lock_foods",
        Locked::Pan => "lesson.lock_pan",
        Locked::Speed => "lesson.lock_speed",
        Locked::Views => "lesson.lock_views",
        Locked::Rewind => "lesson.lock_rewind",
    };
    locked.iter().map(|what| l.text(words(what))).collect::<Vec<_>>().join(l.text("doneness.list_joint"))
}

/// What is entered of a cook at a real stove.
pub fn entered(entered: Entered, l: Language) -> &'static str {
    l.text(match entered {
        Entered::CoreC => "study.core_c",
        Entered::Class => "study.class",
        Entered::TargetSharePct => "study.target_share",
        Entered::WeightBeforeG => "study.weight_before",
        Entered::WeightAfterG => "study.weight_after",
        Entered::PanTimeS => "study.pan_time",
        Entered::RestTimeS => "study.rest_time",
        Entered::Flips => "study.flips",
    })
}
