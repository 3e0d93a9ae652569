//! The page's script, as the window calls it.

use crate::listener::Listener;
use saute_session::kept::autosave::CookStore;
use saute_sound::{Event, Told, letter};
use wasm_bindgen::prelude::wasm_bindgen;

#[wasm_bindgen]
extern "C" {
    /// What the page's script does for the window; `web/host.js` is one.
    #[derive(Clone, Debug)]
    pub type Host;

    /// Keeps a part of the cook; returns why an earlier part could not be kept.
    #[wasm_bindgen(method, js_name = keepCook)]
    fn keep_cook(this: &Host, begins: bool, bytes: &[u8]) -> Option<String>;

    /// Rows of the participant of a study that were kept before, as CSV; none where rows cannot be kept.
    #[wasm_bindgen(method, js_name = keptRows)]
    pub(crate) fn kept_rows(this: &Host) -> Option<String>;

    /// Keeps the rows of a study, as CSV; returns why it could not.
    #[wasm_bindgen(method, js_name = keepRows)]
    pub(crate) fn keep_rows(this: &Host, text: &str) -> Option<String>;

    /// Numbers of the first gamepad; none where none is plugged in.
    #[wasm_bindgen(method, js_name = readPad)]
    pub(crate) fn read_pad(this: &Host) -> Option<Vec<f64>>;

    /// Lets the strong and the weak motor of the first gamepad turn so fast, 0 to 1.
    #[wasm_bindgen(method, js_name = shakePad)]
    pub(crate) fn shake_pad(this: &Host, strong: f64, weak: f64);

    /// Returns true if the page can read how the phone is held.
    #[wasm_bindgen(method, js_name = canTilt)]
    pub(crate) fn can_tilt(this: &Host) -> bool;

    /// Reads from now on how the phone is held, after permission; or no longer.
    #[wasm_bindgen(method)]
    pub(crate) fn tilt(this: &Host, on: bool);

    /// How the phone is held, if that is new: angles, turn of the picture, accelerations; nothing in it if it was refused.
    #[wasm_bindgen(method, js_name = readTilt)]
    pub(crate) fn read_tilt(this: &Host) -> Option<Vec<f64>>;

    /// Sends what there is to hear, as numbers ([`saute_sound::letter`]).
    #[wasm_bindgen(method, js_name = tellSound)]
    fn tell_sound(this: &Host, letter: &[f32]);

    /// Why nothing is heard, once.
    #[wasm_bindgen(method, js_name = soundTrouble)]
    fn sound_trouble(this: &Host) -> Option<String>;

    /// Sends an order to the page's worker for a kind of work, or to both of its two where they share it.
    #[wasm_bindgen(method, js_name = askWorker)]
    pub(crate) fn ask_worker(this: &Host, kind: &str, is_shared: bool, order: &[u8]);

    /// Takes what the worker for a kind of work answered; none if it is of no use.
    #[wasm_bindgen(method, js_name = workerAnswers)]
    pub(crate) fn worker_answers(this: &Host, kind: &str) -> Option<js_sys::Array>;

    /// Shows the controls of the panels as HTML, from JSON.
    #[wasm_bindgen(method, js_name = showControls)]
    pub(crate) fn show_controls(this: &Host, controls: &str);

    /// Describes the status of the cook, for those who request it.
    #[wasm_bindgen(method)]
    pub(crate) fn describe(this: &Host, cook: &str);

    /// Lets a sentence be heard once.
    #[wasm_bindgen(method)]
    pub(crate) fn announce(this: &Host, sentence: &str);

    /// Copies what a report of a problem needs: version, browser, and the notices.
    #[wasm_bindgen(method, js_name = copyReport)]
    pub(crate) fn copy_report(this: &Host, said: &str);

    /// Hands a result to the page around this one, if the address states to whom.
    #[wasm_bindgen(method, js_name = reportResult)]
    fn report_result(this: &Host, row: &str);

    /// Copies a text to the clipboard.
    #[wasm_bindgen(method, js_name = copyText)]
    pub(crate) fn copy_text(this: &Host, text: &str);
}

/// What a page has for the window when it starts.
#[derive(Clone, Debug, Default)]
pub struct PageStart {
    /// Its script; without one nothing is kept.
    pub host: Option<Host>,
    /// What is kept of the last cook.
    pub kept: Option<Vec<u8>>,
    /// The fragment of the page's address.
    pub link: String,
    /// True if the page is a part of another one: it begins with the cook itself.
    pub is_embedded: bool,
    /// What was chosen among the pictures of the page's first sight.
    pub opening: Opening,
    /// The version of the page's build.
    pub version: String,
}

/// What was chosen before the window was there.
#[derive(Clone, Debug, Default)]
pub struct Opening {
    /// True if something was chosen: the card of the first steps is not needed.
    pub is_chosen: bool,
    /// Id of a food to set out.
    pub food: Option<String>,
    /// True if the food is shown cut.
    pub is_cut: bool,
}

impl Host {
    /// Hands a result to the page around this one, if the address states to whom.
    pub(crate) fn report(&self, row: &saute_study::class::ResultRow) {
        if let Ok(text) = serde_json::to_string(row) {
            self.report_result(&text);
        }
    }
}

/// Plays what is heard by the page's script.
pub(crate) struct HostPlays {
    host: Host,
    is_paused: bool,
}

impl HostPlays {
    pub(crate) fn new(host: Host) -> Self {
        Self { host, is_paused: true }
    }
}

impl Listener for HostPlays {
    /// A pause is sent once: a page that is silent needs no sound.
    fn hear(&mut self, told: &Told, events: &[Event]) {
        if !(told.is_paused && self.is_paused) {
            self.host.tell_sound(&letter::written(told, events));
        }
        self.is_paused = told.is_paused;
    }

    fn trouble(&mut self) -> Option<String> {
        self.host.sound_trouble()
    }
}

impl CookStore for Host {
    fn begin(&mut self, bytes: &[u8]) -> Result<(), String> {
        self.keep_cook(true, bytes).map_or(Ok(()), Err)
    }

    fn append(&mut self, bytes: &[u8]) -> Result<(), String> {
        self.keep_cook(false, bytes).map_or(Ok(()), Err)
    }
}
