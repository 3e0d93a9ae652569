//! The program's window.

use std::collections::BTreeSet;
use std::sync::Arc;

use egui::{Rect, Ui};
use saute_kitchen::{Command, Library, Place, RestOn};
use saute_picture::View;
use saute_picture::colour::map::TemperatureMap;
use saute_picture::stage::{CUT_YAW, Places, Stage, following, nearness};
use saute_recipe::Recipe;
use saute_scene::camera::Camera;
use saute_scene::quality::Quality;
use web_time::{Duration, Instant};

use crate::act::{Act, BINDINGS};
use crate::governor::Governor;
use crate::input::pad_input::Pad;
use crate::input::pan_keys::PanKeys;
use crate::input::pouring::Portion;
use crate::input::tool_hand::{ToolHand, TurnerPose};
use crate::mirror::presenter::MirrorCallback;
use crate::mirror::view::MirrorView;
use crate::paint::ground::GroundCallback;
use crate::paint::scene::SceneCallback;
use crate::panels;
use crate::session::{SPEEDS, STEAK, Session};
use crate::settings::Settings;
use crate::ui::layout::Layout;
use crate::ui::motion::Motions;
use crate::ui::notice::Notice;
use crate::ui::scene_view::SceneView;
use crate::ui::theme;
use crate::words::language::Language;

/// Where settings are remembered.
const SETTINGS_KEY: &str = "saute.settings";
/// What is remembered at the first start: nothing.
const FIRST_START: &str = "{}";
/// Longest that one frame may spend on stepping the world [ms] (chosen: half a frame at 25 frames a second).
const STEP_BUDGET_MS: u64 = 20;

/// Height of a toss by key [m] (chosen: over the rim, within reach).
const TOSS_M: f64 = 0.12;
/// Held keys move the pan no further at once than in this time [s] (chosen: a slow frame makes no leap).
const LONGEST_FRAME_S: f64 = 0.1;

/// What the window starts with.
#[derive(Clone, Debug, Default)]
pub struct Start {
    /// What can be built; the embedded data unless given.
    pub library: Option<Arc<Library>>,
    /// A recipe to play at once.
    pub recipe: Option<Recipe>,
    /// Devices that hands hold.
    #[cfg(not(target_arch = "wasm32"))]
    pub hands: crate::hand::HandsStart,
}

/// The window's state.
pub struct SauteApp {
    pub(crate) session: Session,
    pub(crate) settings: Settings,
    pub(crate) stage: Stage,
    pub(crate) camera: Camera,
    pub(crate) camera_preset: usize,
    /// Place of the cut (−1…1), or none.
    pub(crate) slice: Option<f64>,
    pub(crate) help: bool,
    /// Whether the card of the settings is open.
    pub(crate) settings_open: bool,
    pub(crate) notice: Notice,
    pub(crate) motions: Motions,
    pub(crate) scene: SceneView,
    pub(crate) inside: panels::inside::Inside,
    pub(crate) drawer: panels::Drawer,
    /// Groups of which the list shows every piece.
    pub(crate) unfolded: BTreeSet<String>,
    /// How many pieces the pantry adds at once.
    pub(crate) count: usize,
    pub(crate) pan_keys: PanKeys,
    pub(crate) tool_hand: ToolHand,
    /// How much is poured at once.
    pub(crate) portion: Portion,
    pub(crate) pad: Pad,
    #[cfg(not(target_arch = "wasm32"))]
    pub(crate) hand_choice: crate::hand::Choice,
    last_time: Option<f64>,
    /// Whether the card of the first steps is shown.
    pub(crate) first_steps: bool,
    /// Whether the system has a font with kana and kanji.
    pub(crate) japanese_font: bool,
    /// Whether the scene can be drawn (a graphics device is there).
    drawable: bool,
    software: bool,
    /// Chooses the quality of the picture where that is left to the program.
    pub(crate) governor: Governor,
    pub(crate) mirror: MirrorView,
}

