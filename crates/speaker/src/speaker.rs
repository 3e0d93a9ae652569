//! The speaker: a thread that plays what it receives.

use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::mpsc::{Receiver, SyncSender, sync_channel};
use std::thread::{Builder, JoinHandle};
use std::time::{Duration, Instant};

use saute_sound::{Event, Player, RATES, Told};

use crate::device::{BLOCK, Device, Trouble};
use crate::events::{Events, queue};

/// Time between two tries to open a device that failed (chosen: whoever plugs one in waits no longer).
const AGAIN: Duration = Duration::from_secs(3);
/// Longest wait before it is seen that nobody listens any more (chosen: a window closes at once for a person).
const LOOK: Duration = Duration::from_millis(50);
/// Longest wait for the thread to end, and between two looks at that (chosen: some blocks; a person waits for neither).
const ENDS: Duration = Duration::from_millis(300);
const SOON: Duration = Duration::from_millis(2);
/// How far a device may run ahead of the clock (chosen: more than any buffer that is requested; a device that takes everything at
/// once, as that which plays nowhere, would keep a processor busy).
const AHEAD: Duration = Duration::from_millis(500);

/// Opens a device; it is called again where one failed.
pub type Opening = Box<dyn FnMut() -> Result<Box<dyn Device>, Trouble> + Send>;

/// Plays the sound of a kitchen. Dropped, it ends its thread.
#[derive(Debug)]
pub struct Speaker {
    told: triple_buffer::Input<Told>,
    events: Events,
    troubles: Receiver<Trouble>,
    is_wanted: Arc<AtomicBool>,
    thread: Option<JoinHandle<()>>,
}

/// The side of the thread.
struct Heard {
    told: triple_buffer::Output<Told>,
    events: Receiver<Event>,
    taken: Vec<Event>,
    troubles: SyncSender<Trouble>,
    is_wanted: Arc<AtomicBool>,
}

impl Speaker {
    /// Begins to play on a device, which its own thread opens.
    ///
    /// # Errors
    ///
    /// If the system gives no thread.
    pub fn new(open: Opening) -> Result<Self, Trouble> {
        let (told, told_out) = triple_buffer::triple_buffer(&Told::default());
        let (events, events_out) = queue();
        let (troubles, troubles_out) = sync_channel(1);
        let is_wanted = Arc::new(AtomicBool::new(true));
        let heard = Heard {
            told: told_out,
            events: events_out,
            taken: Vec::with_capacity(crate::QUEUED),
            troubles,
            is_wanted: Arc::clone(&is_wanted),
        };
        let thread = Builder::new().name("speaker".into()).spawn(move || heard.serve(open));
        let thread = Some(thread.map_err(|error| Trouble::NoThread(error.to_string()))?);
        Ok(Self { told, events, troubles: troubles_out, is_wanted, thread })
    }

    /// Sends what there is to hear; it never waits. What there is to hear of an event counts from its arrival.
    pub fn hear(&mut self, told: Told, events: &[Event]) {
        self.told.write(told);
        self.events.send(events);
    }

    /// Returns why nothing is heard, once for each time that sound is lost.
    pub fn trouble(&self) -> Option<Trouble> {
        self.troubles.try_recv().ok()
    }

    /// Number of events that were dropped on their way because too many came at once [-].
    pub fn dropped_events(&self) -> u64 {
        self.events.dropped()
    }
}

impl Drop for Speaker {
    fn drop(&mut self) {
        self.is_wanted.store(false, Ordering::Relaxed);
        let begun = Instant::now();
        // A device that hangs keeps its thread; it does not keep the window.
        while self.thread.as_ref().is_some_and(|thread| !thread.is_finished()) && begun.elapsed() < ENDS {
            std::thread::sleep(SOON);
        }
    }
}

impl Heard {
    /// Plays on one device after the other. A loss is reported once; while it lasts, the device is tried again in silence.
    fn serve(mut self, mut open: Opening) {
        let mut is_said = false;
        while self.is_wanted() {
            let played = open().and_then(|mut device| {
                is_said = false;
                self.play(device.as_mut())
            });
            let Err(trouble) = played else { return };
            if !std::mem::replace(&mut is_said, true) {
                // If the last one was not read yet, this one states the same.
                drop(self.troubles.try_send(trouble.clone()));
            }
            if !trouble.may_pass() {
                return;
            }
            self.wait(AGAIN);
        }
    }

    /// Plays until nobody listens any more.
    fn play(&mut self, device: &mut dyn Device) -> Result<(), Trouble> {
        let rate = device.rate().clamp(*RATES.start(), *RATES.end());
        let mut player = Player::new(rate);
        let mut block = [[0.0; 2]; BLOCK];
        let (begun, mut played) = (Instant::now(), 0u64);
        // What was done while there was no sound is not heard now.
        while self.events.try_recv().is_ok() {}
        while self.is_wanted() {
            self.taken.clear();
            self.taken.extend(self.events.try_iter());
            if self.told.update() || !self.taken.is_empty() {
                player.hear(self.told.output_buffer(), &self.taken);
            }
            player.render(&mut block);
            device.play(&block)?;
            played += BLOCK as u64;
            let due = Duration::from_secs_f64(played as f64 / f64::from(rate));
            if let Some(early) = due.checked_sub(begun.elapsed() + AHEAD) {
                std::thread::sleep(early);
            }
        }
        Ok(())
    }

    fn is_wanted(&self) -> bool {
        self.is_wanted.load(Ordering::Relaxed)
    }

    /// Waits, and ends as soon as nobody listens.
    fn wait(&self, time: Duration) {
        let begun = Instant::now();
        while self.is_wanted() && begun.elapsed() < time {
            std::thread::sleep(LOOK);
        }
    }
}
