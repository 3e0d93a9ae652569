//! The course of a study: events of the participant become rows of the log.

use std::collections::BTreeMap;
use std::sync::Arc;

use super::log_row::{LogRow, RowKind};
use super::measures::Measures;
use super::pace::Pace;
use super::participant::Participant;
use super::protocol::{Answering, CookForReal, LIKERT_STEPS, Phase, Protocol, Questionnaire, Simulate, Task};
use super::protocol_file::{Entered, Information};

/// A participant's way through a protocol. It has no clock: who drives it states how much time has passed.
#[derive(Clone, Debug)]
pub struct Study {
    protocol: Arc<Protocol>,
    participant: Participant,
    condition: usize,
    is_simulated: bool,
    started: Option<String>,
    stage: Stage,
}

/// Where a participant is.
#[derive(Clone, Copy, Debug, Eq, PartialEq)]
pub enum Stage {
    /// Reads what is agreed to.
    Consent,
    /// Before or in a trial, by its number from 1.
    Trial {
        /// Place of the phase.
        phase: usize,
        /// Number of the trial.
        trial: u32,
    },
    /// Cooks for real, and enters what came of it.
    CookForReal {
        /// Place of the phase.
        phase: usize,
    },
    /// Answers questions.
    Questionnaire {
        /// Place of the phase.
        phase: usize,
    },
    /// Everything is done.
    Over,
}

/// What happened.
#[derive(Clone, Debug, PartialEq)]
pub enum Event {
    /// The participant agreed.
    Agreed,
    /// A trial ended.
    TrialEnded {
        /// What came of it.
        measures: Box<Measures>,
        /// Wall time that it took; none for a simulated participant [s].
        wall_s: Option<f64>,
        /// How the locked speed was held; none for a simulated participant.
        pace: Option<Pace>,
        /// File of its session.
        session: Option<String>,
        /// Names of the devices that were connected; none if there were none.
        devices: Option<String>,
    },
    /// Values were entered, or questions answered.
    Answered(Answers),
}

/// Answers by the ids of their items.
pub type Answers = BTreeMap<String, Answer>;

/// An answer.
#[derive(Clone, Debug, PartialEq)]
pub enum Answer {
    /// A number, or a step of a Likert item.
    Number(f64),
    /// A choice, by its place from 0.
    Choice(usize),
    /// Free text.
    Text(String),
}

/// Why an event is refused.
#[derive(Clone, Debug, Eq, PartialEq, thiserror::Error)]
pub enum StudyError {
    /// It does not belong to the stage.
    #[error("this does not belong to the present phase")]
    OutOfOrder,
    /// An item has no answer.
    #[error("{0} has no answer")]
    Missing(String),
    /// An answer is not one of its item.
    #[error("the answer to {0} is out of range")]
    OutOfRange(String),
    /// A log is of another protocol, participant or condition, or in another order.
    #[error("the log is not that of this participant and protocol: {0}")]
    OtherLog(&'static str),
}

/// Longest free text that is kept [letters] (chosen: a few sentences).
const LONGEST_TEXT: usize = 400;

impl Study {
    /// Begins a study.
    pub fn begin(protocol: Arc<Protocol>, participant: Participant) -> Self {
        let condition = participant.condition(&protocol);
        Self { protocol, participant, condition, is_simulated: false, started: None, stage: Stage::Consent }
    }

    /// As [`Self::begin`], for a simulated participant.
    pub fn simulated(protocol: Arc<Protocol>, participant: Participant) -> Self {
        Self { is_simulated: true, ..Self::begin(protocol, participant) }
    }

    /// States the time of day of the start; it is kept only if the protocol requests it.
    pub fn started_at(mut self, time_of_day: String) -> Self {
        self.started = self.protocol.time_of_day.then_some(time_of_day);
        self
    }

    /// Goes on after the rows of an earlier run. A questionnaire or a cook of which rows are missing is requested again in full.
    ///
    /// # Errors
    ///
    /// If the rows are not those of this participant and protocol, in its order.
    pub fn resume(mut self, rows: &[LogRow]) -> Result<Self, StudyError> {
        let mut rest = rows;
        while let Some(row) = rest.first() {
            self.check_own(row)?;
            let count = match self.stage {
                Stage::Consent if row.kind == RowKind::Consent => 1,
                Stage::Trial { phase, trial } if is_of(row, RowKind::Trial, phase) && row.trial == Some(trial) => 1,
                Stage::CookForReal { phase } if is_of(row, RowKind::Entry, phase) => {
                    self.protocol.items_of(phase).len()
                }
                Stage::Questionnaire { phase } if is_of(row, RowKind::Answer, phase) => {
                    self.protocol.items_of(phase).len()
                }
                _ => return Err(StudyError::OtherLog("its rows are in another order")),
            };
            if rest.len() < count {
                return Ok(self);
            }
            rest = &rest[count..];
            self.go_on();
        }
        Ok(self)
    }