/// Why the window cannot start.
#[derive(Debug, thiserror::Error)]
pub enum StartError {
    /// Embedded or user data is broken.
    #[error(transparent)]
    Library(#[from] saute_kitchen::LibraryError),
    /// The first kitchen cannot be set up.
    #[error(transparent)]
    Setup(#[from] saute_kitchen::kitchen::SetupError),
}

impl SauteApp {
    /// Sets out the remembered food, or plays the given recipe.
    pub fn new(cc: &eframe::CreationContext<'_>, start: Start) -> Result<Self, StartError> {
        let stored = cc.storage.map(|s| s.get_string(SETTINGS_KEY).unwrap_or_else(|| FIRST_START.to_owned()));
        #[cfg(not(target_arch = "wasm32"))]
        let hands = start.hands.clone();
        let mut app = Self::start(&cc.egui_ctx, cc.wgpu_render_state.as_ref(), stored, start)?;
        app.pad = Pad::connected();
        #[cfg(not(target_arch = "wasm32"))]
        {
            app.session.hands.folder = eframe::storage_dir("saute").map(|folder| folder.join("calibrations"));
            app.begin_hands(hands);
        }
        Ok(app)
    }

    /// As [`Self::new`], with any egui context and graphics state, and remembered settings as JSON: `{}` at the first
    /// start, when the system's language holds and the card of the first steps is shown; none where nothing is ever
    /// remembered, as for pictures: then the window speaks English.
    pub fn start(
        context: &egui::Context,
        graphics: Option<&egui_wgpu::RenderState>,
        stored: Option<String>,
        start: Start,
    ) -> Result<Self, StartError> {
        theme::install(context);
        let japanese_font = crate::ui::japanese_font::install(context);
        let remembers = stored.is_some() && start.recipe.is_none();
        let (settings, refused) = stored.map_or_else(Default::default, |text| Settings::remembered(&text));
        let library = start.library.map_or_else(|| Library::embedded().map(Arc::new), Ok)?;
        let mut session = Session::new(Arc::clone(&library), &settings.choice)
            .or_else(|_| Session::new(library, &Default::default()))?;
        session.set_speed(settings.speed);
        if let Some(recipe) = start.recipe {
            session.play(recipe)?;
        }
        let mut software = false;
        if let Some(state) = graphics {
            SceneCallback::install(state);
            GroundCallback::install(state);
            MirrorCallback::install(state);
            software = state.adapter.get_info().device_type == wgpu::DeviceType::Cpu;
        }
        let language = settings.language;
        let first_steps = remembers && !settings.introduced;
        let mut app = Self {
            session,
            settings,
            stage: Stage::default(),
            camera: Camera::three_quarter(),
            camera_preset: 0,
            slice: None,
            help: false,
            settings_open: false,
            notice: Notice::default(),
            motions: Motions::default(),
            scene: SceneView::default(),
            inside: Default::default(),
            drawer: Default::default(),
            unfolded: BTreeSet::new(),
            count: 1,
            pan_keys: PanKeys::default(),
            tool_hand: ToolHand::default(),
            portion: Portion::default(),
            pad: Pad::default(),
            #[cfg(not(target_arch = "wasm32"))]
            hand_choice: Default::default(),
            last_time: None,
            drawable: graphics.is_some(),
            software,
            governor: Governor::new(Quality::Best),
            first_steps,
            japanese_font,
            mirror: MirrorView::default(),
        };
        app.settings.language = Language::English;
        app.set_language(language);
        if refused {
            app.say("notice.settings_refused");
        }
        Ok(app)
    }

    /// The world behind the window.
    pub fn session(&self) -> &Session {
        &self.session
    }

    /// The world behind the window, to drive it from outside.
    pub fn session_mut(&mut self) -> &mut Session {
        &mut self.session
    }

    /// The settings that are remembered.
    pub fn settings(&self) -> &Settings {
        &self.settings
    }

    /// Place of the cut (−1…1), or none.
    pub fn slice(&self) -> Option<f64> {
        self.slice
    }

    /// Chooses how many pieces the pantry adds at once.
    pub fn set_count(&mut self, count: usize) {
        self.count = count;
    }

    /// Chooses the window's language; without a font for Japanese it stays English and says what is missing.
    pub fn set_language(&mut self, language: Language) {
        if language == Language::Japanese && !self.japanese_font {
            self.say("notice.no_font");
            return;
        }
        self.settings.language = language;
    }

    /// Whether the card of the first steps is shown.
    pub fn first_steps_are_open(&self) -> bool {
        self.first_steps
    }

    pub(crate) fn close_first_steps(&mut self) {
        self.first_steps = false;
        self.settings.introduced = true;
    }

    /// Whether the list of keys is open.
    pub fn help_is_open(&self) -> bool {
        self.help
    }

    /// Whether the card of the settings is open.
    pub fn settings_are_open(&self) -> bool {
        self.settings_open
    }

    /// Size at which the scene was drawn last [pixels].
    pub fn scene_size(&self) -> [u32; 2] {
        self.scene.drawn_size
    }

    /// Does one thing, as a button or key asks.
    pub fn act(&mut self, act: Act, ctx: &egui::Context) {
        match act {
            Act::Pause => self.session.set_paused(!self.session.paused),
            Act::Step => self.single_step(),
            Act::Speed(by) => self.change_speed(by),
            Act::Hob(by) => self.change_hob(by),
            Act::HobSet(w) => self.command(&Command::Hob(w)),
            Act::Cloth => {
                let for_s = self.session.kitchen.room().cloth.default_s;
                self.command(&Command::Cool { for_s });
            }
            Act::Put => self.lay_in(&self.its_group()),
            Act::Flip => self.command(&Command::Flip { food: self.handled_id() }),
            Act::Halve => self.command(&Command::Halve { food: self.handled_id(), at: 0.0 }),
            Act::Out => self.command(&Command::Rest { food: self.handled_id(), on: RestOn::Board }),
            Act::Toss => self.command(&Command::Toss { height: TOSS_M }),
            Act::Pour(what) => self.pour(what),
            Act::Portion => self.next_portion(),
            Act::Lid => self.turn_lid(),
            Act::Tool => self.choose_tool(),
            Act::ToolBy(by) => self.with_turner(|turner| turner.shift(glam::DVec3::Z * by)),
            Act::RollBy(by) => self.with_turner(|turner| turner.tilt(by, 0.0)),
            Act::LevelTool => self.with_turner(TurnerPose::level),
            Act::PutAway => self.put_tool_away(),
            Act::NextPiece => self.select_next(),
            Act::Pieces => self.open_left(false, !self.settings.pieces_open),
            Act::Restart => self.restart(),
            Act::View(view) => self.settings.view = view,
            Act::Split => self.toggle_split(),
            Act::Probe => self.place_probe(),
            Act::Map => self.next_map(),
            Act::Scale => self.next_scale(),
            Act::Slice => self.toggle_slice(),
            Act::SliceBy(by) => self.slice = Some((self.slice.unwrap_or(0.0) + by).clamp(-0.95, 0.95)),
            Act::Units => self.settings.fahrenheit = !self.settings.fahrenheit,
            Act::Camera => self.next_camera(),
            Act::Zoom(factor) => self.camera.zoom(factor),
            Act::Orbit(dx, dy) => self.camera.orbit(dx, dy),
            Act::Pantry => self.open_left(!self.settings.pantry_open, false),
            Act::Curves => self.settings.curves_open = !self.settings.curves_open,
            Act::Panels => self.settings.panels_hidden = !self.settings.panels_hidden,
            #[cfg(not(target_arch = "wasm32"))]
            Act::StopHands => self.stop_hands(),
            #[cfg(not(target_arch = "wasm32"))]
            Act::Strings => self.toggle_strings(),
            #[cfg(target_arch = "wasm32")]
            Act::StopHands | Act::Strings => {}
            Act::Picture => crate::ui::save_picture::save_picture(ctx, &self.notice, self.settings.language),
            Act::Mirror => self.toggle_mirror(),
            Act::Help => (self.help, self.settings_open) = (!self.help, false),
            Act::Settings => (self.settings_open, self.help) = (!self.settings_open, false),
            Act::Close => (self.help, self.settings_open, self.scene.placing) = (false, false, false),
        }
    }

    /// Opens one of the panels on the left, or none.
    fn open_left(&mut self, pantry: bool, pieces: bool) {
        (self.settings.pantry_open, self.settings.pieces_open) = (pantry, pieces);
        match (pantry, pieces) {
            (true, _) => self.drawer = panels::Drawer::Food,
            (_, true) => self.drawer = panels::Drawer::Pieces,
            _ => {}
        }
    }

    fn select_next(&mut self) {
        let pieces = self.session.kitchen.pieces();
        let next = if self.session.selected().is_some() { self.session.steak_index() + 1 } else { 0 };
        let id = pieces.get(next).or(pieces.first()).map(|p| p.id.clone());
        self.session.select(id);
    }

    pub(crate) fn steak_id(&self) -> String {
        self.session.steak().map_or_else(|| STEAK.to_owned(), |p| p.id.clone())
    }

    /// Gives the kitchen a command and says so if it refuses.
    pub(crate) fn command(&mut self, command: &Command) {
        let played = self.session.runner.is_some();
        match self.session.command(command) {
            Ok(()) if played => self.say("notice.taken_over"),
            Ok(()) => {}
            Err(refused) => self.say_refused(&refused),
        }
    }

    fn single_step(&mut self) {
        self.session.set_paused(true);
        if let Err(error) = self.session.tick() {
            self.say_trouble(&error);
        }
    }

    /// Says a text that leaves nothing open.
    pub(crate) fn say(&self, key: &'static str) {
        self.notice.say(self.settings.language.text(key));
    }

    /// Says why the kitchen refused.
    pub(crate) fn say_refused(&self, refused: &saute_kitchen::Refused) {
        self.notice.say(crate::words::refusal::words(refused, self.settings.language));
    }

    /// Says what the core could not do; recipes and data have their own words, with file and line.
    pub(crate) fn say_trouble(&self, error: &dyn std::fmt::Display) {
        self.notice.say(self.settings.language.fill("notice.trouble", &[("error", error)]));
    }

    fn change_speed(&mut self, by: i8) {
        let now = SPEEDS.iter().position(|&s| s == self.session.speed).unwrap_or(0) as i8;
        self.set_speed(SPEEDS[(now + by).clamp(0, SPEEDS.len() as i8 - 1) as usize]);
    }

    pub(crate) fn set_speed(&mut self, speed: f64) {
        self.session.set_speed(speed);
        self.settings.speed = speed;
    }

    fn change_hob(&mut self, by: i8) {
        let settings = self.session.kitchen.hob().coil.settings_w.clone();
        let now = self.session.kitchen.hob_w();
        let next = if by > 0 {
            settings.iter().copied().find(|&w| w > now + 0.5)
        } else {
            settings.iter().rev().copied().find(|&w| w < now - 0.5)
        };
        if let Some(w) = next {
            self.command(&Command::Hob(w));
        }
    }

    fn restart(&mut self) {
        if let Err(error) = self.session.restart() {
            self.say_trouble(&error);
        }
        self.motions.clear();
    }

    /// In the pan the cut's face looks towards +x: the eye steps to that side so that it is seen.
    fn toggle_slice(&mut self) {
        self.slice = if self.slice.is_some() { None } else { Some(0.0) };
        let in_pan = self.session.steak().is_some_and(saute_kitchen::Piece::in_pan);
        if self.slice.is_some() && in_pan && !(0.35..2.6).contains(&self.camera.yaw) {
            self.camera.yaw = CUT_YAW;
        }
    }

    /// The look beside the view, or the view alone; where only the look is shown, temperatures come beside it.
    fn toggle_split(&mut self) {
        self.settings.split = !self.settings.is_split();
        if self.settings.split && self.settings.view == View::Look {
            self.settings.view = View::Temperature;
        }
    }

    fn next_map(&mut self) {
        self.settings.map = match self.settings.map {
            TemperatureMap::Uniform => TemperatureMap::Paper2013,
            TemperatureMap::Paper2013 => TemperatureMap::Uniform,
        };
    }

    fn next_camera(&mut self) {
        self.camera_preset = (self.camera_preset + 1) % 3;
        self.camera = [Camera::three_quarter, Camera::above, Camera::close_up][self.camera_preset]();
        if self.camera_preset == 2 {
            self.camera.zoom(self.session.steak().map_or(1.0, nearness));
        }
        let on_board = matches!(self.session.steak().map(|p| p.place), Some(Place::Rest(_) | Place::Waiting));
        if self.camera_preset == 2 && on_board {
            self.camera.target = saute_picture::waiting::FIRST_ON_BOARD;
        }
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
                return self.notice.say(l.fill("notice.wrong_recipe", &parts));
            }
        };
        match self.session.play(recipe) {
            Ok(()) => {
                let title = l.called("recipe", self.session.recipe_title().unwrap_or(file));
                self.notice.say(l.fill("notice.playing", &[("title", &title)]));
            }
            Err(error) => self.say_trouble(&error),
        }
    }

