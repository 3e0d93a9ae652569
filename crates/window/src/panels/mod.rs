//! The panels around the scene.

pub mod ahead;
pub mod alarm;
pub mod at_home;
pub mod badge;
pub mod cards;
pub mod cook;
pub mod curve;
pub mod curves;
pub mod cut_picture;
pub mod doneness_bar;
pub mod eye_bar;
pub mod guided;
pub(crate) mod host_panels;
pub mod inside;
pub mod learn;
pub mod legend;
pub mod memory;
pub mod now;
pub mod pantry;
pub mod pieces;
pub mod plan;
pub mod probes;
pub mod read_out;
pub mod section_read;
pub mod still;
pub mod top;
pub mod ways;

use egui::{Rect, ScrollArea, Ui, UiBuilder};

use crate::host::CurrentHost;
use crate::paint::ground::GroundCallback;
use crate::panels::at_home::at_home_state::AtHomeState;
use crate::panels::cards::mirror::MirrorState;
use crate::panels::cards::settings::SettingsState;
use crate::panels::cards::{first_steps, goals, help, learn as learn_card, lessons, messages, result, unfinished};
use crate::panels::cook::cook_state::CookState;
use crate::panels::cook::{few_controls, hob_bar, pour, time_strip};
use crate::panels::inside::InsideState;
use crate::panels::memory::{Drawer, PanelMemory};
use crate::panels::top::TopState;
use crate::system::IS_PAGE;
use crate::ui::aloud::name_panel;
use crate::ui::layout::{GAP, Layout};
use crate::ui::scene_view::SceneView;
use crate::ui::{fingers, theme};
use saute_controls::act::{Acts, Card};
use saute_controls::context::PanelContext;
use saute_controls::now::now_state::NowState;
use saute_controls::plan::plan_state::PlanState;
use saute_controls::spoken::notice::{Notice, Said};
use saute_controls::ways_state::WaysState;
use saute_words::judgement_words::ResultWords;

/// Space within a panel of controls for a mouse, and within one for fingers [points].
const MARGIN: i8 = 6;
const WIDE_MARGIN: i8 = 12;

/// Height of the strip of time in the drawer [points].
const STRIP_HEIGHT: f32 = 28.0;

/// What all panels read in a frame: each panel gets its own part, and none gets all of them.
pub struct Parts<'a> {
    /// What every panel reads.
    pub context: PanelContext<'a>,
    /// What the window has of the desktop, or of its page.
    pub host: &'a CurrentHost,
    /// The scene's part of the window.
    pub scene: &'a SceneView,
    /// The card that is open.
    pub card: Option<Card>,
    /// How far a cook came with which the window offers to go on [s].
    pub unfinished_s: Option<f64>,
    /// All notices so far.
    pub said: &'a Notice,
    /// The last notice, while it is still shown.
    pub notice: Option<Said>,
    /// What waits until the instant is reached to which time is turned.
    pub waiting: Vec<String>,
    /// The result in words, while its card is open, and from when the cook is tried again [s].
    pub result: Option<&'a (ResultWords, Option<f64>)>,
    /// For the chips at the top.
    pub top: TopState<'a>,
    /// For the line that states what to do now.
    pub now: NowState<'a>,
    /// For the controls.
    pub cook: CookState<'a>,
    /// For what is inside.
    pub inside: InsideState<'a>,
    /// For ways side by side.
    pub ways: WaysState<'a>,
    /// For the card of the settings.
    pub settings: SettingsState<'a>,
    /// For the card of the half mirror.
    pub mirror: MirrorState<'a>,
    /// For the card of plans.
    pub plan: PlanState<'a>,
    /// For the card of the kitchen at home.
    pub at_home: AtHomeState<'a>,
}

