//! What the browser does for the window: events to the page, files, downloads.

pub(crate) mod gamepad;
pub(crate) mod hands;
mod helper;
pub mod host;
mod mirrored;
mod page_log;

pub(crate) use self::mirrored::Mirrored;
pub(crate) use self::page_log::PageLog;

use std::path::Path;
use std::sync::{Arc, Mutex};

use js_sys::{Array, Uint8Array};
use wasm_bindgen::closure::Closure;
use wasm_bindgen::{JsCast, JsValue};
use wasm_bindgen_futures::{JsFuture, spawn_local};
use web_sys::{Blob, BlobPropertyBag, CustomEvent, File, HtmlAnchorElement, HtmlInputElement, Url};

use crate::app::SauteApp;
use crate::plan::PlanFile;
use crate::ui::japanese_font;
use saute_session::export::Export;
use saute_words::language::Language;

/// Sent to the page's window when Japanese is chosen and has no font yet.
const FONT_WANTED: &str = "saute-font";

/// A file that was read, or why it could not be.
type ReadFile = (String, Result<Vec<u8>, String>);

/// What the page hands in between two frames.
#[derive(Clone, Debug, Default)]
pub(crate) struct Inbox {
    files: Arc<Mutex<Vec<ReadFile>>>,
    font: Arc<Mutex<Option<Vec<u8>>>>,
    /// The font that was taken: a picture that begins anew needs it again.
    taken_font: Option<Arc<egui::FontData>>,
    /// True if time was stopped because the tab was hidden.
    paused_hidden: bool,
}

impl Inbox {
    fn put(&self, file: ReadFile) {
        if let Ok(mut files) = self.files.lock() {
            files.push(file);
        }
    }

    fn take(&self) -> (Vec<ReadFile>, Option<Vec<u8>>) {
        let files = self.files.lock().map(|mut files| std::mem::take(&mut *files)).unwrap_or_default();
        let font = self.font.lock().ok().and_then(|mut font| font.take());
        (files, font)
    }
}

impl SauteApp {
    /// Takes a font with the characters of Japanese; the window then speaks it.
    pub fn offer_font(&self, bytes: Vec<u8>) {
        if let Ok(mut font) = self.inbox.font.lock() {
            *font = Some(bytes);
        }
    }

    /// Pauses while the tab is hidden, and says so once it is seen again.
    fn pause_hidden(&mut self) {
        let hidden = document().is_some_and(|document| document.hidden());
        if hidden && !self.session.paused {
            self.session.set_paused(true);
            self.inbox.paused_hidden = true;
        } else if !hidden && std::mem::take(&mut self.inbox.paused_hidden) {
            self.say("notice.hidden");
        }
    }

    pub(crate) fn want_font(&mut self) {
        announce(FONT_WANTED);
    }

    pub(crate) fn take_inbox(&mut self, ctx: &egui::Context) {
        self.pause_hidden();
        let (files, font) = self.inbox.take();
        if let Some(bytes) = font {
            self.inbox.taken_font = Some(Arc::new(egui::FontData::from_owned(bytes)));
            self.japanese_font = self.install_taken_font(ctx);
            self.set_language(Language::Japanese);
        }
        for (name, read) in files {
            self.take_file(&name, read);
        }
    }

    /// Installs the font that the page handed in; returns false if there is none.
    pub(crate) fn install_taken_font(&self, ctx: &egui::Context) -> bool {
        let Some(font) = &self.inbox.taken_font else { return false };
        japanese_font::install_font(ctx, Arc::clone(font));
        true
    }

    /// Hands the browser a file that is made of the cook.
    pub(crate) fn export(&mut self, what: Export, _: &egui::Context) {
        let name = what.file_name(self.settings.language);
        self.export_by(what, Path::new(&name), |bytes| download(&name, what.media_type(), bytes));
    }

    /// Hands the browser a file that is made of a plan.
    pub(crate) fn save_plan(&mut self, file: PlanFile, _: &egui::Context) {
        let Some(bytes) = self.plan_file(file) else { return };
        let name = file.file_name(self.settings.language);
        let written = download(&name, file.media_type(), &bytes);
        self.say_written(Path::new(&name), written, PlanFile::SAID);
    }

    /// Reads dropped files; they arrive in a later frame.
    pub(crate) fn take_dropped_files(&mut self, ctx: &egui::Context) {
        for file in ctx.input(|i| i.raw.dropped_files.clone()) {
            let (inbox, ctx) = (self.inbox.clone(), ctx.clone());
            spawn_local(async move {
                let name = file.path().display().to_string();
                inbox.put((name, file.bytes_async().await));
                ctx.request_repaint();
            });
        }
    }

    /// Opens the browser's file dialog for a recipe or a session.
    pub(crate) fn choose_file(&mut self, ctx: &egui::Context) {
        if let Err(error) = choose(self.inbox.clone(), ctx.clone()) {
            self.say_trouble(&shown(&error));
        }
    }
}

/// Sends an event without content to the page's window.
pub fn announce(name: &str) {
    let Some(window) = web_sys::window() else { return };
    if let Ok(event) = CustomEvent::new(name) {
        // An event that nobody hears is no error.
        let _ = window.dispatch_event(&event);
    }
}

fn document() -> Option<web_sys::Document> {
    web_sys::window()?.document()
}

/// The language that the browser prefers, such as `ja-JP`.
pub(crate) fn language() -> Option<String> {
    web_sys::window()?.navigator().language()
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

fn choose(inbox: Inbox, ctx: egui::Context) -> Result<(), JsValue> {
    let input: HtmlInputElement = element("input")?;
    input.set_type("file");
    input.set_accept(".toml,.saute,.csv,.tsv,text/plain,text/csv");
    let chosen = input.clone();
    let read = Closure::once_into_js(move || {
        let Some(file) = chosen.files().and_then(|files| files.get(0)) else { return };
        spawn_local(async move {
            inbox.put((file.name(), bytes_of(&file).await));
            ctx.request_repaint();
        });
    });
    input.set_onchange(Some(read.unchecked_ref()));
    input.click();
    Ok(())
}

async fn bytes_of(file: &File) -> Result<Vec<u8>, String> {
    let buffer = JsFuture::from(file.array_buffer()).await.map_err(|error| shown(&error))?;
    Ok(Uint8Array::new(&buffer).to_vec())
}

fn element<T: JsCast>(name: &str) -> Result<T, JsValue> {
    document().ok_or("there is no document")?.create_element(name)?.dyn_into().map_err(JsValue::from)
}

/// The message of what was thrown.
fn shown(thrown: &JsValue) -> String {
    let error = thrown.dyn_ref::<js_sys::Error>().map(|error| String::from(error.message()));
    error.or_else(|| thrown.as_string()).unwrap_or_else(|| format!("{thrown:?}"))
}
