//! The judgement of a cook in the cook's words.

use std::fmt::Display;

use saute_kitchen::data::goals::Counted;
use saute_kitchen::food::change::doneness::Measure;
use saute_plan::goal::{Better, Goal, GoalVerdict, Judgement, Shortfall};

use crate::doneness_words::class;
use crate::language::Language;
use crate::mark_words::{TermRow, best_words, good_words, mark_words, table};
use crate::speech::Speech;

/// A result in words.
#[derive(Clone, Debug, PartialEq)]
pub struct ResultWords {
    /// True if the goal is met.
    pub is_met: bool,
    /// Whether the goal is met, with its name.
    pub verdict: String,
    /// What is missing.
    pub missed: Vec<String>,
    /// The grade and the mark in words.
    pub mark: String,
    /// The heading over how it is counted.
    pub counted: String,
    /// Heads of the table of how it is counted, and its rows.
    pub table: (TermRow, Vec<TermRow>),
    /// Names and values of what shows why.
    pub measures: Vec<(String, String)>,
    /// What went well; empty where nothing did.
    pub good: String,
    /// Heading over what to do better, and what.
    pub better: [String; 2],
    /// The best mark so far and the last ones; empty before there are any.
    pub best: String,
    /// The cut, for those who do not see it.
    pub cut: String,
    /// Thickness of the grey band below the lower and the upper face [mm].
    pub grey_mm: [f64; 2],
}

impl ResultWords {
    /// Puts a judgement of a food, by its noun in the language, into words.
    pub fn of(judgement: &Judgement, goal: &Goal, food: &str, speech: Speech) -> Self {
        let teller = Teller { judgement, goal, speech };
        let l = speech.language;
        let is_met = judgement.verdict == GoalVerdict::Met;
        let name = match l.named("goal", &goal.name, &goal.names) {
            name if name == goal.name => class(&goal.scale, &goal.name, l).to_owned(),
            name => name.to_owned(),
        };
        let key = if is_met { "result.met" } else { "result.missed" };
        let missed = match &judgement.verdict {
            GoalVerdict::Met => Vec::new(),
            GoalVerdict::Missed(shortfalls) => shortfalls.iter().map(|one| teller.missing(*one)).collect(),
        };
        Self {
            is_met,
            verdict: l.fill(key, &[("goal", &name)]),
            missed,
            mark: mark_words(&judgement.mark, l),
            counted: l.text("grade.counted").to_owned(),
            table: table(&judgement.mark, goal, l),
            measures: teller.measures(),
            good: good_words(&judgement.mark, l),
            better: [l.text("result.better").to_owned(), teller.better()],
            best: String::new(),
            cut: l.fill("inside.section", &[("food", &food)]),
            grey_mm: judgement.grey_mm,
        }
    }
}

impl ResultWords {
    /// The words with the best of all marks so far, the last at the end, and the last of them.
    #[must_use]
    pub fn with_marks(self, marks: &[f64], l: Language) -> Self {
        Self { best: best_words(marks, l), ..self }
    }

    /// The words while the food still rests, given how high its core rises [°C]: nothing is missed yet, and nothing is met.
    #[must_use]
    pub fn while_it_rests(self, rises_to_c: f64, speech: Speech) -> Self {
        let l = speech.language;
        let verdict = l.fill("result.resting", &[("core", &speech.temperature(rises_to_c))]);
        let better = [self.better[0].clone(), l.text("better.rest_longer").to_owned()];
        Self {
            is_met: false,
            verdict,
            missed: Vec::new(),
            mark: l.text("result.mark_later").to_owned(),
            table: (self.table.0, Vec::new()),
            good: String::new(),
            better,
            ..self
        }
    }
}

/// Time from which a span is given in minutes, and to what it is rounded then [s] (chosen: nobody pulls by the second after minutes).
const MINUTES_S: f64 = 120.0;
const HALF_MINUTE_S: f64 = 30.0;
/// Kill beyond which no more is told [log₁₀] (chosen: nothing is left of any germ).
const MOST_LOG: f64 = 12.0;

