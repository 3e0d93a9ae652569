//! Session files (`.saute`): a first line of text, then records that are appended one after another, each with its length and a checksum.
//!
//! A program that is killed leaves at most a part of a last record. Reading stops at the first invalid record, with a message;
//! what is before it opens. Undone entries stay in the file until it is written again: a record states how many of them count.

use std::borrow::Cow;

use serde::{Deserialize, Serialize};

use crate::session::beginning::Beginning;
use crate::session::entry::Deed;
use crate::session::moment::Moment;
use crate::session::recording::{FRAMES_PER_HASH, Recording, Saved};
use crate::session::stored_entries::{Counts, StoredEntries, Unread, limits};

/// Ending of the names of session files.
pub const ENDING: &str = "saute";
/// First line of a session file; the number is the version of the format.
const FIRST_LINE: &[u8] = b"saute session 1\n";
/// First line up to the version.
const ANY_VERSION: &[u8] = b"saute session ";
/// Bytes before each record: its length and its checksum [-].
const RECORD_HEAD: usize = 8;
/// Largest file that is read [MiB] (chosen: above what the entries of the longest session take).
pub const LARGEST_MIB: u64 = 64;
/// Longest record [bytes] (chosen: the largest file may be one).
const LONGEST_RECORD: u32 = (LARGEST_MIB as u32) << 20;
/// Latest frame: that after a week (chosen: nobody cooks longer, and a replay ends).
const LATEST_FRAME: u64 = 7 * 24 * 3600 * 60;

