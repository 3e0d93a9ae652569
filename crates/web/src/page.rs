//! The class that a page's script uses.

use std::cell::Cell;
use std::rc::Rc;

use eframe::{CreationContext, WebOptions, WebRunner};
use saute_controls::pose::Pose;
use saute_recipe::Recipe;
use saute_window::browser::host::PageStart;
use saute_window::{DesktopOptions, SauteApp, Start};
use wasm_bindgen::prelude::wasm_bindgen;
use wasm_bindgen::{JsCast, JsValue};
use web_sys::HtmlCanvasElement;

use crate::backend::Backend;
use crate::led;
use crate::options::Options;
use crate::shared_app::SharedApp;
use crate::stats::Stats;

/// Sent to the window when the graphics device is lost.
const LOST: &str = "saute-lost";

/// One simulator on one canvas.
#[wasm_bindgen]
pub struct Page {
    runner: WebRunner,
    app: SharedApp,
    backend: Rc<Cell<Option<Backend>>>,
}

#[wasm_bindgen]
impl Page {
    /// A page that is not started.
    #[wasm_bindgen(constructor)]
    #[allow(clippy::new_without_default)]
    pub fn new() -> Self {
        // A second page of the same module finds the logger installed.
        let _ = eframe::WebLogger::init(log::LevelFilter::Error);
        Self { runner: WebRunner::new(), app: SharedApp::default(), backend: Rc::default() }
    }

    /// Starts on a canvas with `{ backend: "auto" | "webgpu" | "webgl2", lang: "en" | "ja" | "", recipe, study, participant, machine, scenario, student, lock, link, embed, host, kept, chosen, food, cut, version }`. A
    /// page that was started goes on with its cook on the new canvas.
    ///
    /// # Errors
    ///
    /// Rejects with a message if an option is wrong, or if neither graphics nor data can be set up.
    pub async fn start(&self, canvas: HtmlCanvasElement, options: JsValue) -> Result<(), JsValue> {
        let options = Options::read(&options).map_err(|message| js_sys::Error::new(&message))?;
        let backend = options.backend.resolve().await;
        if options.is_embedded {
            self.app.forget();
        }
        let web = WebOptions { wgpu_options: backend.setup(), dithering: false, ..WebOptions::default() };
        let app = self.app.clone();
        let create = move |cc: &CreationContext<'_>| -> Result<Box<dyn eframe::App>, _> {
            watch(cc);
            app.begin(cc, || start(options))?;
            Ok(Box::new(app) as Box<dyn eframe::App>)
        };
        self.runner.start(canvas, web, Box::new(create)).await.map_err(error)?;
        self.backend.set(Some(backend));
        Ok(())
    }

    /// The graphics interface in use: `webgpu` or `webgl2`; empty before the start.
    pub fn backend(&self) -> String {
        self.backend.get().map(Backend::name).unwrap_or_default().to_owned()
    }

    /// Stops the picture, and frees canvas and graphics; the cook stays for another start.
    pub fn destroy(&self) {
        self.runner.destroy();
        self.backend.set(None);
    }

    /// State and speed as JSON; empty before the start.
    pub fn stats(&self) -> String {
        let app = self.app.get();
        app.and_then(|app| serde_json::to_string(&Stats::of(&app, self.backend())).ok()).unwrap_or_default()
    }

    /// Shows a stated condition, as JSON, and stops time there: for pictures that are compared.
    ///
    /// # Errors
    ///
    /// Throws with a message if the text or its recipe is wrong.
    pub fn pose(&self, json: &str) -> Result<(), JsValue> {
        let pose = serde_json::from_str::<Pose>(json).map_err(|e| e.to_string());
        let mut app = self.app.get().ok_or_else(|| js_sys::Error::new("not started"))?;
        pose.and_then(|pose| app.pose(&pose)).map_err(|message| js_sys::Error::new(&message))?;
        app.wake();
        Ok(())
    }

    /// Takes a font that has the characters of Japanese.
    pub fn offer_font(&self, bytes: Vec<u8>) {
        if let Some(app) = self.app.get() {
            app.offer_font(bytes);
        }
    }

    /// Draws a frame soon: something has come for the window.
    pub fn wake(&self) {
        if let Some(app) = self.app.get() {
            app.wake();
        }
    }

    /// Writes what happened to the storage at once, as before the page is closed.
    pub fn keep_now(&self) {
        if let Some(mut app) = self.app.get() {
            app.keep_cook(true);
        }
    }

    /// Notes that the tab is seen, or no longer.
    pub fn be_seen(&self, seen: bool) {
        if let Some(mut app) = self.app.get() {
            app.be_seen(seen);
            app.wake();
        }
    }

    /// Returns true if Tab, or Shift+Tab for `back`, leaves the picture now: no control has the focus, and forward the last one had
    /// it.
    pub fn tab_leaves(&self, back: bool) -> bool {
        self.app.get().is_some_and(|mut app| app.tab_leaves(back))
    }

    /// Opens the cook of a fragment that was put into the page's address.
    pub fn open_link(&self, fragment: &str) {
        if let Some(mut app) = self.app.get() {
            app.open_link(fragment);
        }
    }

    /// Presses a control that is shown as HTML.
    pub fn press_control(&self, id: &str) {
        if let Some(app) = self.app.get() {
            app.press_control(id);
        }
    }

    /// Sets the value of a control: a text, else a number.
    pub fn set_control(&self, id: &str, value: &str, is_text: bool) {
        if let Some(app) = self.app.get() {
            app.set_control(id, value, is_text);
        }
    }

    /// Hashes of the kitchen's state every ten seconds of the cook, as lines of frame and hash: the same on every machine.
    pub fn hashes(&self) -> String {
        let app = self.app.get();
        let lines = |app: &SauteApp| {
            let hashes = app.session().recording().hashes().iter();
            hashes.map(|(frame, hash)| format!("{frame} {hash:016x}\n")).collect::<String>()
        };
        app.map(|app| lines(&app)).unwrap_or_default()
    }
}

