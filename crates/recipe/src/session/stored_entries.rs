//! The entries of a record of a session file, read one by one within the limits of a session.

use crate::session::entry::{Deed, Entry};
use crate::session::moment::Moment;
use crate::session::recording::Recording;
use crate::session::session_file::sound;

/// Largest number of entries [-] (chosen: more than two hours of a hand that leads the pan, with 60 poses a second; they take 60 MB).
pub const MOST_ENTRIES: usize = 500_000;
/// Largest number of entries that are no poses [-] (chosen: a key each second for half a day; each becomes a step of the replay).
pub const MOST_ACTS: usize = 50_000;
/// Largest number of foods that are added [-] (chosen: five full pans; each needs a mesh).
pub const MOST_ADDED: usize = 500;

/// Entries that are looked at again where some were undone, in all [-] (chosen: a thousand undos of a session of a hundred thousand
/// entries; less than a second).
const MOST_LOOKED_AT: usize = 100_000_000;

/// Number of the record of entries.
const ENTRIES: u32 = 1;

/// Returns what a session has at most, in words.
pub fn limits() -> String {
    format!("a session has at most {MOST_ENTRIES} entries, {MOST_ACTS} of them no poses, and {MOST_ADDED} added foods")
}

impl Recording {
    /// Returns true if more happened than a file of a session may contain: it ends before the first entry that is too much.
    pub fn is_full(&self) -> bool {
        self.first_beyond().is_some()
    }

    /// Returns the last instant in a file: the present one, unless the session is full.
    pub(super) fn storable(&self) -> Moment {
        let Some(entries) = self.first_beyond() else { return self.moment() };
        let Entry { frame, after_steps, .. } = self.entries()[entries];
        Moment { frame, entries, steps_done: after_steps }
    }

    /// Returns the first entry that is too much.
    fn first_beyond(&self) -> Option<usize> {
        // None of the limits is lower.
        if self.entries().len() <= MOST_ADDED {
            return None;
        }
        let mut counts = Counts::default();
        self.entries().iter().position(|entry| !counts.add(&entry.deed))
    }

    /// Adds entries; none of them if one does not hold.
    pub(super) fn read_entries(&mut self, mut stored: StoredEntries, counts: &mut Counts) -> Result<(), Unread> {
        let before = self.moment();
        let mut last = self.entries().last().map_or((0, false), |entry| (entry.frame, entry.after_steps));
        let mut frame = 0_u64;
        let read = loop {
            let entry = match stored.next_entry(frame) {
                Ok(Some(entry)) => entry,
                Ok(None) => break Ok(()),
                Err(unread) => break Err(unread),
            };
            if (entry.frame, entry.after_steps) < last {
                break Err(Unread::Damaged);
            }
            if !counts.add(&entry.deed) {
                break Err(Unread::Beyond);
            }
            (frame, last) = (entry.frame, (entry.frame, entry.after_steps));
            self.restore(entry);
        };
        if read == Err(Unread::Damaged) {
            self.truncate(before);
        }
        read
    }
}

/// Why a record is not read.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Unread {
    /// It does not hold, or does not follow from those before.
    Damaged,
    /// It goes beyond what a session may have.
    Beyond,
}

/// Numbers of entries, of those that are no poses, and of foods that are added.
#[derive(Default)]
pub(super) struct Counts {
    entries: usize,
    acts: usize,
    added: usize,
    /// Entries that were looked at again because some were undone.
    looked_at: usize,
}

impl Counts {
    /// Counts the entries that stay where some were undone; returns false if that happens too often.
    pub(super) fn again(&mut self, entries: &[Entry]) -> bool {
        let looked_at = self.looked_at + entries.len();
        *self = Self { looked_at, ..Self::default() };
        entries.iter().all(|entry| self.add(&entry.deed)) && looked_at <= MOST_LOOKED_AT
    }

    /// Counts an entry; returns false if there are too many with it.
    fn add(&mut self, deed: &Deed) -> bool {
        self.entries += 1;
        self.acts += usize::from(!deed.is_pose());
        self.added += usize::from(matches!(deed, Deed::Add(_)));
        self.entries <= MOST_ENTRIES && self.acts <= MOST_ACTS && self.added <= MOST_ADDED
    }
}

/// The entries of a record, which are read one by one: together they take forty times their bytes.
pub(super) struct StoredEntries<'a> {
    left: u64,
    rest: &'a [u8],
}

impl<'a> StoredEntries<'a> {
    /// Returns the entries of a record's body; none of another record.
    pub(super) fn of(body: &'a [u8]) -> Option<Self> {
        let (kind, rest) = postcard::take_from_bytes::<u32>(body).ok()?;
        let (left, rest) = postcard::take_from_bytes::<u64>(rest).ok().filter(|_| kind == ENTRIES)?;
        Some(Self { left, rest })
    }

