//! Carries out the acts of panels, keys and gamepads.

mod cards;
mod clock;
mod food;
mod learn;
mod look;
mod time;
pub(crate) mod waiting;

use saute_kitchen::Command;

use crate::act::{Act, Card, Setting};
use crate::app::SauteApp;
use crate::input::tool_hand::TurnerPose;

/// Height of a toss by key [m] (chosen: over the rim, within reach).
const TOSS_M: f64 = 0.12;

impl SauteApp {
    /// Carries out an act. Only this function lets acts change the window; the match is exhaustive, one line per act.
    pub fn act(&mut self, act: Act, ctx: &egui::Context) {
        if self.refuses(&act) || self.is_hidden(&act) || self.puts_off(&act) {
            return;
        }
        match act {
            Act::Pause => self.session.set_paused(!self.session.paused),
            Act::Step => self.single_step(),
            Act::Speed(by) => self.change_speed(by),
            Act::SpeedSet(speed) => self.set_speed(speed),
            Act::Hob(by) => self.change_hob(by),
            Act::HobSet(w) => self.command(&Command::Hob(w)),
            Act::HobHold(c) => self.hold_pan_at(c),
            Act::Cloth => self.cool_with_cloth(),
            Act::Put => self.lay_in(&self.session.its_group()),
            Act::Lay(ids) => self.lay_in(&ids),
            Act::Heap(ids) => self.heap_in(&ids),
            Act::Remove(ids) => self.session.remove(&ids),
            Act::Flip => self.command(&Command::Flip { food: self.handled_id() }),
            Act::Asked(question) => self.do_asked(question),
            Act::Halve => self.halve(),
            Act::Out => self.take_out(),
            Act::Toss => self.command(&Command::Toss { height: TOSS_M }),
            Act::Pour(what) => self.pour(what),
            Act::Portion => self.next_portion(),
            Act::Lid => self.turn_lid(),
            #[cfg(target_arch = "wasm32")]
            Act::TiltPhone => self.tilt_phone(),
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
            Act::ResumeRecipe => self.resume_recipe(),
            Act::ChooseFile => self.choose_file(ctx),
            Act::Export(what) => self.export(what, ctx),
            Act::CopyLink => self.copy_link(),
            #[cfg(not(target_arch = "wasm32"))]
            Act::OpenFile(path) => self.open_file(&path),
            #[cfg(not(target_arch = "wasm32"))]
            Act::ShowFile(path) => self.show_file(&path),
            Act::Pieces => self.open_left(false, !self.settings.pieces_open),
            Act::Restart => self.restart(),
            Act::GoOn(goes_on) => self.decide_on_offer(goes_on),
            Act::Undo => self.undo(),
            Act::Redo => self.redo(),
            Act::Scrub(time_s) => self.scrub(time_s),
            Act::HoldTime(held) => self.session.hold_time(held),
            Act::Branch(place) => self.go_to_branch(place),
            Act::SideBySide => self.toggle_ways(),
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
            Act::SliceBy(by) => self.shift_slice(by),
            Act::SliceAt(place) => self.slice = Some(place),
            Act::Units => self.settings.fahrenheit = !self.settings.fahrenheit,
            Act::Camera => self.next_camera(),
            Act::Eye(view) => self.look_from(view),
            Act::Zoom(factor) => self.zoom(factor),
            Act::Orbit(dx, dy) => self.orbit(dx, dy),
            Act::Pantry => self.open_left(!self.settings.pantry_open, false),
            Act::Curves => self.settings.curves_open = !self.settings.curves_open,
            Act::Panels => self.settings.panels_hidden = !self.settings.panels_hidden,
            #[cfg(not(target_arch = "wasm32"))]
            Act::StopHands => self.stop_hands(),
            #[cfg(not(target_arch = "wasm32"))]
            Act::ResumeHands => self.resume_hands(),
            #[cfg(not(target_arch = "wasm32"))]
            Act::Strings => self.toggle_strings(),
            #[cfg(not(target_arch = "wasm32"))]
            Act::Connect { role, device, pairing } => self.connect_hand(role, &device, pairing),
            #[cfg(not(target_arch = "wasm32"))]
            Act::Disconnect(role) => self.session.hands.disconnect(role),
            #[cfg(target_arch = "wasm32")]
            Act::StopHands | Act::Strings => {}
            #[cfg(not(target_arch = "wasm32"))]
            Act::Picture if self.photo.open => self.take_photo(ctx),
            Act::Picture => self.save_picture(ctx),
            #[cfg(target_arch = "wasm32")]
            Act::Photo => self.say("settings.native_only"),
            #[cfg(not(target_arch = "wasm32"))]
            Act::Photo => self.photo.open = !self.photo.open,
            #[cfg(not(target_arch = "wasm32"))]
            Act::SetPhoto(choice) => self.photo.choice = choice,
            #[cfg(not(target_arch = "wasm32"))]
            Act::TimeLapse => self.make_time_lapse(ctx),
            Act::Mirror if cfg!(target_arch = "wasm32") => self.say("settings.native_only"),
            Act::Mirror => self.toggle_mirror(),
            Act::MirrorWindow(open) => (self.mirror.open, self.mirror.full) = (open, false),
            Act::Calibrate(on) => self.calibrate_mirror(on),
            Act::ReadRig => self.mirror.forget_rig(),
            Act::ShareResult => self.share_result(),
            Act::Tutorial(on) => self.set_tutorial(on),
            Act::Set(setting) => self.set(setting),
            Act::Guided(act) => self.guided_act(act, ctx),
            Act::Say(text) => self.notice.say(text),
            Act::Plan(act) => self.act_on_plan(act, ctx),
            Act::AtHome(act) => self.act_on_home(act),
            Act::Open(card) => self.open_card(card),
            Act::Shut(card) => self.shut_card(card),
            Act::Help => self.toggle_card(Card::Help),
            Act::Messages => self.toggle_card(Card::Messages),
            Act::Settings => self.toggle_card(Card::Settings),
            Act::Close => self.close_all(),
        }
    }

    /// Changes a remembered setting.
    fn set(&mut self, setting: Setting) {
        match setting {
            Setting::Theme(theme) => self.settings.theme = theme,
            Setting::White(white) => self.settings.white_balance = white,
            Setting::Light(light) => self.settings.light = light,
            Setting::Quality(quality) => self.set_quality(quality),
            Setting::Language(language) => self.set_language(language),
            Setting::Fahrenheit(on) => self.settings.fahrenheit = on,
            Setting::Size(size) => self.settings.size = size,
            Setting::LessMotion(less) => self.settings.less_motion = Some(less),
            Setting::Scale(id) => {
                if let Some(scale) = self.session.library.scale(&id).cloned() {
                    self.choose_scale(&scale);
                }
            }
            Setting::Goal(goal) => {
                if let Some(scale) = self.scale() {
                    self.settings.set_goal(&scale, goal);
                    self.settings.goal_id = None;
                }
            }
            Setting::GoalNamed(id) => self.choose_goal(id),
            Setting::Coach(on) => self.settings.coach = on,
            Setting::ResultOpens(on) => self.settings.result_opens = on,
            Setting::SkillMode(on) => self.set_skill_mode(on),
            Setting::Choice(choice) => self.settings.choice = choice,
            Setting::Forecasts(on) => self.settings.forecasts = on,
            Setting::Mirror(mirror) => self.settings.mirror = *mirror,
        }
    }
}
