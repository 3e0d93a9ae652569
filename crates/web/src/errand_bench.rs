//! The class that a worker's script uses: it plays cooks for the page, in an instance of its own.

use std::time::Duration;

use saute_kitchen::Library;
use saute_window::session::errand::bench::Bench;
use wasm_bindgen::prelude::wasm_bindgen;

/// A bench with its own foods and pans.
#[wasm_bindgen]
pub struct ErrandBench(Bench);

#[wasm_bindgen]
impl ErrandBench {
    /// A bench without work.
    ///
    /// # Errors
    ///
    /// Throws if the embedded data is broken.
    #[wasm_bindgen(constructor)]
    pub fn new() -> Result<Self, js_sys::Error> {
        let library = Library::embedded().map_err(|error| js_sys::Error::new(&error.to_string()))?;
        Ok(Self(Bench::new(library.into())))
    }

    /// Takes an errand in place of the one before.
    pub fn take(&mut self, errand: &[u8]) {
        self.0.take(errand);
    }

    /// Plays on for some milliseconds; returns an answer where one is due.
    pub fn go_on(&mut self, for_ms: u32) -> Option<Vec<u8>> {
        self.0.go_on(Duration::from_millis(for_ms.into()))
    }

    /// True while an errand is under way.
    pub fn is_busy(&self) -> bool {
        self.0.is_busy()
    }
}
