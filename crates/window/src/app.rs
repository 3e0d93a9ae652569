//! The program's window.

mod apply;
mod desk;
#[cfg(not(target_arch = "wasm32"))]
mod desktop;
mod export;
mod findings;
pub(crate) mod frame;
mod graphics;
mod hands;
mod keeps;
mod keys;
mod leads;
mod on_host;
mod open_session;
mod outside;
mod pace;
#[cfg(target_arch = "wasm32")]
mod page;
mod parts;
mod sights;
mod sounds;
mod unseen;

use std::sync::Arc;

use egui::{Rect, Ui};
use saute_kitchen::{Command, Library, TICK_S};
use saute_picture::stage::{Places, following};
use saute_recipe::Recipe;
use saute_scene::camera::Camera;
use saute_scene::light::gathered::LightSample;
use saute_scene::quality::Quality;

use self::desk::Desk;
use self::graphics::Graphics;
use self::hands::Inputs;
use self::keeps::Keeps;
use self::keeps::later::Later;
use self::leads::Leads;
use self::on_host::OnHost;
use self::pace::Pace;
use self::sights::Sights;
use self::sounds::Sounds;
use crate::host::{CurrentHost, Host};
use crate::mirror::callback::MirrorCallback;
use crate::paint::ground::GroundCallback;
use crate::paint::panel_layer::PanelLayer;
use crate::paint::scene::SceneCallback;
use crate::start::{Start, StartError};
use crate::ui::fingers;
use crate::ui::theme;
use saute_controls::act::Card;
use saute_controls::session::Session;
use saute_controls::settings::Settings;
use saute_session::at_home::kept::KeptKitchen;
use saute_session::guided::Guided;
use saute_session::permits::NotDone;
use saute_session::work::Agency;
use saute_words::language::Language;

/// Where settings are remembered.
const SETTINGS_KEY: &str = "saute.settings";
/// Remembered settings at the first start: none.
const FIRST_START: &str = "{}";
/// Wall time between two looks at slow changes, where the graphics are software [s] (chosen: browning and films creep; to shade
/// foods and floor takes longer there than all else of a frame, so that frames between two looks come three times as fast).
const LOOK_PERIOD_S: f64 = 0.3;

/// Time between two savings of the settings (chosen: whoever is cut off loses no more than this; a file of a few
/// kilobytes).
const AUTO_SAVE: std::time::Duration = std::time::Duration::from_secs(5);

/// The window's state.
pub struct SauteApp {
    pub(crate) session: Session,
    pub(crate) settings: Settings,
    pub(crate) sights: Sights,
    pub(crate) sounds: Sounds,
    pub(crate) inputs: Inputs,
    pub(crate) leads: Leads,
    pub(crate) desk: Desk,
    pub(crate) pace: Pace,
    pub(crate) graphics: Graphics,
    pub(crate) keeps: Keeps,
    /// The agency that finds helpers for heavy work, if there is one.
    agency: Option<Box<dyn Agency>>,
    /// What the window has of the desktop, or of its page.
    pub(crate) host: CurrentHost,
}

impl SauteApp {
    /// Sets out the remembered food, or plays the given recipe.
    pub fn new(cc: &eframe::CreationContext<'_>, start: Start) -> Result<Self, StartError> {
        let stored = cc.storage.map(|s| s.get_string(SETTINGS_KEY).unwrap_or_else(|| FIRST_START.to_owned()));
        let (host, keeps) = (start.host.clone(), stored.is_some() && start.names_nothing());
        let mut app = Self::start(&cc.egui_ctx, cc.wgpu_render_state.as_ref(), stored, start)?;
        app.settle_in(host, keeps, &cc.egui_ctx);
        Ok(app)
    }

