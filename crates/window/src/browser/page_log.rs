//! A participant's log in the browser's storage: rows are kept there before the next trial begins.

use std::sync::Arc;

use saute_study::{LogRow, Participant, Protocol, from_csv, to_csv, with_all_columns};

use super::host::Host;
use saute_session::guided::StudyStart;
use saute_session::guided::log_keeper::LogKeeper;

/// The log that the page's script keeps.
#[derive(Debug)]
pub(crate) struct PageLog {
    host: Host,
    text: String,
}

impl PageLog {
    /// Opens the log, with the rows that it contains; none where the browser gives the page no storage.
    ///
    /// # Errors
    ///
    /// If what is there is no log.
    pub fn open(host: &Host) -> Result<Option<(Self, Vec<LogRow>)>, String> {
        let Some(text) = host.kept_rows() else { return Ok(None) };
        let rows = from_csv("the browser's storage", &text).map_err(|error| error.to_string())?;
        let text = with_all_columns(&text, &rows).unwrap_or(text);
        Ok(Some((Self { host: host.clone(), text }, rows)))
    }
}

impl LogKeeper for PageLog {
    fn append(&mut self, rows: &[LogRow]) -> Result<(), String> {
        let text = format!("{}{}", self.text, to_csv(rows, self.text.is_empty()));
        if let Some(error) = self.host.keep_rows(&text) {
            return Err(error);
        }
        self.text = text;
        Ok(())
    }
}

/// A study whose log is in the browser's storage, in memory where there is none; an existing log is continued.
///
/// # Errors
///
/// If what is there is no log, or one of another participant or protocol.
pub fn study_in_page(protocol: Arc<Protocol>, participant: Participant, host: &Host) -> Result<StudyStart, String> {
    let Some((log, earlier)) = PageLog::open(host)? else {
        return Ok(StudyStart::in_memory(protocol, participant));
    };
    StudyStart::resumed(protocol, participant, (Box::new(log), earlier))
}
