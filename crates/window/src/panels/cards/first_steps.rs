//! The card of the first start: three steps from raw food to a steak, each with a picture.

use egui::{Align, Color32, Id, Layout, Modal, Pos2, Rect, RichText, Sense, Shape, Stroke, Ui, Vec2, pos2, vec2};

use crate::panels::cards::language;
use crate::ui::aloud::heading;
use crate::ui::theme;
use saute_controls::act::{Act, Acts, AppAct, Card, LearnAct};
use saute_controls::context::PanelContext;
use saute_words::clock::whole_minutes;
use saute_words::doneness_words;

/// Size of a picture [points].
const PICTURE: Vec2 = vec2(112.0, 78.0);
/// Below this width the steps are below each other [points] (chosen: three columns of type that can be read).
const NARROW: f32 = 700.0;
/// Wall time in which a cook waits for hands [s] (chosen: seven acts of six seconds).
const HANDS_S: f64 = 40.0;
/// Height of what does not scroll [points]: heading, time and two rows of buttons and words.
const BESIDE: f32 = 210.0;
/// Room for one step next to others [points].
const COLUMN: f32 = 236.0;

// Colours of the pictures: things look the same in every theme (chosen).

/// Raw lean meat.
const STEAK_RAW: Color32 = Color32::from_rgb(186, 52, 58);
/// Warm, not yet grey.
const STEAK_PINK: Color32 = Color32::from_rgb(206, 112, 104);
/// Grey-brown.
const STEAK_DONE: Color32 = Color32::from_rgb(160, 118, 98);
/// Browned.
const STEAK_CRUST: Color32 = Color32::from_rgb(98, 56, 32);
/// The rim of fat.
const STEAK_FAT: Color32 = Color32::from_rgb(238, 214, 190);
/// The shaded side.
const STEAK_SIDE: Color32 = Color32::from_rgb(122, 34, 40);
/// A board.
const WOOD: Color32 = Color32::from_rgb(196, 150, 98);
/// Its edge.
const WOOD_SIDE: Color32 = Color32::from_rgb(140, 100, 60);
/// A flame.
const FLAME: Color32 = Color32::from_rgb(236, 138, 60);
/// Its core.
const FLAME_CORE: Color32 = Color32::from_rgb(224, 200, 120);
/// A pan.
const IRON: Color32 = Color32::from_rgb(22, 22, 24);

/// Title, words and picture of a step.
type Step = (&'static str, &'static str, fn(&Ui, Rect));

const STEPS: [Step; 3] = [
    ("first.set_out", "first.set_out_how", board),
    ("first.heat", "first.heat_how", pan),
    ("first.watch", "first.watch_how", cut),
];

/// Shows the card over everything; the button, Esc or a click beside it closes it for good.
pub fn show(state: &PanelContext, japanese_font: bool, ui: &Ui, acts: &mut Acts, whole: Rect) {
    let l = state.settings.language;
    let mut begun = false;
    let modal = Modal::new(Id::unique("first-steps")).frame(theme::of(ui).panel().fill(theme::of(ui).solid)).show(
        ui.ctx(),
        |ui| {
            let narrow = whole.width() < NARROW;
            ui.set_width(if narrow { whole.width() - 56.0 } else { 3.0 * (COLUMN + 14.0) });
            ui.horizontal(|ui| {
                heading(ui, title(state));
                ui.with_layout(Layout::right_to_left(Align::Center), |ui| {
                    language::chip(state, japanese_font, ui, acts)
                });
            });
            ui.add_space(6.0);
            // In a low window the steps scroll; the button that begins stays in sight.
            egui::ScrollArea::vertical().max_height(whole.height() - BESIDE).show(ui, |ui| {
                if narrow {
                    STEPS.iter().enumerate().for_each(|(place, step)| row(state, ui, place, step));
                } else {
                    ui.horizontal_top(|ui| {
                        STEPS.iter().enumerate().for_each(|(place, step)| column(state, ui, place, step))
                    });
                }
            });
            ui.add_space(8.0);
            if let Some(words) = lasts(state) {
                ui.label(RichText::new(words).size(14.0).strong());
                ui.add_space(4.0);
            }
            ui.horizontal_wrapped(|ui| {
                begun =
                    ui.add(theme::of(ui).primary(l.text("first.begin")).min_size(vec2(120.0, theme::TOUCH))).clicked();
                let shown = ui.add(theme::of(ui).button(l.text("tutorial.begin"), false));
                if shown.on_hover_text(l.text("learn.tutorial")).clicked() {
                    acts.push(Act::Learn(LearnAct::Tutorial(true)));
                }
                ui.label(RichText::new(l.text("first.again")).size(13.0).color(theme::of(ui).quiet));
            });
        },
    );
    if begun || modal.should_close() {
        acts.push(Act::App(AppAct::Shut(Card::FirstSteps)));
    }
}