/// One record.
#[derive(Deserialize, Serialize)]
enum Record<'a> {
    /// What the session began with; the first record, and only that.
    Begins(Cow<'a, Beginning>),
    /// Entries, the first one at a frame since the start, the others at frames since the one before.
    Entries(Vec<(u64, bool, Cow<'a, Deed>)>),
    /// The hash of the state at a frame.
    Hash(u64, u64),
    /// How far the session came: the frame, and whether the recipe's steps due at it were carried out.
    Reached(u64, bool),
    /// Only so many of the entries before count; the session went on from a frame.
    Undone(u64, u64),
    /// The kitchen at home, where it is not the program's own; it follows the beginning.
    Home(Cow<'a, str>),
}

/// Reason why a file is no session.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum SessionError {
    /// The file does not begin as a session.
    #[error("this is no session of saute; name a .saute file that `saute cook --record` or the window wrote")]
    NoSession,
    /// Another version of the format.
    #[error("the session has format {0}, this program reads format 1; use the program that wrote it")]
    Format(String),
    /// The first record does not hold.
    #[error("the session is damaged at its beginning: nothing of it can be read; name another file")]
    NoBeginning,
}

/// The end of a session file that was not read.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Damage {
    /// Number of bytes before it: the valid part [-].
    pub sound: usize,
    /// Number of bytes from there on [-].
    pub lost: usize,
    /// True if nothing is wrong with it, but the session goes beyond what this program reads.
    pub is_beyond: bool,
}

/// A session that was read.
#[derive(Clone, Debug, PartialEq)]
pub struct Opened {
    /// The recording.
    pub recording: Recording,
    /// The end of the file that was not read, if there is one.
    pub damage: Option<Damage>,
}

impl std::fmt::Display for Damage {
    fn fmt(&self, f: &mut std::fmt::Formatter) -> std::fmt::Result {
        let Self { sound, lost, is_beyond } = self;
        if *is_beyond {
            return write!(f, "its last {lost} bytes are left out: {}", limits());
        }
        write!(f, "its last {lost} bytes are damaged, as after a power cut; the {sound} before them hold")
    }
}

/// Returns true if bytes begin as a session file of any version.
pub fn is_session(bytes: &[u8]) -> bool {
    bytes.starts_with(ANY_VERSION)
}

impl Recording {
    /// Returns the whole session as a file.
    pub fn to_file(&self) -> Vec<u8> {
        self.fork(self.moment()).unsaved()
    }

    /// Returns what must be appended to the session's file to bring it up to date: nothing if it is. The first call returns the
    /// beginning too; the caller appends the bytes before it calls again. What a full session went on with is in no file
    /// ([`Self::is_full`]).
    pub fn unsaved(&mut self) -> Vec<u8> {
        let mut bytes = Vec::new();
        if !self.saved.has_begun {
            bytes.extend_from_slice(FIRST_LINE);
            write(&mut bytes, &Record::Begins(Cow::Borrowed(self.beginning())));
            if let Some(home) = &self.beginning().home {
                write(&mut bytes, &Record::Home(Cow::Borrowed(home)));
            }
        }
        let moment = self.storable();
        if let Some(kept) = self.saved.cut {
            write(&mut bytes, &Record::Undone(kept as u64, moment.frame));
        }
        let fresh = &self.entries()[self.saved.entries.min(moment.entries)..moment.entries];
        if !fresh.is_empty() {
            let mut before = 0;
            let stored = fresh.iter().map(|entry| {
                let since = entry.frame - core::mem::replace(&mut before, entry.frame);
                (since, entry.after_steps, Cow::Borrowed(&entry.deed))
            });
            write(&mut bytes, &Record::Entries(stored.collect()));
        }
        for (frame, hash) in self.hashes().range(self.saved.hashes_below..).filter(|(frame, _)| **frame <= moment.frame)
        {
            write(&mut bytes, &Record::Hash(*frame, *hash));
        }
        let reached = (moment.frame, moment.steps_done);
        if self.saved.reached != Some(reached) || self.saved.cut.is_some() {
            write(&mut bytes, &Record::Reached(reached.0, reached.1));
        }
        self.mark_saved(moment);
        bytes
    }

    fn mark_saved(&mut self, moment: Moment) {
        self.saved = Saved {
            entries: moment.entries,
            hashes_below: self.hashes().range(..=moment.frame).next_back().map_or(0, |(frame, _)| frame + 1),
            reached: Some((moment.frame, moment.steps_done)),
            cut: None,
            has_begun: true,
        };
    }

    /// Reads a session file. A damaged end is reported, and what is before it is returned.
    ///
    /// # Errors
    ///
    /// If the bytes are no session.
    pub fn from_file(bytes: &[u8]) -> Result<Opened, SessionError> {
        let Some(records) = bytes.strip_prefix(FIRST_LINE) else { return Err(refusal(bytes)) };
        let mut rest = records;
        let first = next_body(&mut rest).and_then(|body| postcard::take_from_bytes::<Record>(body).ok());
        let Some((Record::Begins(beginning), [])) = first else { return Err(SessionError::NoBeginning) };
        let mut recording = Self::with(beginning.into_owned());
        let (mut sound, mut is_beyond, mut counts) = (rest, false, Counts::default());
        while let Some(body) = next_body(&mut rest) {
            if let Err(unread) = recording.read_body(body, &mut counts) {
                is_beyond = unread == Unread::Beyond;
                break;
            }
            sound = rest;
        }
        recording.mark_saved(recording.moment());
        let (lost, sound) = (sound.len(), bytes.len() - sound.len());
        Ok(Opened { recording, damage: (lost > 0).then_some(Damage { sound, lost, is_beyond }) })
    }

    /// Adds the content of the body of a record.
    fn read_body(&mut self, body: &[u8], counts: &mut Counts) -> Result<(), Unread> {
        if let Some(stored) = StoredEntries::of(body) {
            return self.read_entries(stored, counts);
        }
        let (record, left) = postcard::take_from_bytes::<Record>(body).map_err(|_| Unread::Damaged)?;
        if !left.is_empty() {
            return Err(Unread::Damaged);
        }
        let is_undone = matches!(record, Record::Undone(..));
        self.read(record).ok_or(Unread::Damaged)?;
        if is_undone && !counts.again(self.entries()) { Err(Unread::Beyond) } else { Ok(()) }
    }

    /// Adds the content of a record; `None` if it does not follow from those before.
    fn read(&mut self, record: Record) -> Option<()> {
        match record {
            // Only the first record begins; entries are read one by one.
            Record::Begins(_) | Record::Entries(_) => return None,
            Record::Home(home) => self.restore_home(home.into_owned())?,
            Record::Hash(frame, hash) => self.restore_hash(sound(frame).filter(is_hashed)?, hash),
            Record::Reached(frame, steps_done) => {
                let last = self.entries().last().map_or(0, |entry| entry.frame);
                self.restore_reached(Some(sound(frame)?).filter(|frame| *frame >= last)?, steps_done);
            }
            Record::Undone(kept, frame) => {
                let kept = usize::try_from(kept).ok().filter(|kept| *kept <= self.entries().len())?;
                let moment = Moment { frame: sound(frame)?, entries: kept, steps_done: false };
                self.truncate(moment);
            }
        }
        Some(())
    }
}

/// Returns true for a frame at which a recording keeps a hash.
fn is_hashed(frame: &u64) -> bool {
    frame.is_multiple_of(FRAMES_PER_HASH)
}

/// Returns a frame that a session may reach.
pub(super) fn sound(frame: u64) -> Option<u64> {
    (frame < LATEST_FRAME).then_some(frame)
}

fn refusal(bytes: &[u8]) -> SessionError {
    let version = bytes.strip_prefix(ANY_VERSION).and_then(|rest| rest.split(|b| *b == b'\n').next());
    version.map_or(SessionError::NoSession, |version| {
        let version = String::from_utf8_lossy(&version[..version.len().min(8)]);
        SessionError::Format(version.chars().filter(|c| c.is_ascii_graphic()).collect())
    })
}

/// Appends a record.
fn write(bytes: &mut Vec<u8>, record: &Record) {
    let body = postcard::to_allocvec(record).expect("a record has no kind that postcard lacks");
    bytes.extend_from_slice(&(body.len() as u32).to_le_bytes());
    bytes.extend_from_slice(&crc32fast::hash(&body).to_le_bytes());
    bytes.extend_from_slice(&body);
}

/// Takes the body of the next record whose checksum matches; `None` at the end and at damage.
fn next_body<'a>(rest: &mut &'a [u8]) -> Option<&'a [u8]> {
    let (head, after) = rest.split_at_checked(RECORD_HEAD)?;
    let length = u32::from_le_bytes(head[..4].try_into().ok()?);
    let checksum = u32::from_le_bytes(head[4..].try_into().ok()?);
    let length = usize::try_from(length).ok().filter(|_| length <= LONGEST_RECORD)?;
    let (body, after) = after.split_at_checked(length)?;
    if crc32fast::hash(body) != checksum {
        return None;
    }
    *rest = after;
    Some(body)
}

