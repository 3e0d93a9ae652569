//! Carries out what panels, keys and gamepads ask for.

use saute_kitchen::{Command, Place, RestOn};
use saute_picture::View;
use saute_picture::colour::map::TemperatureMap;
use saute_picture::stage::{CUT_YAW, nearness};
use saute_scene::camera::Camera;

use crate::act::{Act, Card, Setting};
use crate::app::SauteApp;
use crate::input::tool_hand::TurnerPose;
use crate::panels::Drawer;
use crate::session::SPEEDS;
use crate::words::piece_words::name;

/// Height of a toss by key [m] (chosen: over the rim, within reach).
const TOSS_M: f64 = 0.12;
/// Most pieces that the kitchen holds (chosen: what a machine still computes).
const MOST_PIECES: usize = 100;

impl SauteApp {
    /// Does one thing, as a button or key asks. Here alone acts change the window.
    pub fn act(&mut self, act: Act, ctx: &egui::Context) {
        match act {
            Act::Pause => self.session.set_paused(!self.session.paused),
            Act::Step => self.single_step(),
            Act::Speed(by) => self.change_speed(by),
            Act::SpeedSet(speed) => self.set_speed(speed),
            Act::Hob(by) => self.change_hob(by),
            Act::HobSet(w) => self.command(&Command::Hob(w)),
            Act::Cloth => {
                let for_s = self.session.kitchen.room().cloth.default_s;
                self.command(&Command::Cool { for_s });
            }
            Act::Put => self.lay_in(&self.session.its_group()),
            Act::Lay(ids) => self.lay_in(&ids),
            Act::Heap(ids) => self.heap_in(&ids),
            Act::Remove(ids) => self.session.remove(&ids),
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
            Act::Select(id) => self.session.select(Some(id)),
            Act::SetOut => self.set_out(),
            Act::Add(count) => self.add(count),
            Act::Play(id) => self.play(&id),
            Act::Pieces => self.open_left(false, !self.settings.pieces_open),
            Act::Restart => self.restart(),
            Act::View(view) => self.settings.view = view,
            Act::Split => self.toggle_split(),
            Act::Probe => self.place_probe(),
            Act::Placing(on) => self.scene.placing = on,
            Act::SelectProbe(number) => self.session.probes.selected = number,
            Act::NameProbe(number, name) => self.session.probes.rename(number, name),
            Act::RemoveProbe(number) => self.session.probes.remove(number),
            Act::Map => self.next_map(),
            Act::Scale => self.next_scale(),
            Act::Slice => self.toggle_slice(),
            Act::SliceBy(by) => self.slice = Some((self.slice.unwrap_or(0.0) + by).clamp(-0.95, 0.95)),
            Act::SliceAt(place) => self.slice = Some(place),
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
            #[cfg(not(target_arch = "wasm32"))]
            Act::Connect { role, device, pairing } => self.connect_hand(role, &device, pairing),
            #[cfg(not(target_arch = "wasm32"))]
            Act::Disconnect(role) => self.session.hands.disconnect(role),
            #[cfg(target_arch = "wasm32")]
            Act::StopHands | Act::Strings => {}
            Act::Picture => crate::ui::save_picture::save_picture(ctx, &self.notice, self.settings.language),
            Act::Mirror => self.toggle_mirror(),
            Act::MirrorWindow(open) => (self.mirror.open, self.mirror.full) = (open, false),
            Act::Calibrate(on) => {
                self.mirror.calibrating = on;
                self.mirror.open |= on;
            }
            Act::ReadRig => self.mirror.forget_rig(),
            Act::Set(setting) => self.set(setting),
            Act::Say(text) => self.notice.say(text),
            Act::Open(card) => self.open_card(card),
            Act::Shut(card) => self.shut_card(card),
            Act::Help => (self.help, self.settings_open) = (!self.help, false),
            Act::Settings => {
                (self.settings_open, self.help) = (!self.settings_open, false);
                self.mirror.card &= !self.settings_open;
            }
            Act::Close => (self.help, self.settings_open, self.scene.placing) = (false, false, false),
        }
    }

    /// Changes a remembered setting.
    fn set(&mut self, setting: Setting) {
        match setting {
            Setting::Theme(theme) => self.settings.theme = theme,
            Setting::White(white) => self.settings.white_balance = white,
            Setting::Quality(quality) => self.set_quality(quality),
            Setting::Language(language) => self.set_language(language),
            Setting::Fahrenheit(on) => self.settings.fahrenheit = on,
            Setting::Size(size) => self.settings.size = size,
            Setting::Scale(id) => {
                if let Some(scale) = self.session.library.scale(&id).cloned() {
                    self.choose_scale(&scale);
                }
            }
            Setting::Goal(celsius) => self.settings.goal_c = celsius,
            Setting::Choice(choice) => self.settings.choice = choice,
            Setting::Mirror(mirror) => self.settings.mirror = *mirror,
        }
    }

    fn open_card(&mut self, card: Card) {
        (self.help, self.settings_open) = (card == Card::Help, card == Card::Settings);
        self.mirror.card |= card == Card::Mirror;
        self.first_steps |= card == Card::FirstSteps;
    }

    fn shut_card(&mut self, card: Card) {
        match card {
            Card::Help => self.help = false,
            Card::Settings => self.settings_open = false,
            Card::Mirror => self.mirror.card = false,
            Card::FirstSteps => self.close_first_steps(),
        }
    }

    /// Opens one of the panels on the left, or none.
    fn open_left(&mut self, pantry: bool, pieces: bool) {
        (self.settings.pantry_open, self.settings.pieces_open) = (pantry, pieces);
        match (pantry, pieces) {
            (true, _) => self.memory.drawer = Drawer::Food,
            (_, true) => self.memory.drawer = Drawer::Pieces,
            _ => {}
        }
    }

    fn select_next(&mut self) {
        let pieces = self.session.kitchen.pieces();
        let next = if self.session.selected().is_some() { self.session.steak_index() + 1 } else { 0 };
        let id = pieces.get(next).or(pieces.first()).map(|p| p.id.clone());
        self.session.select(id);
    }

    /// Starts over with the chosen food and pan.
    fn set_out(&mut self) {
        match self.session.set_out(&self.settings.choice) {
            Ok(()) => self.motions.clear(),
            Err(error) => self.say_trouble(&error),
        }
    }

    /// Sets more food out; nothing of it is in the pan yet.
    fn add(&mut self, count: usize) {
        let (here, l) = (self.session.kitchen.pieces().len(), self.settings.language);
        if here + count > MOST_PIECES {
            let room = MOST_PIECES.saturating_sub(here);
            self.notice.say(l.fill("pantry.full", &[("most", &MOST_PIECES), ("room", &room)]));
            return;
        }
        match self.session.add(&self.settings.choice, count) {
            Ok(group) => {
                let first = self.session.members(&group).into_iter().next();
                self.session.select(first);
                self.notice.say(l.fill("pantry.added", &[("count", &count), ("food", &name(&group, l))]));
            }
            Err(error) => self.say_trouble(&error),
        }
    }

    /// Plays a recipe of the library.
    fn play(&mut self, id: &str) {
        let library = std::sync::Arc::clone(&self.session.library);
        if let Some(text) = library.recipes.get(id) {
            self.open_recipe(text, &format!("{id}.toml"));
        }
    }

    fn single_step(&mut self) {
        self.session.set_paused(true);
        if let Err(error) = self.session.tick() {
            self.say_trouble(&error);
        }
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

    /// The look beside the view, or the view alone; where only the look is shown, temperatures come next to it.
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
}