    /// As [`Self::new`], with any egui context and graphics state, and remembered settings as JSON: `{}` at the first
    /// start, when the system's language applies and the card of the first steps is shown; none where nothing is ever
    /// remembered, as for pictures: then the window is in English.
    pub fn start(
        context: &egui::Context,
        graphics: Option<&egui_wgpu::RenderState>,
        stored: Option<String>,
        start: Start,
    ) -> Result<Self, StartError> {
        let japanese_font = crate::ui::japanese_font::install(context);
        let remembers = stored.is_some() && start.names_nothing();
        let is_first = stored.as_deref().is_some_and(Settings::were_never_kept);
        let (settings, refused) =
            stored.map_or_else(Default::default, |text| Settings::remembered(&text, crate::system::language()));
        let library = start.library.map_or_else(|| Library::embedded().map(Arc::new), Ok)?;
        let started = Arc::clone(&library);
        let library = KeptKitchen::library(settings.kitchen.as_ref(), library);
        let mut session = Session::new(Arc::clone(&library), &settings.choice)
            .or_else(|_| Session::new(library, &Default::default()))?;
        let first_steps = remembers && !settings.introduced;
        let settings = if first_steps && is_first { settings.of_first_visit() } else { settings };
        session.set_speed(settings.first_speed());
        if let Some(recipe) = start.recipe {
            session.play(recipe)?;
        }
        if let Some(recorded) = start.recorded {
            session.resume(recorded)?;
        }
        let language = start.language.unwrap_or(settings.language);
        let mut app = Self {
            session,
            settings,
            sights: Sights::default(),
            sounds: Sounds::default(),
            inputs: Inputs::default(),
            leads: Leads::default(),
            desk: Desk { card: first_steps.then_some(Card::FirstSteps), ..Desk::default() },
            pace: Pace::default(),
            graphics: Graphics::new(start.frugal, japanese_font),
            keeps: Keeps { library: started, autosave: Default::default() },
            agency: None,
            host: CurrentHost::default(),
        };
        app.draw_on(context, graphics);
        app.take_options(start.desktop, context);
        app.settings.language = Language::ENGLISH;
        app.set_language(language);
        if refused {
            app.say("notice.settings_refused");
        }
        if let Some(study) = start.study {
            app.begin_study(study);
        } else if let Some(lesson) = start.lesson {
            app.open_lesson(lesson);
        }
        Ok(app)
    }

    /// Draws on this context from now on; without graphics the scene is left out.
    fn draw_on(&mut self, context: &egui::Context, graphics: Option<&egui_wgpu::RenderState>) {
        theme::install(context);
        fingers::note(context, crate::system::has_coarse_pointer());
        self.graphics.drawable = graphics.is_some();
        let Some(state) = graphics else { return };
        SceneCallback::install(state);
        GroundCallback::install(state);
        MirrorCallback::install(state);
        self.graphics.software = state.adapter.get_info().device_type == wgpu::DeviceType::Cpu;
        if self.is_frugal() {
            PanelLayer::install(context, state);
        }
    }

    /// Returns true if panels are drawn a few times a second only.
    fn is_frugal(&self) -> bool {
        self.graphics.frugal && self.graphics.software
    }

    /// Sends a command to the kitchen and shows a notice if it is refused.
    pub(crate) fn command(&mut self, command: &Command) {
        self.give(command);
    }

    /// As [`Self::command`]; returns true if the kitchen takes it at once.
    pub(crate) fn give(&mut self, command: &Command) -> bool {
        if self.puts_off_command(command) {
            return false;
        }
        let played = self.session.runner.is_some();
        let taken = self.session.command(command);
        let is_taken = taken.is_ok();
        match taken {
            Ok(()) if played => self.say("notice.taken_over"),
            Ok(()) if self.session.paused && takes_time(command) => self.say("notice.later"),
            Ok(()) => {}
            Err(not_done) => self.say_not_done(&not_done),
        }
        is_taken
    }

    /// Returns true if panels and clock make room for the camera.
    pub(crate) fn photo_is_open(&self) -> bool {
        self.host.photo().is_some()
    }

    /// Returns true if a card covers the scene, or a photo is taken of it; time then waits.
    pub(crate) fn card_is_open(&self) -> bool {
        // Behind that of the half mirror the cook goes on in the mirror.
        let card = self.desk.card.is_some_and(|card| card != Card::Mirror);
        let asks = self.leads.guided.as_ref().is_some_and(Guided::asks) || self.session.asks();
        card || asks || self.photo_is_open() || self.offered_s().is_some()
    }

    /// Shows a notice whose text has no placeholders.
    pub(crate) fn say(&self, key: &'static str) {
        self.desk.notice.say(self.settings.language.text(key));
    }

    /// Shows why a command was not carried out.
    pub(crate) fn say_not_done(&self, not_done: &NotDone) {
        match not_done {
            NotDone::Locked => self.say("guided.locked"),
            NotDone::Refused(refused) => {
                let (library, l) = (&self.session.library, self.settings.language);
                self.desk.notice.say(saute_words::refusal::words(refused, library, l));
            }
        }
    }

