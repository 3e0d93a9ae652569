//! Helpers on threads of the native window, one for each kind of work.

use std::sync::Arc;
use std::sync::mpsc::{Receiver, Sender, TryRecvError, channel};
use std::thread;

use saute_kitchen::Library;
use web_time::Duration;

use super::executor::Executor;
use super::in_frames::InFrames;
use super::{Agency, Helper, WorkKind};

/// Computing time between two looks at what is ordered [ms] (chosen: a new order waits no longer; short against a frame).
const SLICE_MS: u64 = 8;

/// Called when an answer has come.
pub type Wake = Arc<dyn Fn() + Send + Sync>;

/// Hires threads.
pub struct Threads {
    wake: Wake,
    begins: fn(),
}

impl Threads {
    /// Threads that wake the window when they have an answer; each calls `begins` first, as to take a low priority.
    pub fn new(wake: Wake, begins: fn()) -> Self {
        Self { wake, begins }
    }
}

impl Agency for Threads {
    fn hire(&self, kind: WorkKind, library: &Arc<Library>) -> Box<dyn Helper> {
        match OwnThread::begin(kind, library, self) {
            Ok(helper) => Box::new(helper),
            Err(_) => Box::new(InFrames::new(kind, library)),
        }
    }
}

/// An executor on a thread, which ends when the helper is dropped.
pub struct OwnThread {
    orders: Sender<Vec<u8>>,
    answers: Receiver<Vec<u8>>,
}

impl OwnThread {
    /// Starts the thread.
    ///
    /// # Errors
    /// If the system gives none.
    pub fn begin(kind: WorkKind, library: &Arc<Library>, threads: &Threads) -> std::io::Result<Self> {
        let (orders, ordered) = channel();
        let (done, answers) = channel();
        let (library, wake, begins) = (Arc::clone(library), Arc::clone(&threads.wake), threads.begins);
        let work = move || {
            begins();
            let mut executor = Executor::new(kind, library);
            while work_on(&mut executor, &ordered, &done, &wake) {}
        };
        thread::Builder::new().name(kind.name().to_owned()).spawn(work)?;
        Ok(Self { orders, answers })
    }
}

/// Takes the last order, works for a slice and rests; returns false once nobody orders or listens any more.
fn work_on(executor: &mut Executor, ordered: &Receiver<Vec<u8>>, done: &Sender<Vec<u8>>, wake: &Wake) -> bool {
    let first = match ordered.try_recv() {
        Err(TryRecvError::Empty) if !executor.is_busy() => ordered.recv().map_err(|_| TryRecvError::Disconnected),
        first => first,
    };
    match first {
        Ok(order) => executor.take(&ordered.try_iter().last().unwrap_or(order)),
        Err(TryRecvError::Empty) => {}
        Err(TryRecvError::Disconnected) => return false,
    }
    if let Some(answer) = executor.go_on(Duration::from_millis(SLICE_MS)) {
        if done.send(answer).is_err() {
            return false;
        }
        wake();
    }
    thread::sleep(executor.rest());
    true
}

impl Helper for OwnThread {
    fn ask(&mut self, order: Vec<u8>) {
        // A thread that has ended reports it when it is polled for answers.
        drop(self.orders.send(order));
    }

    fn answers(&mut self) -> Option<Vec<Vec<u8>>> {
        let mut answers = Vec::new();
        loop {
            match self.answers.try_recv() {
                Ok(answer) => answers.push(answer),
                Err(TryRecvError::Empty) => return Some(answers),
                Err(TryRecvError::Disconnected) => return (!answers.is_empty()).then_some(answers),
            }
        }
    }
}
