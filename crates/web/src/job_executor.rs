//! The class that a worker's script uses: it does one kind of work for the page, in its own instance.

use std::time::Duration;

use saute_kitchen::Library;
use saute_session::work::executor::Executor;
use saute_session::work::{End, WorkKind};
use wasm_bindgen::prelude::wasm_bindgen;

/// An executor with its own foods and pans.
#[wasm_bindgen]
pub struct JobExecutor(Executor);

#[wasm_bindgen]
impl JobExecutor {
    /// An executor without an order, for a kind of work by its name; the second of two that share it works from the other end.
    ///
    /// # Errors
    ///
    /// Throws if there is no such kind, or the embedded data is broken.
    #[wasm_bindgen(constructor)]
    pub fn new(kind: &str, is_second: bool) -> Result<Self, js_sys::Error> {
        let kind = WorkKind::named(kind).ok_or_else(|| js_sys::Error::new(&format!("there is no work \"{kind}\"")))?;
        let library = Library::embedded().map_err(|error| js_sys::Error::new(&error.to_string()))?;
        let end = if is_second { End::Back } else { End::Front };
        Ok(Self(Executor::at(end, kind, library.into())))
    }

    /// Takes an order in place of the one before.
    pub fn take(&mut self, order: &[u8]) {
        self.0.take(order);
    }

    /// What was done here since the last call, for the other of two.
    pub fn share(&mut self) -> Option<Vec<u8>> {
        self.0.share()
    }

    /// Takes what the other of two has done.
    pub fn take_shared(&mut self, shares: &[u8]) {
        self.0.take_shared(shares);
    }

    /// How long it rests before it goes on [ms].
    pub fn rest_ms(&mut self) -> f64 {
        1000.0 * self.0.rest().as_secs_f64()
    }

    /// Works on for some milliseconds; returns an answer where one is due.
    pub fn go_on(&mut self, for_ms: u32) -> Option<Vec<u8>> {
        self.0.go_on(Duration::from_millis(for_ms.into()))
    }

    /// True while there is something to do.
    pub fn is_busy(&self) -> bool {
        self.0.is_busy()
    }
}
