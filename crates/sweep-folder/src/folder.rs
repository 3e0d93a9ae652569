//! The folder of a sweep: what is in it, what is missing, and its files.
//!
//! `rows/` has one Parquet file for each complete part; `unfinished/` has journals of the others, a lock, and files on their way to
//! their final names. `sweep.json` states which sweep it is, with copies of specification and recipe.

use std::collections::{BTreeMap, BTreeSet};
use std::fs::{self, File};
use std::io;
use std::path::{Path, PathBuf};
use std::sync::Arc;

use saute_files::Journal;
use saute_files::checksums::{self, Checksums};
use saute_files::whole_file::write_by_way_of;
use saute_files::{locked_file, regular_file};
use saute_formats::{Table, Value};
use saute_sweep::{Manifest, RowResult, Status, Sweep, manifest};

use crate::error::FolderError;
use crate::tally::Tally;

/// Folder of the Parquet files.
pub const ROWS: &str = "rows";
/// Larger manifests are not read [MiB] (chosen: a usual one has 2 kB).
pub const MANIFEST_MIB: u64 = 4;
/// Larger parts are not read [MiB] (chosen: the most rows of a part with a thousand numbers each).
pub const PART_MIB: u64 = 1024;
/// Folder of what is not complete.
const UNFINISHED: &str = "unfinished";
/// File that is locked while a program writes to the folder.
const LOCK: &str = "lock";
/// Ending of the names of journals.
const JOURNAL: &str = "rows";

/// A part that is not complete: its journal and the rows that are in it.
#[derive(Debug)]
struct OpenPart {
    journal: Journal,
    rows: BTreeSet<u64>,
}

/// The folder of a sweep, to which this program alone writes.
#[derive(Debug)]
pub struct SweepFolder {
    path: PathBuf,
    sweep: Arc<Sweep>,
    complete: BTreeSet<u64>,
    open: BTreeMap<u64, OpenPart>,
    /// Next row to hand out, unless it is there.
    next: u64,
    /// Rows that were handed out and came back without a result.
    returned: BTreeSet<u64>,
    tally: Tally,
    /// Held as long as this lives.
    _lock: File,
}

impl SweepFolder {
    /// Opens the folder of a sweep, or makes it; what an earlier program has left is gone on with.
    ///
    /// # Errors
    /// If another program writes there, it contains another sweep or other files, or cannot be written.
    pub fn open(path: &Path, sweep: Arc<Sweep>) -> Result<Self, FolderError> {
        let at = |e: io::Error| FolderError::io(path, &e);
        for folder in [ROWS, UNFINISHED] {
            fs::create_dir_all(path.join(folder)).map_err(at)?;
        }
        let lock = locked(&path.join(UNFINISHED).join(LOCK)).map_err(at)?;
        let tally = Tally { rows: sweep.manifest().rows, ..Tally::default() };
        let (complete, open, returned) = Default::default();
        let mut folder = Self { path: path.to_owned(), sweep, complete, open, next: 0, returned, tally, _lock: lock };
        folder.claim()?;
        folder.find_complete()?;
        folder.find_journals()?;
        folder.clear_if_complete()?;
        Ok(folder)
    }

    /// The sweep.
    pub fn sweep(&self) -> &Arc<Sweep> {
        &self.sweep
    }

    /// How far it is.
    pub fn tally(&self) -> Tally {
        self.tally
    }

    /// Returns a row to cook; none if all were handed out. Rows come in their order, those that were returned first.
    pub fn next_row(&mut self) -> Option<u64> {
        if let Some(row) = self.returned.pop_first() {
            return Some(row);
        }
        let m = self.sweep.manifest();
        while self.next < m.rows {
            let (row, part) = (self.next, self.next / m.rows_per_part);
            if self.complete.contains(&part) {
                self.next = m.part_rows(part).end;
                continue;
            }
            self.next += 1;
            if !self.open.get(&part).is_some_and(|open| open.rows.contains(&row)) {
                return Some(row);
            }
        }
        None
    }

    /// Takes back a row that was handed out and has no result; it will be handed out again.
    pub fn give_back(&mut self, row: u64) {
        if row < self.tally.rows && !self.has(row) {
            self.returned.insert(row);
        }
    }

