//! A session file that grows while the session runs: what happened is appended, and brought to the disk every half second.

use std::fs::{File, OpenOptions};
use std::io::{self, Seek, SeekFrom, Write};
use std::path::Path;

use saute_recipe::Recording;
use web_time::{Duration, Instant};

/// Longest wall time that is not on the disk yet (chosen: killing the program loses at most a second, with room for a slow disk).
const SYNC_AFTER: Duration = Duration::from_millis(400);

/// An open session file.
#[derive(Debug)]
pub struct SessionFile {
    file: File,
    synced: Instant,
}

impl SessionFile {
    /// Begins a file with what a recording contains; what was at the path is replaced.
    pub fn create(path: &Path, recording: &mut Recording) -> io::Result<Self> {
        let mut file = Self { file: File::create(path)?, synced: Instant::now() };
        file.bring_up_to_date(recording)?;
        Ok(file)
    }

    /// Goes on with a file that was read, after the valid bytes.
    pub fn resume(path: &Path, sound_bytes: u64) -> io::Result<Self> {
        let mut file = OpenOptions::new().write(true).open(path)?;
        file.set_len(sound_bytes)?;
        file.seek(SeekFrom::End(0))?;
        Ok(Self { file, synced: Instant::now() })
    }

    /// Appends what happened if some time has passed since the last call that did. Call it at least a few times a second.
    pub fn follow(&mut self, recording: &mut Recording) -> io::Result<()> {
        if self.synced.elapsed() < SYNC_AFTER {
            return Ok(());
        }
        self.bring_up_to_date(recording)
    }

    /// Appends all that happened, and waits until it is on the disk.
    pub fn bring_up_to_date(&mut self, recording: &mut Recording) -> io::Result<()> {
        let bytes = recording.unsaved();
        if !bytes.is_empty() {
            self.file.write_all(&bytes)?;
            self.file.sync_data()?;
        }
        self.synced = Instant::now();
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use saute_kitchen::{Command, Library};
    use saute_recipe::{Recipe, Replay};

    use super::*;

    #[test]
    fn a_damaged_file_is_gone_on_with_after_what_holds() {
        let library = Library::embedded().expect("embedded data");
        let recipe = Recipe::parse(&library.recipes["rare"], "rare", &library).expect("parses");
        let mut recording = Recording::begin(&recipe, true, &library);
        let live = Replay::begin(&recording, &library).expect("begins");
        let path = std::env::temp_dir().join(format!("saute-session-{}.saute", std::process::id()));
        let mut file = SessionFile::create(&path, &mut recording).expect("creates");
        recording.push(&live.kitchen, Command::Hob(500.0));
        file.bring_up_to_date(&mut recording).expect("writes");
        drop(file);
        let mut bytes = std::fs::read(&path).expect("reads");
        let whole = bytes.len();
        bytes.extend_from_slice(b"half a record");
        std::fs::write(&path, &bytes).expect("writes");
        let opened = Recording::from_file(&bytes).expect("opens");
        let damage = opened.damage.expect("is damaged");
        assert_eq!((damage.sound, damage.lost), (whole, 13));
        let mut going_on = opened.recording;
        let mut file = SessionFile::resume(&path, damage.sound as u64).expect("opens");
        going_on.push(&live.kitchen, Command::Hob(0.0));
        file.bring_up_to_date(&mut going_on).expect("writes");
        let opened = Recording::from_file(&std::fs::read(&path).expect("reads")).expect("opens");
        std::fs::remove_file(&path).expect("removes");
        assert_eq!((opened.damage, opened.recording.entries()), (None, going_on.entries()));
    }
}
