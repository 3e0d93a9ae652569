//! One frame of the window: input, time, scene and panels.

use egui::Ui;
use saute_recipe::session::session_file::is_session;
use web_time::{Duration, Instant};

use super::SauteApp;
use super::on_host::OnHost;
use crate::panels;
use crate::system::IS_PAGE;
use crate::ui::fingers;
use crate::ui::layout::Layout;
use saute_controls::act::{Act, Acts, AppAct, Card};
use saute_session::MOST_OWED_S;
use saute_session::forecasts::Shown;
use saute_session::guided::Guided;

/// Longest that one frame may spend on stepping the world [ms] (chosen: half a frame at 25 frames a second).
const STEP_BUDGET_MS: u64 = 20;
/// In a browser, where another process draws, and where a study's speed is kept, stepping may take this share of a slow frame [-], up
/// to this long [s] (chosen: five times real time is sustained at a few frames a second, and the page still answers).
const STEP_SHARE: f64 = 0.5;
const LONGEST_STEPPING_S: f64 = 0.15;
/// Held keys move the pan no further at once than in this time [s] (chosen: a slow frame makes no leap).
const LONGEST_FRAME_S: f64 = 0.1;

impl SauteApp {
    /// One frame: takes input, lets time pass, shows everything.
    pub fn frame(&mut self, ui: &mut Ui) {
        let ctx = ui.ctx().clone();
        self.sights.scene.rests = self.sights.scene.rest.is_final() && !ctx.requested_repaint_last_pass();
        crate::ui::display::display(&self.settings, &ctx);
        fingers::note(&ctx, false);
        self.shake_pad(&ctx);
        self.take_devices(&ctx);
        self.take_keys(&ctx);
        self.take_dropped_files(&ctx);
        self.take_news(&ctx);
        self.build_foods(&ctx);
        self.let_time_pass(&ctx);
        self.guide(&ctx);
        self.follow_plan(&ctx);
        self.follow_fit(&ctx);
        self.keep_cook(false);
        self.show(ui);
        self.sound(&ctx);
        self.inputs.tab_end.look(&ctx);
        self.publish_frame();
        self.show_mirror(&ctx);
    }

    fn show(&mut self, ui: &mut Ui) {
        let whole = ui.max_rect();
        let hands = (fingers::are_used(ui.ctx()), self.leads.guided.is_some());
        let layout = Layout::used_by(whole, &self.settings, hands);
        let layout = self.make_room(layout);
        let layout = if self.photo_is_open() { layout.bare() } else { layout };
        let layout = if self.reads_out() { layout } else { layout.without_inside() };
        self.session.probes.forget_gone(&self.session.kitchen);
        let layout = self.lay_out_ways(layout);
        self.show_scene(ui, &layout);
        let acts = self.show_panels(ui, &layout);
        if !acts.is_empty() {
            ui.ctx().request_repaint();
        }
        acts.into_iter().for_each(|act| self.act(act, ui.ctx()));
    }

    /// Shows the panels and cards; returns the requested acts.
    fn show_panels(&mut self, ui: &mut Ui, layout: &Layout) -> Acts {
        let found = self.find_out();
        let mut acts = Acts::new();
        let (parts, memory) = self.parts(&found);
        panels::show_all(&parts, memory, ui, &mut acts, layout);
        self.pulse_at_goal(found.alarm);
        self.ease(found.keeping.is_none() && self.needs_hand(&found.advised, found.rise));
        self.tutor(&found.advised);
        self.watch_result(&found.advised);
        acts
    }

