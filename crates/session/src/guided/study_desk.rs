//! A study in the window: the participant's way, the present trial, and where rows go.

use std::collections::BTreeSet;
use std::sync::Arc;

use saute_study::protocol_file::Information;
use saute_study::{
    Event, LogRow, Measures, Pace, PaceMeter, Participant, Protocol, Simulate, Stage, Study, StudyError, Times, to_csv,
};
use web_time::Instant;

use super::log_keeper::{InMemory, LogKeeper};
use super::readiness::{Readiness, TrialRun};
use crate::Session;
use crate::hands::Hands;

/// A study to begin with.
pub struct StudyStart {
    study: Study,
    earlier: Vec<LogRow>,
    keeper: Box<dyn LogKeeper>,
    readiness: Readiness,
}

impl Clone for StudyStart {
    /// A clone keeps its rows in memory: a log has one writer.
    fn clone(&self) -> Self {
        Self {
            study: self.study.clone(),
            earlier: self.earlier.clone(),
            keeper: Box::new(InMemory),
            readiness: self.readiness.clone(),
        }
    }
}

impl std::fmt::Debug for StudyStart {
    fn fmt(&self, f: &mut std::fmt::Formatter) -> std::fmt::Result {
        f.debug_struct("StudyStart").field("participant", self.study.participant()).finish_non_exhaustive()
    }
}

impl StudyStart {
    /// A study whose rows are kept in memory, as in a page without storage.
    pub fn in_memory(protocol: Arc<Protocol>, participant: Participant) -> Self {
        let study = Study::begin(protocol, participant);
        Self { study, earlier: Vec::new(), keeper: Box::new(InMemory), readiness: Readiness::Untried }
    }

    /// The same on a machine that somebody has tried: its speed is stored with each trial as usual.
    #[must_use]
    pub fn on_tried_machine(self) -> Self {
        Self { readiness: Readiness::NotNeeded, ..self }
    }

    /// The same on a machine whose pace is known: it is not tried.
    #[must_use]
    pub fn on_machine(self, pace: Pace) -> Self {
        Self { readiness: Readiness::known(pace), ..self }
    }

    /// Goes on after the rows of a log.
    ///
    /// # Errors
    ///
    /// If they are of another participant or protocol.
    pub fn resumed(
        protocol: Arc<Protocol>,
        participant: Participant,
        (keeper, earlier): (Box<dyn LogKeeper>, Vec<LogRow>),
    ) -> Result<Self, String> {
        let study = Self::in_memory(protocol, participant).study;
        let study = study.resume(&earlier).map_err(|error| error.to_string())?;
        Ok(Self { study, earlier, keeper, readiness: Readiness::Untried })
    }
}

/// A study in the window.
pub struct StudyDesk {
    study: Study,
    keeper: Box<dyn LogKeeper>,
    /// All rows, and how many of them are kept.
    rows: Vec<LogRow>,
    kept: usize,
    trial: Option<Trial>,
    last: Option<Measures>,
    has_declined: bool,
    begun: Instant,
    trouble: Option<String>,
    readiness: Readiness,
}

/// A trial that runs.
struct Trial {
    masses: Vec<f64>,
    begun: Instant,
    meter: PaceMeter,
    /// Names of the devices that were connected at any time of it.
    devices: BTreeSet<String>,
}

impl StudyDesk {
    /// Begins a study at a time of day [ISO 8601, UTC].
    pub fn begin(start: StudyStart, now: String) -> Self {
        let kept = start.earlier.len();
        Self {
            study: start.study.started_at(now),
            keeper: start.keeper,
            rows: start.earlier,
            kept,
            trial: None,
            last: None,
            has_declined: false,
            begun: Instant::now(),
            trouble: None,
            readiness: start.readiness,
        }
    }

    /// The participant's way.
    pub fn study(&self) -> &Study {
        &self.study
    }

    /// What is known of the machine.
    pub fn readiness(&self) -> &Readiness {
        &self.readiness
    }

    /// The trials at whose speed the machine is to be tried now; none where that is known.
    pub fn to_try(&self) -> Option<&Simulate> {
        matches!(self.readiness, Readiness::Untried).then(|| self.study.fastest_to_come()).flatten()
    }

    /// Tries the machine with what is set out now, at a speed; without one there is no need.
    pub fn try_machine(&mut self, speed: Option<f64>) {
        self.readiness = speed.map_or(Readiness::NotNeeded, |speed| Readiness::Tried(TrialRun::at(speed)));
    }

    /// Forgets what is known of the machine.
    pub fn try_again(&mut self) {
        if matches!(self.readiness, Readiness::TooSlow(_)) {
            self.readiness = Readiness::Untried;
        }
    }

    /// These devices are connected now.
    pub fn note_devices(&mut self, names: Vec<String>) {
        if let Some(trial) = &mut self.trial {
            trial.devices.extend(names);
        }
    }

