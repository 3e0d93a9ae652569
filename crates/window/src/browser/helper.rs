//! The page's workers as helpers: each works in its own instance of the module.

use std::sync::Arc;

use js_sys::Uint8Array;
use saute_kitchen::Library;
use wasm_bindgen::JsCast;

use super::host::Host;
use saute_session::work::in_frames::OrInFrames;
use saute_session::work::{Agency, Helper, WorkKind};

/// The worker for a kind of work.
struct OwnWorker {
    host: Host,
    kind: WorkKind,
}

impl Agency for Host {
    fn hire(&self, kind: WorkKind, library: &Arc<Library>) -> Box<dyn Helper> {
        let worker = Box::new(OwnWorker { host: self.clone(), kind });
        match kind {
            // Without a worker the session plays cooks itself.
            WorkKind::Play => worker,
            _ => Box::new(OrInFrames::new(worker, kind, library)),
        }
    }
}

impl Helper for OwnWorker {
    fn ask(&mut self, order: Vec<u8>) {
        self.host.ask_worker(self.kind.name(), self.kind.is_shared(), &order);
    }

    fn answers(&mut self) -> Option<Vec<Vec<u8>>> {
        let answers = self.host.worker_answers(self.kind.name())?;
        Some(answers.iter().filter_map(|bytes| Some(bytes.dyn_into::<Uint8Array>().ok()?.to_vec())).collect())
    }
}