    fn take_keys(&mut self, ctx: &egui::Context) {
        self.settings.size = self.settings.size.by_keys(ctx);
        if ctx.egui_wants_keyboard_input() {
            return;
        }
        let pressed: Vec<Act> = ctx.input(|i| {
            // With Shift, letters move the pan.
            let plain = !i.modifiers.command && !i.modifiers.alt && !i.modifiers.shift;
            let times = |b: &crate::act::Binding| if plain { i.num_presses(b.key) } else { 0 };
            BINDINGS.iter().flat_map(|b| std::iter::repeat_n(b.act, times(b))).collect()
        });
        pressed.into_iter().for_each(|act| self.act(act, ctx));
    }

    #[cfg(not(target_arch = "wasm32"))]
    fn take_dropped_files(&mut self, ctx: &egui::Context) {
        for file in ctx.input(|i| i.raw.dropped_files.clone()) {
            let name = file.path().display().to_string();
            match file.bytes().map(String::from_utf8) {
                Ok(Ok(text)) => self.open_recipe(&text, &name),
                Ok(Err(_)) => self.notice.say(self.settings.language.fill("notice.not_text", &[("file", &name)])),
                Err(error) => {
                    let open: [(&str, &dyn std::fmt::Display); 2] = [("file", &name), ("error", &error)];
                    self.notice.say(self.settings.language.fill("notice.not_read", &open));
                }
            }
        }
    }