/// What the window starts with.
fn start(options: Options) -> Result<Start, String> {
    let library = saute_kitchen::Library::embedded().map_err(|e| e.to_string())?;
    let recipe = options.recipe.map(|name| shipped(&library, &name)).transpose()?;
    let study =
        options.study.as_ref().map(|(id, code)| led::study(&library, (id, code), options.host.as_ref())).transpose()?;
    let study = study.map(|start| if options.machine_is_tried { start.on_tried_machine() } else { start });
    let Options { host, kept, link, is_embedded, opening, version, .. } = options;
    let host = PageStart { host, kept, link, is_embedded, opening, version };
    let lesson = options.lesson.map(|lesson| led::lesson(&library, lesson)).transpose()?;
    let (language, library) = (options.language, Some(library.into()));
    let desktop = DesktopOptions::default();
    Ok(Start { library, recipe, recorded: None, study, lesson, language, frugal: true, desktop, host })
}

fn shipped(library: &saute_kitchen::Library, name: &str) -> Result<Recipe, String> {
    let names = || saute_kitchen::Library::names(&library.recipes);
    let text =
        library.recipes.get(name).ok_or_else(|| format!("recipe: there is no \"{name}\"; there are {}", names()))?;
    Recipe::parse(text, name, library).map_err(|e| e.to_string())
}

/// Reports the loss and the errors of the graphics device.
fn watch(cc: &CreationContext<'_>) {
    let Some(state) = &cc.wgpu_render_state else { return };
    state.device.on_uncaptured_error(std::sync::Arc::new(|error| log::error!("graphics: {error}")));
    state.device.set_device_lost_callback(|reason, message| {
        if reason != wgpu::DeviceLostReason::Destroyed {
            log::info!("graphics lost: {message}");
            saute_window::browser::announce(LOST);
        }
    });
}

/// An `Error` with the message of whatever was thrown.
fn error(thrown: JsValue) -> JsValue {
    if thrown.is_instance_of::<js_sys::Error>() {
        return thrown;
    }
    js_sys::Error::new(&thrown.as_string().unwrap_or_else(|| format!("{thrown:?}"))).into()
}