/// Shows all panels, the notices over the scene, and the card that is open.
pub fn show_all(parts: &Parts, memory: &mut PanelMemory, ui: &mut Ui, acts: &mut Acts, layout: &Layout) {
    let (state, whole) = (&parts.context, layout.whole);
    if host_panels::show_instead(state, parts.host, ui, acts, layout) {
        return host_panels::devices(state, ui, acts, layout);
    }
    if let Some(ways) = &layout.ways {
        ways::show(&parts.ways, &mut memory.ways, ui, acts, (whole, ways));
    }
    if !(state.settings.hides_panels() || layout.tiny) {
        show(parts, memory, ui, acts, layout);
    }
    if state.reads_out() {
        read_out::show(state, parts.scene, ui, whole);
    }
    // What is due at the goal, and the words of a plan, are shown with the panels hidden, too; to a class all words are.
    if !state.settings.panels_hidden || parts.now.alarm || parts.now.is_led() {
        now::show(&parts.now, &mut memory.now, ui, acts, layout);
    }
    badge::show(state, parts.notice.as_ref(), &parts.waiting, ui, acts, layout);
    alarm::show(state, ui, acts, whole);
    host_panels::devices(state, ui, acts, layout);
    if guided::show(state, &mut memory.answers, ui, acts, layout) {
        return;
    }
    match (parts.unfinished_s, parts.card) {
        (Some(time_s), _) => unfinished::show(state, time_s, ui, acts, whole),
        (None, Some(card)) => show_card(card, parts, memory, ui, acts, whole),
        (None, None) => {}
    }
}

/// Shows the card that is open.
fn show_card(card: Card, parts: &Parts, memory: &mut PanelMemory, ui: &Ui, acts: &mut Acts, whole: Rect) {
    let state = &parts.context;
    match card {
        Card::Help => help::show(state, parts.host, &mut memory.search, ui, acts, whole),
        Card::Messages => messages::show(state, parts.said, ui, acts, whole),
        Card::Settings => cards::settings::show(&parts.settings, &mut memory.host, ui, acts, whole),
        Card::Mirror => cards::mirror::show(&parts.mirror, ui, acts, whole),
        Card::FirstSteps => first_steps::show(state, parts.settings.japanese_font, ui, acts, whole),
        Card::Learn => learn_card::show(state, ui, acts, whole),
        Card::Files => cards::files::show(state, ui, acts, whole),
        Card::Lessons => lessons::show(state, ui, acts, whole),
        Card::Goals => goals::show(state, ui, acts, whole),
        Card::Result => result::show(state, parts.result, &mut memory.result, ui, acts, whole),
        Card::Plan => plan::card::show(&parts.plan, ui, acts, whole),
        Card::AtHome => at_home::card::show(&parts.at_home, ui, acts, whole),
    }
}

/// Shows all panels.
fn show(parts: &Parts, memory: &mut PanelMemory, ui: &mut Ui, acts: &mut Acts, layout: &Layout) {
    let state = &parts.context;
    if layout.eye.is_positive() {
        eye_bar::show(state, ui, acts, layout.eye);
    }
    let (margin, l) = (if layout.narrow { WIDE_MARGIN } else { MARGIN }, state.settings.language);
    floating(ui, layout.top, (0, margin), ("views", l.text("panel.views")), |ui| match state.settings.few {
        true => top::few(&parts.top, ui, acts),
        false => top::show(&parts.top, ui, acts, layout.narrow),
    });
    if layout.narrow {
        floating(ui, layout.bottom, (1, WIDE_MARGIN), ("drawer", l.text("panel.cook")), |ui| {
            match state.settings.few {
                true => few_drawer(parts, memory, ui, acts),
                false => drawer(parts, memory, ui, acts),
            }
        });
        return;
    }
    if state.settings.few {
        return floating(ui, layout.bottom, (3, WIDE_MARGIN), ("cook", l.text("panel.cook")), |ui| {
            few_controls::row(&parts.cook, ui, acts)
        });
    }
    if layout.right.is_positive() {
        floating(ui, layout.right, (2, 10), ("inside", l.text("panel.inside")), |ui| {
            scrolled(ui, |ui| inside::show(&parts.inside, &mut memory.inside, ui, acts))
        });
    }
    floating(ui, layout.bottom, (3, MARGIN), ("cook", l.text("panel.cook")), |ui| {
        hob_bar::show(&parts.cook, ui, acts, false)
    });
    if parts.cook.turner_in_hand {
        turner_strip(state, ui, acts, layout);
    }
    let Some(left) = layout.left else { return };
    floating(ui, left, (4, WIDE_MARGIN), ("left", l.text("panel.food")), |ui| {
        scrolled(ui, |ui| {
            if state.settings.pieces_open {
                pieces::show(state, &mut memory.unfolded, ui, acts);
            } else {
                pantry::show(state, &mut memory.pantry, ui, acts);
            }
        });
    });
}