    /// Browsers hand files over later, which the page does not wait for yet.
    #[cfg(target_arch = "wasm32")]
    fn take_dropped_files(&mut self, ctx: &egui::Context) {
        if ctx.input(|i| !i.raw.dropped_files.is_empty()) {
            self.say("notice.no_drop");
        }
    }

    fn let_time_pass(&mut self, ctx: &egui::Context) {
        let now = ctx.input(|i| i.time);
        let wall = now - self.last_time.unwrap_or(now);
        self.last_time = Some(now);
        self.take_hands(ctx, wall.clamp(0.0, LONGEST_FRAME_S));
        let begun = Instant::now();
        let passed =
            self.session.advance(Duration::from_secs_f64(wall.max(0.0)), Duration::from_millis(STEP_BUDGET_MS));
        // While time stands still frames come when there is something to see.
        if !self.session.paused {
            self.governor.frame(wall, begun.elapsed().as_secs_f64());
        }
        if let Err(error) = passed {
            self.say_trouble(&error);
        }
        self.motions.advance(&self.session.kitchen, self.session.generation, wall as f32);
        if !self.session.paused || self.motions.moving() {
            ctx.request_repaint();
        } else {
            ctx.request_repaint_after(std::time::Duration::from_millis(250));
        }
    }

    /// Size at which to draw the scene [pixels]: in full, or on a software rasteriser, unless the best is asked for,
    /// scaled down to 960 × 540 at least.
    pub(crate) fn scene_pixels(&self, rect: Rect, pixels_per_point: f32) -> [u32; 2] {
        let (w, h) = (rect.width() * pixels_per_point, rect.height() * pixels_per_point);
        let scaled = self.software && self.quality() < Quality::Best;
        let least = if scaled { (960.0 / w).max(540.0 / h).clamp(0.1, 1.0) } else { 1.0 };
        let most = 2048.0 / w.max(h);
        let scale = least.min(most);
        [(w * scale).round().max(1.0) as u32, (h * scale).round().max(1.0) as u32]
    }

