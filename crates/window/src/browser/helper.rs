//! The page's worker as a helper: it plays recorded cooks in a second instance of the module.

use js_sys::Uint8Array;
use wasm_bindgen::JsCast;

use super::host::Host;
use crate::session::errand::Helper;

impl Helper for Host {
    fn ask(&mut self, errand: Vec<u8>) {
        self.ask_worker(&errand);
    }

    fn answers(&mut self) -> Option<Vec<Vec<u8>>> {
        let answers = self.worker_answers()?;
        Some(answers.iter().filter_map(|bytes| Some(bytes.dyn_into::<Uint8Array>().ok()?.to_vec())).collect())
    }
}
