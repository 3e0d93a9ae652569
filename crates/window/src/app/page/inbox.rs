//! What the browser does for the window: events to the page, files, downloads.

use crate::app::SauteApp;
use crate::app::export::COOK_SAID;
use crate::browser::{Inbox, announce, download, element, shown};
use crate::ui::japanese_font;
use js_sys::Uint8Array;
use saute_controls::plan::PlanFile;
use saute_session::export::Export;
use saute_words::language::{Font, Language};
use std::path::Path;
use std::sync::Arc;
use wasm_bindgen::closure::Closure;
use wasm_bindgen::{JsCast, JsValue};
use wasm_bindgen_futures::{JsFuture, spawn_local};
use web_sys::{File, HtmlInputElement};

/// Sent to the page's window when Japanese is chosen and has no font yet.
const FONT_WANTED: &str = "saute-font";

impl SauteApp {
    /// Takes a font with the characters of Japanese; the window is then in Japanese.
    pub fn offer_font(&self, bytes: Vec<u8>) {
        if let Ok(mut font) = self.host.inbox.font.lock() {
            *font = Some(bytes);
        }
    }

    pub(super) fn want_font(&mut self) {
        announce(FONT_WANTED);
    }

    pub(super) fn take_inbox(&mut self, ctx: &egui::Context) {
        let (files, font) = self.host.inbox.take();
        if let Some(bytes) = font {
            self.host.inbox.taken_font = Some(Arc::new(egui::FontData::from_owned(bytes)));
            self.graphics.japanese_font = self.install_taken_font(ctx);
            if let Some(language) = Language::all().find(|language| language.font() == Font::Japanese) {
                self.set_language(language);
            }
        }
        for (name, read) in files {
            self.take_file(&name, read);
        }
    }

    /// Installs the font that the page handed in; returns false if there is none.
    pub(super) fn install_taken_font(&self, ctx: &egui::Context) -> bool {
        let Some(font) = &self.host.inbox.taken_font else { return false };
        japanese_font::install_font(ctx, Arc::clone(font));
        true
    }

    /// Hands the browser a file that is made of the cook.
    pub(super) fn download_export(&mut self, what: Export) {
        let name = what.file_name(self.settings.language);
        self.export_by(what, Path::new(&name), COOK_SAID, |bytes| download(&name, what.media_type(), bytes));
    }

    /// Hands the browser a file that is made of a plan.
    pub(super) fn download_plan(&mut self, file: PlanFile) {
        let Some(bytes) = self.plan_file(file) else { return };
        let name = file.file_name(self.settings.language);
        let written = download(&name, file.media_type(), &bytes);
        self.say_written(Path::new(&name), written, PlanFile::SAID);
    }

    /// Goes on with a new picture after the graphics were lost: the cook, the eye and what is open stay.
    pub fn begin_picture_anew(&mut self, cc: &eframe::CreationContext<'_>) {
        if !self.install_taken_font(&cc.egui_ctx) {
            cc.egui_ctx.set_fonts(crate::system::latin());
        }
        self.host.mirrored.listen(&cc.egui_ctx);
        self.draw_on(&cc.egui_ctx, cc.wgpu_render_state.as_ref());
        // Pictures of panels, and what was drawn before, belonged to the lost graphics.
        self.desk.memory = Default::default();
        self.sights.stage = Default::default();
        self.pace.last_time = None;
    }

    /// Reads dropped files; they arrive in a later frame.
    pub(super) fn read_dropped_files(&mut self, ctx: &egui::Context) {
        for file in ctx.input(|i| i.raw.dropped_files.clone()) {
            let (inbox, ctx) = (self.host.inbox.clone(), ctx.clone());
            spawn_local(async move {
                let name = file.path().display().to_string();
                inbox.put((name, file.bytes_async().await));
                ctx.request_repaint();
            });
        }
    }

    /// Opens the browser's file dialog for a recipe or a session.
    pub(super) fn open_dialog(&mut self, ctx: &egui::Context) {
        if let Err(error) = choose(self.host.inbox.clone(), ctx.clone()) {
            self.say_trouble(&shown(&error));
        }
    }
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
