//! Checks a protocol file: what parses must also be possible.

use std::collections::BTreeSet;
use std::sync::Arc;

use saute_kitchen::Library;
use saute_schema::{InputError, InputText};
use toml::Spanned;

use super::protocol::{Answering, Condition, CookForReal, Item, Phase, Protocol, Questionnaire, Simulate, Task};
use super::protocol_file::{
    AnswerKind, ConditionEntry, CookForRealEntry, ItemEntry, MOST_CONDITIONS, MOST_ITEMS, MOST_PHASES, PhaseEntry,
    ProtocolFile, QuestionnaireEntry, SimulateEntry,
};
use crate::set_out::SetOut;
use saute_plan::Aimed;

/// Longest trial unless the protocol states another one [s].
const USUAL_MAX_S: f64 = 1800.0;
/// Longest text of a question or a title [letters] (chosen: what is read on a phone without scrolling far).
const LONGEST_TEXT: usize = 600;
/// Longest text of consent and instructions [letters] (chosen: two pages).
const LONGEST_PAGE: usize = 6000;
/// Words for the ends of a Likert item without its own.
const USUAL_ENDS: [&str; 2] = ["not at all", "very much"];

/// A protocol's text and the library with what it can name.
pub(super) struct Check<'a> {
    pub(super) input: InputText<'a>,
    pub(super) library: &'a Library,
}

type Checked<T> = Result<T, InputError>;

