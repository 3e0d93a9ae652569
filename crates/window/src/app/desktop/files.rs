//! Files of the system: dialogs that open a recipe and save a cook, the recipes opened before, the folder of pictures.

use crate::app::SauteApp;
use crate::app::export::COOK_SAID;
use crate::desktop::dialog_errors;
use crate::desktop::files::{Asked, Dialog, DialogAnswer, free_path, read};
use saute_controls::plan::PlanFile;
use saute_files::write_whole;
use saute_session::export::Export;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use std::sync::mpsc::channel;

/// Recipes that are remembered at most (chosen: what is seen without scrolling).
const REMEMBERED: usize = 5;
/// Key of the notice once a file is saved without a dialog.
const SAVED_WITHOUT_DIALOG: &str = "notice.no_dialog_saved";

impl SauteApp {
    /// Opens the system's file dialog.
    pub(super) fn ask(&mut self, asked: Asked, ctx: &egui::Context) {
        if self.host.dialog.0.is_some() {
            return;
        }
        let (send, receive) = channel();
        let ctx = ctx.clone();
        let dialog = self.dialog_for(asked);
        let begun = std::thread::Builder::new().name("file-dialog".to_owned()).spawn(move || {
            let answer = dialog_errors::show(|| match asked {
                Asked::Open => dialog.pick_file(),
                Asked::Save(_) | Asked::SavePlan(_) => dialog.save_file(),
            });
            // Nobody waits for the answer once the window is closed.
            let _ = send.send(answer);
            ctx.request_repaint();
        });
        match begun {
            Ok(_) => self.host.dialog = Dialog(Some((asked, receive))),
            Err(error) => self.say_trouble(&error),
        }
    }

    fn dialog_for(&self, asked: Asked) -> rfd::FileDialog {
        let l = self.settings.language;
        let dialog = match asked {
            Asked::Open => rfd::FileDialog::new()
                .set_title(l.text("pantry.choose_file"))
                .add_filter("TOML, SAUTE, CSV", &["toml", Export::Cook.ending(), "csv", "tsv"]),
            Asked::Save(what) => save_dialog(l.text(what.words()), what.ending(), what.file_name(l)),
            Asked::SavePlan(file) => save_dialog(l.text(file.words()), file.ending(), file.file_name(l)),
        };
        match self.settings.recent.first().and_then(|file| file.parent()) {
            Some(folder) => dialog.set_directory(folder),
            None => dialog,
        }
    }

    /// Opens the file that was chosen since the last frame, or writes it.
    pub(crate) fn take_chosen_file(&mut self) {
        let Some((asked, answer)) = &self.host.dialog.0 else { return };
        let asked = *asked;
        match answer.try_recv() {
            Ok(answer) => {
                self.host.dialog = Dialog::default();
                match (answer, asked) {
                    (DialogAnswer::Chosen(path), Asked::Open) => self.open_file(&path),
                    (DialogAnswer::Chosen(path), Asked::Save(what)) => self.save_export(what, &path),
                    (DialogAnswer::Chosen(path), Asked::SavePlan(file)) => self.save_plan_at(file, &path),
                    (DialogAnswer::Cancelled, _) => {}
                    (DialogAnswer::NotShown, Asked::Open) => self.say_how_to_open(),
                    (DialogAnswer::NotShown, Asked::Save(what)) => self.export_without_dialog(what),
                    (DialogAnswer::NotShown, Asked::SavePlan(file)) => self.save_plan_without_dialog(file),
                }
            }
            Err(std::sync::mpsc::TryRecvError::Empty) => {}
            Err(std::sync::mpsc::TryRecvError::Disconnected) => self.host.dialog = Dialog::default(),
        }
    }

    /// Writes a file that is made of the cook, and shows a notice; or states why it cannot.
    pub fn save_export(&mut self, what: Export, path: &Path) {
        let path = if path.extension().is_some() { path.to_owned() } else { path.with_extension(what.ending()) };
        self.export_to(what, &path, COOK_SAID);
    }

    /// Writes a file that is made of the cook where no dialog can be shown: into the folder of pictures.
    pub fn export_without_dialog(&mut self, what: Export) {
        let Some(path) = self.place_without_dialog(&what.file_name(self.settings.language)) else { return };
        self.export_to(what, &path, [SAVED_WITHOUT_DIALOG, COOK_SAID[1]]);
        if path.exists() {
            self.remember(&path);
        }
    }

    fn export_to(&self, what: Export, path: &Path, said: [&'static str; 2]) {
        self.export_by(what, path, said, |bytes| write_whole(path, bytes).map_err(|error| error.to_string()));
    }

    /// Writes a file that is made of a plan, and shows a notice; or states why it cannot.
    pub fn save_plan_at(&mut self, file: PlanFile, path: &Path) {
        let path = if path.extension().is_some() { path.to_owned() } else { path.with_extension(file.ending()) };
        self.write_plan(file, &path, PlanFile::SAID);
    }

    /// Writes a file that is made of a plan where no dialog can be shown: into the folder of pictures.
    fn save_plan_without_dialog(&mut self, file: PlanFile) {
        let Some(path) = self.place_without_dialog(&file.file_name(self.settings.language)) else { return };
        self.write_plan(file, &path, [SAVED_WITHOUT_DIALOG, PlanFile::SAID[1]]);
    }

    fn write_plan(&mut self, file: PlanFile, path: &Path, said: [&'static str; 2]) {
        let Some(bytes) = self.plan_file(file) else { return };
        let written = write_whole(path, &bytes).map_err(|error| error.to_string());
        self.say_written(path, written, said);
    }

    /// A free place in the folder of pictures; states why there is none.
    fn place_without_dialog(&self, name: &str) -> Option<PathBuf> {
        free_path(&self.host.pictures_folder(), name).map_err(|error| self.say_trouble(&error)).ok()
    }

    /// Shows how a file is opened where no dialog can be shown.
    fn say_how_to_open(&self) {
        let folder = self.host.pictures_folder();
        self.desk.notice.say(self.settings.language.fill("notice.no_dialog_open", &[("folder", &folder.display())]));
    }

    /// Opens a recipe's file and remembers it.
    pub(crate) fn open_file(&mut self, path: &Path) {
        let read = read(path);
        if read.is_ok() {
            self.remember(path);
        }
        self.take_file(&path.display().to_string(), read);
    }

    /// Lists a file first among those that were opened before.
    fn remember(&mut self, path: &Path) {
        self.settings.recent.retain(|file| file != path);
        self.settings.recent.insert(0, path.to_owned());
        self.settings.recent.truncate(REMEMBERED);
    }

    /// Shows a file in the system's file manager.
    pub(crate) fn show_file(&mut self, file: &Path) {
        let folder = file.parent().unwrap_or(file);
        let opener = if cfg!(target_os = "macos") {
            "open"
        } else if cfg!(windows) {
            "explorer"
        } else {
            "xdg-open"
        };
        let mut shown = Command::new(opener);
        shown.arg(folder).stdin(Stdio::null()).stdout(Stdio::null()).stderr(Stdio::null());
        if let Err(error) = shown.spawn() {
            self.say_trouble(&format!("{opener} {}: {error}", folder.display()));
        }
    }
}

fn save_dialog(title: &str, ending: &str, name: String) -> rfd::FileDialog {
    rfd::FileDialog::new().set_title(title).add_filter(ending.to_uppercase(), &[ending]).set_file_name(name)
}