    fn check_own(&self, row: &LogRow) -> Result<(), StudyError> {
        let cases = [
            (row.study == self.protocol.id, "it is of another study"),
            (row.protocol == self.protocol.checksum_text(), "the protocol was changed since"),
            (row.participant == self.participant.code(), "it is of another participant"),
            (row.condition == self.condition().id, "it is of another condition"),
            (row.simulated == self.is_simulated, "one of the two is simulated"),
        ];
        cases.iter().find(|(is_own, _)| !is_own).map_or(Ok(()), |(_, why)| Err(StudyError::OtherLog(why)))
    }

    /// The protocol.
    pub fn protocol(&self) -> &Arc<Protocol> {
        &self.protocol
    }

    /// The participant.
    pub fn participant(&self) -> &Participant {
        &self.participant
    }

    /// The participant's condition.
    pub fn condition(&self) -> &super::protocol::Condition {
        &self.protocol.conditions[self.condition]
    }

    /// Where the participant is.
    pub fn stage(&self) -> Stage {
        self.stage
    }

    /// Place of the present phase; none before the first and after the last.
    pub fn phase_place(&self) -> Option<usize> {
        match self.stage {
            Stage::Trial { phase, .. } | Stage::CookForReal { phase } | Stage::Questionnaire { phase } => Some(phase),
            Stage::Consent | Stage::Over => None,
        }
    }

    /// The present phase.
    pub fn phase(&self) -> Option<&Phase> {
        self.phase_place().map(|place| &self.protocol.phases[place])
    }

    /// The trials of the present phase.
    pub fn simulate(&self) -> Option<&Simulate> {
        match &self.phase()?.task {
            Task::Simulate(simulate) => Some(simulate),
            _ => None,
        }
    }

    /// The cook at a real stove of the present phase.
    pub fn cook_for_real(&self) -> Option<&CookForReal> {
        match &self.phase()?.task {
            Task::CookForReal(real) => Some(real),
            _ => None,
        }
    }

    /// The questions of the present phase.
    pub fn questionnaire(&self) -> Option<&Questionnaire> {
        match &self.phase()?.task {
            Task::Questionnaire(asked) => Some(asked),
            _ => None,
        }
    }

    /// Whether read-outs are shown now: as the phase states, else as the condition states; nothing is shown outside trials.
    pub fn information(&self) -> Information {
        let stated = self.simulate().map(|simulate| simulate.information.unwrap_or(self.condition().information));
        stated.unwrap_or(Information::Hidden)
    }

    /// Takes an event at a wall time since the beginning [s]; returns the rows to be written.
    ///
    /// # Errors
    ///
    /// If it does not belong to the stage, or an answer is missing or impossible; the stage stays as it is.
    pub fn take(&mut self, event: Event, elapsed_s: f64) -> Result<Vec<LogRow>, StudyError> {
        let rows = match (event, self.stage) {
            (Event::Agreed, Stage::Consent) => vec![self.row(RowKind::Consent, elapsed_s)],
            (Event::TrialEnded { measures, wall_s, pace, session, devices }, Stage::Trial { trial, .. }) => {
                let row = self.row(RowKind::Trial, elapsed_s);
                let information = Some(self.information());
                let goal = self.simulate().map(|simulate| simulate.goal.goal.id.clone());
                let trial_wall_s = wall_s.map(tenth);
                let row = LogRow { trial: Some(trial), information, goal, session, trial_wall_s, devices, ..row };
                vec![with_pace(measures.written(row), pace)]
            }
            (Event::Answered(answers), Stage::CookForReal { .. }) => self.entries(&answers, elapsed_s)?,
            (Event::Answered(answers), Stage::Questionnaire { .. }) => self.answers(&answers, elapsed_s)?,
            _ => return Err(StudyError::OutOfOrder),
        };
        self.go_on();
        Ok(rows)
    }

    /// Goes to the next trial or phase.
    fn go_on(&mut self) {
        self.stage = match self.stage {
            Stage::Consent => self.begin_of(0),
            Stage::Trial { phase, trial } if self.simulate().is_some_and(|s| trial < s.trials) => {
                Stage::Trial { phase, trial: trial + 1 }
            }
            Stage::Trial { phase, .. } | Stage::CookForReal { phase } | Stage::Questionnaire { phase } => {
                self.begin_of(phase + 1)
            }
            Stage::Over => Stage::Over,
        };
    }

    fn begin_of(&self, phase: usize) -> Stage {
        match self.protocol.phases.get(phase).map(|phase| &phase.task) {
            Some(Task::Simulate(_)) => Stage::Trial { phase, trial: 1 },
            Some(Task::CookForReal(_)) => Stage::CookForReal { phase },
            Some(Task::Questionnaire(_)) => Stage::Questionnaire { phase },
            None => Stage::Over,
        }
    }