    /// Whether the graphics are software.
    pub(crate) fn software(&self) -> bool {
        self.software
    }

    pub(crate) fn drawable(&self) -> bool {
        self.drawable
    }

    pub(crate) fn places(&self) -> Places {
        let mut places = self.motions.places();
        places.pieces.extend(self.scene.carried.clone());
        places
    }

    /// The eye as the scene is drawn with it.
    pub(crate) fn eye(&self) -> Camera {
        following(&self.camera, self.places().followed(&self.session.kitchen))
    }

    /// One frame: takes input, lets time pass, shows everything.
    pub fn frame(&mut self, ui: &mut Ui) {
        let ctx = ui.ctx().clone();
        self.settings.display(&ctx);
        #[cfg(not(target_arch = "wasm32"))]
        self.take_devices(&ctx);
        self.take_keys(&ctx);
        self.take_dropped_files(&ctx);
        self.let_time_pass(&ctx);
        self.show(ui);
        self.show_mirror(&ctx);
    }

    fn show(&mut self, ui: &mut Ui) {
        let whole = ui.max_rect();
        let layout = Layout::new(whole, &self.settings);
        #[cfg(not(target_arch = "wasm32"))]
        let layout = crate::hand::make_room(layout, &self.session.hands);
        self.session.probes.forget_gone(&self.session.kitchen);
        self.show_scene(ui, &layout);
        if !self.settings.panels_hidden {
            panels::show(self, ui, &layout);
        }
        panels::read_out::show(self, ui, whole);
        panels::badge::show(self, ui, &layout);
        #[cfg(not(target_arch = "wasm32"))]
        crate::hand::show(self, ui, &layout);
        if self.help {
            panels::help::show(self, ui, whole);
        } else if self.settings_open {
            panels::settings_card::show(self, ui, whole);
        } else if self.mirror.card {
            panels::mirror_card::show(self, ui, whole);
        } else if self.first_steps {
            panels::first_steps::show(self, ui, whole);
        }
    }
}

impl eframe::App for SauteApp {
    fn ui(&mut self, ui: &mut Ui, _frame: &mut eframe::Frame) {
        self.frame(ui);
    }

    fn save(&mut self, storage: &mut dyn eframe::Storage) {
        self.settings.choice = if self.session.recipe_title().is_some() {
            self.settings.choice.clone()
        } else {
            self.session.choice().clone()
        };
        if let Ok(text) = serde_json::to_string(&self.settings) {
            storage.set_string(SETTINGS_KEY, text);
        }
    }
}