#[cfg(test)]
mod tests {
    use saute_kitchen::dynamics::Pose;
    use saute_kitchen::{Command, FRAME_S, Library};

    use super::*;
    use crate::recipe::Recipe;
    use crate::session::entry::Entry;

    /// Frames of twenty minutes.
    const TWENTY_MINUTES: u64 = 72_000;
    /// Frames from one append to the next: half a second.
    const APPENDED: u64 = 30;

    fn begun() -> Recording {
        let library = Library::embedded().expect("embedded data");
        let text = &library.recipes["steak-carrots-leeks"];
        Recording::begin(&Recipe::parse(text, "dish.toml", &library).expect("parses"), true, &library)
    }

    /// A session of twenty minutes as it is in its file; `deed` states what is done at each frame.
    fn file_of(deed: impl Fn(u64) -> Option<Command>) -> (Recording, Vec<u8>) {
        let (mut recording, mut file) = (begun(), Vec::new());
        for frame in 0..=TWENTY_MINUTES {
            if let Some(command) = deed(frame) {
                recording.restore(Entry { frame, after_steps: false, deed: Deed::Command(command) });
            }
            if frame.is_multiple_of(600) {
                recording.restore_hash(frame, frame.wrapping_mul(0x9e37_79b9_7f4a_7c15));
            }
            recording.restore_reached(frame, false);
            if frame.is_multiple_of(APPENDED) {
                file.extend(recording.unsaved());
            }
        }
        (recording, file)
    }

