//! The program, kept apart from the picture: where the graphics are lost, a new picture shows the same cook.

use std::cell::{Cell, RefCell, RefMut};
use std::rc::Rc;

use eframe::CreationContext;
use saute_window::{SauteApp, Start, StartError};

/// The program once it has started; clones share it.
#[derive(Clone, Default)]
pub(crate) struct SharedApp {
    app: Rc<RefCell<Option<SauteApp>>>,
    /// True if the browser is to keep nothing of it.
    forgets: Rc<Cell<bool>>,
}

impl SharedApp {
    /// Starts the program, or lets the one that runs draw on new graphics.
    pub fn begin(&self, cc: &CreationContext<'_>, start: impl FnOnce() -> Result<Start, String>) -> Result<(), String> {
        let mut app = self.app.borrow_mut();
        match &mut *app {
            Some(app) => app.begin_picture_anew(cc),
            none => *none = Some(SauteApp::new(cc, start()?).map_err(|error: StartError| error.to_string())?),
        }
        Ok(())
    }

    /// Lets the browser keep nothing of it, as where the page is a part of another one.
    pub fn forget(&self) {
        self.forgets.set(true);
    }

    /// The program; none before it has started, or while it draws.
    pub fn get(&self) -> Option<RefMut<'_, SauteApp>> {
        RefMut::filter_map(self.app.try_borrow_mut().ok()?, Option::as_mut).ok()
    }
}

impl eframe::App for SharedApp {
    fn ui(&mut self, ui: &mut egui::Ui, frame: &mut eframe::Frame) {
        if let Some(mut app) = self.get() {
            app.ui(ui, frame);
        }
    }

    fn auto_save_interval(&self) -> std::time::Duration {
        self.get().map_or(std::time::Duration::MAX, |app| app.auto_save_interval())
    }

    fn save(&mut self, storage: &mut dyn eframe::Storage) {
        if let (false, Some(mut app)) = (self.forgets.get(), self.get()) {
            app.save(storage);
        }
    }

    fn persist_egui_memory(&self) -> bool {
        !self.forgets.get()
    }
}