    /// So much wall time and simulated time has passed [s]; returns true if the machine was tried and it is known now.
    pub fn pass(&mut self, wall_s: f64, simulated_s: f64) -> bool {
        if let Some(trial) = &mut self.trial {
            trial.meter.pass(wall_s, simulated_s);
        }
        let Readiness::Tried(run) = &mut self.readiness else { return false };
        let Some(found) = run.pass(wall_s, simulated_s) else { return false };
        self.readiness = found;
        true
    }

    /// True while a trial runs.
    pub fn is_running(&self) -> bool {
        self.trial.is_some()
    }

    /// True if the participant did not agree.
    pub fn has_declined(&self) -> bool {
        self.has_declined
    }

    /// What came of the trial before, if it is to be shown to the participant.
    pub fn told(&self) -> Option<&Measures> {
        self.last.as_ref()
    }

    /// Why rows could not be written.
    pub fn trouble(&self) -> Option<&str> {
        self.trouble.as_deref()
    }

    /// True if rows are where only the page reaches them.
    pub fn offers_download(&self) -> bool {
        !self.keeper.is_file() && !self.rows.is_empty()
    }

    /// The log as CSV.
    pub fn csv(&self) -> String {
        to_csv(&self.rows, true)
    }

    /// True if the condition hides read-outs.
    pub fn hides_read_outs(&self) -> bool {
        self.study.information() == Information::Hidden
    }

    /// Returns true if the protocol lets participants hear the pan.
    pub fn sounds(&self) -> bool {
        self.study.protocol().sound
    }

    /// The participant does not agree.
    pub fn decline(&mut self) {
        self.has_declined = self.study.stage() == Stage::Consent;
    }

    /// A trial begins with what is set out now.
    pub fn begin_trial<H: Hands>(&mut self, session: &Session<H>) {
        let masses = session.kitchen.pieces().iter().map(saute_kitchen::Piece::mass).collect();
        let meter = PaceMeter::at(session.speed);
        let devices = session.hands.names().into_iter().collect();
        self.trial = Some(Trial { masses, begun: Instant::now(), meter, devices });
    }

    /// Returns true if the trial has come to its end: its time is over, or the food has rested.
    pub fn is_over<H: Hands>(&self, session: &Session<H>) -> bool {
        let Some(simulate) = self.study.simulate().filter(|_| self.is_running()) else { return false };
        session.kitchen.time_s() >= simulate.max_s || saute_study::class::rest::has_rested(&session.kitchen)
    }

    /// Ends the trial, and keeps its row.
    pub fn end_trial<H: Hands>(&mut self, session: &Session<H>) {
        let (Some(trial), Some(simulate)) = (self.trial.take(), self.study.simulate()) else { return };
        let measures = Measures::read(
            &session.kitchen,
            &trial.masses,
            &simulate.goal,
            &Times::of(session.recording(), &session.recorder),
        );
        let told = simulate.feedback.then_some(measures);
        let session_name = self.keep_session(session);
        let wall_s = Some(trial.begun.elapsed().as_secs_f64());
        // A trial that runs belongs to the stage.
        let pace = trial.meter.pace();
        let devices = (!trial.devices.is_empty()).then(|| Vec::from_iter(trial.devices).join(" "));
        let measures = Box::new(measures);
        let _ = self.take(Event::TrialEnded { measures, wall_s, pace, session: session_name, devices });
        self.last = told;
    }

    /// Takes an event; its rows are kept at once.
    ///
    /// # Errors
    ///
    /// If it does not belong to the present stage.
    pub fn take(&mut self, event: Event) -> Result<(), StudyError> {
        let rows = self.study.take(event, self.begun.elapsed().as_secs_f64())?;
        self.rows.extend(rows);
        self.last = None;
        self.keep_rows();
        Ok(())
    }

    /// Writes rows that are not kept yet; states why if it cannot.
    pub fn keep_rows(&mut self) {
        self.trouble = self.keeper.append(&self.rows[self.kept..]).err();
        if self.trouble.is_none() {
            self.kept = self.rows.len();
        }
    }

    /// Keeps the session of the trial, if the protocol requests it and there is a place for it; returns the name of its file.
    fn keep_session<H: Hands>(&mut self, session: &Session<H>) -> Option<String> {
        let Stage::Trial { phase, trial } = self.study.stage() else { return None };
        if !self.study.protocol().keep_sessions {
            return None;
        }
        let name = format!("study-{}-phase-{}-trial-{trial}.saute", self.study.participant(), phase + 1);
        match self.keeper.keep_session(&name, &session.recording().clone().to_file())? {
            Ok(()) => Some(name),
            Err(error) => {
                self.trouble = Some(format!("{name}: {error}"));
                None
            }
        }
    }
}
