//! The window as a page: what the browser does for it. Events to the page, files, downloads.

pub(crate) mod fonts;
pub(crate) mod gamepad;
mod helper;
pub mod host;
mod mirrored;
pub(crate) mod page;
pub mod page_log;
pub(crate) mod panels;
pub(crate) mod system;

pub(crate) use self::mirrored::Mirrored;
use js_sys::{Array, Uint8Array};
use std::sync::{Arc, Mutex};
use wasm_bindgen::{JsCast, JsValue};
use web_sys::{Blob, BlobPropertyBag, CustomEvent, HtmlAnchorElement, Url};

/// A file that was read, or why it could not be.
type ReadFile = (String, Result<Vec<u8>, String>);

/// What the page hands in between two frames.
#[derive(Clone, Debug, Default)]
pub(crate) struct Inbox {
    pub(crate) files: Arc<Mutex<Vec<ReadFile>>>,
    pub(crate) font: Arc<Mutex<Option<Vec<u8>>>>,
    /// The font that was taken: a picture that begins again needs it again.
    pub(crate) taken_font: Option<Arc<egui::FontData>>,
}

impl Inbox {
    pub(crate) fn put(&self, file: ReadFile) {
        if let Ok(mut files) = self.files.lock() {
            files.push(file);
        }
    }

    pub(crate) fn take(&self) -> (Vec<ReadFile>, Option<Vec<u8>>) {
        let files = self.files.lock().map(|mut files| std::mem::take(&mut *files)).unwrap_or_default();
        let font = self.font.lock().ok().and_then(|mut font| font.take());
        (files, font)
    }
}

/// Sends an event without content to the page's window.
pub fn announce(name: &str) {
    let Some(window) = web_sys::window() else { return };
    if let Ok(event) = CustomEvent::new(name) {
        // An event without a listener is no error.
        let _ = window.dispatch_event(&event);
    }
}

pub(crate) fn document() -> Option<web_sys::Document> {
    web_sys::window()?.document()
}

/// Hands the browser a file to save.
pub(crate) fn download(name: &str, media_type: &str, bytes: &[u8]) -> Result<(), String> {
    save(name, media_type, bytes).map_err(|error| shown(&error))
}

fn save(name: &str, media_type: &str, bytes: &[u8]) -> Result<(), JsValue> {
    let kind = BlobPropertyBag::new();
    kind.set_type(media_type);
    let blob = Blob::new_with_u8_array_sequence_and_options(&Array::of1(&Uint8Array::from(bytes)), &kind)?;
    let address = Url::create_object_url_with_blob(&blob)?;
    let link: HtmlAnchorElement = element("a")?;
    link.set_href(&address);
    link.set_download(name);
    link.click();
    Url::revoke_object_url(&address)
}

pub(crate) fn element<T: JsCast>(name: &str) -> Result<T, JsValue> {
    document().ok_or("there is no document")?.create_element(name)?.dyn_into().map_err(JsValue::from)
}

/// The message of what was thrown.
pub(crate) fn shown(thrown: &JsValue) -> String {
    let error = thrown.dyn_ref::<js_sys::Error>().map(|error| String::from(error.message()));
    error.or_else(|| thrown.as_string()).unwrap_or_else(|| format!("{thrown:?}"))
}