    /// Takes the result of a row; one that is there already is not taken twice.
    ///
    /// # Errors
    /// If it cannot be written.
    pub fn take(&mut self, result: &RowResult) -> Result<(), FolderError> {
        if self.has(result.row) || result.row >= self.tally.rows {
            return Ok(());
        }
        let part = result.row / self.sweep.manifest().rows_per_part;
        if !self.open.contains_key(&part) {
            self.open_part(part)?;
        }
        let Some(open) = self.open.get_mut(&part) else { return Ok(()) };
        open.journal.add(&result.to_bytes()).map_err(|e| FolderError::io(&self.path, &e))?;
        open.rows.insert(result.row);
        self.returned.remove(&result.row);
        self.tally.done += 1;
        self.tally.fresh += 1;
        self.tally.failed += u64::from(result.status == Status::Failed);
        self.complete_part(part)?;
        self.clear_if_complete()
    }

    fn has(&self, row: u64) -> bool {
        let part = row / self.sweep.manifest().rows_per_part;
        self.complete.contains(&part) || self.open.get(&part).is_some_and(|open| open.rows.contains(&row))
    }

    /// Opens the journal of a part; rows in it are done.
    fn open_part(&mut self, part: u64) -> Result<(), FolderError> {
        let path = self.path.join(UNFINISHED).join(Manifest::part_name(part)).with_extension(JOURNAL);
        let (journal, found) = journal(&path).map_err(|e| FolderError::io(&path, &e))?;
        let own = self.sweep.part_rows(part);
        let known = found.values().filter(|result| own.contains(&result.row));
        self.tally.done += known.clone().count() as u64;
        self.tally.failed += known.clone().filter(|result| result.status == Status::Failed).count() as u64;
        self.open.insert(part, OpenPart { journal, rows: known.map(|result| result.row).collect() });
        Ok(())
    }

    /// Makes the Parquet file of a part whose rows are all there.
    fn complete_part(&mut self, part: u64) -> Result<(), FolderError> {
        let own = self.sweep.part_rows(part);
        let count = own.end - own.start;
        let Some(open) = self.open.get(&part).filter(|open| open.rows.len() as u64 == count) else { return Ok(()) };
        let path = open.journal.path().to_owned();
        // The rows were not kept in memory.
        let (_, found) = journal(&path).map_err(|e| FolderError::io(&path, &e))?;
        let results: Vec<RowResult> = found.into_values().filter(|result| own.contains(&result.row)).collect();
        if results.len() as u64 != count {
            return Err(FolderError::new(&path, "was changed by another program", "start it again: it goes on"));
        }
        let file = self.sweep.part_file(&results);
        let bytes =
            file.map_err(|e| FolderError::new(&path, e.to_string(), "report this as a mistake of the program"))?;
        let name = Manifest::part_name(part);
        // First the checksum: a file without one is not compared, one with that of other bytes is cooked again.
        let mut checksums = Checksums::in_folder(&self.path.join(ROWS));
        checksums.note(&name, &bytes);
        self.write(&Path::new(ROWS).join(checksums::FILE), checksums.text().as_bytes())?;
        self.write(&Path::new(ROWS).join(name), &bytes)?;
        fs::remove_file(&path).map_err(|e| FolderError::io(&path, &e))?;
        self.open.remove(&part);
        self.complete.insert(part);
        Ok(())
    }

    /// Writes a file completely or not at all.
    fn write(&self, name: &Path, bytes: &[u8]) -> Result<(), FolderError> {
        let (path, file_name) = (self.path.join(name), name.file_name().unwrap_or_default());
        let on_its_way = self.path.join(UNFINISHED).join(file_name);
        write_by_way_of(&on_its_way, &path, bytes).map_err(|e| FolderError::io(&path, &e))
    }

    /// Makes sure that the folder contains this sweep, or nothing.
    fn claim(&self) -> Result<(), FolderError> {
        let (place, own) = (self.path.join(manifest::FILE), self.sweep.manifest());
        let another = "name another folder, or remove this one";
        match regular_file::read_text(&place, MANIFEST_MIB) {
            Ok(text) => {
                let found = Manifest::parse(&text).map_err(|message| FolderError::new(&place, message, another))?;
                own.conflict(&found).map_or(Ok(()), |why| Err(FolderError::new(&self.path, why, another)))
            }
            Err(unread) if unread.is_missing() => {
                let is_empty = fs::read_dir(self.path.join(ROWS)).is_ok_and(|mut entries| entries.next().is_none());
                if !is_empty {
                    return Err(FolderError::new(&self.path.join(ROWS), "holds files of something else", another));
                }
                self.write(Path::new("spec.toml"), self.sweep.text().as_bytes())?;
                self.write(Path::new("recipe.toml"), self.sweep.recipe_text().as_bytes())?;
                self.write(Path::new(manifest::FILE), own.text().as_bytes())
            }
            Err(unread) => Err(FolderError::new(&place, unread.to_string(), another)),
        }
    }

