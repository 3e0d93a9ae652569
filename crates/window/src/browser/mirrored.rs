//! The panels a second time, as HTML beside the canvas: what egui tells screen readers goes to the page's script, and what is done
//! there comes back.

use std::sync::{Arc, Mutex};

use egui::accesskit::{Action, ActionData, ActionRequest, NodeId, TreeId, TreeUpdate};
use egui::{Context, Event, FullOutput, RawInput};
use web_time::{Duration, Instant};

use crate::app::SauteApp;
use crate::controls::controls;
use crate::words::told::told;

/// Time between two looks at the panels (chosen: a screen reader speaks no faster, and looks cost time).
const LOOK_EVERY: Duration = Duration::from_millis(250);
/// Time between two descriptions of the cook (chosen: one is heard to its end before the next begins).
const TELL_EVERY: Duration = Duration::from_secs(5);

/// What goes between the plugin, which egui owns, and the window.
#[derive(Default)]
struct Passed {
    tree: Option<TreeUpdate>,
    asked: Vec<ActionRequest>,
    looked: Option<Instant>,
    ctx: Option<Context>,
}

/// The window's side.
#[derive(Clone, Default)]
pub(crate) struct Mirrored {
    passed: Arc<Mutex<Passed>>,
    shown: String,
    told: Option<Instant>,
}

impl Mirrored {
    /// Listens to a context from now on.
    pub fn listen(&self, ctx: &Context) {
        ctx.add_plugin(Listener(Arc::clone(&self.passed)));
        if let Ok(mut passed) = self.passed.lock() {
            passed.ctx = Some(ctx.clone());
        }
    }

    fn ask(&self, request: ActionRequest) {
        let Ok(mut passed) = self.passed.lock() else { return };
        passed.asked.push(request);
        drop(passed);
        self.wake();
    }

    /// Lets a frame be drawn soon.
    fn wake(&self) {
        if let Ok(passed) = self.passed.lock()
            && let Some(ctx) = &passed.ctx
        {
            ctx.request_repaint();
        }
    }

    fn take_tree(&self) -> Option<TreeUpdate> {
        self.passed.lock().ok()?.tree.take()
    }
}

/// The part that egui calls.
struct Listener(Arc<Mutex<Passed>>);

impl egui::Plugin for Listener {
    fn debug_name(&self) -> &'static str {
        "mirrored controls"
    }

    fn input_hook(&mut self, ctx: &Context, input: &mut RawInput) {
        let Ok(mut passed) = self.0.lock() else { return };
        input.events.extend(passed.asked.drain(..).map(Event::AccessKitActionRequest));
        // The tree costs time; few frames make one.
        if passed.looked.is_none_or(|at| at.elapsed() >= LOOK_EVERY) {
            passed.looked = Some(Instant::now());
            ctx.enable_accesskit();
        } else {
            ctx.disable_accesskit();
        }
    }

    fn output_hook(&mut self, _: &Context, output: &mut FullOutput) {
        let Some(tree) = output.platform_output.accesskit_update.take() else { return };
        if let Ok(mut passed) = self.0.lock() {
            passed.tree = Some(tree);
        }
    }
}

impl SauteApp {
    /// Shows the page what the panels show, if that is new, and tells it now and then how the cook stands.
    pub(crate) fn show_mirrored(&mut self) {
        let Some(host) = &self.host else { return };
        if let Some(tree) = self.mirrored.take_tree()
            && let Ok(text) = serde_json::to_string(&controls(&tree))
            && text != self.mirrored.shown
        {
            host.show_controls(&text);
            self.mirrored.shown = text;
        }
        if self.mirrored.told.is_none_or(|at| at.elapsed() >= TELL_EVERY) {
            self.mirrored.told = Some(Instant::now());
            let said = self.notice.current().map(|said| said.text).unwrap_or_default();
            host.tell(&told(&self.session, &self.settings), &said);
        }
    }

    /// Draws a frame soon: something has come for the window.
    pub fn wake(&self) {
        self.mirrored.wake();
    }

    /// Presses a control of the page.
    pub fn press_control(&self, id: &str) {
        self.ask_control(id, Action::Click, None);
    }

    /// Sets what a control of the page holds: a text, else a number.
    pub fn set_control(&self, id: &str, value: &str, is_text: bool) {
        let number = value.parse().ok().filter(|_| !is_text).map(ActionData::NumericValue);
        let data = number.unwrap_or_else(|| ActionData::Value(value.into()));
        self.ask_control(id, Action::SetValue, Some(data));
    }

    fn ask_control(&self, id: &str, action: Action, data: Option<ActionData>) {
        let Ok(number) = id.parse() else { return };
        let target_node = NodeId(number);
        self.mirrored.ask(ActionRequest { action, target_tree: TreeId::ROOT, target_node, data });
    }
}
