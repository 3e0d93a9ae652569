//! The panels a second time, as HTML beside the canvas: what egui tells screen readers goes to the page's script, and what is done
//! there comes back.

use std::sync::{Arc, Mutex};

use egui::accesskit::{Action, ActionData, ActionRequest, NodeId, TreeId};
use egui::{Context, Event, FullOutput, RawInput};
use web_time::{Duration, Instant};

use crate::app::SauteApp;
use crate::controls::{Control, Identity, controls};
use crate::spoken::told::told;

/// Time between two looks at the panels (chosen: a screen reader speaks no faster, and looks cost time).
const LOOK_EVERY: Duration = Duration::from_millis(250);
/// Time between two descriptions of the cook (chosen: one is heard to its end before the next begins).
const TELL_EVERY: Duration = Duration::from_secs(5);

/// What was done to a control of the page.
struct Asked {
    control: Identity,
    action: Action,
    data: Option<ActionData>,
}

impl Asked {
    fn request(&self, id: &str) -> Option<ActionRequest> {
        let target_node = NodeId(id.parse().ok()?);
        Some(ActionRequest { action: self.action, target_tree: TreeId::ROOT, target_node, data: self.data.clone() })
    }
}

/// What goes between the plugin, which egui owns, and the window.
#[derive(Default)]
struct Passed {
    /// What the panels show, since it was last looked at.
    seen: Option<Vec<Control>>,
    /// What the page shows.
    shown: Vec<Control>,
    /// What was done to that, until the panels are looked at anew.
    asked: Vec<Asked>,
    /// Where to do it in the panels: the ids that the controls had when they were looked at.
    found: Vec<(String, Asked)>,
    looked: Option<Instant>,
    ctx: Option<Context>,
}

impl Passed {
    /// What is under way to a control needs the panels of each frame.
    fn is_under_way(&self) -> bool {
        !self.asked.is_empty() || !self.found.is_empty()
    }

    /// Finds the controls that were pressed in the present panels; what is gone by now is not pressed.
    fn find(&mut self, now: &[Control]) {
        // Where the panels had numbered anew in the very frame in which it was done, it was missed.
        let is_missed = |id: &str, asked: &Asked| asked.control.find(now).is_some_and(|control| control.id != id);
        let missed = std::mem::take(&mut self.found).into_iter().filter(|(id, asked)| is_missed(id, asked));
        let asked = missed.map(|(_, asked)| asked).chain(self.asked.drain(..));
        self.found = asked.filter_map(|asked| Some((asked.control.find(now)?.id.clone(), asked))).collect();
    }
}

/// The window's side.
#[derive(Clone, Default)]
pub(crate) struct Mirrored {
    passed: Arc<Mutex<Passed>>,
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

    fn ask(&self, id: &str, action: Action, data: Option<ActionData>) {
        let Ok(mut passed) = self.passed.lock() else { return };
        // Now, while the page shows what it was pressed in.
        let Some(control) = Identity::of(id, &passed.shown) else { return };
        passed.asked.push(Asked { control, action, data });
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

    /// What the page is to show, if that is new.
    fn news(&self) -> Option<String> {
        let mut passed = self.passed.lock().ok()?;
        let seen = passed.seen.take().filter(|seen| *seen != passed.shown)?;
        let text = serde_json::to_string(&seen).ok()?;
        passed.shown = seen;
        Some(text)
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
        let requests = passed.found.iter().filter_map(|(id, asked)| asked.request(id));
        input.events.extend(requests.map(Event::AccessKitActionRequest));
        // The tree costs time; few frames make one.
        if passed.is_under_way() || passed.looked.is_none_or(|at| at.elapsed() >= LOOK_EVERY) {
            passed.looked = Some(Instant::now());
            ctx.enable_accesskit();
        } else {
            ctx.disable_accesskit();
        }
    }

    fn output_hook(&mut self, ctx: &Context, output: &mut FullOutput) {
        let Some(tree) = output.platform_output.accesskit_update.take() else { return };
        let Ok(mut passed) = self.0.lock() else { return };
        let seen = controls(&tree);
        passed.find(&seen);
        passed.seen = Some(seen);
        if passed.is_under_way() {
            ctx.request_repaint();
        }
    }
}

impl SauteApp {
    /// Shows the page what the panels show, if that is new, and tells it now and then how the cook stands.
    pub(crate) fn show_mirrored(&mut self) {
        let Some(host) = &self.host else { return };
        if let Some(text) = self.mirrored.news() {
            host.show_controls(&text);
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
        self.mirrored.ask(id, action, data);
    }
}
