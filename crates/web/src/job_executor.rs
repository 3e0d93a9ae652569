//! The class that a worker's script uses: it does one kind of work for the page, in its own instance.

use std::time::Duration;

use saute_kitchen::Library;
use saute_session::work::WorkKind;
use saute_session::work::executor::Executor;
use wasm_bindgen::prelude::wasm_bindgen;

/// An executor with its own foods and pans.
#[wasm_bindgen]
pub struct JobExecutor(Executor);

#[wasm_bindgen]
impl JobExecutor {
    /// An executor without an order, for a kind of work by its name.
    ///
    /// # Errors
    ///
    /// Throws if there is no such kind, or the embedded data is broken.
    #[wasm_bindgen(constructor)]
    pub fn new(kind: &str) -> Result<Self, js_sys::Error> {
        let kind = WorkKind::named(kind).ok_or_else(|| js_sys::Error::new(&format!("there is no work \"{kind}\"")))?;
        let library = Library::embedded().map_err(|error| js_sys::Error::new(&error.to_string()))?;
        Ok(Self(Executor::new(kind, library.into())))
    }

    /// Takes an order in place of the one before.
    pub fn take(&mut self, order: &[u8]) {
        self.0.take(order);
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
