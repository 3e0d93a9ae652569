//! A session as it is recorded.

use std::collections::BTreeMap;

use saute_kitchen::{Command, FRAMES_PER_TICK, Kitchen, Library, PieceOrder, TICK_S};

use crate::recipe::Recipe;
use crate::session::beginning::Beginning;
use crate::session::entry::{Deed, Entry};
use crate::session::moment::Moment;

/// Frames from hash to hash: ten seconds (chosen: a departure is found near its cause, at 5 ms of work).
pub const FRAMES_PER_HASH: u64 = (10.0 / TICK_S) as u64 * FRAMES_PER_TICK as u64;

/// What happened in a session up to now.
#[derive(Clone, Debug, PartialEq)]
pub struct Recording {
    beginning: Beginning,
    entries: Vec<Entry>,
    hashes: BTreeMap<u64, u64>,
    /// How far the session came.
    reached: u64,
    /// Frame at which the recipe's steps were carried out last.
    steps_done_at: Option<u64>,
    is_taken_over: bool,
    pub(super) saved: Saved,
}

/// How much of a recording is in its file.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(super) struct Saved {
    /// Number of entries; more than there are if some were undone since.
    pub(super) entries: usize,
    /// Frame up to which hashes are stored.
    pub(super) hashes_below: u64,
    /// Instant up to which the file states that the session came.
    pub(super) reached: Option<(u64, bool)>,
    /// Entries that stay of those in the file, if some were undone since it was written.
    pub(super) cut: Option<usize>,
    /// True if the beginning is stored.
    pub(super) has_begun: bool,
}

impl Recording {
    /// Begins a recording with a recipe, whose steps are carried out if `plays` is true.
    pub fn begin(recipe: &Recipe, plays: bool, library: &Library) -> Self {
        Self::with(Beginning::of(recipe, plays, library))
    }

    pub(super) fn with(beginning: Beginning) -> Self {
        Self {
            beginning,
            entries: Vec::new(),
            hashes: BTreeMap::new(),
            reached: 0,
            steps_done_at: None,
            is_taken_over: false,
            saved: Saved::default(),
        }
    }

    /// Sets the kitchen at home in which it was recorded; none if anything has happened in it.
    pub(super) fn restore_home(&mut self, home: String) -> Option<()> {
        let is_first = self.entries.is_empty() && self.hashes.is_empty() && self.reached == 0;
        self.beginning.home = Some(home).filter(|_| is_first && self.beginning.home.is_none());
        self.beginning.home.as_ref().map(|_| ())
    }

    /// Records a command of a person that the kitchen carried out; it stops the recipe.
    pub fn push(&mut self, kitchen: &Kitchen, command: Command) {
        self.take_over(kitchen);
        self.enter(kitchen, Deed::Command(command));
    }

    /// Records food that a person added; it stops the recipe.
    pub fn add(&mut self, kitchen: &Kitchen, order: PieceOrder) {
        self.take_over(kitchen);
        self.enter(kitchen, Deed::Add(order));
    }

    /// Records that a person removed a piece; it stops the recipe.
    pub fn remove(&mut self, kitchen: &Kitchen, food: &str) {
        self.take_over(kitchen);
        self.enter(kitchen, Deed::Remove(food.to_owned()));
    }

    /// Records that the recipe was stopped, if it plays.
    pub fn take_over(&mut self, kitchen: &Kitchen) {
        if self.beginning.plays && !self.is_taken_over {
            self.enter(kitchen, Deed::TakeOver);
        }
    }

    /// Records that the recipe goes on from where a person took over, if one did.
    pub fn resume(&mut self, kitchen: &Kitchen) {
        if self.is_taken_over {
            self.enter(kitchen, Deed::Resume);
        }
    }

    /// Records the commands that the kitchen carried out since the last call, by whomever; the recipe goes on. The kitchen must
    /// listen ([`Kitchen::listen`]).
    pub fn take(&mut self, kitchen: &mut Kitchen) {
        for command in kitchen.take_carried_out() {
            self.enter(kitchen, Deed::Command(command));
        }
    }

    /// Notes that the recipe's steps due at this frame were carried out. What a listening kitchen heard of them is forgotten.
    pub fn on_steps(&mut self, kitchen: &mut Kitchen) {
        self.steps_done_at = Some(kitchen.frame());
        drop(kitchen.take_carried_out());
    }