impl Check<'_> {
    pub(super) fn protocol(&self) -> Checked<Protocol> {
        if self.input.text.trim().is_empty() {
            return self.input.error(0, "the file is empty", "start from a shipped protocol: saute list studies");
        }
        let raw: ProtocolFile = self.input.parse("the keys and their types are listed by: saute schema study")?;
        self.id("id", &raw.id)?;
        self.text("title", &raw.title, LONGEST_TEXT)?;
        self.text("consent", &raw.consent, LONGEST_PAGE)?;
        self.count("condition", raw.condition.len(), MOST_CONDITIONS)?;
        self.count("phase", raw.phase.len(), MOST_PHASES)?;
        self.distinct("condition.id", raw.condition.iter().map(|condition| &condition.get_ref().id))?;
        let conditions = raw.condition.iter().map(|c| self.condition(c.get_ref())).collect::<Checked<_>>()?;
        let phases = raw.phase.iter().map(|p| self.phase(p, raw.allow_free_text)).collect::<Checked<Vec<_>>>()?;
        self.items_are_distinct(&raw.phase)?;
        Ok(Protocol {
            id: raw.id.into_inner(),
            title: raw.title.into_inner(),
            consent: raw.consent.into_inner(),
            seed: raw.seed,
            keep_sessions: raw.keep_sessions,
            time_of_day: raw.time_of_day,
            sound: raw.sound,
            conditions,
            phases,
            checksum: crc32fast::hash(self.input.text.as_bytes()),
        })
    }

    fn condition(&self, entry: &ConditionEntry) -> Checked<Condition> {
        self.id("condition.id", &entry.id)?;
        Ok(Condition { id: entry.id.get_ref().clone(), information: entry.information })
    }

    fn phase(&self, entry: &Spanned<PhaseEntry>, free_text: bool) -> Checked<Phase> {
        let PhaseEntry { title, simulate, cook_for_real, questionnaire } = entry.get_ref();
        let task = match (simulate, cook_for_real, questionnaire) {
            (Some(trials), None, None) => Task::Simulate(self.simulate(trials)?),
            (None, Some(real), None) => Task::CookForReal(self.cook_for_real(real.get_ref())?),
            (None, None, Some(asked)) => Task::Questionnaire(self.questionnaire(asked.get_ref(), free_text)?),
            _ => {
                let remedy = "write one of [phase.simulate], [phase.cook_for_real] and [phase.questionnaire]";
                return self.input.error(entry.span().start, "phase has no task, or more than one", remedy);
            }
        };
        Ok(Phase { title: title.clone().unwrap_or_default(), task })
    }

    fn simulate(&self, entry: &Spanned<SimulateEntry>) -> Checked<Simulate> {
        let raw = entry.get_ref();
        let set_out = SetOut::named(self.input, entry.span().start, raw.recipe.as_ref(), raw.scenario.as_ref())?;
        let recipe = set_out.recipe(self.input, self.library)?;
        let max_s = raw.max_s.as_ref().map_or(USUAL_MAX_S, |s| *s.get_ref());
        let goal = self.goal(&raw.goal)?;
        self.fits(&raw.goal, &goal, &recipe)?;
        Ok(Simulate {
            goal,
            recipe: Arc::new(recipe),
            trials: *raw.trials.get_ref(),
            speed: *raw.speed.get_ref(),
            max_s,
            information: raw.information,
            feedback: raw.feedback,
        })
    }

    fn cook_for_real(&self, entry: &CookForRealEntry) -> Checked<CookForReal> {
        self.text("instructions", &entry.instructions, LONGEST_PAGE)?;
        let (enter, at) = (entry.enter.get_ref(), entry.enter.span().start);
        if enter.is_empty() || enter.iter().collect::<BTreeSet<_>>().len() != enter.len() {
            return self.input.error(
                at,
                "enter is empty or names a thing twice",
                "name each thing once, as [\"core_c\"]",
            );
        }
        let instructions = entry.instructions.get_ref().clone();
        Ok(CookForReal { instructions, goal: self.goal(&entry.goal)?, enter: enter.clone() })
    }

    fn questionnaire(&self, entry: &QuestionnaireEntry, free_text: bool) -> Checked<Questionnaire> {
        self.count("item", entry.item.len(), MOST_ITEMS)?;
        let items = entry.item.iter().map(|item| self.item(item.get_ref(), free_text)).collect::<Checked<_>>()?;
        Ok(Questionnaire { intro: entry.intro.clone().unwrap_or_default(), items })
    }

    fn item(&self, entry: &ItemEntry, free_text: bool) -> Checked<Item> {
        self.id("item.id", &entry.id)?;
        self.text("item.text", &entry.text, LONGEST_TEXT)?;
        let at = entry.answer.span().start;
        let answer = match entry.answer.get_ref() {
            AnswerKind::Likert => Answering::Likert(self.ends(entry)?),
            AnswerKind::Number => Answering::Number(self.range(entry, at)?, entry.unit.clone().unwrap_or_default()),
            AnswerKind::Choice => Answering::Choice(self.choices(entry, at)?),
            AnswerKind::Text if free_text => Answering::Text,
            AnswerKind::Text => {
                let message = "answer = \"text\" invites personal data";
                let remedy = "ask by likert, number or choice, or write allow_free_text = true at the top of the file";
                return self.input.error(at, message, remedy);
            }
        };
        Ok(Item { id: entry.id.get_ref().clone(), text: entry.text.get_ref().clone(), answer })
    }

    fn ends(&self, entry: &ItemEntry) -> Checked<[String; 2]> {
        match entry.ends.as_ref().map(|ends| (ends.get_ref().as_slice(), ends.span().start)) {
            None => Ok(USUAL_ENDS.map(str::to_owned)),
            Some(([low, high], _)) => Ok([low.clone(), high.clone()]),
            Some((_, at)) => {
                self.input.error(at, "ends has not two words", "write ends = [\"not at all\", \"very much\"]")
            }
        }
    }

    fn range(&self, entry: &ItemEntry, at: usize) -> Checked<[f64; 2]> {
        match entry.range.as_ref().map(|range| range.get_ref().as_slice()) {
            Some([low, high]) if low.is_finite() && high.is_finite() && low < high => Ok([*low, *high]),
            _ => self.input.error(at, "a number needs a range", "write range = [lowest, highest]"),
        }
    }

    fn choices(&self, entry: &ItemEntry, at: usize) -> Checked<Vec<String>> {
        match entry.choices.as_ref().map(Spanned::get_ref) {
            Some(choices) if (2..=9).contains(&choices.len()) && choices.iter().all(|c| !c.trim().is_empty()) => {
                Ok(choices.clone())
            }
            _ => self.input.error(at, "a choice needs 2 to 9 choices", "write choices = [\"yes\", \"no\"]"),
        }
    }

    fn goal(&self, id: &Spanned<String>) -> Checked<Aimed> {
        Aimed::named(self.input, self.library, "goal", id)
    }

    fn fits(&self, id: &Spanned<String>, aimed: &Aimed, recipe: &saute_recipe::Recipe) -> Checked<()> {
        aimed.check_fits(self.input, self.library, id, recipe)
    }

    fn id(&self, key: &str, id: &Spanned<String>) -> Checked<()> {
        let (name, at) = (id.get_ref(), id.span().start);
        let plain = |c: char| c.is_ascii_alphanumeric() || c == '-' || c == '_';
        if !name.is_empty() && name.len() <= 40 && name.chars().all(plain) {
            return Ok(());
        }
        self.input.error(at, format!("{key} = \"{name}\" cannot be used"), "write 1 to 40 letters, digits, - and _")
    }

    fn text(&self, key: &str, text: &Spanned<String>, longest: usize) -> Checked<()> {
        let count = text.get_ref().trim().chars().count();
        if (1..=longest).contains(&count) {
            return Ok(());
        }
        let remedy = format!("{key} may have 1 to {longest} letters");
        self.input.error(text.span().start, format!("{key} has {count} letters"), remedy)
    }

    fn count(&self, key: &str, count: usize, most: usize) -> Checked<()> {
        if (1..=most).contains(&count) {
            return Ok(());
        }
        self.input.error(0, format!("there are {count} tables [[{key}]]"), format!("write 1 to {most} of them"))
    }

    fn distinct<'a>(&self, key: &str, ids: impl Iterator<Item = &'a Spanned<String>>) -> Checked<()> {
        let mut known = BTreeSet::new();
        for id in ids {
            if !known.insert(id.get_ref()) {
                let message = format!("{key} = \"{}\" is there twice", id.get_ref());
                return self.input.error(id.span().start, message, "give each its own id");
            }
        }
        Ok(())
    }

    fn items_are_distinct(&self, phases: &[Spanned<PhaseEntry>]) -> Checked<()> {
        let asked = phases.iter().filter_map(|phase| phase.get_ref().questionnaire.as_ref());
        asked.clone().try_for_each(|q| self.distinct("item.id", q.get_ref().item.iter().map(|item| &item.get_ref().id)))
    }
}