/// A span of time in words [s].
pub(crate) fn span(seconds: f64, l: Language) -> String {
    if seconds < MINUTES_S {
        return l.fill("better.span_s", &[("seconds", &format!("{seconds:.0}"))]);
    }
    let whole = (HALF_MINUTE_S * (seconds / HALF_MINUTE_S).round()) as u64;
    l.fill("better.span_min", &[("minutes", &(whole / 60)), ("seconds", &format!("{:02}", whole % 60))])
}

/// What it describes.
struct Teller<'a> {
    judgement: &'a Judgement,
    goal: &'a Goal,
    speech: Speech,
}

impl Teller<'_> {
    fn fill(&self, key: &'static str, open: &[(&str, &dyn Display)]) -> String {
        self.speech.language.fill(key, open)
    }

    fn text(&self, key: &'static str) -> String {
        self.speech.language.text(key).to_owned()
    }

    /// A value of the core in its unit.
    fn core(&self, value: f64) -> String {
        match self.goal.scale.measure() {
            Measure::Peak => self.speech.fine_temperature(value),
            Measure::Share => format!("{value:.0}\u{a0}%"),
        }
    }

    /// A distance of the core in its unit: K, °F or points of %.
    fn distance(&self, by: f64) -> String {
        match self.goal.scale.measure() {
            Measure::Peak if self.speech.fahrenheit => format!("{:.0}\u{a0}°F", 1.8 * by),
            Measure::Peak => format!("{by:.0}\u{a0}°C"),
            Measure::Share => format!("{by:.0}\u{a0}%"),
        }
    }

    fn span(&self, seconds: f64) -> String {
        span(seconds, self.speech.language)
    }

    fn class(&self) -> String {
        let name = self.goal.scale.class.get(self.goal.class).map_or("", |class| class.name.as_str());
        class(&self.goal.scale, name, self.speech.language).to_owned()
    }

    fn missing(&self, shortfall: Shortfall) -> String {
        let (outcome, goal) = (&self.judgement.outcome, self.goal);
        let pct = |value: f64| format!("{value:.0}");
        match shortfall {
            Shortfall::Undercooked => self.fill(
                "result.undercooked",
                &[("core", &self.core(outcome.at_core)), ("wanted", &self.core(goal.core[0]))],
            ),
            Shortfall::Overcooked => self.fill(
                "result.overcooked",
                &[("core", &self.core(outcome.at_core)), ("wanted", &self.core(goal.core[1]))],
            ),
            Shortfall::Share => self.fill(
                if goal.counts == Counted::Faces { "result.too_little_brown" } else { "result.too_little" },
                &[
                    ("share", &pct(outcome.target_share_pct)),
                    ("class", &self.class()),
                    ("wanted", &pct(goal.least_share_pct)),
                ],
            ),
            Shortfall::Crust => {
                self.fill("result.pale", &[("share", &pct(outcome.least_crust_pct)), ("wanted", &pct(goal.crust_pct))])
            }
            Shortfall::Burnt => self
                .fill("result.burnt", &[("share", &pct(outcome.charred_pct)), ("most", &pct(goal.most_charred_pct))]),
            Shortfall::Fire => self.text("result.fire"),
        }
    }

    fn measures(&self) -> Vec<(String, String)> {
        let (judgement, outcome) = (self.judgement, &self.judgement.outcome);
        let two = |[below, above]: [f64; 2], unit: &str| {
            let [above, below] = [above, below].map(|v| format!("{v:.1}"));
            self.fill("result.faces", &[("above", &above), ("below", &below), ("unit", &unit)])
        };
        let whole = |[below, above]: [f64; 2]| {
            let [above, below] = [above, below].map(|v| format!("{v:.0}"));
            self.fill("result.faces", &[("above", &above), ("below", &below), ("unit", &"%")])
        };
        let mut measures = vec![("result.core", self.core(outcome.at_core))];
        if self.goal.counts == Counted::Section {
            measures.push(("result.grey", two(judgement.grey_mm, "mm")));
            let [beyond, usual] = [outcome.beyond_pct, 100.0 - self.goal.full_share_pct].map(|pct| format!("{pct:.0}"));
            measures
                .push(("result.beyond", self.fill("result.beyond_usual", &[("percent", &beyond), ("usual", &usual)])));
        }
        measures.extend([
            ("result.crust", whole(judgement.crust_pct)),
            ("result.charred", whole(judgement.charred_pct)),
            // Adding zero turns −0 into 0.
            ("result.lost", format!("{:.0}\u{a0}%", outcome.lost_pct.round() + 0.0)),
            (
                "result.energy",
                format!("{:.0}\u{a0}kJ ({:.2}\u{a0}kWh)", judgement.energy_kj, judgement.energy_kj / 3600.0),
            ),
        ]);
        if let Some(kill) = judgement.kill {
            let key = if kill.is_enough() { "result.pasteurised" } else { "result.not_pasteurised" };
            let [log, asked] = [kill.log.clamp(0.0, MOST_LOG), kill.asked_log].map(|log| format!("{log:.1}"));
            measures.push(("result.germs", self.fill(key, &[("log", &log), ("asked", &asked)])));
        }
        measures.into_iter().map(|(key, value)| (self.text(key), value)).collect()
    }

    fn better(&self) -> String {
        let degrees = |c: f64| self.speech.temperature(c);
        let pct = |value: f64| format!("{value:.0}");
        let watts = |had: Option<f64>| had.map(|w| format!("{w:.0} W"));
        match self.judgement.better {
            None => self.text("better.nothing"),
            Some(Better::RestLonger) => self.text("better.rest_longer"),
            Some(Better::PullEarlier { by, by_s: Some(by_s) }) => {
                self.fill("better.pull_earlier_by", &[("time", &self.span(by_s)), ("by", &self.distance(by))])
            }
            Some(Better::PullEarlier { by, by_s: None }) => {
                self.fill("better.pull_earlier", &[("by", &self.distance(by))])
            }
            Some(Better::PullLater { by, by_s: Some(by_s) }) => {
                self.fill("better.pull_later_by", &[("time", &self.span(by_s)), ("by", &self.distance(by))])
            }
            Some(Better::PullLater { by, by_s: None }) => self.fill("better.pull_later", &[("by", &self.distance(by))]),
            Some(Better::LeaveIn { by, until }) => {
                self.fill("better.leave_in", &[("by", &self.distance(by)), ("until", &self.core(until))])
            }
            Some(Better::HotterPan { had_c, until_c }) => {
                self.fill("better.hotter_pan", &[("had", &degrees(had_c)), ("wanted", &degrees(until_c))])
            }
            Some(Better::CoolerPan { had_c, most_c }) => {
                self.fill("better.cooler_pan", &[("had", &degrees(had_c)), ("most", &degrees(most_c))])
            }
            Some(Better::LessCrowded { covered_pct }) => {
                self.fill("better.less_crowded", &[("share", &pct(covered_pct))])
            }
            Some(Better::DryFaces { lowest_c }) => self.fill("better.dry_faces", &[("lowest", &degrees(lowest_c))]),
            Some(Better::PalerFace { faces_pct: [pale, brown] }) => {
                self.fill("better.paler_face", &[("pale", &pct(pale)), ("brown", &pct(brown))])
            }
            Some(Better::MorePower { had_w }) => match watts(had_w) {
                Some(had) => self.fill("better.more_power_than", &[("had", &had)]),
                None => self.text("better.more_power"),
            },
            Some(Better::LessPower { had_w }) => match watts(had_w) {
                Some(had) => self.fill("better.less_power_than", &[("had", &had)]),
                None => self.text("better.less_power"),
            },
            Some(Better::FlipMoreOften { had, every_s }) => {
                self.fill("better.flip_more", &[("had", &had), ("seconds", &every_s)])
            }
        }
    }
}