    /// Notes how far the kitchen came; every ten simulated seconds keeps a hash of its state.
    pub fn observe(&mut self, kitchen: &Kitchen) {
        self.reached = kitchen.frame();
        if self.reached.is_multiple_of(FRAMES_PER_HASH) && !self.hashes.contains_key(&self.reached) {
            self.hashes.insert(self.reached, kitchen.state_hash());
        }
    }

    fn enter(&mut self, kitchen: &Kitchen, deed: Deed) {
        let frame = kitchen.frame();
        let after_steps = self.steps_done_at == Some(frame);
        self.restore(Entry { frame, after_steps, deed });
    }

    /// Adds an entry that follows all others, as it is: one of another recording that is carried out again, or of a file.
    pub fn restore(&mut self, entry: Entry) {
        self.reached = self.reached.max(entry.frame);
        match entry.deed {
            Deed::TakeOver => self.is_taken_over = true,
            Deed::Resume => self.is_taken_over = false,
            _ => {}
        }
        self.entries.push(entry);
    }

    pub(super) fn restore_hash(&mut self, frame: u64, hash: u64) {
        self.hashes.insert(frame, hash);
    }

    pub(super) fn restore_reached(&mut self, frame: u64, steps_done: bool) {
        self.reached = frame;
        self.steps_done_at = steps_done.then_some(frame);
    }

    /// What the session began with.
    pub fn beginning(&self) -> &Beginning {
        &self.beginning
    }

    /// All entries in their order.
    pub fn entries(&self) -> &[Entry] {
        &self.entries
    }

    /// Entries for a timeline, by their index: all but the poses that follow another one within a second, and hand-overs.
    pub fn marks(&self) -> impl Iterator<Item = (usize, &Entry)> {
        let mut last_pose: Option<u64> = None;
        self.entries.iter().enumerate().filter(move |(_, entry)| {
            if !entry.deed.is_pose() {
                return entry.deed != Deed::TakeOver;
            }
            let follows = last_pose.is_some_and(|last| entry.frame < last + FRAMES_PER_HASH / 10);
            last_pose = Some(entry.frame);
            !follows
        })
    }

    /// Hashes of the kitchen's state by frame.
    pub fn hashes(&self) -> &BTreeMap<u64, u64> {
        &self.hashes
    }

    /// Returns true while a person has taken over from the recipe.
    pub fn is_taken_over(&self) -> bool {
        self.is_taken_over
    }

    /// The present instant: all entries carried out.
    pub fn moment(&self) -> Moment {
        let steps_done = self.steps_done_at == Some(self.reached);
        Moment { frame: self.reached, entries: self.entries.len(), steps_done }
    }

    /// The beginning of a frame, before its entries and steps.
    pub fn moment_at(&self, frame: u64) -> Moment {
        let frame = frame.min(self.reached);
        Moment { frame, entries: self.entries.partition_point(|entry| entry.frame < frame), steps_done: false }
    }

    /// The instant before an entry, for an undo; a hand-over that belongs to it is undone with it.
    pub fn before(&self, entry: usize) -> Option<Moment> {
        let here = self.entries.get(entry)?;
        let before = entry.checked_sub(1).filter(|at| self.entries[*at].deed == Deed::TakeOver);
        Some(Moment { frame: here.frame, entries: before.unwrap_or(entry), steps_done: here.after_steps })
    }

    /// Undoes everything after a moment.
    pub fn truncate(&mut self, moment: Moment) {
        self.entries.truncate(moment.entries);
        self.hashes.retain(|frame, _| *frame <= moment.frame);
        let hand_over = self.entries.iter().rev().find(|e| matches!(e.deed, Deed::TakeOver | Deed::Resume));
        self.is_taken_over = hand_over.is_some_and(|entry| entry.deed == Deed::TakeOver);
        self.restore_reached(moment.frame, moment.steps_done);
        if self.saved.has_begun {
            let kept = self.saved.cut.unwrap_or(self.saved.entries).min(moment.entries);
            self.saved.cut = Some(kept);
            self.saved.entries = self.saved.entries.min(moment.entries);
            self.saved.hashes_below = self.saved.hashes_below.min(moment.frame + 1);
        }
    }

    /// Returns it without hashes of states, for where room is scarce; it is in no file yet.
    pub fn without_hashes(&self) -> Self {
        Self { hashes: BTreeMap::new(), saved: Saved::default(), ..self.clone() }
    }

    /// Returns a branch that ends at a moment; it is in no file yet.
    pub fn fork(&self, moment: Moment) -> Self {
        let mut fork = Self { saved: Saved::default(), ..self.clone() };
        fork.truncate(moment);
        fork
    }
}