    /// Returns the next entry, which follows one at a frame.
    fn next_entry(&mut self, frame: u64) -> Result<Option<Entry>, Unread> {
        if self.left == 0 {
            return if self.rest.is_empty() { Ok(None) } else { Err(Unread::Damaged) };
        }
        let ((since, after_steps, deed), rest) =
            postcard::take_from_bytes::<(u64, bool, Deed)>(self.rest).map_err(|_| Unread::Damaged)?;
        (self.left, self.rest) = (self.left - 1, rest);
        let frame = frame.checked_add(since).and_then(sound).ok_or(Unread::Damaged)?;
        Ok(Some(Entry { frame, after_steps, deed }))
    }
}

#[cfg(test)]
mod tests {
    use saute_kitchen::dynamics::Pose;
    use saute_kitchen::{Command, Library};

    use super::*;
    use crate::recipe::Recipe;

    fn begun() -> Recording {
        let library = Library::embedded().expect("embedded data");
        let recipe = Recipe::parse(&library.recipes["medium"], "medium", &library).expect("parses");
        Recording::begin(&recipe, true, &library)
    }

    fn entries_of(count: usize, deed: &Deed) -> impl Iterator<Item = Entry> {
        std::iter::repeat_n(Entry { frame: 7, after_steps: false, deed: deed.clone() }, count)
    }

    fn file_of(count: usize, deed: &Deed) -> Vec<u8> {
        let mut recording = begun();
        entries_of(count, deed).for_each(|entry| recording.restore(entry));
        recording.to_file()
    }

    /// A file with more entries than this program writes: what another one has after its beginning is appended.
    fn longer_file_of([count, more]: [usize; 2], deed: &Deed) -> Vec<u8> {
        let mut other = begun();
        drop(other.unsaved());
        entries_of(more, deed).for_each(|entry| other.restore(entry));
        [file_of(count, deed), other.unsaved()].concat()
    }

    #[test]
    fn a_full_session_ends_in_its_file_and_loses_nothing_before() {
        let hob = || Entry { frame: 7, after_steps: false, deed: Deed::Command(Command::Hob(0.0)) };
        let mut recording = begun();
        let mut file = recording.unsaved();
        (0..MOST_ACTS).for_each(|_| recording.restore(hob()));
        file.extend(recording.unsaved());
        assert!(!recording.is_full());
        recording.restore(Entry { frame: 9, ..hob() });
        file.extend(recording.unsaved());
        assert!(recording.is_full());
        recording.restore(Entry { frame: 11, ..hob() });
        assert!(recording.unsaved().is_empty(), "nothing more is written");
        let opened = Recording::from_file(&file).expect("opens");
        assert_eq!(opened.damage, None);
        assert_eq!(opened.recording.entries(), &recording.entries()[..MOST_ACTS]);
        assert_eq!(opened.recording.moment().frame, 9, "up to the first entry that is too much");
        assert_eq!(Recording::from_file(&recording.to_file()).map(|opened| opened.damage), Ok(None));
        // What is undone gives room.
        recording.truncate(recording.before(MOST_ACTS - 1).expect("an entry"));
        recording.restore(Entry { frame: 8, ..hob() });
        file.extend(recording.unsaved());
        let opened = Recording::from_file(&file).expect("opens");
        assert_eq!((opened.damage, opened.recording.entries()), (None, recording.entries()));
    }

    #[test]
    fn a_session_opens_up_to_its_limits_and_says_what_is_left_out() {
        let hob = Deed::Command(Command::Hob(0.0));
        let pose = Deed::Command(Command::HoldPan { pose: Pose::at(0.0, 0.0, 0.1) });
        for (most, deed) in [(MOST_ACTS, hob), (MOST_ENTRIES, pose)] {
            let whole = Recording::from_file(&file_of(most, &deed)).expect("opens");
            assert_eq!((whole.damage, whole.recording.entries().len()), (None, most));
            let opened = Recording::from_file(&longer_file_of([most, 100], &deed)).expect("opens");
            let damage = opened.damage.expect("it is too long");
            assert!(damage.is_beyond && opened.recording.entries().len() == most, "{damage:?}");
            assert!(damage.to_string().contains("are left out") && !damage.to_string().contains("damaged"), "{damage}");
        }
    }

    #[test]
    fn a_session_that_is_undone_again_and_again_ends_in_a_moment() {
        let pose = Deed::Command(Command::HoldPan { pose: Pose::at(0.0, 0.0, 0.1) });
        let count = MOST_LOOKED_AT / 1000;
        let mut file = file_of(count, &pose);
        let mut whole = Recording::from_file(&file).expect("opens").recording;
        for _ in 0..1200 {
            whole.truncate(whole.moment());
            file.extend(whole.unsaved());
        }
        let opened = Recording::from_file(&file).expect("opens");
        assert!(opened.damage.is_some_and(|damage| damage.is_beyond), "{:?}", opened.damage);
        assert_eq!(opened.recording.entries().len(), count);
    }

    #[test]
    fn an_entry_takes_little_memory() {
        // Half a million of them must not take more than a kitchen.
        assert!(size_of::<Entry>() <= 128, "{} bytes", size_of::<Entry>());
    }
}
