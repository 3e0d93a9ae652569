//! A participant's log on the disk: rows are appended, and on the disk before the next trial begins.

use std::fs::{self, File, OpenOptions};
use std::io::{self, Read, Seek, SeekFrom, Write};
use std::path::{Path, PathBuf};
use std::sync::Arc;

use saute_files::{locked_file, regular_file, write_whole};
use saute_study::{LogRow, Participant, Protocol, dictionary, from_csv, to_csv, with_all_columns};

use saute_session::guided::StudyStart;
use saute_session::guided::log_keeper::LogKeeper;

/// An open log.
#[derive(Debug)]
pub struct LogFile {
    file: File,
    /// The folder.
    folder: PathBuf,
    is_empty: bool,
}

impl LogFile {
    /// Opens the log of a participant in a folder, with the rows that it contains, and writes the data dictionary next to it. A last line that
    /// was cut off is removed.
    pub fn open(folder: &Path, participant: &Participant) -> Result<(Self, Vec<LogRow>), String> {
        let path = folder.join(format!("study-{participant}.csv"));
        let place = |e: io::Error| format!("{}: {e}", path.display());
        fs::create_dir_all(folder).and_then(|()| regular_file::check_place(&path)).map_err(place)?;
        let mut file =
            OpenOptions::new().read(true).write(true).create(true).truncate(false).open(&path).map_err(place)?;
        // Where a folder has no locks, a study still goes on.
        locked_file::lock(&file)
            .or_else(|e| if e.kind() == io::ErrorKind::ResourceBusy { Err(place(e)) } else { Ok(()) })?;
        let mut text = String::new();
        file.read_to_string(&mut text).map_err(place)?;
        let whole = text.rfind('\n').map_or(0, |end| end + 1);
        file.set_len(whole as u64).and_then(|()| file.seek(SeekFrom::End(0))).map_err(place)?;
        let rows = from_csv(&path.display().to_string(), &text[..whole]).map_err(|error| error.to_string())?;
        if let Some(today) = with_all_columns(&text[..whole], &rows) {
            // Whatever happens meanwhile, one of the two is whole.
            let before = folder.join(format!("study-{participant}-before.csv"));
            write_whole(&before, &text.as_bytes()[..whole]).map_err(place)?;
            rewrite(&mut file, &today).map_err(place)?;
        }
        for (name, text) in [("data-dictionary.csv", dictionary::csv()), ("data-dictionary.md", dictionary::page())] {
            write_whole(&folder.join(name), text.as_bytes()).map_err(place)?;
        }
        Ok((Self { file, folder: folder.to_owned(), is_empty: whole == 0 }, rows))
    }

    /// Appends rows, and waits until they are on the disk. What was written in part is removed again.
    fn write(&mut self, rows: &[LogRow]) -> io::Result<()> {
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

impl LogKeeper for LogFile {
    fn append(&mut self, rows: &[LogRow]) -> Result<(), String> {
        self.write(rows).map_err(|error| error.to_string())
    }

    fn is_file(&self) -> bool {
        true
    }

    fn keep_session(&mut self, name: &str, bytes: &[u8]) -> Option<Result<(), String>> {
        Some(write_whole(&self.folder.join(name), bytes).map_err(|error| error.to_string()))
    }
}

/// A study whose log is a file in a folder; an existing one is continued.
///
/// # Errors
///
/// If the folder cannot be written to, or the log is of another participant or protocol.
pub fn study_in_folder(protocol: Arc<Protocol>, participant: Participant, folder: &Path) -> Result<StudyStart, String> {
    let (file, earlier) = LogFile::open(folder, &participant)?;
    StudyStart::resumed(protocol, participant, (Box::new(file), earlier))
}

/// Writes a text in place of what a file contains, and waits until it is on the disk; the file's end is where it goes on.
fn rewrite(file: &mut File, text: &str) -> io::Result<()> {
    file.set_len(0)?;
    file.seek(SeekFrom::Start(0))?;
    file.write_all(text.as_bytes())?;
    file.sync_data()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A log of before the column `mark`.
    const BEFORE: &str = "study,protocol,participant,simulated,condition,phase,kind,elapsed_s,started,trial,information,goal,score,\
        is_met,target_share_pct,beyond_pct,grey_band_mm,core_peak_c,crust_pct,charred_pct,lost_pct,energy_kj,flips,put_s,out_s,end_s,\
        trial_wall_s,session,item,value,text\n\
        2013,8f2be7b4,S07,false,B,0,consent,60.0,,,,,,,,,,,,,,,,,,,,,,,\n";

    #[test]
    fn a_log_of_before_goes_on_with_the_columns_of_today_and_is_kept_as_it_was() {
        let folder = std::env::temp_dir().join(format!("saute-log-{}", std::process::id()));
        fs::create_dir_all(&folder).expect("a folder");
        let path = folder.join("study-S07.csv");
        fs::write(&path, BEFORE).expect("writes");
        let code = "S07".parse().expect("a code");
        let (mut log, rows) = LogFile::open(&folder, &code).expect("opens");
        log.write(&rows).expect("appends");
        drop(log);
        let text = fs::read_to_string(&path).expect("reads");
        assert_eq!(from_csv("log.csv", &text).expect("is a log").len(), 2);
        assert_eq!(fs::read_to_string(folder.join("study-S07-before.csv")).expect("is kept"), BEFORE);
        fs::remove_dir_all(&folder).expect("is removed");
    }
}