/// How long the cook takes, and how long here.
fn lasts(state: &PanelContext) -> Option<String> {
    let (l, settings) = (state.settings.language, state.settings);
    let whole_s = state.whole_time_s()?;
    let [minutes, here] = [whole_s, whole_s / settings.speed + HANDS_S].map(whole_minutes);
    let parts: [(&str, &dyn std::fmt::Display); 2] = [("minutes", &minutes), ("here", &here)];
    Some(l.fill(if settings.speed > 1.0 { "first.lasts" } else { "first.lasts_real" }, &parts))
}

fn column(state: &PanelContext, ui: &mut Ui, place: usize, step: &Step) {
    ui.vertical(|ui| {
        ui.set_width(COLUMN);
        picture(ui, step);
        words(state, ui, place, step);
    });
}

fn row(state: &PanelContext, ui: &mut Ui, place: usize, step: &Step) {
    ui.horizontal_top(|ui| {
        picture(ui, step);
        ui.vertical(|ui| words(state, ui, place, step));
    });
    ui.add_space(6.0);
}

fn words(state: &PanelContext, ui: &mut Ui, place: usize, &(title, how, _): &Step) {
    let l = state.settings.language;
    ui.label(RichText::new(format!("{}  {}", place + 1, l.text(title))).size(16.0).strong().color(theme::of(ui).text));
    ui.label(RichText::new(l.text(how)).size(14.0));
}

fn picture(ui: &mut Ui, &(_, _, paint): &Step) {
    let (rect, _) = ui.allocate_exact_size(PICTURE, Sense::hover());
    ui.painter().rect_filled(rect, 8.0, theme::of(ui).raised);
    paint(ui, rect);
}

/// A steak as seen at a slant from above: the middle of its outline and its half width.
fn steak(ui: &Ui, middle: Pos2, half: f32) {
    let outline = |grow: f32, drop: f32| {
        let point = |k: usize| {
            let angle = std::f32::consts::TAU * k as f32 / 40.0;
            // A loin's outline: an egg with a dent at one side.
            let reach = 1.0 + 0.16 * angle.cos() - 0.13 * (2.0 * angle + 0.6).sin();
            middle + vec2(half * grow * reach * angle.cos(), 0.5 * half * grow * reach * angle.sin() + drop)
        };
        (0..40).map(point).collect::<Vec<_>>()
    };
    let painter = ui.painter();
    painter.add(Shape::convex_polygon(outline(1.0, 0.2 * half), STEAK_SIDE, Stroke::NONE));
    painter.add(Shape::convex_polygon(outline(1.0, 0.0), STEAK_FAT, Stroke::NONE));
    painter.add(Shape::convex_polygon(outline(0.88, 0.0), STEAK_RAW, Stroke::NONE));
}