    /// Shows what the core could not do; errors of recipes and data have their own words, with file and line.
    pub(crate) fn say_trouble(&self, error: &dyn std::fmt::Display) {
        self.desk.notice.say(self.settings.language.fill("notice.trouble", &[("error", error)]));
    }

    /// Opens a recipe's text, as from a dropped file.
    pub fn open_recipe(&mut self, text: &str, file: &str) {
        let l = self.settings.language;
        let recipe = match Recipe::parse(text, file, &self.session.library) {
            Ok(recipe) => recipe,
            Err(wrong) => {
                let parts: [(&str, &dyn std::fmt::Display); 4] = [
                    ("file", &wrong.file),
                    ("line", &wrong.line),
                    ("message", &wrong.message),
                    ("remedy", &wrong.remedy),
                ];
                return self.desk.notice.say(l.fill("notice.wrong_recipe", &parts));
            }
        };
        let is_to_build = self.session.builds_recipe_first(&recipe);
        if self.waits_for_food(is_to_build, || Later::Recipe(file.to_owned(), text.to_owned())) {
            return;
        }
        match self.session.play(recipe) {
            Ok(()) => {
                let title = l.called("recipe", self.session.recipe_title().unwrap_or(file));
                self.desk.notice.say(l.fill("notice.playing", &[("title", &title)]));
            }
            Err(error) => self.say_trouble(&error),
        }
    }

    /// Size at which to draw the scene [pixels]: in full, or on a software rasteriser, unless the best is chosen,
    /// scaled down to 960 × 540 at least.
    pub(crate) fn scene_pixels(&self, rect: Rect, pixels_per_point: f32) -> [u32; 2] {
        let (w, h) = (rect.width() * pixels_per_point, rect.height() * pixels_per_point);
        let scaled = self.graphics.software && self.quality() < Quality::Best;
        let least = if scaled { (960.0 / w).max(540.0 / h).clamp(0.1, 1.0) } else { 1.0 };
        let most = 2048.0 / w.max(h);
        let scale = least.min(most);
        [(w * scale).round().max(1.0) as u32, (h * scale).round().max(1.0) as u32]
    }

    /// Samples of light that the picture gathers while it rests: a paused kitchen at the best level refines until it is touched.
    pub(crate) fn samples(&self) -> u32 {
        if self.session.paused && self.quality() == Quality::Best { LightSample::KEPT } else { 1 }
    }

    /// Returns true if the graphics are software.
    pub(crate) fn software(&self) -> bool {
        self.graphics.software
    }

    /// Ticks between two looks at slow changes in the pan.
    pub(crate) fn look_ticks(&self) -> u64 {
        if !self.graphics.software || self.session.paused || self.quality() > Quality::Quick {
            return 1;
        }
        (LOOK_PERIOD_S * self.session.speed / TICK_S).round() as u64
    }

    pub(crate) fn drawable(&self) -> bool {
        self.graphics.drawable
    }

    pub(crate) fn places(&self) -> Places {
        let mut places = self.sights.motions.places();
        places.pieces.extend(self.sights.scene.carried.clone());
        places
    }

    /// The eye as the scene is drawn with it.
    pub(crate) fn eye(&self) -> Camera {
        following(&self.sights.camera, self.places().followed(&self.session.kitchen))
    }
}

/// Commands that a hand carries out over time.
fn takes_time(command: &Command) -> bool {
    matches!(
        command,
        Command::Flip { .. }
            | Command::Rest { .. }
            | Command::Toss { .. }
            | Command::Shake { .. }
            | Command::Press { .. }
            | Command::Baste { .. }
            | Command::Move { .. }
            | Command::Tilt { .. }
    )
}

impl eframe::App for SauteApp {
    fn ui(&mut self, ui: &mut Ui, _frame: &mut eframe::Frame) {
        self.frame(ui);
    }

    #[cfg(target_arch = "wasm32")]
    fn as_any_mut(&mut self) -> Option<&mut dyn std::any::Any> {
        Some(&mut *self)
    }

    fn auto_save_interval(&self) -> std::time::Duration {
        AUTO_SAVE
    }

    fn save(&mut self, storage: &mut dyn eframe::Storage) {
        // What a study shows is not what the next person at this machine chose.
        if matches!(self.leads.guided, Some(Guided::Study(_))) {
            return;
        }
        if let Ok(text) = serde_json::to_string(&self.settings) {
            storage.set_string(SETTINGS_KEY, text);
        }
    }
}