/// What moves the turner, over the scene: no row of the panels jumps when it is taken.
fn turner_strip(state: &PanelContext, ui: &Ui, acts: &mut Acts, layout: &Layout) {
    let at = layout.eye.left_bottom() - egui::vec2(GAP, 0.0);
    let area = egui::Area::new(egui::Id::unique("turner")).fixed_pos(at).pivot(egui::Align2::RIGHT_BOTTOM);
    area.show(ui.ctx(), |ui| {
        theme::of(ui).panel().inner_margin(MARGIN).show(ui, |ui| ui.horizontal(|ui| pour::turner(state, ui, acts)));
    });
}

/// The drawer of a first cook: what to do now, and the few controls.
fn few_drawer(parts: &Parts, memory: &mut PanelMemory, ui: &mut Ui, acts: &mut Acts) {
    now::in_drawer(&parts.now, &mut memory.now, ui, acts);
    ui.add_space(6.0);
    scrolled(ui, |ui| few_controls::rows(&parts.cook, ui, acts));
}

fn drawer(parts: &Parts, memory: &mut PanelMemory, ui: &mut Ui, acts: &mut Acts) {
    let state = &parts.context;
    ui.horizontal(|ui| {
        // Narrow enough for all of them and what there is to learn, in one row of a phone.
        (ui.spacing_mut().item_spacing.x, ui.spacing_mut().button_padding.x) = (4.0, 5.0);
        for part in Drawer::ALL.into_iter().filter(|part| part.is_offered(state)) {
            if ui.add(theme::of(ui).button(part.name(state), memory.drawer == part)).clicked() {
                memory.drawer = part;
            }
        }
        top::learn_and_settings(&parts.top, ui, acts);
    });
    ui.horizontal(|ui| {
        (ui.spacing_mut().item_spacing.x, ui.spacing_mut().button_padding.x) = (5.0, 7.0);
        let height = fingers::height(ui, STRIP_HEIGHT);
        ui.spacing_mut().interact_size.y = height;
        time_strip::undo_and_redo(state, ui, acts);
        time_strip::branches(state, parts.cook.side_by_side, ui, acts);
        let width = ui.available_width();
        time_strip::show(state, ui, acts, egui::vec2(width, height));
    });
    now::in_drawer(&parts.now, &mut memory.now, ui, acts);
    ui.add_space(6.0);
    let part = if memory.drawer.is_offered(state) { memory.drawer } else { Drawer::Cook };
    scrolled(ui, |ui| match part {
        Drawer::Cook => hob_bar::show(&parts.cook, ui, acts, true),
        Drawer::Inside => {
            ways::curves_in_drawer(&parts.ways, &mut memory.ways, ui);
            inside::show(&parts.inside, &mut memory.inside, ui, acts);
        }
        Drawer::Food => pantry::show(state, &mut memory.pantry, ui, acts),
        Drawer::Pieces if !state.reads_out() => inside::show(&parts.inside, &mut memory.inside, ui, acts),
        Drawer::Pieces => pieces::show(state, &mut memory.unfolded, ui, acts),
    });
}

/// A panel at a fixed place; it takes the mouse so that the scene below does not.
fn floating(
    ui: &mut Ui,
    rect: Rect,
    (index, margin): (u32, i8),
    (name, spoken): (&str, &str),
    content: impl FnOnce(&mut Ui),
) {
    ui.interact(rect, ui.scope_id().with(("ground", name)), egui::Sense::click_and_drag());
    let points = ui.ctx().pixels_per_point();
    let ground = GroundCallback {
        index,
        colour: theme::of(ui).ground.to_normalized_gamma_f32(),
        size: [rect.width() * points, rect.height() * points],
        radius: f32::from(theme::CORNER) * points,
    };
    ui.painter().add(egui_wgpu::Callback::new_paint_callback(rect, ground));
    let mut child = ui.new_child(UiBuilder::new().id_salt(name).max_rect(rect));
    theme::of(ui).panel().fill(egui::Color32::TRANSPARENT).inner_margin(margin).show(&mut child, |ui| {
        let inner = ui.available_size();
        ui.set_min_size(inner);
        ui.set_max_size(inner);
        ui.set_clip_rect(rect);
        content(ui);
    });
    if IS_PAGE {
        name_panel(&child, spoken);
    }
}

fn scrolled(ui: &mut Ui, content: impl FnOnce(&mut Ui)) {
    ScrollArea::vertical().auto_shrink([false, false]).show(ui, content);
}