    fn entries(&self, answers: &Answers, elapsed_s: f64) -> Result<Vec<LogRow>, StudyError> {
        let Some(real) = self.cook_for_real() else { return Err(StudyError::OutOfOrder) };
        let classes = real.goal.classes();
        let row = |entered: &Entered| {
            let answering = match entered.range() {
                Some(range) => Answering::Number(range, entered.unit().to_owned()),
                None => Answering::Choice(classes.clone()),
            };
            self.answered(RowKind::Entry, entered.id(), &answering, answers, elapsed_s)
        };
        real.enter.iter().map(row).collect()
    }

    fn answers(&self, answers: &Answers, elapsed_s: f64) -> Result<Vec<LogRow>, StudyError> {
        let Some(asked) = self.questionnaire() else { return Err(StudyError::OutOfOrder) };
        let row =
            |item: &super::protocol::Item| self.answered(RowKind::Answer, &item.id, &item.answer, answers, elapsed_s);
        asked.items.iter().map(row).collect()
    }

    fn answered(
        &self,
        kind: RowKind,
        id: &str,
        answering: &Answering,
        answers: &Answers,
        elapsed_s: f64,
    ) -> Result<LogRow, StudyError> {
        let answer = answers.get(id).ok_or_else(|| StudyError::Missing(id.to_owned()))?;
        let (value, text) = written(answering, answer).ok_or_else(|| StudyError::OutOfRange(id.to_owned()))?;
        Ok(LogRow { item: Some(id.to_owned()), value, text, ..self.row(kind, elapsed_s) })
    }

    /// A row without what only some kinds have.
    fn row(&self, kind: RowKind, elapsed_s: f64) -> LogRow {
        LogRow {
            study: self.protocol.id.clone(),
            protocol: self.protocol.checksum_text(),
            participant: self.participant.code().to_owned(),
            simulated: self.is_simulated,
            condition: self.condition().id.clone(),
            phase: self.phase_place().map_or(0, |place| place as u32 + 1),
            kind,
            elapsed_s: tenth(elapsed_s),
            started: self.started.clone(),
            trial: None,
            information: None,
            goal: None,
            score: None,
            is_met: None,
            target_share_pct: None,
            beyond_pct: None,
            grey_band_mm: None,
            core_peak_c: None,
            crust_pct: None,
            charred_pct: None,
            lost_pct: None,
            energy_kj: None,
            flips: None,
            put_s: None,
            out_s: None,
            end_s: None,
            trial_wall_s: None,
            session: None,
            item: None,
            value: None,
            text: None,
            mark: None,
            speed_set: None,
            speed_held_median: None,
            behind_s: None,
            devices: None,
        }
    }
}

impl Protocol {
    /// The checksum as logs state it: eight hexadecimal digits.
    pub fn checksum_text(&self) -> String {
        format!("{:08x}", self.checksum)
    }
}

fn is_of(row: &LogRow, kind: RowKind, phase: usize) -> bool {
    row.kind == kind && row.phase == phase as u32 + 1
}

fn with_pace(row: LogRow, pace: Option<Pace>) -> LogRow {
    let pace = pace.map(Pace::to_two_places);
    let (speed_set, speed_held_median) = (pace.map(|p| p.set), pace.map(|p| p.held_median));
    LogRow { speed_set, speed_held_median, behind_s: pace.map(|p| p.behind_s), ..row }
}

/// An answer as number and text of a row; none if it is not one of its item.
fn written(answering: &Answering, answer: &Answer) -> Option<(Option<f64>, Option<String>)> {
    match (answering, answer) {
        (Answering::Likert(_), Answer::Number(step)) => {
            let is_step = (1..=LIKERT_STEPS).any(|s| f64::from(s) == *step);
            is_step.then_some((Some(*step), None))
        }
        (Answering::Number([low, high], _), Answer::Number(value)) => {
            (low..=high).contains(&value).then_some((Some(*value), None))
        }
        (Answering::Choice(choices), Answer::Choice(place)) => {
            choices.get(*place).map(|word| (Some(*place as f64 + 1.0), Some(word.clone())))
        }
        (Answering::Text, Answer::Text(text)) => Some((None, Some(plain_text(text)))),
        _ => None,
    }
}

/// Free text on one line, that no sheet takes for a formula.
fn plain_text(text: &str) -> String {
    let plain = text.trim().chars().map(|c| if c.is_control() { ' ' } else { c });
    let guard = if text.trim().starts_with(['=', '+', '-', '@']) { "'" } else { "" };
    guard.chars().chain(plain.take(LONGEST_TEXT)).collect()
}

/// A time to a tenth [s].
pub(super) fn tenth(seconds: f64) -> f64 {
    libm::round(10.0 * seconds) / 10.0
}
