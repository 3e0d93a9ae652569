//! Carries out the acts of panels, keys and gamepads.

mod cards;
mod clock;
mod food;
mod learn;
mod look;
mod time;
pub(crate) mod waiting;

use saute_kitchen::Command;

use crate::app::SauteApp;
use crate::app::on_host::OnHost;
use crate::system::IS_PAGE;
use saute_controls::act::{Act, AppAct, Card, CookAct, LearnAct, Setting, TimeAct, ViewAct};
use saute_controls::input::tool_hand::TurnerPose;

/// How long the button bastes [s] (chosen: three or four spoonfuls).
const BASTE_S: f64 = 10.0;

impl SauteApp {
    /// Carries out an act. Only this function lets acts change the window; the matches are exhaustive, one line per act.
    pub fn act(&mut self, act: Act, ctx: &egui::Context) {
        if self.refuses(&act) || self.is_hidden(&act) || self.takes_back_later(&act) || self.puts_off(&act) {
            return;
        }
        match act {
            Act::Cook(act) => self.act_on_cook(act),
            Act::Time(act) => self.act_on_time(act),
            Act::View(act) => self.act_on_view(act, ctx),
            Act::Learn(act) => self.act_on_learning(act, ctx),
            Act::App(act) => self.act_on_app(act, ctx),
        }
    }

    /// With food, pan, hob and tools.
    fn act_on_cook(&mut self, act: CookAct) {
        match act {
            CookAct::Hob(by) => self.change_hob(by),
            CookAct::HobSet(w) => self.command(&Command::Hob(w)),
            CookAct::HobHold(c) => self.hold_pan_at(c),
            CookAct::Cloth => self.cool_with_cloth(),
            CookAct::Put => self.lay_in(&self.session.its_group()),
            CookAct::Lay(ids) => self.lay_in(&ids),
            CookAct::Heap(ids) => self.heap_in(&ids),
            CookAct::Remove(ids) => self.session.remove(&ids),
            CookAct::Flip => self.command(&Command::Flip { food: self.handled_id() }),
            CookAct::Asked(question) => self.do_asked(question),
            CookAct::Halve => self.halve(),
            CookAct::Out => self.take_out(),
            CookAct::Toss => self.toss(),
            CookAct::Pour(what) => self.pour(what),
            CookAct::Portion => self.next_portion(),
            CookAct::Lid => self.turn_lid(),
            CookAct::Baste => self.command(&Command::Baste { food: self.handled_id(), for_s: BASTE_S }),
            CookAct::Wipe => self.command(&Command::Wipe),
            CookAct::Tool => self.choose_tool(),
            CookAct::ToolBy(by) => self.with_turner(|turner| turner.shift(glam::DVec3::Z * by)),
            CookAct::RollBy(by) => self.with_turner(|turner| turner.tilt(by, 0.0)),
            CookAct::LevelTool => self.with_turner(TurnerPose::level),
            CookAct::PutAway => self.put_tool_away(),
            CookAct::SetOut(count) => self.set_out_by_hand(count),
            CookAct::Add(count) => self.add(count),
            CookAct::Play(id) => self.play(&id),
            CookAct::ResumeRecipe => self.resume_recipe(),
            CookAct::Restart => self.restart(),
        }
    }

    /// With the time of the cook.
    fn act_on_time(&mut self, act: TimeAct) {
        match act {
            TimeAct::Pause => self.session.set_paused(!self.session.paused),
            TimeAct::Step => self.single_step(),
            TimeAct::Speed(by) => self.change_speed(by),
            TimeAct::SpeedSet(speed) => self.set_speed(speed),
            TimeAct::SpeedEased => self.ease_speed(),
            TimeAct::GoOn(goes_on) => self.decide_on_offer(goes_on),
            TimeAct::Undo => self.undo(),
            TimeAct::Redo => self.redo(),
            TimeAct::Scrub(time_s) => self.scrub(time_s),
            TimeAct::TryFrom(time_s) => self.try_from(time_s),
            TimeAct::HoldTime(held) => self.session.hold_time(held),
            TimeAct::Branch(place) => self.go_to_branch(place),
        }
    }