    /// Finds the complete parts, and reads what their rows are.
    fn find_complete(&mut self) -> Result<(), FolderError> {
        let folder = self.path.join(ROWS);
        for name in names(&folder)? {
            let Some(part) = Manifest::part_of(&name).filter(|part| *part < self.sweep.manifest().parts()) else {
                continue;
            };
            let failed = self.read_part(&folder.join(&name), part)?;
            let own = self.sweep.part_rows(part);
            self.tally.done += own.end - own.start;
            self.tally.failed += failed;
            self.complete.insert(part);
        }
        Ok(())
    }

    /// Reads the rows of a complete part; returns how many of them could not be cooked.
    fn read_part(&self, path: &Path, part: u64) -> Result<u64, FolderError> {
        let damaged = |message: String| FolderError::new(path, message, "remove this file: its rows are cooked again");
        let bytes = regular_file::read(path, PART_MIB).map_err(|unread| damaged(unread.to_string()))?;
        if !Checksums::in_folder(&self.path.join(ROWS)).holds(&Manifest::part_name(part), &bytes) {
            return Err(damaged("has not the checksum with which it was written".to_owned()));
        }
        let table = Table::from_parquet(bytes, |name| name == "row" || name == "status");
        let table = table.map_err(|e| damaged(e.to_string()))?;
        let rows = table.column("row").map(|at| table.rows.iter().map(move |row| row[at].clone()));
        let own = self.sweep.part_rows(part).map(|row| Some(Value::Integer(row as i64)));
        let failed = Some(Value::Text(Status::Failed.name().to_owned()));
        let is_whole = rows.is_some_and(|rows| rows.eq(own));
        match table.column("status").filter(|_| is_whole) {
            Some(status) => Ok(table.rows.iter().filter(|row| row[status] == failed).count() as u64),
            None => Err(damaged("has not the rows of its part".to_owned())),
        }
    }

    /// Finds the journals, and what a dead program has left on its way.
    fn find_journals(&mut self) -> Result<(), FolderError> {
        let folder = self.path.join(UNFINISHED);
        for name in names(&folder)?.into_iter().filter(|name| name != LOCK) {
            let path = folder.join(&name);
            let journal = path.extension().is_some_and(|ending| ending == JOURNAL);
            let part =
                Manifest::part_of(&path.with_extension("parquet").file_name().unwrap_or_default().to_string_lossy());
            match part.filter(|part| journal && *part < self.sweep.manifest().parts()) {
                Some(part) if !self.complete.contains(&part) => {
                    self.open_part(part)?;
                    self.complete_part(part)?;
                }
                _ => fs::remove_file(&path).map_err(|e| FolderError::io(&path, &e))?,
            }
        }
        Ok(())
    }

    fn clear_if_complete(&self) -> Result<(), FolderError> {
        if !self.tally.is_complete() {
            return Ok(());
        }
        let place = self.path.join(UNFINISHED);
        fs::remove_dir_all(&place).or_else(|e| match e.kind() {
            io::ErrorKind::NotFound => Ok(()),
            _ => Err(FolderError::io(&place, &e)),
        })
    }
}

/// Returns the names in a folder, sorted.
fn names(folder: &Path) -> Result<BTreeSet<String>, FolderError> {
    let entries = fs::read_dir(folder).map_err(|e| FolderError::io(folder, &e))?;
    let name = |entry: io::Result<fs::DirEntry>| entry.map(|e| e.file_name().to_string_lossy().into_owned());
    entries.map(name).collect::<io::Result<_>>().map_err(|e| FolderError::io(folder, &e))
}

/// Locks a file for this program alone. The system releases the lock of a dead one.
fn locked(path: &Path) -> io::Result<File> {
    regular_file::check_place(path)?;
    let file = File::options().write(true).create(true).truncate(false).open(path)?;
    locked_file::lock(&file)?;
    Ok(file)
}

/// Opens the journal of a part; returns it with the results that are in it, by their rows.
fn journal(path: &Path) -> io::Result<(Journal, BTreeMap<u64, RowResult>)> {
    let mut results = BTreeMap::new();
    let journal = Journal::open(path, |own| {
        let result = RowResult::from_bytes(own);
        result.is_some_and(|result| {
            results.entry(result.row).or_insert(result);
            true
        })
    })?;
    Ok((journal, results))
}
