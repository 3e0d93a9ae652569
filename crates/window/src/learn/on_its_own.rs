//! The result drawn on its own, without a window: by an interface that nobody sees, filled in by the processor. The same in a
//! window and in a page.

use egui::{Context, Pos2, RawInput, Rect, Vec2, vec2};
use saute_kitchen::Piece;
use saute_picture::cut::section::Picture;

use crate::learn::raster::Canvas;
use crate::panels::cards::result::{CutOfResult, content};
use crate::ui::theme;
use saute_words::judgement_words::ResultWords;
use saute_words::language::Language;

/// Size of the picture at most [points], and pixels to a point (chosen: sharp on a phone, read at a glance).
const SIZE: Vec2 = vec2(680.0, 900.0);
const PIXELS: f32 = 2.0;
/// Space around [points].
const MARGIN: f32 = 24.0;

/// Draws a result.
pub fn picture(words: &ResultWords, piece: &Piece, l: Language) -> Picture {
    let context = Context::default();
    crate::ui::japanese_font::install(&context);
    theme::install(&context);
    context.set_theme(egui::Theme::Dark);
    context.set_pixels_per_point(PIXELS);
    let mut cut = CutOfResult::default();
    let mut canvas = Canvas::default();
    let mut used = Rect::NOTHING;
    // The first pass measures: the sizes of an interface are known only once it was laid out.
    for _ in 0..2 {
        let input = RawInput { screen_rect: Some(Rect::from_min_size(Pos2::ZERO, SIZE)), ..RawInput::default() };
        let output = context.run_ui(input, |ui| {
            let mut inner = ui.new_child(egui::UiBuilder::new().max_rect(ui.max_rect().shrink(MARGIN)));
            cut.refresh(piece, words, inner.ctx());
            inner.heading(l.text("result.shared"));
            content(&mut inner, words, &cut, false);
            used = inner.min_rect().expand(MARGIN);
        });
        canvas.take_textures(output.textures_delta);
        let primitives = context.tessellate(output.shapes, output.pixels_per_point);
        let size = used.size().min(SIZE) * PIXELS;
        let ground = crate::ui::palette::Palette::of(true).solid;
        canvas.paint([size.x as usize, size.y as usize], ground, &primitives, PIXELS);
    }
    canvas.picture()
}
