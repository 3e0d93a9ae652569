//! A participant's log on the disk: rows are appended, and on the disk before the next trial begins.

use std::fs::{self, File, OpenOptions};
use std::io::{self, Read, Seek, SeekFrom, Write};
use std::path::{Path, PathBuf};

use saute_study::{LogRow, Participant, dictionary, from_csv, to_csv};

/// An open log.
#[derive(Debug)]
pub(crate) struct LogFile {
    file: File,
    /// The folder.
    pub(super) folder: PathBuf,
    is_empty: bool,
}

impl LogFile {
    /// Opens the log of a participant in a folder, with the rows that it holds, and writes the data dictionary beside it. A last line that
    /// was cut off is removed.
    pub(crate) fn open(folder: &Path, participant: &Participant) -> Result<(Self, Vec<LogRow>), String> {
        let path = folder.join(format!("study-{participant}.csv"));
        let place = |e: io::Error| format!("{}: {e}", path.display());
        fs::create_dir_all(folder).map_err(place)?;
        let mut file =
            OpenOptions::new().read(true).write(true).create(true).truncate(false).open(&path).map_err(place)?;
        if matches!(file.try_lock(), Err(fs::TryLockError::WouldBlock)) {
            return Err(format!("{}: another program is writing there", path.display()));
        }
        let mut text = String::new();
        file.read_to_string(&mut text).map_err(place)?;
        let whole = text.rfind('\n').map_or(0, |end| end + 1);
        file.set_len(whole as u64).and_then(|()| file.seek(SeekFrom::End(0))).map_err(place)?;
        let rows = from_csv(&path.display().to_string(), &text[..whole]).map_err(|error| error.to_string())?;
        for (name, text) in [("data-dictionary.csv", dictionary::csv()), ("data-dictionary.md", dictionary::page())] {
            crate::kept::session_file::write_whole(&folder.join(name), text.as_bytes()).map_err(place)?;
        }
        Ok((Self { file, folder: folder.to_owned(), is_empty: whole == 0 }, rows))
    }

    /// Appends rows, and waits until they are on the disk. What was written in part is removed again.
    pub(crate) fn append(&mut self, rows: &[LogRow]) -> io::Result<()> {
        let before = self.file.stream_position()?;
        let text = to_csv(rows, self.is_empty);
        let written = self.file.write_all(text.as_bytes()).and_then(|()| self.file.sync_data());
        if written.is_err() {
            self.file.set_len(before)?;
            self.file.seek(SeekFrom::Start(before))?;
        }
        self.is_empty &= written.is_err();
        written
    }
}
