//! The panels a second time, as HTML beside the canvas: what egui gives screen readers goes to the page's script, and what is done
//! there comes back.

use egui::accesskit::{Action, ActionData, ActionRequest, NodeId, TreeId};
use egui::{Context, Event, FullOutput, RawInput};
use saute_controls::control_list::{Control, Identity, controls, under_card};
use saute_controls::spoken::announcer::Announcer;
use std::sync::{Arc, Mutex};
use web_time::{Duration, Instant};

/// Time between two looks at the panels (chosen: a screen reader speaks no faster, and looks cost time).
const LOOK_EVERY: Duration = Duration::from_millis(250);

/// What was done to a control of the page.
pub(crate) struct Asked {
    pub(crate) control: Identity,
    pub(crate) action: Action,
    pub(crate) data: Option<ActionData>,
}

impl Asked {
    fn request(&self, id: &str) -> Option<ActionRequest> {
        let target_node = NodeId(id.parse().ok()?);
        Some(ActionRequest { action: self.action, target_tree: TreeId::ROOT, target_node, data: self.data.clone() })
    }
}

/// What goes between the plugin, which egui owns, and the window.
#[derive(Default)]
pub(crate) struct Passed {
    /// What the panels show, since it was last looked at.
    pub(crate) seen: Option<Vec<Control>>,
    /// What the page shows.
    pub(crate) shown: Vec<Control>,
    /// What was done to that, until the panels are looked at again.
    pub(crate) asked: Vec<Asked>,
    /// Where to do it in the panels: the ids that the controls had when they were looked at.
    pub(crate) found: Vec<(String, Asked)>,
    pub(crate) looked: Option<Instant>,
    pub(crate) ctx: Option<Context>,
}

impl Passed {
    /// What is under way to a control needs the panels of each frame.
    fn is_under_way(&self) -> bool {
        !self.asked.is_empty() || !self.found.is_empty()
    }

    /// Finds the controls that were pressed in the present panels; what is gone by now is not pressed.
    fn find(&mut self, now: &[Control]) {
        // Where the panels had changed their numbers in the very frame in which it was done, it was missed.
        let is_missed = |id: &str, asked: &Asked| asked.control.find(now).is_some_and(|control| control.id != id);
        let missed = std::mem::take(&mut self.found).into_iter().filter(|(id, asked)| is_missed(id, asked));
        let asked = missed.map(|(_, asked)| asked).chain(self.asked.drain(..));
        self.found = asked.filter_map(|asked| Some((asked.control.find(now)?.id.clone(), asked))).collect();
    }
}

/// The window's side.
#[derive(Clone, Default)]
pub(crate) struct Mirrored {
    pub(crate) passed: Arc<Mutex<Passed>>,
    pub(crate) told: Option<Instant>,
    pub(crate) announcer: Announcer,
}

impl Mirrored {
    /// Listens to a context from now on.
    pub fn listen(&self, ctx: &Context) {
        ctx.add_plugin(Listener(Arc::clone(&self.passed)));
        if let Ok(mut passed) = self.passed.lock() {
            passed.ctx = Some(ctx.clone());
        }
    }

    pub(crate) fn ask(&self, id: &str, action: Action, data: Option<ActionData>) {
        let Ok(mut passed) = self.passed.lock() else { return };
        // Now, while the page shows what it was pressed in.
        let Some(control) = Identity::of(id, &passed.shown) else { return };
        passed.asked.push(Asked { control, action, data });
        drop(passed);
        self.wake();
    }

    /// Lets a frame be drawn soon.
    pub(crate) fn wake(&self) {
        if let Ok(passed) = self.passed.lock()
            && let Some(ctx) = &passed.ctx
        {
            ctx.request_repaint();
        }
    }

    /// What the page is to show, if that is new; under a card nothing can be used.
    pub(crate) fn news(&self, card_is_open: bool) -> Option<String> {
        let mut passed = self.passed.lock().ok()?;
        let mut seen = passed.seen.take()?;
        if card_is_open {
            under_card(&mut seen);
        }
        let seen = Some(seen).filter(|seen| *seen != passed.shown)?;
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