    /// Opens what was read of a recipe's or a session's file, or of a thermometer's log, or states why it cannot.
    pub(crate) fn take_file(&mut self, name: &str, read: Result<Vec<u8>, String>) {
        if self.refuses(&Act::App(AppAct::ChooseFile)) {
            return;
        }
        self.shut_card(Card::Files);
        let read = match read {
            Ok(bytes) if is_session(&bytes) => return self.open_session(name, &bytes),
            Ok(bytes) if is_table(name) => return self.open_log(name, &bytes),
            read => read,
        };
        match read.map(String::from_utf8) {
            Ok(Ok(text)) if self.desk.card == Some(Card::AtHome) => self.take_cooked(name, &text),
            Ok(Ok(text)) => self.open_recipe(&text, name),
            Ok(Err(_)) => self.desk.notice.say(self.settings.language.fill("notice.not_text", &[("file", &name)])),
            Err(error) => {
                let open: [(&str, &dyn std::fmt::Display); 2] = [("file", &name), ("error", &error)];
                self.desk.notice.say(self.settings.language.fill("notice.not_read", &open));
            }
        }
    }

    /// Behind a card nothing is missed; a trial whose time cannot be stopped goes on.
    pub(super) fn time_waits(&self) -> bool {
        self.card_is_open() && self.leads.guided.as_ref().is_none_or(Guided::time_waits)
    }

    fn let_time_pass(&mut self, ctx: &egui::Context) {
        let now = ctx.input(|i| i.time);
        // A longer gap is a tab that was hidden, or a machine that slept: nobody saw it.
        let since = now - self.pace.last_time.unwrap_or(now);
        let wall = since.clamp(0.0, MOST_OWED_S);
        self.pace.last_time = Some(now);
        self.take_hands(ctx, wall.min(LONGEST_FRAME_S));
        let begun = Instant::now();
        self.session.permits = self.permits();
        let waits = self.time_waits();
        let passes = if waits { 0.0 } else { wall };
        let holds_speed = self.leads.guided.as_ref().is_some_and(Guided::holds_speed);
        let before_s = self.session.kitchen.time_s();
        let passed = self.session.advance(Duration::from_secs_f64(passes), step_budget(wall, holds_speed));
        if !self.session.paused && !waits {
            self.note_pace(since, self.session.kitchen.time_s() - before_s);
        }
        self.pace.meter.frame(now, self.session.kitchen.time_s());
        // While time is stopped frames come when there is something to see.
        if !self.session.paused && !waits {
            self.graphics.governor.frame(wall, begun.elapsed().as_secs_f64());
        }
        self.do_what_waited(ctx);
        // Studies and lessons contain questions about what will come.
        let shown = match self.settings.foresees() && self.leads.guided.is_none() {
            true if self.settings.curves_open => Shown::Table,
            true => Shown::Line,
            false => Shown::Nothing,
        };
        self.session.foresee(now, shown, &self.settings.scale);
        self.keep_ways_beside(wall);
        self.keep_up(passes);
        if let Err(error) = passed {
            self.say_trouble(&error);
        }
        self.sights.motions.jumps = crate::ui::display::moves_less(&self.settings);
        self.sights.motions.advance(&self.session.kitchen, self.session.generation, wall as f32);
        self.move_eye(wall as f32);
        if !(self.session.paused || waits)
            || self.sights.motions.moving()
            || self.sights.glance.is_some()
            || self.session.is_travelling()
            || self.sights.ways.catch_up
            || self.session.forecasts().need_frames()
            || ((self.sights.scene.rest.at_once || self.samples() > 1) && !self.sights.scene.rest.is_final())
        {
            ctx.request_repaint();
        } else {
            ctx.request_repaint_after(std::time::Duration::from_millis(250));
        }
    }
}

/// True for the names of tables, as thermometers write their logs; those included that a log's reader refuses by their kind.
fn is_table(name: &str) -> bool {
    let name = name.to_lowercase();
    [".csv", ".tsv", ".txt", ".log", ".json", ".xlsx", ".xls", ".ods"].iter().any(|ending| name.ends_with(ending))
}

/// How long a frame may spend on stepping the world, when the last one took `wall_s`. A speed that is to be kept takes precedence over smooth
/// frames.
pub(crate) fn step_budget(wall_s: f64, holds_speed: bool) -> Duration {
    let least = Duration::from_millis(STEP_BUDGET_MS);
    let share = Duration::from_secs_f64((STEP_SHARE * wall_s).clamp(0.0, LONGEST_STEPPING_S));
    if IS_PAGE || holds_speed { least.max(share) } else { least }
}