    fn pan_in_hand(frame: u64) -> Option<Command> {
        let t = frame as f64 * FRAME_S;
        let mut pose = Pose::at(0.05 * libm::sin(t), 0.02 * libm::cos(1.3 * t), 0.03);
        pose.rotation.x = 0.1 * libm::sin(0.7 * t);
        Some(Command::HoldPan { pose })
    }

    #[test]
    fn twenty_minutes_of_keys_take_less_than_100_kb_and_of_a_pan_in_the_hand_less_than_5_mb() {
        let key = |frame: u64| frame.is_multiple_of(60).then(|| Command::Flip { food: "leeks.11".into() });
        for (name, most, (recording, file)) in
            [("keys", 100_000, file_of(key)), ("a pan in the hand", 5_000_000, file_of(pan_in_hand))]
        {
            println!("{name}: {} bytes", file.len());
            assert!(file.len() < most, "{name}: {}", file.len());
            let opened = Recording::from_file(&file).expect("opens");
            assert_eq!((opened.damage, &opened.recording), (None, &recording));
        }
    }

    #[test]
    fn a_file_that_is_cut_anywhere_opens_up_to_its_last_whole_record() {
        let (mut recording, mut file) = (begun(), Vec::new());
        let mut frames = Vec::new();
        for frame in 0..20 {
            recording.restore(Entry { frame, after_steps: false, deed: Deed::Command(Command::Hob(frame as f64)) });
            recording.restore_reached(frame, false);
            file.extend(recording.unsaved());
            frames.push((file.len(), frame));
        }
        let mut damaged = 0;
        for cut in 0..file.len() {
            let Ok(opened) = Recording::from_file(&file[..cut]) else {
                assert!(cut < frames[0].0, "{cut}");
                continue;
            };
            // What was appended completely is there.
            let whole = frames.iter().rev().find(|(end, _)| *end <= cut).map_or(0, |(_, frame)| *frame);
            assert!(opened.recording.moment().frame >= whole, "{cut}");
            damaged += usize::from(opened.damage.is_some());
            if let Some(damage) = opened.damage {
                assert_eq!(damage.sound + damage.lost, cut);
                assert!(!damage.is_beyond, "{cut}");
            }
        }
        assert!(2 * damaged > file.len() - frames[0].0, "{damaged} of {}", file.len());
        for at in 0..file.len() {
            let mut changed = file.clone();
            changed[at] ^= 1 << (at % 8);
            match Recording::from_file(&changed) {
                Ok(opened) => assert!(opened.damage.is_some(), "{at}"),
                Err(error) => assert!(at < frames[0].0, "{at}: {error}"),
            }
        }
    }

    #[test]
    fn undone_entries_do_not_come_back() {
        let mut recording = begun();
        let hob = |frame| Entry { frame, after_steps: false, deed: Deed::Command(Command::Hob(frame as f64)) };
        (0..10).for_each(|frame| recording.restore(hob(frame)));
        let mut file = recording.unsaved();
        recording.truncate(recording.before(4).expect("an entry"));
        recording.restore(hob(6));
        file.extend(recording.unsaved());
        recording.truncate(recording.before(2).expect("an entry"));
        file.extend(recording.unsaved());
        recording.restore(hob(9));
        file.extend(recording.unsaved());
        assert!(recording.unsaved().is_empty());
        let read = Recording::from_file(&file).expect("opens").recording;
        assert_eq!(read, recording);
        let frames: Vec<u64> = read.entries().iter().map(|entry| entry.frame).collect();
        assert_eq!(frames, [0, 1, 9]);
    }

    #[test]
    fn what_is_no_session_is_refused_with_a_reason() {
        assert_eq!(Recording::from_file(b"title = \"Steak\""), Err(SessionError::NoSession));
        assert_eq!(Recording::from_file(b"saute session 2\nrest"), Err(SessionError::Format("2".into())));
        assert_eq!(Recording::from_file(b"saute session 1\nrest"), Err(SessionError::NoBeginning));
        assert!(is_session(b"saute session 2\n") && !is_session(b"saute"));
    }
}