    /// With what is seen.
    fn act_on_view(&mut self, act: ViewAct, ctx: &egui::Context) {
        // What shows more than a first cook has is shown among all controls.
        self.settings.few &= !(act.traits().reads || act == ViewAct::Pantry);
        match act {
            ViewAct::NextPiece => self.select_next(),
            ViewAct::Select(id) => self.session.select(Some(id)),
            ViewAct::Pieces => self.open_left(false, !self.settings.pieces_open),
            ViewAct::SideBySide => self.toggle_ways(),
            ViewAct::View(view) => self.settings.view = view,
            ViewAct::Split => self.toggle_split(),
            ViewAct::Probe => self.place_probe(),
            ViewAct::Placing(on) => self.sights.scene.placing = on,
            ViewAct::SelectProbe(number) => self.session.probes.selected = number,
            ViewAct::NameProbe(number, name) => self.session.probes.rename(number, name),
            ViewAct::RemoveProbe(number) => self.session.probes.remove(number),
            ViewAct::Map => self.next_map(),
            ViewAct::Scale => self.next_scale(),
            ViewAct::Slice => self.toggle_slice(),
            ViewAct::SliceBy(by) => self.shift_slice(by),
            ViewAct::SliceAt(place) => self.sights.slice = Some(place),
            ViewAct::Units => self.settings.fahrenheit = !self.settings.fahrenheit,
            ViewAct::Camera => self.next_camera(),
            ViewAct::Eye(view) => self.look_from(view),
            ViewAct::Zoom(factor) => self.zoom(factor),
            ViewAct::Orbit(dx, dy) => self.orbit(dx, dy),
            ViewAct::Pantry => self.open_left(!self.settings.pantry_open, false),
            ViewAct::Curves => self.settings.curves_open = !self.settings.curves_open,
            ViewAct::Panels => self.settings.toggle_panels(),
            ViewAct::Projector => self.toggle_projector(),
            ViewAct::More => self.more_or_few(ctx),
            ViewAct::Strings => self.toggle_strings(),
        }
    }

    /// With what leads, and with what is searched for.
    fn act_on_learning(&mut self, act: LearnAct, ctx: &egui::Context) {
        match act {
            LearnAct::Tutorial(on) => self.set_tutorial(on),
            LearnAct::Guided(act) => self.guided_act(act, ctx),
            LearnAct::Plan(act) => self.act_on_plan(act, ctx),
            LearnAct::AtHome(act) => self.act_on_home(act),
        }
    }

    /// With cards, files, pictures, devices and settings.
    fn act_on_app(&mut self, act: AppAct, ctx: &egui::Context) {
        match act {
            AppAct::ChooseFile => self.choose_file(ctx),
            AppAct::Export(what) => self.export(what, ctx),
            AppAct::CopyLink => self.copy_link(ctx),
            AppAct::StopHands => self.stop_hands(),
            AppAct::Picture => self.take_picture(ctx),
            AppAct::Photo => self.turn_photo_mode(ctx),
            AppAct::Host(act) => self.act_on_host(act, ctx),
            // A page has one canvas.
            AppAct::Mirror if IS_PAGE => self.say("settings.native_only"),
            AppAct::Mirror => self.toggle_mirror(),
            AppAct::MirrorWindow(open) => (self.sights.mirror.open, self.sights.mirror.full) = (open, false),
            AppAct::Calibrate(on) => self.calibrate_mirror(on),
            AppAct::ReadRig => self.sights.mirror.forget_rig(),
            AppAct::ShareResult => self.share_result(),
            AppAct::Set(setting) => self.set(setting),
            AppAct::Hear(example) => self.play_example(example, ctx),
            AppAct::Say(text) => self.desk.notice.say(text),
            AppAct::Open(card) => self.open_card(card),
            AppAct::Shut(card) => self.shut_card(card),
            AppAct::Help => self.toggle_card(Card::Help),
            AppAct::Messages => self.toggle_card(Card::Messages),
            AppAct::Settings => self.toggle_card(Card::Settings),
            AppAct::Close => self.close_all(),
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
            Setting::Sound(on) => self.settings.sound = on,
            Setting::Volume(volume) => self.settings.volume = volume.clamp(0.0, 1.0),
        }
    }
}
