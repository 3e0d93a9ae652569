//! The rows of a sweep cooked on threads.

use std::num::NonZero;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::{Mutex, MutexGuard, PoisonError};
use std::thread;

use saute_sweep::{RowResult, Sweep};

use crate::error::FolderError;
use crate::folder::SweepFolder;
use crate::tally::Tally;

/// Returns the number of threads that this machine runs at once [-].
pub fn cores() -> usize {
    thread::available_parallelism().map_or(1, NonZero::get)
}

/// Cooks all rows that are missing on so many threads. `watch` is called with the progress after each row; as soon as `may_go_on` is false,
/// the rows that are being cooked are broken off. Returns how far it came. The files are the same for any number of threads.
///
/// # Errors
/// If a result cannot be written.
pub fn cook_all(
    folder: SweepFolder,
    jobs: usize,
    watch: &(dyn Fn(Tally) + Sync),
    may_go_on: &(dyn Fn() -> bool + Sync),
) -> Result<Tally, FolderError> {
    let sweep = std::sync::Arc::clone(folder.sweep());
    let folder = Mutex::new(folder);
    let failure = Mutex::new(None);
    let goes_on = || may_go_on() && held(&failure).is_none();
    let work = || {
        while goes_on() {
            let Some(row) = held(&folder).next_row() else { return };
            let Some(result) = guarded(&sweep, row, may_go_on) else { return };
            let (taken, tally) = {
                let mut folder = held(&folder);
                (folder.take(&result), folder.tally())
            };
            match taken {
                Ok(()) => watch(tally),
                Err(error) => *held(&failure) = Some(error),
            }
        }
    };
    thread::scope(|scope| (0..jobs.max(1)).for_each(|_| drop(scope.spawn(work))));
    let tally = held(&folder).tally();
    failure.into_inner().unwrap_or_else(PoisonError::into_inner).map_or(Ok(tally), Err)
}

/// Cooks a row; a fault of the program becomes the message of the row, and the others go on.
pub fn guarded(sweep: &Sweep, row: u64, may_go_on: &dyn Fn() -> bool) -> Option<RowResult> {
    let cooked = catch_unwind(AssertUnwindSafe(|| sweep.run_row_while(row, may_go_on)));
    cooked.unwrap_or_else(|_| Some(sweep.failed_row(row, "a fault of the program".to_owned())))
}

/// A thread that ends by a fault leaves nothing half done.
fn held<T>(mutex: &Mutex<T>) -> MutexGuard<'_, T> {
    mutex.lock().unwrap_or_else(PoisonError::into_inner)
}
