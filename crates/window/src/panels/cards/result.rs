//! The card of the result: verdict, score, the cut that shows why, and the one thing to do better.

use egui::{
    Align, Align2, Color32, FontId, Grid, Layout, Rect, RichText, ScrollArea, Sense, Stroke, TextureHandle,
    TextureOptions, Ui, vec2,
};
use saute_kitchen::Piece;
use saute_kitchen::heat::BodyMesh;
use saute_picture::View;
use saute_picture::cut::section::section_picture;

use crate::panels::cards::frame::Framed;
use crate::panels::cards::serving::Serving;
use crate::ui::theme;
use saute_controls::act::{Act, Acts, AppAct, Card, CookAct, TimeAct};
use saute_controls::context::PanelContext;
use saute_words::clock::clock;
use saute_words::judgement_words::ResultWords;

/// Width of the card at most, and below which its parts are below each other [points].
const WIDTH: f32 = 720.0;
const NARROW: f32 = 560.0;
/// Width that the plate takes beside them [points].
const PLATE: f32 = 330.0;
/// Size of the picture of the cut at most [points], and room beside it for the brackets of the grey band.
const CUT: egui::Vec2 = vec2(440.0, 118.0);
const BRACKET: f32 = 76.0;
/// Fineness of the picture [pixels/mm] (chosen: sharp in the card and in the picture that is shared).
const PER_MM: f64 = 8.0;

/// The picture of the cut, painted again when another result is shown.
#[derive(Default)]
pub struct CutOfResult {
    texture: Option<TextureHandle>,
    painted_for: Option<ResultWords>,
    /// The food on its plate; none where nothing can be drawn.
    pub plate: Option<Serving>,
    /// Thickness that the picture shows, of food whose section is seen as it lies [mm].
    thickness_mm: Option<f64>,
}

impl CutOfResult {
    /// Paints the cut of a piece if the result is another one.
    pub fn refresh(&mut self, piece: &Piece, words: &ResultWords, ctx: &egui::Context) {
        if self.painted_for.as_ref() == Some(words) {
            return;
        }
        let picture = section_picture(piece, 0.0, View::Look, None, PER_MM);
        let image = egui::ColorImage::from_rgba_unmultiplied([picture.width, picture.height], &picture.rgba);
        self.texture = Some(ctx.load_texture("result", image, TextureOptions::LINEAR));
        let lies = match piece.model.mesh() {
            BodyMesh::Swept(mesh) => mesh.is_upright(),
            BodyMesh::Cells(_) => true,
        };
        self.thickness_mm = lies.then(|| 1e3 * piece.model.thickness(&piece.state));
        self.painted_for = Some(words.clone());
    }
}

/// Shows the card with the result and the time from which the cook is tried again [s]; Esc, the button or a click beside it closes it.
pub fn show(
    state: &PanelContext,
    result: Option<&(ResultWords, Option<f64>)>,
    memory: &mut CutOfResult,
    ui: &Ui,
    acts: &mut Acts,
    whole: Rect,
) {
    let wide = whole.width() > WIDTH + PLATE + 80.0 && memory.plate.is_some();
    let width = if wide { WIDTH + PLATE } else { WIDTH };
    let framed = Framed { card: Card::Result, id: "result", title: "result.title", width };
    framed.show(state, ui, acts, whole, |ui, acts| {
        let l = state.settings.language;
        let Some(((words, try_from_s), piece)) = result.zip(state.session.shown_piece()) else {
            ui.label(l.text("result.none"));
            return;
        };
        memory.refresh(piece, words, ui.ctx());
        let narrow = ui.available_width() < NARROW;
        let height = whole.height() - if narrow { 230.0 } else { 180.0 };
        ui.horizontal_top(|ui| {
            ui.vertical(|ui| {
                ui.set_width(ui.available_width() - if wide { PLATE } else { 0.0 });
                ScrollArea::vertical()
                    .max_height(height)
                    .min_scrolled_height(height)
                    .show(ui, |ui| content(ui, words, memory, narrow));
            });
            if let Some(plate) = memory.plate.as_ref().filter(|_| wide) {
                plate.show(ui, ui.available_width(), l);
            }
        });
        ui.add_space(4.0);
        ui.horizontal_wrapped(|ui| buttons(state, *try_from_s, ui, acts));
    });
}

fn buttons(state: &PanelContext, try_from_s: Option<f64>, ui: &mut Ui, acts: &mut Acts) {
    let (l, palette) = (state.settings.language, theme::of(ui));
    let mut try_again = |ui: &mut Ui, words: &str, is_first: bool, hint: &'static str, act: Act| {
        let button = if is_first { palette.primary(words) } else { palette.button(words, false) };
        if ui.add(button).on_hover_text(l.text(hint)).clicked() {
            acts.extend([Act::App(AppAct::Shut(Card::Result)), act]);
        }
    };
    if let Some(time_s) = try_from_s {
        let words = l.fill("result.try_from", &[("time", &clock(time_s))]);
        try_again(ui, &words, true, "result.try_from_hint", Act::Time(TimeAct::TryFrom(time_s)));
    }
    try_again(ui, l.text("result.again"), try_from_s.is_none(), "key.restart", Act::Cook(CookAct::Restart));
    if ui.add(palette.button(l.text("result.share"), false)).on_hover_text(l.text("result.share_hint")).clicked() {
        acts.push(Act::App(AppAct::ShareResult));
    }
    if ui.add(palette.button(l.text("goals.title"), false)).clicked() {
        acts.push(Act::App(AppAct::Open(Card::Goals)));
    }
}