/// A steak on a wooden board.
fn board(ui: &Ui, rect: Rect) {
    let wood = Rect::from_center_size(rect.center() + vec2(0.0, 4.0), vec2(92.0, 48.0));
    ui.painter().rect_filled(wood.translate(vec2(0.0, 5.0)), 7.0, WOOD_SIDE);
    ui.painter().rect_filled(wood, 7.0, WOOD);
    steak(ui, wood.center() - vec2(2.0, 4.0), 29.0);
}

/// A pan on flames, and a steak on its way into it.
fn pan(ui: &Ui, rect: Rect) {
    let (painter, floor) = (ui.painter(), rect.bottom() - 24.0);
    let middle = rect.center().x - 12.0;
    for k in 0..5u8 {
        let x = middle + 11.0 * (f32::from(k) - 2.0);
        let high = if k % 2 == 0 { 13.0 } else { 17.0 };
        let tip =
            |w: f32, h: f32| vec![pos2(x - w, floor + 19.0), pos2(x, floor + 19.0 - h), pos2(x + w, floor + 19.0)];
        painter.add(Shape::convex_polygon(tip(5.0, high), FLAME, Stroke::NONE));
        painter.add(Shape::convex_polygon(tip(2.5, 0.5 * high), FLAME_CORE, Stroke::NONE));
    }
    let side = [(-40.0, -15.0), (40.0, -15.0), (31.0, 0.0), (-31.0, 0.0)];
    let side = side.map(|(x, y)| pos2(middle + x, floor + y)).to_vec();
    painter.add(Shape::convex_polygon(side, IRON, Stroke::new(1.0, theme::of(ui).quiet)));
    let handle = [pos2(middle + 39.0, floor - 13.0), pos2(middle + 66.0, floor - 19.0)];
    painter.line_segment(handle, Stroke::new(6.0, IRON));
    steak(ui, pos2(middle, floor - 40.0), 24.0);
    arrow(ui, [pos2(middle, floor - 25.0), pos2(middle, floor - 13.0)]);
}

/// The cut face of a steak, browned outside and red inside, with the way it is flipped.
fn cut(ui: &Ui, rect: Rect) {
    let face = Rect::from_center_size(rect.center() + vec2(0.0, 12.0), vec2(86.0, 34.0));
    let bands = [STEAK_CRUST, STEAK_DONE, STEAK_PINK, STEAK_RAW];
    for (place, colour) in bands.into_iter().enumerate() {
        let inner = face.shrink2(vec2(1.5, 4.2) * place as f32);
        ui.painter().rect_filled(inner, 9.0 - 1.5 * place as f32, colour);
    }
    let around = |k: u8| {
        let angle = std::f32::consts::PI * (1.0 - f32::from(k) / 12.0);
        face.center_top() + vec2(26.0 * angle.cos(), -4.0 - 17.0 * angle.sin())
    };
    let way: Vec<Pos2> = (0..=11).map(around).collect();
    ui.painter().add(Shape::line(way, Stroke::new(2.5, theme::of(ui).text)));
    arrow(ui, [around(11), around(12) + vec2(0.0, 3.0)]);
}

/// An arrow's head at the end of a line.
fn arrow(ui: &Ui, [from, to]: [Pos2; 2]) {
    let along = (to - from).normalized();
    let back = to - 7.0 * along;
    let wings = vec![to, back + 4.5 * along.rot90(), back - 4.5 * along.rot90()];
    ui.painter().line_segment([from, back], Stroke::new(2.5, theme::of(ui).text));
    ui.painter().add(Shape::convex_polygon(wings, theme::of(ui).text, Stroke::NONE));
}

/// What is cooked, and how it is to come out where a scale has words for it.
fn title(state: &PanelContext) -> String {
    let l = state.settings.language;
    state.scale().map_or_else(
        || l.text("first.title").to_owned(),
        |scale| {
            let class = scale.name_of(scale.of_nodes(state.settings.goal(&scale)));
            l.fill("first.title_to", &[("class", &doneness_words::class(&scale, class, l))])
        },
    )
}