/// The text of the card, and what its picture shows: the cut, the verdict with its grade, what went well and what to do better.
pub fn content(ui: &mut Ui, words: &ResultWords, cut: &CutOfResult, narrow: bool) {
    let palette = theme::of(ui);
    (ui.spacing_mut().item_spacing.y, ui.spacing_mut().interact_size.y) = (4.0, 18.0);
    cut_picture(ui, words, cut);
    ui.add_space(4.0);
    ui.label(RichText::new(&words.mark).size(22.0).strong());
    ui.label(RichText::new(&words.verdict).size(17.0));
    for missed in &words.missed {
        ui.label(RichText::new(format!("– {missed}")).size(14.0));
    }
    ui.add_space(2.0);
    if !words.good.is_empty() {
        ui.label(RichText::new(&words.good).size(15.0));
    }
    better(ui, words);
    if !words.best.is_empty() {
        ui.label(RichText::new(&words.best).size(14.0).color(palette.quiet));
    }
    ui.add_space(4.0);
    let half = if narrow { ui.available_width() } else { 0.5 * (ui.available_width() - 44.0) };
    let part = |ui: &mut Ui, part: fn(&mut Ui, &ResultWords)| {
        ui.allocate_ui_with_layout(vec2(half, 0.0), Layout::top_down(Align::Min), |ui| {
            ui.set_width(half);
            part(ui, words);
        });
        ui.add_space(10.0);
    };
    if narrow {
        part(ui, measures);
        part(ui, counted);
    } else {
        ui.horizontal_top(|ui| [measures as fn(&mut Ui, &ResultWords), counted].map(|one| part(ui, one)));
    }
}

/// The cut with brackets over the grey band below each face.
fn cut_picture(ui: &mut Ui, words: &ResultWords, cut: &CutOfResult) {
    let Some(texture) = &cut.texture else { return };
    let size = texture.size_vec2();
    let room = vec2((ui.available_width() - BRACKET).min(CUT.x), CUT.y);
    let size = size * (room.x / size.x).min(room.y / size.y);
    let (row, response) = ui.allocate_exact_size(vec2(ui.available_width(), size.y), Sense::hover());
    response.widget_info(|| egui::WidgetInfo::labeled(egui::accesskit::Role::Image, true, &words.cut));
    let left = row.left() + (0.5 * (row.width() - BRACKET - size.x)).max(0.0);
    let rect = Rect::from_min_size(egui::pos2(left, row.top()), size);
    egui::Image::new((texture.id(), size)).corner_radius(5).paint_at(ui, rect);
    let Some(thickness) = cut.thickness_mm else { return };
    let [below, above] = words.grey_mm.map(|mm| rect.height() * (mm / thickness).clamp(0.0, 1.0) as f32);
    bracket(ui, rect, [rect.top(), rect.top() + above], words.grey_mm[1]);
    bracket(ui, rect, [rect.bottom() - below, rect.bottom()], words.grey_mm[0]);
}

/// Least thickness of a band that is marked [mm] (chosen: it can be distinguished from the line that marks it).
const MARKED_MM: f64 = 0.2;

/// A bracket at the right of a picture from one height to another, with a line across the picture where the band ends.
fn bracket(ui: &Ui, rect: Rect, [top, bottom]: [f32; 2], mm: f64) {
    if mm < MARKED_MM {
        return;
    }
    let (palette, painter) = (theme::of(ui), ui.painter());
    let inner = if (top - rect.top()).abs() < 0.5 { bottom } else { top };
    let ends = [egui::pos2(rect.left(), inner), egui::pos2(rect.right() + 8.0, inner)];
    // Seen on dark crust and on pale flesh.
    painter.line_segment(ends, Stroke::new(2.5, Color32::from_black_alpha(150)));
    painter.extend(egui::Shape::dashed_line(&ends, Stroke::new(1.2, Color32::WHITE), 5.0, 4.0));
    let stroke = Stroke::new(2.0, palette.text);
    let x = rect.right() + 8.0;
    painter.line_segment([egui::pos2(x, top + 1.0), egui::pos2(x, bottom - 1.0)], stroke);
    let at = egui::pos2(x + 6.0, 0.5 * (top + bottom));
    painter.text(at, Align2::LEFT_CENTER, format!("{mm:.1} mm"), FontId::proportional(13.0), palette.text);
}

fn measures(ui: &mut Ui, words: &ResultWords) {
    Grid::new("measures").num_columns(2).spacing(vec2(12.0, 3.0)).show(ui, |ui| {
        for (name, value) in &words.measures {
            ui.label(RichText::new(name).size(13.0).color(theme::of(ui).quiet));
            ui.label(RichText::new(value).size(14.5).strong());
            ui.end_row();
        }
    });
}

/// How the mark is counted.
fn counted(ui: &mut Ui, words: &ResultWords) {
    let (heads, rows) = &words.table;
    // Before the rest is over nothing is counted.
    if rows.is_empty() {
        return;
    }
    ui.label(RichText::new(&words.counted).size(13.0).color(theme::of(ui).quiet));
    Grid::new("score").num_columns(4).spacing(vec2(10.0, 2.0)).show(ui, |ui| {
        for head in heads {
            ui.label(RichText::new(head).size(12.0).color(theme::of(ui).quiet));
        }
        ui.end_row();
        for row in rows {
            for cell in row {
                ui.label(RichText::new(cell).size(13.0));
            }
            ui.end_row();
        }
    });
}

fn better(ui: &mut Ui, words: &ResultWords) {
    let palette = theme::of(ui);
    ui.add_space(2.0);
    egui::Frame::new().fill(palette.raised).corner_radius(8).inner_margin(9).show(ui, |ui| {
        ui.set_width(ui.available_width());
        let [heading, what] = &words.better;
        ui.label(RichText::new(heading).size(13.0).strong());
        ui.label(RichText::new(what).size(15.0));
    });
}
